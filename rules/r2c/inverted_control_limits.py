from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_LIFT


class InvertedControlLimits(Rule):
    """The minimum of an interface is above its maximum, or both are the same number.

    ros2_control never compares the two: no command is within the limits, and for velocity and effort
    the smaller magnitude counts in both directions. With the same number twice one command is left, which
    is a warning; a joint that is locked at 0 is meant.
    """

    code = "R2C021"
    name = "inverted-control-limits"
    severity = Severity.ERROR
    remedy = "Exchange the minimum and the maximum, or correct the sign that was lost."
    looks_at = (ControlInterface,)
    scaffold = IN_LIFT

    bad = (
        Bad(
            '<command_interface name="position"><param name="min">«1»</param><param name="max">-1</param>'
            "</command_interface>",
            says="`min` 1 of `position` is above `max` -1",
        ),
        Bad(
            '<command_interface name="position"><param name="min">«-1»</param><param name="max">-1</param>'
            "</command_interface>",
            says="`min` and `max` of `position` are both -1",
        ),
    )
    good = (
        Good(
            '<command_interface name="position"><param name="min">0</param><param name="max">0</param>'
            "</command_interface>",
            why="locked on purpose",
        ),
    )

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        low, high = interface.minimum.number, interface.maximum.number
        return low > high or low == high != 0

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        low, high = interface.minimum, interface.maximum
        message, severity = f"`min` {low.text} of `{interface.name}` is above `max` {high.text}", None
        if low.number == high.number:
            message = f"`min` and `max` of `{interface.name}` are both {low.text}, which leaves one command"
            severity = Severity.WARNING
        yield self.diagnostic(low, message, labels={high: "the maximum"}, severity=severity)
