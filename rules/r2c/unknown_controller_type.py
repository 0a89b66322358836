from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = (
    '<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="lift"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>'
)
PLUGIN = (
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<{}>controllers.yaml</parameters></plugin></gazebo>"
)
ROBOT, SOUND = BLOCK + PLUGIN.format("«parameters»"), BLOCK + PLUGIN.format("parameters")


def files(kind: str) -> dict[str, str]:
    return {"controllers.yaml": f"controller_manager: {{ros__parameters: {{states: {{type: {kind}}}}}}}\n"}


class UnknownControllerType(Rule):
    """A controller has a type that its package does not have.

    The controller manager says that the class does not exist, and does not load it. Mostly the type is that of ROS 1,
    such as `position_controllers/JointTrajectoryController`, or `joint_state_controller/JointStateController`, which
    Foxy was the last release to have. Looked at are the file that the simulator's plugin names, and packages of
    ros2_controllers.
    """

    code = "R2C047"
    name = "unknown-controller-type"
    severity = Severity.ERROR
    remedy = """Write a type of ROS 2, with its package.

    `ros2 control list_controller_types` lists those that are installed.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("ros2_control",)
    scaffold = IN_ROBOT
    sources = ("https://github.com/ros-controls/ros2_controllers",)

    bad = (
        Bad(
            ROBOT,
            files=files("joint_state_controller/JointStateController"),
            says="controller `states` in `controllers.yaml` has type `joint_state_controller/JointStateController`, "
            "which ROS 2 does not have",
        ),
        Bad(ROBOT, files=files("effort_controllers/JointTrajectoryController")),
        Bad(ROBOT, files=files("diff_drive_controller/DiffDriveControler")),
        Bad(ROBOT, files=files("joint_state_broadcasters/JointStateBroadcaster")),
    )
    good = (
        Good(SOUND, files=files("joint_state_broadcaster/JointStateBroadcaster")),
        Good(SOUND, files=files("my_controllers/JointStateController"), why="nothing is known about it"),
        Good(SOUND, files=files("$(var kind)"), why="it is written later"),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return any(True for _ in robot.strange_controllers)

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        for plugin, each in robot.strange_controllers:
            file = each.span.source.path.name
            yield self.diagnostic(
                plugin.file_of_controllers or plugin,
                f"controller `{each.owner}` in `{file}` has type `{each.name}`, which ROS 2 does not have",
                labels={each.span: "written here"},
                help=f"write `{each.meant}`",
            )
