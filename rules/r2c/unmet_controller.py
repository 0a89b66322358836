from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Rule, Severity, suggest
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

PLUGIN = (
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<{}>controllers.yaml</parameters></plugin></gazebo>"
)
BLOCK = (
    '<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="lift"><command_interface name="position"/><state_interface name="position"/></joint>'
    '<sensor name="imu"><state_interface name="orientation.x"/></sensor></ros2_control>'
)
ROBOT = PLUGIN.format("«parameters»") + BLOCK
SOUND = PLUGIN.format("parameters") + BLOCK
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
GROUP = "position_controllers/JointGroupPositionController"
HAND = f"hand: {{ros__parameters: {{type: {GROUP}, joints: [tuner]}}}}\n"
IMU = "imu_sensor_broadcaster/IMUSensorBroadcaster"


def files(kind: str, parameters: str) -> dict[str, str]:
    return {"controllers.yaml": f"arm_controller: {{ros__parameters: {{type: {kind}, {parameters}}}}}\n"}


class UnmetController(Rule):
    """A controller asks for a joint or sensor that no `ros2_control` block of the robot has.

    Looked at are the files that the simulator's plugin names. When the controller is started, the controller manager
    says that its interfaces do not exist, and the controller stays inactive: commands do nothing.
    """

    code = "R2C041"
    name = "unmet-controller"
    severity = Severity.WARNING
    remedy = (
        "Correct the name in the file of parameters, or add the joint or sensor to a `ros2_control` block."
    )
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("ros2_control",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            ROBOT,
            files=files(
                TRAJECTORY, "joints: [lfit], command_interfaces: [position], state_interfaces: [position]"
            ),
            says="`arm_controller` of `controllers.yaml` asks for joint `lfit`, which no `ros2_control` block of "
            "robot `r` has; there is `lift`",
        ),
        Bad(ROBOT, files=files("velocity_controllers/JointGroupVelocityController", "joints: [wheel]")),
        Bad(
            ROBOT.replace(
                "</joint>", "</joint><joint name='turner'><command_interface name='position'/></joint>"
            ),
            files={"controllers.yaml": f"{files(GROUP, 'joints: [lift]')['controllers.yaml']}{HAND}"},
            says="`hand` of `controllers.yaml` asks for joint `tuner`, which no `ros2_control` block of robot `r` has",
            also=("URD012",),
        ),
        Bad(
            ROBOT,
            files=files(IMU, "sensor_name: imu_sensor, frame_id: imu"),
            says="asks for sensor `imu_sensor`",
        ),
    )
    good = (
        Good(
            SOUND,
            files=files(
                TRAJECTORY, "joints: [lift], command_interfaces: [position], state_interfaces: [position]"
            ),
        ),
        Good(
            SOUND,
            files=files(TRAJECTORY, "joints: [$(var prefix)lift]"),
            why="the launch file gives the name",
        ),
        Good(SOUND, files=files("my_controllers/Own", "joints: [all]"), why="nothing is known about it"),
        Good(SOUND, files=files(IMU, "sensor_name: imu, frame_id: imu")),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return any(True for _ in robot.unmet_needs)

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        seen = set()
        for plugin, need in robot.unmet_needs:
            if need.controller in seen:
                continue
            seen.add(need.controller)
            near = suggest(need.name, robot.control_joints) if need.what == "joint" else None
            message = (
                f"`{need.controller}` of `{need.span.source.path.name}` asks for {need.what} `{need.name}`, which no "
                f"`ros2_control` block of {robot.title} has{f'; there is `{near}`' if near else ''}"
            )
            yield self.diagnostic(
                next(plugin.children("parameters")), message, labels={need.span: "asked for here"}
            )
