from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Link, Rule, Severity
from sdfcheck_rules.urd.colon_in_comment import is_description

MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
JOINT = '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint></robot>'


class RootWithInertia(Rule):
    """The root link has mass, which KDL drops.

    robot_state_publisher and other users of KDL print a warning at every start, and what they
    compute is without that mass. For simulators the robot is correct. In a robot that does
    not move, or shows nothing of ROS, this is a hint.
    """

    code = "URD008"
    name = "root-with-inertia"
    severity = Severity.WARNING
    remedy = """Put an empty link above the root, with a fixed joint between them.

    ```xml
    <link name="base_footprint"/>
    <joint name="base_footprint_joint" type="fixed">
      <parent link="base_footprint"/>
      <child link="base_link"/>
    </joint>
    ```

    A robot that is never used with KDL needs nothing. Do not take the mass away: simulators need it.
    """
    looks_at = (Link,)
    selects = ("urdf:robot/link",)

    bad = (
        Bad(
            f'<robot name="r"><link name="a">{MASS.replace("inertial", "«inertial»", 1)}</link>'
            f'<link name="b">{MASS}</link>{JOINT}',
            says="root link `a` has mass, which KDL drops",
        ),
    )
    good = (
        Good(f'<robot name="r"><link name="a"/><link name="b">{MASS}</link>{JOINT}', why="an empty root"),
        Good(f'<robot name="r"><link name="a">{MASS}</link></robot>', why="a thing, not a chain of links"),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        # A root called `world` is the world; one of a second tree is an error of its own, or follows from one.
        if link.name == "world" or not link.has_mass:
            return False
        return bool(link.child_joints) and link.model.tree.is_whole and link not in link.model.tree.parents

    def check(self, link: Link) -> Iterator[Diagnostic]:
        message = f"root {link.title} has mass, which KDL drops"
        moves = any(joint.moves for joint in link.model.joints)
        severity = None if moves and is_description(link.root) else Severity.INFO
        yield self.diagnostic(link.inertial, message, labels={link: "the root"}, severity=severity)
