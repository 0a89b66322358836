from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_LIFT


class DoubledControlInterface(Rule):
    """An interface is listed twice for one joint, sensor or group of signals.

    The second is ignored in silence, its parameters and limits with it.
    """

    code = "R2C013"
    name = "doubled-control-interface"
    severity = Severity.WARNING
    remedy = "Remove one of them, and keep the parameters and limits that are meant in the other."
    looks_at = (ControlInterface,)
    scaffold = IN_LIFT

    bad = (
        Bad(
            '<state_interface name="position"/><state_interface name="«position»"/>',
            says="`state_interface` `position` is listed twice in joint `lift`",
        ),
    )
    good = (Good('<command_interface name="position"/><state_interface name="position"/>'),)

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        return interface.twin is not None

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        twin, name = interface.twin, interface.name_value
        assert twin is not None
        assert twin.name_value is not None
        assert name is not None
        message = (
            f"`{interface.element.name}` `{interface.name}` is listed twice in {interface.component.title}"
        )
        yield self.diagnostic(name, message, labels={twin.name_value: "first listed here"})
