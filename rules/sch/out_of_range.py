from collections.abc import Iterator

from sdfcheck import (
    IN_COLLISION,
    IN_LINK,
    IN_ROBOT,
    IN_WORLD,
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Document,
    Element,
    Good,
    Rule,
    Severity,
    problems,
    undersized,
    unreadable,
    warns,
)

CAMERA = (
    '<sdf version="1.12"><model name="m"><link name="base"><sensor name="s" type="camera">'
    "<camera>{}</camera></sensor></link></model></sdf>"
)

OTHER_VALUE = dict.fromkeys(Consumer, warns("takes another value"))
FINITE_IN_DRAKE = frozenset(
    "capsule/length capsule/radius cylinder/length cylinder/radius sphere/radius "
    "limit/effort limit/lower limit/upper limit/velocity".split()
)
"""The numbers of SDFormat for which Drake asserts that they are finite; of others it does not."""


class OutOfRange(Rule):
    """A number lies outside the range that the format states or that its quantity has.

    libsdformat enforces the bounds of its specification: outside them it refuses the
    document, which is an error; so it does for moments of inertia that are not finite. Of
    other bounds it checks none, or takes a default instead, as for a shape whose size is
    not positive. In URDF, Drake aborts at such a shape (it takes a sphere of radius 0 for a
    point), and MuJoCo refuses it as a collision.
    """

    code = "SCH014"
    name = "out-of-range"
    severity = Severity.WARNING
    remedy = """Write a number within the range, in the unit of the format.

    Angles are in radians: a camera that sees 90° has a `horizontal_fov` of 1.5708. Sizes are in meters and
    above 0; of two bounds the lower one comes first. `sdfcheck describe ELEMENT` shows range and unit.
    """
    explains = (problems.ValueOutOfRange, problems.ReversedRange)
    scaffold = CAMERA

    bad = (
        Bad(
            "<horizontal_fov>«90»</horizontal_fov>",
            says="`horizontal_fov` must be from 0.001 to 6.283186, not 90",
        ),
        Bad(
            "<image><width>«0»</width><height>240</height></image>",
            says="`width` should be at least 1, not 0",
        ),
        Bad(
            "<lens><type>stereographic</type><env_texture_size>«1,5»</env_texture_size></lens>",
            says="`env_texture_size` must be from 4 to 2048, not 1,5",
        ),
        Bad("<clip><near>«10»</near><far>1</far></clip>", says="near 10 is above far 1"),
        Bad(
            "<geometry><box><size>1 «0» 1</size></box></geometry>",
            scaffold=IN_COLLISION,
            says="`size` should be above 0, not 0, so libsdformat takes 1 1 1",
        ),
        Bad(
            '<link name="pad"><collision><geometry><sphere radius="«-1»"/></geometry></collision></link>'
            '<joint name="j" type="fixed"><parent link="base"/><child link="pad"/></joint>',
            scaffold=IN_ROBOT,
            says="`radius` should be above 0, not -1, so libsdformat takes 1",
        ),
        Bad(
            "<inertial><mass>1</mass><inertia><ixx>«nan»</ixx><ixy>0</ixy><ixz>0</ixz>"
            "<iyy>1</iyy><iyz>0</iyz><izz>1</izz></inertia></inertial>",
            scaffold=IN_LINK,
            says="`ixx` must be finite, not nan",
        ),
        Bad(
            '<physics type="ode"><max_step_size>0.001</max_step_size>'
            "<ode><solver><min_step_size>«0.01»</min_step_size></solver></ode></physics>",
            scaffold=IN_WORLD,
            says="min_step_size 0.01 is above max_step_size 0.001",
        ),
        Bad(
            '<gazebo reference="base"><visual><material><ambient>«220» 0 0 1</ambient></material></visual></gazebo>',
            scaffold=IN_ROBOT,
            says="should be",
        ),
    )
    good = (
        Good("<clip><near>0.1</near><far>inf</far></clip>", why="there is no end to what it sees"),
        Good("<clip><near>1</near><far>1</far></clip>"),
        Good(
            '<link name="pad"><collision><geometry><sphere radius="1"/></geometry></collision></link>'
            '<joint name="j" type="fixed"><parent link="base"/><child link="pad"/></joint>',
            scaffold=IN_ROBOT,
        ),
    )

    def check(self, problem: problems.ValueOutOfRange | problems.ReversedRange) -> Iterator[Diagnostic]:
        if isinstance(problem, problems.ReversedRange):
            upper = problem.upper
            labels, cause = {upper: "the upper end"}, upper.span
            yield self.diagnostic(
                problem.lower, problem.text, labels=labels, affects=OTHER_VALUE, cause=cause
            )
            return
        name = problem.value.attribute or problem.value.element.name
        is_refused = (problem.refused and not _is_lost(problem.value.element)) or _is_moment(problem)
        must = "must" if is_refused else "should"
        message = f"`{name}` {must} be {problem.bound}, not {problem.span.text}"
        if problem.instead is not None:
            message += f", so libsdformat takes {problem.instead}"
        severity, affects = None, {**OTHER_VALUE, **undersized(problem.value)}
        if is_refused:
            severity = Severity.ERROR
            affects[Consumer.GAZEBO] = REFUSES
        if is_refused and problem.refused:
            others = warns("takes the number as it is") if name == "rgba" else REFUSES
            affects = {**dict.fromkeys(Consumer, others), **unreadable(problem.value)}
        if name == "rgba":
            affects |= {Consumer.DRAKE: REFUSES, Consumer.MUJOCO: others, Consumer.ISAAC: others}
        is_in_world = any(each.name == "world" for each in problem.value.element.around)
        if _is_checked_by_drake(problem) or (is_in_world and _is_moment(problem)):
            affects[Consumer.DRAKE] = REFUSES
        yield self.diagnostic(problem.span, message, severity=severity, affects=affects)


def _is_lost(element: Element) -> bool:
    """Is it in a block about the visual of a link that has none? Nobody reads it."""
    around = {each.name: each for each in element.around}
    block = around.get("gazebo") if "visual" in around else None
    return block is not None and block.text_of("reference") in element.document.view(unseen_links)


def unseen_links(document: Document) -> frozenset[str | None]:
    """The names of the links that have no visual."""
    links = document.root.children("link") if document.root is not None else ()
    return frozenset(link.text_of("name") for link in links if not link.has("visual"))


def _is_moment(problem: problems.ValueOutOfRange) -> bool:
    """Is it a moment of inertia of SDFormat, or added mass? libsdformat refuses those that are not finite."""
    element = problem.value.element
    is_sdf, around = element.document.kind.value == "sdf", element.parent
    return is_sdf and around is not None and around.name in {"inertia", "fluid_added_mass"}


def _is_checked_by_drake(problem: problems.ValueOutOfRange) -> bool:
    element = problem.value.element
    around = element.parent.name if element.parent is not None else ""
    return problem.bound == "finite" and f"{around}/{element.name}" in FINITE_IN_DRAKE
