from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_LIFT


class InitialValueOutsideLimits(Rule):
    """A joint starts at a position outside of its limits.

    The initial value of its state is below the lower limit of the joint, or above the upper one. Simulators
    start there anyway, and controllers push it back or stop.
    """

    code = "R2C022"
    name = "initial-value-outside-limits"
    severity = Severity.WARNING
    remedy = """Write an initial value between the limits of the joint.

    For a joint that cannot be at 0, choose the middle of its range. The parameter is in rad or m.
    """
    looks_at = (ControlInterface,)
    scaffold = IN_LIFT

    bad = (
        Bad(
            '<state_interface name="position"><param name="initial_value">«2»</param></state_interface>',
            says="joint `lift` starts at 2, outside of its limits 0 and 1",
        ),
    )
    good = (
        Good('<state_interface name="position"><param name="initial_value">1</param></state_interface>'),
        Good('<state_interface name="velocity"><param name="initial_value">2</param></state_interface>'),
    )

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        joint = interface.component.joint
        if joint is None or interface.is_command or interface.name != "position" or joint.axis_count != 1:
            return False
        low, high = joint.axis.limit.range
        return interface.initial.number < low or interface.initial.number > high

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        joint = interface.component.joint
        assert joint is not None
        limit = joint.axis.limit
        low, high = limit.lower.text or "0", limit.upper.text or "0"
        message = f"{joint.title} starts at {interface.initial.text}, outside of its limits {low} and {high}"
        yield self.diagnostic(interface.initial, message, labels={limit: "its limits"})
