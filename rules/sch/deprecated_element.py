from collections.abc import Iterator

from sdfcheck import (
    IN_JOINT,
    IN_LINK,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Fix,
    Good,
    Rule,
    Severity,
    TextEdit,
    accepts,
    make_fix,
    named,
    problems,
)

SCAN = (
    "<scan><horizontal><samples>9</samples><min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan>"
    "<range><min>0.1</min><max>9</max></range>"
)


class DeprecatedElement(Rule):
    """An element or value has a successor and will go.

    Elements that the format marks as deprecated get a warning, as they do from libsdformat. An
    info is for names that have a newer form and that all consumers still read: the sensor types
    `ray`, `gpu_ray` and `gps` are now `lidar`, `gpu_lidar` and `navsat`. Renaming needs a look,
    because Gazebo Classic knows the old names only.
    """

    code = "SCH009"
    name = "deprecated-element"
    severity = Severity.WARNING
    remedy = """Use the successor that the message names.

    Files for Gazebo Classic keep the old names of sensors: ignore this for them in `sdfcheck.toml`.
    """
    explains = (problems.DeprecatedElement,)
    scaffold = IN_LINK

    bad = (
        Bad(
            f'<sensor name="s" type="«gpu_ray»"><ray>{SCAN}</ray></sensor>',
            fixed=f'<sensor name="s" type="gpu_lidar"><lidar>{SCAN}</lidar></sensor>',
            unsafe=True,
            says="sensor type `gpu_ray` is called `gpu_lidar` since version 1.6",
        ),
        Bad(
            '<sensor name="s" type="navsat"><«gps»/></sensor>',
            fixed='<sensor name="s" type="navsat"><navsat/></sensor>',
            unsafe=True,
            says="`gps` is called `navsat` since version 1.7",
        ),
        Bad(
            "<«thread_pitch»>2</thread_pitch>",
            says="`thread_pitch` is deprecated since version 1.10; use `screw_thread_pitch`",
            scaffold=IN_JOINT.replace("revolute", "fixed"),
        ),
    )
    good = (
        Good('<sensor name="s" type="navsat"><navsat/></sensor>'),
        Good(
            '<sensor name="s" type="gps"><gps/></sensor>',
            why="1.5 has no other name for it",
            scaffold=IN_LINK.replace("1.12", "1.5"),
        ),
    )

    def check(self, problem: problems.DeprecatedElement) -> Iterator[Diagnostic]:
        element, value, successor = problem.element, problem.value, problem.successor
        since = f" since version {problem.since}" if problem.since else ""
        if problem.announced:
            what = f"{element.name} type `{value.text}`" if value is not None else f"`{element.name}`"
            yield self.diagnostic(
                value or element,
                f"{what} is called `{successor}`{since}",
                severity=Severity.INFO,
                fix=_renaming(problem),
                affects=dict.fromkeys((Consumer.GAZEBO, Consumer.DRAKE), accepts("reads the old name")),
            )
            return
        message = f"`{element.name}` is deprecated{since}"
        if successor is not None:
            message += f"; use {named(successor.split(', '))}"
        # URDF has no version: the Gazebo that reads it may not know the successor yet.
        severity = Severity.INFO if element.document.kind.value != "sdf" else None
        yield self.diagnostic(element, message, severity=severity)


def _renaming(problem: problems.DeprecatedElement) -> Fix:
    """Give the value and its settings, or the settings alone, their new names."""
    edits: tuple[TextEdit, ...] = ()
    settings, name = problem.element, problem.successor or ""
    if problem.value is None:
        edits = _renamed(settings, name)
    else:
        edits = (TextEdit(problem.value.span, name),)
        if problem.settings is not None:
            edits += _renamed(problem.settings, name.removeprefix("gpu_"))
    return make_fix(f"rename it to `{name}`", edits, unsafe=True)


def _renamed(element: Element, name: str) -> tuple[TextEdit, ...]:
    spans = (element.span, element.document.spans.end_name(element))
    return tuple(TextEdit(span, name) for span in spans if span is not None)
