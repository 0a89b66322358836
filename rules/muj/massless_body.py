from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Link, Rule, Severity
from sdfcheck_rules.muj.mass import is_massless

JOINT = '<joint name="j" type="{}"><parent link="base"/><child link="arm"/></joint>'
INERTIAL = (
    '<inertial><mass value="1"/><inertia ixx="{0}" iyy="{0}" izz="{0}" ixy="0" ixz="0" iyz="0"/></inertial>'
)
BOX = '<collision><geometry><box size="1 1 1"/></geometry></collision>'


class MasslessBody(Rule):
    """A link that moves has no mass or no moments of inertia, and nothing fixed to it has.

    MuJoCo refuses the robot. A link without `inertial` is weighed by its collisions, so one
    with both missing counts; links that do not move need no mass.
    """

    code = "MUJ003"
    name = "massless-body"
    severity = Severity.ERROR
    remedy = """Give the link an `<inertial>` with its mass and moments.

    `sdfcheck rule missing-inertial` says how to get the numbers. For a link that only splits a motion, a
    hundredth of the next link's mass is enough;
    `<mujoco><compiler boundmass="1e-4" boundinertia="1e-7"/></mujoco>` sets lower bounds for all.
    """
    default = False
    looks_at = (Link,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<«link» name="arm"/>' + JOINT.format("continuous"),
            says="link `arm` moves by joint `j` and has no mass or no inertia",
        ),
        Bad(
            f'<«link» name="arm">{INERTIAL.format("0")}</link>' + JOINT.format("continuous"),
            says="link `arm` moves by joint `j` and has no mass or no inertia",
            also=("URD013",),
        ),
    )
    good = (
        Good(f'<link name="arm">{INERTIAL.format("1")}</link>' + JOINT.format("continuous")),
        Good(f'<link name="arm">{BOX}</link>' + JOINT.format("continuous"), why="weighed by its box"),
        Good('<link name="arm"/>' + JOINT.format("fixed"), why="does not move"),
    )

    @staticmethod
    def applies(link: Link) -> bool:
        return link.is_urdf and is_massless(link)

    def check(self, link: Link) -> Iterator[Diagnostic]:
        joint = link.parent_joints[0]
        message = (
            f"{link.title} moves by {joint.title} and has no mass or no inertia: MuJoCo refuses the file"
        )
        yield self.diagnostic(link, message, labels={joint: "it moves here"})
