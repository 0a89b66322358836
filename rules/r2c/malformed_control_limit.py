from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_LIFT


class MalformedControlLimit(Rule):
    """The minimum, maximum or initial value of an interface is not a number.

    From jazzy on the limits of an interface with such a text are ignored, with a note on the terminal. An
    initial value that is not a number makes the hardware fail when it is loaded: that is an error.
    """

    code = "R2C020"
    name = "malformed-control-limit"
    severity = Severity.WARNING
    remedy = """Write one number with a decimal point, in SI units.

    Positions are in rad or m, velocities in rad/s or m/s. An expression such as `${pi/2}` works only where
    xacro expands it.
    """
    looks_at = (ControlInterface,)
    scaffold = IN_LIFT

    bad = (
        Bad(
            '<command_interface name="position"><param name="min">«low»</param></command_interface>',
            says="`min` of `position` should be a number, not `low`: ros2_control ignores this limit",
        ),
        Bad(
            '<state_interface name="position"><param name="initial_value">«1,5»</param></state_interface>',
            says="`initial_value` of `position` should be a number, not `1,5`",
        ),
    )
    good = (
        Good('<command_interface name="position"><param name="min">-1e3</param></command_interface>'),
        Good(
            '<state_interface name="position"><param name="initial_value"/></state_interface>',
            why="not a number yet",
        ),
        Good(
            '<state_interface name="on" data_type="bool"><param name="initial_value">true</param></state_interface>'
        ),
    )

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        return bool(interface.malformed)

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        for name, number in interface.malformed:
            message = f"`{name}` of `{interface.name}` should be a number, not `{number.text}`"
            is_limit = name != "initial_value"
            message += ": ros2_control ignores this limit" if is_limit else ""
            yield self.diagnostic(number, message, severity=None if is_limit else Severity.ERROR)
