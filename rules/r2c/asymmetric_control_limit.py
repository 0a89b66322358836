from collections.abc import Iterator

from sdfcheck import Bad, ControlInterface, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_LIFT


class AsymmetricControlLimit(Rule):
    """The minimum and maximum of a velocity or effort differ in their magnitude.

    ros2_control takes such limits to be symmetric: from jazzy on the smaller of both magnitudes counts in
    both directions.
    """

    code = "R2C033"
    name = "asymmetric-control-limit"
    severity = Severity.WARNING
    remedy = """Write the same magnitude for both: `min` is `-max`.

    Where the two directions really differ, the weaker one has to hold for both; limit the stronger one in
    the controller.
    """
    default = False
    looks_at = (ControlInterface,)
    scaffold = IN_LIFT

    bad = (
        Bad(
            '<command_interface name="velocity"><param name="min">«-1»</param><param name="max">2</param>'
            "</command_interface>",
            says="the limits -1 and 2 of `velocity` become -1 and 1",
        ),
    )
    good = (
        Good(
            '<command_interface name="velocity"><param name="min">-2</param><param name="max">2.0</param>'
            "</command_interface>"
        ),
    )

    @staticmethod
    def applies(interface: ControlInterface) -> bool:
        if not interface.is_limited or interface.name not in {"velocity", "effort"}:
            return False
        low, high = interface.minimum, interface.maximum
        return (
            low.is_given
            and high.is_given
            and low.number <= high.number
            and abs(low.number + high.number) > 1e-9
        )

    def check(self, interface: ControlInterface) -> Iterator[Diagnostic]:
        low, high = interface.minimum, interface.maximum
        least = min(low, high, key=abs)
        size = least.text.lstrip("+-")
        message = f"the limits {low.text} and {high.text} of `{interface.name}` become -{size} and {size}"
        yield self.diagnostic(low, message, labels={high: "the maximum"})
