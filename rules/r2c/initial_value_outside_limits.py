from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_LIFT

IN_GAZEBO = (
    IN_LIFT.replace("mock_components/GenericSystem", "gz_ros2_control/GazeboSimSystem")
    .replace('lower="0"', 'lower="0.3"')
    .replace(
        "</robot>",
        '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
        "<parameters>c.yaml</parameters></plugin></gazebo></robot>",
    )
)


class InitialValueOutsideLimits(Rule):
    """A joint starts at a position outside of its limits.

    The initial value of its state is below the lower limit of the joint, or above the upper one. Simulators
    start there anyway, and controllers push it back or stop. Without an initial value a joint in Gazebo starts at 0,
    which its limits may exclude: MoveIt then plans nothing, for the first state is outside of its bounds.
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
        Bad(
            '<state_interface name="«position»"/>',
            scaffold=IN_GAZEBO,
            says="joint `lift` has no `initial_value` and starts at 0, outside of its limits 0.3 and 1",
        ),
    )
    good = (
        Good('<state_interface name="position"><param name="initial_value">1</param></state_interface>'),
        Good('<state_interface name="velocity"><param name="initial_value">2</param></state_interface>'),
        Good(
            '<state_interface name="position"/>',
            scaffold=IN_LIFT.replace('lower="0"', 'lower="0.3"'),
            why="the hardware knows where the joint is",
        ),
    )

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        joint = interface.component.joint
        if joint is None or interface.is_command or interface.name != "position" or joint.axis_count != 1:
            return False
        low, high = joint.axis.limit.range
        start = interface.initial.number
        if not interface.initial.is_given and interface.component.block.is_simulated and low < high:
            start = 0.0
        return start < low - CLOSE or start > high + CLOSE

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        joint, initial, name = interface.component.joint, interface.initial, interface.name_value
        assert joint is not None
        assert name is not None
        limit = joint.axis.limit
        low, high = limit.lower.text or "0", limit.upper.text or "0"
        start = f"starts at {initial.text}" if initial.is_given else "has no `initial_value` and starts at 0"
        message = f"{joint.title} {start}, outside of its limits {low} and {high}"
        yield self.diagnostic(initial if initial.is_given else name, message, labels={limit: "its limits"})


CLOSE = 1e-3
"""So little outside (rad or m) is rounding, which a controller and MoveIt take."""
