from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity, named
from sdfcheck_rules.r2c.scaffold import IN_BLOCK


class MalformedControlValue(Rule):
    """A value in `ros2_control` is not of its kind.

    Truth values are `true` or `false` (from jazzy on others are refused, before they were
    false), sizes and priorities are positive whole numbers, and types of data are those that
    ros2_control knows. For a refused value ros2_control drops the whole description, or all
    interfaces of the hardware.
    """

    code = "R2C019"
    name = "malformed-control-value"
    severity = Severity.ERROR
    remedy = """Write a value of the kind that the message names.

    Truth values are `true` and `false` in lower case; sizes are whole numbers from 1 on; the default type
    of data is `double`.
    """
    looks_at = (Ros2Control,)
    scaffold = IN_BLOCK

    bad = (
        Bad('<joint name="lift" mimic="«yes»"/>', says="`mimic` should be `true` or `false`, not `yes`"),
        Bad(
            '<gpio name="io"><state_interface name="port" size="«0»"/></gpio>',
            says="`size` should be a whole number from 1 on, not `0`",
        ),
        Bad(
            '<gpio name="io"><state_interface name="port" data_type="«float»"/></gpio>',
            says="unknown `data_type` `float`",
        ),
    )
    good = (
        Good('<joint name="lift" mimic="False"/>'),
        Good('<gpio name="io"><state_interface name="port" data_type="uint8" size="4"/></gpio>'),
        Good('<gpio name="io"><state_interface name="port" data_type="uint8" size="1"/></gpio>'),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return any(True for _ in block.unsound)

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        for value, attribute in block.unsound:
            near = None
            if attribute.type == "bool":
                message = f"`{attribute.name}` should be `true` or `false`, not `{value.text}`"
            elif attribute.listed:
                near = block.nearest(value.text, attribute.listed)
                message = f"unknown `{attribute.name}` `{value.text}`"
                message += "" if near else f"; it is one of {named(attribute.listed, 'or')}"
            else:
                message = f"`{attribute.name}` should be a whole number from 1 on, not `{value.text}`"
            yield self.diagnostic(value, message, meant=near)
