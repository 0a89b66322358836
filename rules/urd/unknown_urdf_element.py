from collections.abc import Iterator, Sequence

from sdfcheck import (
    IN_URDF_LINK,
    Bad,
    Consumer,
    Diagnostic,
    Element,
    Fix,
    Good,
    Rule,
    Severity,
    lacking,
    named,
    problems,
    refuses,
    rename,
    rewrite,
    used,
)

SHAPE = '<geometry><sphere radius="1"/></geometry>'
PAINTED = '<robot name="r"><material name="m">{}</material><link name="a"/></robot>'
FOR_GAZEBO = frozenset(("light", "plugin", "sensor"))
"""Parts that only `gazebo` blocks hold."""
PLACED = frozenset(("collision", "inertial", "visual"))
"""Elements whose `origin` says what a `pose` of SDFormat would; that of a joint is in its parent link."""


class UnknownUrdfElement(Rule):
    """An element that no consumer of URDF looks for is in the description.

    All of them ignore it in silence, with everything in it, so that a misspelling of a
    name costs the robot a mass, a limit or a shape in silence. Elements
    with a prefix are free, and so is what is inside `gazebo`, `transmission` and
    `ros2_control`. Of its own language MuJoCo reads `compiler`, `option` and `size` in URDF, and
    no `worldbody`. Where the misspelling leaves something out that is required, this is an error.
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
        Bad(
            '<robot name="r"><mujoco><compiler/><«worldbody»/></mujoco><link name="a"/></robot>',
            scaffold="{}",
            says="unknown element `worldbody` in `mujoco`",
        ),
        Bad('<«mass» value="1"/>', says="`mass` is not read in link `base`; it goes into `inertial`"),
        Bad(
            '<«sensor» name="s" type="imu"/>',
            says='`sensor` is not read in link `base`; it goes into `<gazebo reference="base">`',
        ),
        Bad(
            f"<visual>{SHAPE}<«pose»>0 0 1 0 1.57 0</pose></visual>",
            fixed=f'<visual>{SHAPE}<origin xyz="0 0 1" rpy="0 1.57 0"/></visual>',
            unsafe=True,
            says="unknown element `pose` in `visual`, which is `origin` in URDF",
        ),
        Bad(
            PAINTED.replace("{}", "<«diffuse»>1 0 0 1</diffuse>"),
            fixed=PAINTED.replace("{}", '<color rgba="1 0 0 1"/>'),
            unsafe=True,
            scaffold="",
            says="`diffuse` is not read in material `m`: URDF has `color`",
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
        fix = rename(problem.suggestion, *problem.uses)
        if problem.attributes:
            count = len(problem.attributes) - 1
            message = f"`{element.name}` of {problem.parent.title} is an attribute, not an element"
            if count:
                message = f"`{element.name}` and {count} more of {problem.parent.title} are attributes, not elements"
        elif near is not None:
            message += f"; did you mean `{near}`?"
        elif element.name in FOR_GAZEBO and problem.parent.name in {"link", "joint"}:
            block = f'<gazebo reference="{problem.parent.attributes.get("name", "")}">'
            message = f"`{element.name}` is not read in {problem.parent.title}; it goes into `{block}`"
        elif problem.is_color:
            message = f"`{element.name}` is not read in {problem.parent.title}: URDF has `color`"
            fix = as_color(problem.uses)
        elif element.name == "pose" and problem.parent.name in PLACED and not problem.parent.has("origin"):
            message += ", which is `origin` in URDF"
            fix = as_origin(problem.uses)
        elif problem.places:
            places = named(problem.places, "or")
            message = f"`{element.name}` is not read in {problem.parent.title}; it goes into {places}"
        severity = Severity.ERROR if problem.needed else None
        affects = lacking(problem.parent, near or "") if problem.needed else {}
        if problem.is_color and not all(map(is_painted, problem.uses)):
            severity, affects = Severity.ERROR, {Consumer.DRAKE: refuses("knows no such material")}
        yield self.diagnostic(
            element,
            message + used(len(problem.uses)),
            severity=severity,
            fix=fix,
            affects=affects,
            repeats=problem.uses[1:],
        )


def as_origin(poses: Sequence[Element]) -> Fix | None:
    """The fix that writes each `pose` of SDFormat as an `origin`."""
    numbers = {pose: pose.content.split() for pose in poses}
    if any(
        len(words) != 6 or pose.attributes or any(pose.children()) or '"' in pose.content
        for pose, words in numbers.items()
    ):
        return None
    texts = {
        pose: f'<origin xyz="{" ".join(words[:3])}" rpy="{" ".join(words[3:])}"/>'
        for pose, words in numbers.items()
    }
    return rewrite("write `origin`", texts)


def as_color(colors: Sequence[Element]) -> Fix | None:
    """The fix that writes each `diffuse` of SDFormat as a `color`, where the material has none."""
    diffuse = [color for color in colors if color.name == "diffuse" and not is_painted(color)]
    return rewrite("write `color`", {color: f'<color rgba="{color.content}"/>' for color in diffuse})


def is_painted(color: Element) -> bool:
    """Has the material of a color of SDFormat one of URDF, or a texture?"""
    return color.parent is None or color.parent.has("color") or color.parent.has("texture")
