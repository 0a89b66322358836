from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Link, Model, Rule, Severity, named

BODY = '<inertial><mass value="2"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
ROBOT = (
    f'<robot name="r"><link name="base">{BODY}</link>{{}}'
    '<joint name="j" type="fixed"><parent link="base"/><child link="tool"/></joint></robot>'
)


class DefaultMass(Rule):
    """A link has no `<inertial>`, and PyBullet gives it 1 kg.

    Links without mass are frames to others: they weigh nothing. In PyBullet every frame of a robot weighs 1 kg, also
    where `URDF_MERGE_FIXED_LINKS` makes it a part of another link. A light arm with a frame at its tip sags or needs
    many times its torque.
    """

    code = "PYB001"
    name = "default-mass"
    severity = Severity.WARNING
    remedy = """Give the link an `<inertial>` with a mass that does not matter, such as 1e-6 kg, and moments of 1e-9.

    A mass of 0 does as well on a fixed joint. `changeDynamics(robot, link, mass=0)` sets it after loading.
    """
    default = False
    looks_at = (Model,)
    scaffold = ROBOT
    sources = (
        "https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportURDFDemo/BulletUrdfImporter.cpp",
    )

    bad = (
        Bad('<«link» name="tool"/>', says="link `tool` without inertial gets 1 kg in PyBullet"),
        Bad(
            '<«link» name="tool"/><link name="eye"/>'
            '<joint name="k" type="fixed"><parent link="tool"/><child link="eye"/></joint>',
            says="links `tool` and `eye` without inertial get 1 kg each in PyBullet",
        ),
    )
    good = (
        Good('<link name="tool"><inertial><mass value="0"/></inertial></link>', why="weighs nothing"),
        Good(
            f'<robot name="r"><link name="world"/><link name="base">{BODY}</link>'
            '<joint name="j" type="fixed"><parent link="world"/><child link="base"/></joint></robot>',
            why="the robot is fixed to it",
            scaffold="",
        ),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return robot.is_urdf and any(map(is_weighed, robot.links))

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        first, *others = [link for link in robot.links if is_weighed(link)]
        names = named((link.name for link in (first, *others)), most=3)
        words = "links {} without inertial get 1 kg each" if others else "link {} without inertial gets 1 kg"
        message = f"{words.format(names)} in PyBullet"
        yield self.diagnostic(first, message, labels=dict.fromkeys(others, "the same"))


def is_weighed(link: Link) -> bool:
    """Does PyBullet choose its mass? Not that of what a robot is fixed to."""
    return not link.has("inertial") and link.name != "world"
