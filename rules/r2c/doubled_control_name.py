from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity
from sdfcheck_rules.r2c.scaffold import HARDWARE, IN_ROBOT, REFUSED

BLOCK = f'<ros2_control name="{{}}" type="system">{HARDWARE}</ros2_control>'


class DoubledControlName(Rule):
    """Two `ros2_control` blocks have one name.

    Hardware goes by the name of its block: the resource manager refuses a second one of a
    name, and the description with it.
    """

    code = "R2C003"
    name = "doubled-control-name"
    severity = Severity.ERROR
    remedy = """Give each block a name of its own.

    In a macro of xacro put the prefix in: `<ros2_control name="${prefix}arm" type="system">`. If both are
    one robot, put their joints into one block.
    """
    looks_at = (Ros2Control,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.replace("{}", "arm") + BLOCK.replace("{}", "«arm»"),
            says="`ros2_control` name `arm` is used twice",
        ),
    )
    good = (Good(BLOCK.replace("{}", "left") + BLOCK.replace("{}", "right")),)

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return block.first_of_name is not None

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        name, first = block.name_value, block.first_of_name
        if name is not None and first is not None and first.name_value is not None:
            message = f"`ros2_control` name `{block.name}` is used twice: {REFUSED}"
            yield self.diagnostic(name, message, labels={first.name_value: "first used here"})
