from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = (
    '<gazebo reference="a"><sensor name="imu" type="imu"/></gazebo><ros2_control name="s" type="system">'
    "<hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>"
    '<sensor name="{}"><state_interface name="orientation.x"/></sensor></ros2_control>'
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>c.yaml</parameters></plugin></gazebo>"
)


class UnknownSimulatedSensor(Rule):
    """A sensor in Gazebo's `ros2_control` has the name of no sensor of the robot in Gazebo.

    The hardware of Gazebo fills the interfaces of a sensor from the simulated one of the same name. Without it the
    sensor is skipped, and its broadcaster does not start.
    """

    code = "R2C036"
    name = "unknown-simulated-sensor"
    severity = Severity.WARNING
    remedy = """Give both sensors one name.

    The simulated one is the `<sensor>` in a `<gazebo reference="LINK">` block; the name of the link does not count.
    """
    looks_at = (ControlComponent,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.replace("{}", "«imu_sensor»"),
            says="robot `r` has no sensor `imu_sensor` in Gazebo; did you mean `imu`?",
            fixed=BLOCK.replace("{}", "imu"),
            unsafe=True,
        ),
    )
    good = (
        Good(BLOCK.replace("{}", "imu")),
        Good(BLOCK.replace("{}", "x").replace("gz_ros2_control/GazeboSimSystem", "my_robot/Hardware")),
    )

    @staticmethod
    def applies(component: ControlComponent) -> bool:
        return is_unknown(component)

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        names = simulated(component)
        near = component.nearest(component.name, names) or (names[0] if len(names) == 1 else None)
        message = f"{component.model.title} has no sensor `{component.name}` in Gazebo"
        yield self.diagnostic(component.name_value or component, message, meant=near)


def is_unknown(component: ControlComponent) -> bool:
    """Is it a sensor that Gazebo is to fill and does not have, in a robot all of whose sensors are known?"""
    if component.what != "sensor" or not component.name or "$" in component.name:
        return False
    return component.block.is_simulated and component.sensor is None and bool(simulated(component))


def simulated(component: ControlComponent) -> list[str]:
    """The names of the sensors that the robot has in Gazebo."""
    return [sensor.name for block in component.model.gazebo_blocks for sensor in block.sensors if sensor.name]
