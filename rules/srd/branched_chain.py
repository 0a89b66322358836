from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, IN_SRDF, ROBOT

FINGER = (
    '<link name="{0}"/><joint name="{0}_joint" type="prismatic"><parent link="hand"/><child link="{0}"/>'
    '<axis xyz="0 1 0"/><limit lower="0" upper="0.1" effort="9" velocity="1"/></joint>'
)
GRIPPER = ROBOT | {
    "arm.urdf": ROBOT["arm.urdf"].replace(
        "</robot>", FINGER.format("left") + FINGER.format("right") + "</robot>"
    )
}
SOLVER = "{}:\n  kinematics_solver: {}\n  kinematics_solver_timeout: 0.05\n"
KDL = "kdl_kinematics_plugin/KDLKinematicsPlugin"
JOINTS = (
    '<group name="{}"><joint name="shoulder"/><joint name="left_joint"/><joint name="right_joint"/></group>'
)


class BranchedChain(Rule):
    """A group is solved as a chain, and its joints branch.

    The solver of KDL, which MoveIt's assistant enters for every group, takes joints that follow each other from one
    link to another. For a group with the fingers of its gripper, or with two arms, MoveIt says "Group is not a chain"
    and has no inverse kinematics: goals cannot be given as poses, and RViz has no marker to drag.
    """

    code = "SRD013"
    name = "branched-chain"
    severity = Severity.WARNING
    remedy = """Let the group end at one link, and give the gripper a group of its own.

    `<chain base_link="…" tip_link="…"/>` is such a group. Or remove the solver of the group from `kinematics.yaml`, if
    its joints alone are to be planned.
    """
    looks_at = (Semantics,)
    scaffold = IN_SRDF

    bad = (
        Bad(
            JOINTS.format("«body»"),
            file=FILE,
            files=GRIPPER | {"kinematics.yaml": SOLVER.format("body", KDL)},
            says="group `body` is solved as a chain, and its joints `left_joint` and `right_joint` branch",
        ),
    )
    good = (
        Good(
            '<group name="body"><chain base_link="base" tip_link="left"/></group>',
            file=FILE,
            files=GRIPPER | {"kinematics.yaml": SOLVER.format("body", KDL)},
        ),
        Good(JOINTS.format("body"), file=FILE, files=GRIPPER, why="nothing solves it"),
        Good(
            JOINTS.format("body"),
            file=FILE,
            files=GRIPPER | {"kinematics.yaml": SOLVER.format("body", "bio_ik/BioIKKinematicsPlugin")},
            why="a solver for trees",
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return bool(semantics.chained) and any(True for _ in semantics.branched_chains)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for value, one, other in semantics.branched_chains:
            message = f"group `{value.text.strip()}` is solved as a chain, and its joints `{one}` and `{other}` branch"
            yield self.diagnostic(value, message)
