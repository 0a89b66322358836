from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity, suggest
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = (
    '<gazebo reference="a"><sensor name="imu" type="imu"/></gazebo><ros2_control name="s" type="system">'
    "<hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>"
    '<sensor name="imu"><state_interface name="{}"/></sensor></ros2_control>'
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>c.yaml</parameters></plugin></gazebo>"
)
IMU = frozenset(
    f"{what}.{axis}"
    for what, axes in (("orientation", "xyzw"), ("angular_velocity", "xyz"), ("linear_acceleration", "xyz"))
    for axis in axes
)


def is_near(name: str) -> bool:
    """Is a name misspelled, so that another rule reports it?"""
    return suggest(name.replace(".", "_"), {each.replace(".", "_") for each in IMU}) is not None


class UnknownImuInterface(Rule):
    """An inertial sensor in Gazebo's `ros2_control` has an interface that it does not know.

    Gazebo's hardware reads `orientation`, `angular_velocity` and `linear_acceleration` with `.x`, `.y`, `.z` and,
    for the orientation, `.w`. Another name of a sensor of type `imu` makes it fail.
    """

    code = "R2C026"
    name = "unknown-imu-interface"
    severity = Severity.ERROR
    remedy = """Write one that Gazebo fills, such as `orientation.x` or `angular_velocity.x`.

    The third is `linear_acceleration.x`; all have `.y` and `.z` as well. The orientation is a quaternion
    with `.x`, `.y`, `.z` and `.w`: yaw is computed from it. If another hardware than Gazebo's fills the
    interface, it belongs in a block of its own.
    """
    looks_at = (ControlInterface,)
    scaffold = IN_ROBOT

    bad = (
        Bad(BLOCK.replace("{}", "«yaw»"), says="sensor `imu` of type `imu` has no interface `yaw` in Gazebo"),
    )
    good = (
        Good(BLOCK.replace("{}", "orientation.w")),
        Good(BLOCK.replace("{}", "yaw").replace('type="imu"', 'type="air_pressure"')),
    )

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        component = interface.component
        if (
            component.sensor is None
            or interface.is_command
            or interface.name in IMU
            or not interface.is_readable
        ):
            return False
        return component.sensor.type == "imu" and component.block.is_simulated and not is_near(interface.name)

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        sensor, name = interface.component.sensor, interface.name_value
        assert sensor is not None
        assert name is not None
        message = f"{sensor.title} of type `imu` has no interface `{interface.name}` in Gazebo"
        yield self.diagnostic(name, message, labels={sensor: "the sensor"})
