from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Link, Rule, Severity

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
ROBOT = (
    f'<robot name="r">{{}}<link name="arm">{INERTIAL}</link>'
    '<joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint></robot>'
)
KEPT = '<mujoco><compiler fusestatic="false"/></mujoco>'


class FusedRoot(Rule):
    """The root link has mass, and MuJoCo makes it a part of the world.

    In URDF MuJoCo welds the root to the world and fuses it with it: there is no body of its
    name, and the robot cannot float or fall.
    """

    code = "MUJ005"
    name = "fused-root"
    severity = Severity.WARNING
    remedy = """Keep it with `<mujoco><compiler fusestatic="false"/></mujoco>` in the robot.

    A robot that is bolted to the floor needs nothing: its root does not move. For a robot that walks,
    drives or floats, add a link `world` above the root and a floating joint between them, in a file for
    MuJoCo alone: libsdformat drops floating joints.
    """
    default = False
    looks_at = (Link,)
    scaffold = ROBOT

    bad = (
        Bad(
            f'<«link» name="base">{INERTIAL}</link>',
            says="root link `base` becomes a part of the world in MuJoCo",
        ),
    )
    good = (
        Good(f'{KEPT}<link name="base">{INERTIAL}</link>'),
        Good('<link name="base"/>', why="nothing is lost"),
        Good("", scaffold=IN_ROBOT, why="without joints"),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        if not link.is_urdf or link.name == "world" or not link.has_mass or not link.child_joints:
            return False
        return link in link.model.tree.main_roots and not is_kept(link)

    def check(self, link: Link) -> Iterator[Diagnostic]:
        message = f"root {link.title} becomes a part of the world in MuJoCo"
        yield self.diagnostic(link, message)


def is_kept(link: Link) -> bool:
    """Does the robot tell MuJoCo not to fuse what does not move?"""
    compilers = (each for block in link.model.children("mujoco") for each in block.children("compiler"))
    return any(each.attributes.get("fusestatic", "").strip().lower() == "false" for each in compilers)
