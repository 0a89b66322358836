from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity
from sdfcheck_rules.r2c.scaffold import HARDWARE, IN_ROBOT

TYPES = ("actuator", "sensor", "system")


class UnknownControlType(Rule):
    """The type of a `ros2_control` block is not `system`, `sensor` or `actuator`.

    The parser takes any text and compares it letter by letter; the hardware of another type is never
    loaded. The controller manager then misses its interfaces and starts without hardware.
    """

    code = "R2C002"
    name = "unknown-control-type"
    severity = Severity.ERROR
    remedy = """Write `system`, `sensor` or `actuator`, in lower case.

    `system` is for several joints that one device drives together, `actuator` for a single joint, `sensor`
    for what is only read.
    """
    looks_at = (Ros2Control,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            f'<ros2_control name="arm" type="«System»">{HARDWARE}</ros2_control>',
            fixed=f'<ros2_control name="arm" type="system">{HARDWARE}</ros2_control>',
            unsafe=True,
            says="unknown type `System` of ros2_control `arm`; `system` differs in case only",
        ),
    )
    good = (
        Good(f'<ros2_control name="arm" type="sensor">{HARDWARE}</ros2_control>'),
        Good(
            f'<ros2_control name="arm" type="${{t}}">{HARDWARE}</ros2_control>',
            why="left-over expressions are reported as such",
        ),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return block.type_value is not None and block.type.strip() not in TYPES and "$" not in block.type

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        assert block.type_value is not None
        message, near = f"unknown type `{block.type}` of {block.title}", block.nearest(block.type, TYPES)
        if near is None:
            message += "; it is one of `actuator`, `sensor` and `system`"
        yield self.diagnostic(block.type_value, message, meant=near)
