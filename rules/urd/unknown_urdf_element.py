from collections.abc import Iterator

from sdfcheck import (
    IN_URDF_LINK,
    Bad,
    Diagnostic,
    Good,
    Rule,
    Severity,
    named,
    problems,
    rename,
    unreadable,
    used,
)

SHAPE = '<geometry><sphere radius="1"/></geometry>'
FOR_GAZEBO = frozenset(("light", "plugin", "sensor"))
"""Parts that only `gazebo` blocks hold."""


class UnknownUrdfElement(Rule):
    """An element that no consumer of URDF looks for is in the description.

    All of them ignore it in silence, with everything in it, so that a misspelling of a
    name costs the robot a mass, a limit or a shape in silence. Elements
    with a prefix are free, and so is what is inside `gazebo`, `transmission` and
    `ros2_control`. Where the misspelling leaves something out that is required, this is an error.
    """

    code = "URD001"
    name = "unknown-urdf-element"
    severity = Severity.WARNING
    remedy = """Write the element as URDF knows it and where it is read, or give it a prefix.

    `sdfcheck describe urdf:link` and the like list what an element holds. An element of your own keeps out
    of the way with a prefix that is declared at the root, and settings for Gazebo belong in a `<gazebo>`
    block.
    """
    explains = (problems.UnknownUrdfElement,)
    scaffold = IN_URDF_LINK

    bad = (
        Bad(
            f"<«visul»>{SHAPE}</visul>",
            fixed=f"<visual>{SHAPE}</visual>",
            unsafe=True,
            says="unknown element `visul` in link `base`; did you mean `visual`?",
        ),
        Bad(
            "<visual><«geometri»/></visual>",
            fixed="<visual><geometry/></visual>",
            unsafe=True,
            says="did you mean `geometry`?",
        ),
        Bad('<«mass» value="1"/>', says="`mass` is not read in link `base`; it goes into `inertial`"),
        Bad(
            '<«sensor» name="s" type="imu"/>',
            says='`sensor` is not read in link `base`; it goes into `<gazebo reference="base">`',
        ),
        Bad(f"<visual>{SHAPE}<«color»/><color/></visual>", says="(used 2 times)"),
    )
    good = (
        Good(f"<collision>{SHAPE}<drake:proximity_properties/></collision>", why="a prefix makes it free"),
        Good(
            '<robot name="r"><link name="a"/><gazebo><any/></gazebo><mujoco><compiler/></mujoco></robot>',
            why="content of others",
            scaffold="",
        ),
        Good(f'<collision>{SHAPE}<material name="m"/></collision>', why="a customary leftover of exporters"),
    )

    def check(self, problem: problems.UnknownUrdfElement) -> Iterator[Diagnostic]:
        element, near = problem.element, problem.suggestion
        message = f"unknown element `{element.name}` in {problem.parent.title}"
        if near is not None:
            message += f"; did you mean `{near}`?"
        elif element.name in FOR_GAZEBO and problem.parent.name in {"link", "joint"}:
            block = f'<gazebo reference="{problem.parent.attributes.get("name", "")}">'
            message = f"`{element.name}` is not read in {problem.parent.title}; it goes into `{block}`"
        elif problem.places:
            places = named(problem.places, "or")
            message = f"`{element.name}` is not read in {problem.parent.title}; it goes into {places}"
        severity = Severity.ERROR if problem.needed else None
        affects = unreadable(problem.parent) if problem.needed else {}
        yield self.diagnostic(
            element,
            message + used(len(problem.uses)),
            severity=severity,
            fix=rename(problem.suggestion, *problem.uses),
            affects=affects,
        )
