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
FINGER = "position_controllers/GripperActionController"
CAR = "ackermann_steering_controller/AckermannSteeringController"


def files(kind: str, parameters: str) -> dict[str, str]:
    return {"controllers.yaml": f"hand: {{ros__parameters: {{type: {kind}, {parameters}}}}}\n"}


class MisspelledControlParameter(Rule):
    """A controller gets a parameter that it does not read, and lacks one of nearly the same name.

    ROS 2 says nothing about a parameter that no node declares: the controller takes its default for the one that was
    meant, which is an empty list or 0, or is not loaded. So it is with the words around them, `controller_manager`,
    `ros__parameters`, `type`. Looked at is the file that the simulator's plugin names, and controllers whose parameters
    are known.
    """

    code = "R2C044"
    name = "misspelled-control-parameter"
    severity = Severity.WARNING
    remedy = "Write the name that the message gives."
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("ros2_control",)
    scaffold = IN_ROBOT
    sources = ("https://github.com/ros-controls/ros2_controllers",)

    bad = (
        Bad(
            ROBOT,
            files=files(FINGER, "joints: [lift]"),
            says="`hand` in `controllers.yaml` has `joints`, and a GripperActionController reads `joint`",
        ),
        Bad(
            ROBOT,
            files=files(CAR, "wheel_base: 0.3"),
            says="and an AckermannSteeringController reads `wheelbase`",
        ),
        Bad(
            ROBOT,
            files={"controllers.yaml": "controller_manager:\n  ros_parameters: {update_rate: 100}\n"},
            says="`controller_manager` in `controllers.yaml` has `ros_parameters`, and ROS 2 reads `ros__parameters`",
        ),
        Bad(
            ROBOT,
            files={"controllers.yaml": "controller_manger:\n  ros__parameters: {update_rate: 100}\n"},
            says="`controllers.yaml` has `controller_manger`, and the plugin of the simulator reads `controller_man",
        ),
    )
    good = (
        Good(SOUND, files=files(FINGER, "joint: lift")),
        Good(
            SOUND, files=files(FINGER, "joint: lift, joints: [lift]"), why="the other name is there as well"
        ),
        Good(SOUND, files=files("my_controllers/Own", "joints: [lift]"), why="nothing is known about it"),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return any(True for _ in robot.misspelled_parameters)

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        for plugin, each in robot.misspelled_parameters:
            where = f"`{each.owner}` in " * bool(each.owner) + f"`{each.span.source.path.name}`"
            message = f"{where} has `{each.name}`, and {each.reader} reads `{each.meant}`"
            yield self.diagnostic(
                plugin.file_of_controllers or plugin, message, labels={each.span: "written here"}
            )
