from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity
from sdfcheck_rules.r2c.scaffold import HARDWARE, IN_BLOCK, IN_LIFT, IN_ROBOT, REFUSED, SINCE_JAZZY


class MissingControlAttribute(Rule):
    """Something in `ros2_control` lacks an attribute that its parser cannot do without.

    A block needs `name` and `type`; joints, sensors, interfaces, parameters and transmissions
    need a `name`, what a transmission connects needs a `role`, and `limits` need `enable`. The
    parser stops at the first that is missing, names no line, and the whole description is lost.
    """

    code = "R2C001"
    name = "missing-control-attribute"
    severity = Severity.ERROR
    remedy = """Write the attribute that the message names.

    - `<ros2_control name="arm" type="system">`: type is `system` (joints that one device drives together),
      `actuator` (one joint) or `sensor`.
    - `<command_interface name="position"/>`: position, velocity, effort, or a name that the hardware knows.
    - `<limits enable="true"/>`, or `false` to switch the limits of the interface off.
    """
    looks_at = (Ros2Control,)
    scaffold = IN_BLOCK

    bad = (
        Bad(
            f'<«ros2_control» type="system">{HARDWARE}</ros2_control>',
            scaffold=IN_ROBOT,
            says="`ros2_control` has no `name`",
        ),
        Bad(f'<«ros2_control» name="arm">{HARDWARE}</ros2_control>', scaffold=IN_ROBOT, says="no `type`"),
        Bad(
            "<«command_interface»/>",
            scaffold=IN_LIFT,
            says="`command_interface` in joint `lift` has no `name`",
        ),
        Bad("<«param»>3</param>", scaffold=IN_LIFT),
        Bad(
            '<command_interface name="position"><«limits»/></command_interface>',
            scaffold=IN_LIFT,
            says="has no `enable`",
        ),
    )
    good = (Good('<gpio name="io"><param name="port">3</param></gpio>'),)

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return any(True for _ in block.lacking)

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        for element, name in block.lacking:
            where = (
                "" if element is block.element or element.parent is None else f" in {element.parent.title}"
            )
            does = SINCE_JAZZY if name == "enable" else REFUSED
            yield self.diagnostic(element, f"{element.title}{where} has no `{name}`: {does}")
