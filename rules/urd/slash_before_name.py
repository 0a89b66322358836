from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Link, Rule, Severity


class SlashBeforeName(Rule):
    """The name of a link begins with a slash.

    tf2 keeps its frame without the slash, and refuses to look up one with it: RViz and MoveIt, which ask by
    the name in the description, do not find it. ROS 1 leaves `tf_prefix` away from such a name, too.
    """

    code = "URD021"
    name = "slash-before-name"
    severity = Severity.WARNING
    remedy = """Remove the slash from the name, and from the joints that name it.

    A namespace for a robot is the `frame_prefix` of robot_state_publisher, or a prefix in the macros of
    xacro.
    """
    sources = ("https://wiki.ros.org/tf2/Migration",)
    looks_at = (Link,)
    selects = ("urdf:robot/link",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<link name="«/arm»"/><joint name="j" type="fixed"><parent link="base"/><child link="/arm"/></joint>',
            says="link `/arm` begins with a slash, with which tf2 does not find it",
        ),
    )
    good = (
        Good(
            '<link name="left/arm"/><joint name="j" type="fixed"><parent link="base"/><child link="left/arm"/></joint>',
            why="inside of a name it is a letter as others",
        ),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return link.name.startswith("/")

    def check(self, link: Link) -> Iterator[Diagnostic]:
        message = f"{link.title} begins with a slash, with which tf2 does not find it"
        yield self.diagnostic(link.name_value or link, message)
