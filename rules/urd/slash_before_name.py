from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Link, Rule, Semantics, Severity, Value

VIRTUAL = (
    '<robot name="r"><virtual_joint name="v" type="{}" parent_frame="{}" child_link="base"/>'
    '<group name="all"><link name="base"/></group></robot>'
)
ROBOT = {"r.urdf": '<robot name="r"><link name="base"/></robot>'}


class SlashBeforeName(Rule):
    """The name of a link, or of the frame in which MoveIt plans, begins with a slash.

    tf2 keeps its frame without the slash, and refuses to look up one with it: RViz and MoveIt, which ask by
    the name in the description, do not find it. ROS 1 leaves `tf_prefix` away from such a name, too. The frame is the
    `parent_frame` of a virtual joint of SRDF that is not fixed.
    """

    code = "URD021"
    name = "slash-before-name"
    severity = Severity.WARNING
    remedy = """Remove the slash from the name, and from the joints that name it.

    A namespace for a robot is the `frame_prefix` of robot_state_publisher, or a prefix in the macros of
    xacro.
    """
    sources = ("https://wiki.ros.org/tf2/Migration",)
    looks_at = (Link, Semantics)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<link name="«/arm»"/><joint name="j" type="fixed"><parent link="base"/><child link="/arm"/></joint>',
            says="link `/arm` begins with a slash, with which tf2 does not find it",
        ),
        Bad(
            VIRTUAL.format("planar", "«/odom»"),
            scaffold="{}",
            file="r.srdf",
            files=ROBOT,
            says="frame `/odom` of virtual joint `v` begins with a slash, with which tf2 does not find it",
        ),
    )
    good = (
        Good(
            VIRTUAL.format("fixed", "/odom"),
            scaffold="{}",
            file="r.srdf",
            files=ROBOT,
            why="MoveIt does not ask for the frame of a fixed one",
        ),
        Good(
            '<link name="left/arm"/><joint name="j" type="fixed"><parent link="base"/><child link="left/arm"/></joint>',
            why="inside of a name it is a letter as others",
        ),
    )

    @staticmethod
    def applies(part: Link | Semantics) -> bool:
        if isinstance(part, Link):
            return part.is_urdf and part.name.startswith("/")
        return any(True for _ in frames(part))

    def check(self, part: Link | Semantics) -> Iterator[Diagnostic]:
        end = "begins with a slash, with which tf2 does not find it"
        if isinstance(part, Link):
            yield self.diagnostic(part.name_value or part, f"{part.title} {end}")
            return
        for joint, frame in frames(part):
            yield self.diagnostic(frame, f"frame `{frame.text.strip()}` of virtual joint `{joint}` {end}")


def frames(semantics: Semantics) -> Iterator[tuple[str, Value]]:
    """The frames with a slash in which MoveIt plans, each with the name of its virtual joint."""
    for joint in semantics.element.children("virtual_joint"):
        frame = joint.attribute("parent_frame")
        if (
            frame is not None
            and frame.text.strip().startswith("/")
            and joint.get("type") in ("planar", "floating")
        ):
            yield joint.get("name") or "", frame
