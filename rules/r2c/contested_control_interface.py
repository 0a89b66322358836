from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Good, Rule, Severity, named
from sdfcheck_rules.r2c.scaffold import HARDWARE, IN_BLOCK

BLOCKS = (
    '<joint name="lift">{}</joint></ros2_control>'
    f'<ros2_control name="drive" type="system">{HARDWARE}<joint name="lift">{{}}</joint>'
)


class ContestedControlInterface(Rule):
    """Two `ros2_control` blocks claim the same interface of a joint.

    Up to iron the second block's is hidden by the first without a message. From jazzy on a second command
    interface makes its block lose its commands, and often all hardware is given up; a state is kept once,
    with a warning. Two blocks may share a joint if one of them reads it and the other one drives it.
    """

    code = "R2C014"
    name = "contested-control-interface"
    severity = Severity.ERROR
    remedy = """Leave the interface to one of the blocks.

    Let the block whose hardware drives the joint command it; another one may list other states of it. For a
    choice between the simulator and the real robot, let a condition of xacro take one block only.
    """
    looks_at = (ControlComponent,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            BLOCKS.replace("{}", '<command_interface name="position"/>', 1).replace(
                "{}", '<command_interface name="«position»"/>'
            ),
            says="`lift/position` takes commands from ros2_control `arm` already",
        ),
        Bad(
            BLOCKS.replace("{}", '<state_interface name="position"/>', 1).replace(
                "{}", '<state_interface name="«position»"/>'
            ),
            says="`lift/position` is read by ros2_control `arm` already",
        ),
    )
    good = (
        Good(
            BLOCKS.replace("{}", '<command_interface name="position"/>', 1).replace(
                "{}", '<state_interface name="position"/>'
            )
        ),
    )

    @staticmethod
    def applies(component: ControlComponent) -> bool:
        return component.what == "joint" and any(True for _ in component.rivals)

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        rivals = list(component.rivals)
        commands = [(own, other) for own, other in rivals if own.is_command]
        shown = commands or rivals
        own, other = shown[0]
        names = named(dict.fromkeys(f"{component.name}/{each.name}" for each, _ in shown))
        verbs = ("takes", "take") if commands else ("is read", "are read")
        message = f"{names} {verbs[len(shown) > 1]} {'commands from' if commands else 'by'}"
        message += f" {other.component.block.title} already"
        severity = None if commands else Severity.WARNING
        labels = {other.name_value or other: "first claimed here"}
        yield self.diagnostic(own.name_value or own, message, severity=severity, labels=labels)
