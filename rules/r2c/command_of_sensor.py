from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import HARDWARE, IN_BLOCK, IN_ROBOT


class CommandOfSensor(Rule):
    """A sensor in `ros2_control` has a command interface.

    The parser ignores commands of a `sensor`. A joint or other signal with commands in a block of type
    `sensor` is never given any: the controller manager
    misses the interface and does not start, so that no hardware of the robot runs.
    """

    code = "R2C023"
    name = "command-of-sensor"
    severity = Severity.ERROR
    remedy = "Make it a state interface, or move the joint to a block of type `system` or `actuator`."
    looks_at = (ControlInterface,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            '<sensor name="imu"><«command_interface» name="reset"/></sensor>',
            says="sensor `imu` has a command interface, which is ignored",
        ),
        Bad(
            f'<ros2_control name="s" type="sensor">{HARDWARE}<gpio name="io">'
            '<«command_interface» name="on"/></gpio></ros2_control>',
            scaffold=IN_ROBOT,
            says="ros2_control `s` is a sensor and takes no commands",
        ),
    )
    good = (Good('<sensor name="imu"><state_interface name="orientation.x"/></sensor>'),)

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        component = interface.component
        return interface.is_command and "sensor" in {component.what, component.block.type}

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        component = interface.component
        if component.what == "sensor":
            message = f"{component.title} has a command interface, which is ignored"
            yield self.diagnostic(interface, message, severity=Severity.WARNING)
        else:
            yield self.diagnostic(interface, f"{component.block.title} is a sensor and takes no commands")
