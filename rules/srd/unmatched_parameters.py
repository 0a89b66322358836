from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Semantics, Severity
from sdfcheck_rules.srd.scaffold import FILE, ROBOT

SRDF = '<«robot» name="arm"><group name="all"><chain base_link="base" tip_link="hand"/></group></robot>'
SOUND = SRDF.translate({ord("«"): None, ord("»"): None})
MANIFEST = {
    "package.xml": "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
}
SENT = (
    "moveit_simple_controller_manager:\n  controller_names: [{0}]\n  {0}:\n    type: FollowJointTrajectory\n"
    "    action_ns: a\n    joints: [{1}]\n"
)
STARTED = (
    "controller_manager:\n  ros__parameters:\n    arm_controller: {type: "
    "joint_trajectory_controller/JointTrajectoryController}\narm_controller:\n  ros__parameters:\n"
    "    joints: [shoulder]\n"
)
SOLVER = "{}:\n  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n"
LIMIT = "joint_limits:\n  {}:\n    has_velocity_limits: true\n    max_velocity: 1.0\n"


def files(**texts: str) -> dict[str, str]:
    return ROBOT | MANIFEST | {f"config/{name}.yaml": text for name, text in texts.items()}


class UnmatchedParameters(Rule):
    """A file of MoveIt's parameters names a joint, group or controller that is not there, or allows a joint too much.

    MoveIt says nothing of what it does not look for: limits of joints that are called otherwise, such as without their
    prefix, are not kept, and a group whose solver is under another name has no inverse kinematics. Trajectories go to a
    controller by its name: where the controller manager starts another one for these joints, MoveIt waits for it in
    vain and does not move the robot. Nor does it where no controller has a joint of the group that is planned for.
    Nor does it read a parameter or load a plugin whose name is misspelled.
    Speeds and positions take the place of those of the robot, also where they are beyond them: MoveIt plans what the
    joint cannot do.
    Looked at are the files in the package of the only SRDF file of it, for ROS 2.
    """

    code = "SRD015"
    name = "unmatched-parameters"
    severity = Severity.WARNING
    remedy = """Give the joints, groups and controllers one name in all files of the package.

    Limits are those of the robot, or stricter.
    """
    looks_at = (Semantics,)
    scaffold = "{}"

    bad = (
        Bad(
            SRDF,
            file=FILE,
            files=files(joint_limits=LIMIT.format("left_shoulder")),
            says="`joint_limits.yaml` limits joint `left_shoulder`, which robot `arm` does not have",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(joint_limits=LIMIT.format("wrist") + LIMIT.format("shouldr").partition("\n")[2]),
            says="limits joint `shouldr`, which robot `arm` does not have; there is `shoulder`",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(kinematics=SOLVER.format("all").replace("cs_solver", "cs_slover")),
            says="`kinematics.yaml` has `kinematics_slover` for group `all`, and MoveIt reads `kinematics_solver`",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(joint_limits=LIMIT.format("shoulder").replace("1.0", "2.618")),
            says="`joint_limits.yaml` has `max_velocity` 2.618 for joint `shoulder`, which has 2",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(kinematics=SOLVER.format("arm")),
            says="`kinematics.yaml` has a solver for group `arm`, and group `all` has none",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(
                moveit_controllers=SENT.format("all_controller", "shoulder"), ros2_controllers=STARTED
            ),
            says="to `all_controller`, and the controller of these joints in `ros2_controllers.yaml` is `arm_cont",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(moveit_controllers=SENT.format("c", "elbow")),
            says="sends joint `elbow`",
        ),
        Bad(
            SRDF,
            file=FILE,
            files=files(servo="move_group_name: panda_arm\nee_frame_name: hand\n"),
            says="`servo.yaml` names group `panda_arm` in `move_group_name`, which is not there",
        ),
    )
    good = (
        Good(
            SOUND,
            file=FILE,
            files=files(
                joint_limits=LIMIT.format("shoulder") + "    max_position: 0.9\n",
                kinematics=SOLVER.format("all"),
                moveit_controllers=SENT.format("arm_controller", "shoulder"),
                ros2_controllers=STARTED,
            ),
        ),
        Good(
            SOUND,
            file=FILE,
            files=files(moveit_controllers=SENT.format("c", "shoulder")),
            why="the driver of the robot may start it",
        ),
    )

    @staticmethod
    def applies(semantics: Semantics) -> bool:
        return bool(semantics.beside) and any(True for _ in semantics.unmatched_parameters)

    def check(self, semantics: Semantics) -> Iterator[Diagnostic]:
        for words, span in semantics.unmatched_parameters:
            message = f"`{span.source.path.name}` {words}"
            yield self.diagnostic(semantics, message, labels={span: "written here"})
