from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity, rename
from sdfcheck_rules.r2c.scaffold import IN_BLOCK, IN_ROBOT, REFUSED

PLUGIN = r"<(plugin)\s*>"
"""A plugin in a branch of xacro that the arguments do not take; those of Gazebo have attributes."""
BLOCK = '<ros2_control name="arm" type="system">{}</ros2_control>'


class MissingControlPlugin(Rule):
    """The hardware or a transmission of `ros2_control` has no plugin.

    A block needs `<hardware><plugin>`, the name of what drives it. Without `plugin` the parser throws
    (earlier versions crash); with an empty one, or without `hardware`, loading fails, and all hardware
    of the robot is given up. A transmission names its kind in `plugin`, too, not in `type` as in ROS 1.
    """

    code = "R2C007"
    name = "missing-control-plugin"
    severity = Severity.ERROR
    remedy = """Name what drives it: `<plugin>` in `<hardware>`, or in the transmission.

    `mock_components/GenericSystem` is for tests without hardware, `gz_ros2_control/GazeboSimSystem` for
    Gazebo; the driver of a real robot documents its own name. For a transmission it is
    `transmission_interface/SimpleTransmission` or one of its kind.
    """
    looks_at = (Ros2Control,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.replace("{}", "").replace("<ros2_control", "<«ros2_control»"),
            says="ros2_control `arm` has no `<hardware>` with a `<plugin>`",
        ),
        Bad(BLOCK.replace("{}", "<«hardware»/>"), says="`hardware` of ros2_control `arm` has no `<plugin>`"),
        Bad(BLOCK.replace("{}", "<hardware><«plugin»/></hardware>"), says="is empty"),
        Bad(
            BLOCK.replace("{}", "<hardware><«plugn»>a/B</plugn></hardware>"),
            fixed=BLOCK.replace("{}", "<hardware><plugin>a/B</plugin></hardware>"),
            unsafe=True,
            says="did you mean `plugin`?",
        ),
        Bad(
            '<transmission name="t"><«type»>transmission_interface/SimpleTransmission</type>'
            '<joint name="lift" role="joint1"/></transmission><joint name="lift"/>',
            fixed='<transmission name="t"><plugin>transmission_interface/SimpleTransmission</plugin>'
            '<joint name="lift" role="joint1"/></transmission><joint name="lift"/>',
            unsafe=True,
            scaffold=IN_BLOCK,
            says="did you mean `plugin`?",
        ),
    )
    good = (Good(BLOCK.replace("{}", "<hardware><plugin>a/B</plugin></hardware>")),)

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return any(True for _ in block.without_plugin)

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        for element in block.without_plugin:
            if element is block.element:
                if not any(block.nearest(child.name, ("hardware",)) for child in block.children()):
                    yield self.diagnostic(element, f"{block.title} has no `<hardware>` with a `<plugin>`")
                continue
            if element.name == "plugin":
                yield self.diagnostic(element, f"`plugin` of {block.title} is empty")
                continue
            may_be = block.document.may_name(PLUGIN, "plugin")
            unless = ", unless an argument brings one" if may_be else ""
            message = f"{element.title} of {block.title} has no `<plugin>`{unless}: {REFUSED}"
            place, fix = element, None
            for child in element.children():
                if child.name == "type" or block.nearest(child.name, ("plugin",)):
                    place, message = child, f"{message}; did you mean `plugin`?"
                    fix = rename("plugin", child)
                    break
            yield self.diagnostic(place, message, fix=fix, severity=Severity.WARNING if may_be else None)
