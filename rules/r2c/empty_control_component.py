from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_BLOCK


class EmptyControlComponent(Rule):
    """A joint, sensor or group of signals in `ros2_control` has no interface.

    It is read and serves nothing: no controller can drive or read it.
    """

    code = "R2C030"
    name = "empty-control-component"
    severity = Severity.WARNING
    remedy = """Give it the interfaces that the hardware has, or remove it.

    A driven joint mostly has `<command_interface name="position"/>`, `<state_interface name="position"/>`
    and `<state_interface name="velocity"/>`.
    """
    default = False
    looks_at = (ControlComponent,)
    scaffold = IN_BLOCK

    bad = (Bad('<«joint» name="lift"/>', says="joint `lift` has no interface in ros2_control `arm`"),)
    good = (
        Good('<joint name="lift"><state_interface name="position"/></joint>'),
        Good('<joint name="lift"><positon/></joint>', why="the misspelled one is reported"),
    )

    @staticmethod
    def applies(component: ControlComponent) -> bool:
        return not component.interfaces and not any(child.name != "param" for child in component.children())

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        yield self.diagnostic(component, f"{component.title} has no interface in {component.block.title}")
