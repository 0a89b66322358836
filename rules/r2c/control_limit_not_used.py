from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_LIFT


class ControlLimitNotUsed(Rule):
    """A minimum or maximum of an interface limits nothing.

    From jazzy on only the commands of a joint called position, velocity, effort, acceleration and jerk have
    limits. On states, and on interfaces of other names, they are ignored.
    """

    code = "R2C031"
    name = "control-limit-not-used"
    severity = Severity.INFO
    remedy = "Move the limit to the command interface that it is to limit, or remove it."
    default = False
    looks_at = (ControlInterface,)
    scaffold = IN_LIFT

    bad = (
        Bad(
            '<state_interface name="position"><«param» name="min">0</param></state_interface>',
            says="`min` of `position` limits nothing: only commands have limits",
        ),
        Bad(
            '<command_interface name="stiffness"><«param» name="max">9</param></command_interface>',
            says="`max` of `stiffness` limits nothing",
        ),
    )
    good = (Good('<command_interface name="position"><param name="min">0</param></command_interface>'),)

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        if interface.component.what != "joint" or interface.is_limited:
            return False
        return interface.minimum.is_given or interface.maximum.is_given

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        for name in ("min", "max"):
            element = interface.parameter(name)
            if element is not None:
                why = (
                    "only commands have limits"
                    if not interface.is_command
                    else "ros2_control knows no such limit"
                )
                yield self.diagnostic(element, f"`{name}` of `{interface.name}` limits nothing: {why}")
