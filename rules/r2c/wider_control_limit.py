from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_LIFT


class WiderControlLimit(Rule):
    """A limit in `ros2_control` is wider than that of the joint, and has no effect.

    From jazzy on the stricter of both counts: for a position that of the joint's `limit`, for velocity and effort
    the smallest of all.
    """

    code = "R2C032"
    name = "wider-control-limit"
    severity = Severity.INFO
    remedy = """Write a limit that is stricter than that of the joint, or remove it.

    If the joint is the one that is too strict, raise the `<limit>` of the joint in the robot: planners read
    that one.
    """
    default = False
    looks_at = (ControlInterface,)
    scaffold = IN_LIFT

    bad = (
        Bad(
            '<command_interface name="position"><param name="max">«2»</param></command_interface>',
            says="`max` 2 of `position` has no effect: the limit of joint `lift` is 1",
        ),
        Bad('<command_interface name="velocity"><param name="min">«-3»</param></command_interface>'),
    )
    good = (Good('<command_interface name="position"><param name="max">1</param></command_interface>'),)

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        return any(True for _ in interface.widened)

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        joint = interface.component.joint
        assert joint is not None
        for name, number, limit in interface.widened:
            message = f"`{name}` {number.text} of `{interface.name}` has no effect"
            message += f": the limit of {joint.title} is {limit.text}"
            yield self.diagnostic(number, message, labels={limit: "the limit"})
