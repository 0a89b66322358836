from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import HARDWARE, IN_BLOCK


class DoubledControlJoint(Rule):
    """A joint is listed twice in one `ros2_control` block.

    Its interfaces are exported twice, and which of them counts depends on the hardware.
    """

    code = "R2C012"
    name = "doubled-control-joint"
    severity = Severity.WARNING
    remedy = """Put the interfaces of both into one `<joint>`.

    If two joints were meant, correct the name of the copy.
    """
    looks_at = (ControlComponent,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            '<joint name="lift"><state_interface name="position"/></joint>'
            '<joint name="«lift»"><command_interface name="position"/></joint>',
            says="joint `lift` is listed twice in ros2_control `arm`",
        ),
    )
    good = (
        Good(
            '<joint name="lift"><state_interface name="position"/></joint></ros2_control>'
            f'<ros2_control name="drive" type="system">{HARDWARE}'
            '<joint name="lift"><command_interface name="position"/></joint>',
            why="one block reads it, the other drives it",
        ),
    )

    @staticmethod
    def applies(component: ControlComponent) -> bool:
        return component.earlier is not None

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        first, name = component.earlier, component.name_value
        assert first is not None
        assert first.name_value is not None
        assert name is not None
        message = f"{component.title} is listed twice in {component.block.title}"
        yield self.diagnostic(name, message, labels={first.name_value: "first listed here"})
