from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Plugin, Ros2Control, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_ROBOT
from sdfcheck_rules.r2c.unknown_control_plugin import KNOWN
from sdfcheck_rules.r2c.unknown_control_simulator import CLASSES

SYSTEMS = {
    "gazebo_ros2_control": ("gazebo_ros2_control/GazeboSystem",),
    "gz_ros2_control-system": ("gz_ros2_control/GazeboSimSystem", "ign_ros2_control/IgnitionSystem"),
    "ign_ros2_control-system": ("ign_ros2_control/IgnitionSystem",),
}
"""Library of Gazebo's plugin → the hardware of the simulator that it can load."""
SIMULATED = f">\\s*(?:{'|'.join(sorted({each for group in SYSTEMS.values() for each in group}))})\\s*<"
FOREIGN = frozenset(KNOWN).difference(*SYSTEMS.values())
"""Hardware that no Gazebo loads."""
ROBOT = (
    '<ros2_control name="arm" type="system"><hardware><plugin>{}</plugin></hardware></ros2_control>'
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>c.yaml</parameters></plugin></gazebo>"
)


class MixedControlGenerations(Rule):
    """The hardware of a `ros2_control` block is not what the plugin of Gazebo that is to load it has.

    `gazebo_ros2_control` is for Gazebo Classic, `ign_ros2_control` for Fortress with ROS 2 Humble, `gz_ros2_control`
    for what came after. Each loads its own hardware only, but that `gz_ros2_control` knows the old name of its own. The
    block is ignored with an error, and no joint of it moves. The same holds for `mock_components/GenericSystem`, which
    moves nothing and is for a robot without simulator, and for the hardware of MuJoCo or of topics: a warning, as the
    robot may be meant to be without Gazebo here. A file for xacro
    that has Gazebo's hardware, too, chooses by an argument.
    """

    code = "R2C034"
    name = "mixed-control-generations"
    severity = Severity.ERROR
    remedy = """Write hardware and plugin of the same package.

    - Gazebo since Garden: `gz_ros2_control/GazeboSimSystem` and `gz_ros2_control-system`.
    - Fortress with Humble: `ign_ros2_control/IgnitionSystem` and `ign_ros2_control-system`.
    - Gazebo Classic: `gazebo_ros2_control/GazeboSystem` and `libgazebo_ros2_control.so`.

    For simulation and mock hardware in one file, let a condition of xacro choose hardware and plugin together.
    """
    looks_at = (Ros2Control,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            ROBOT.replace("{}", "«gazebo_ros2_control/GazeboSystem»"),
            says="`gz_ros2_control-system` does not load `gazebo_ros2_control/GazeboSystem`; did you mean "
            "`gz_ros2_control/GazeboSimSystem`?",
            fixed=ROBOT.replace("{}", "gz_ros2_control/GazeboSimSystem"),
            unsafe=True,
        ),
        Bad(
            ROBOT.replace("{}", "«mock_components/GenericSystem»"),
            says="does not load `mock_components/GenericSystem`",
            fixed=ROBOT.replace("{}", "gz_ros2_control/GazeboSimSystem"),
            unsafe=True,
        ),
    )
    good = (
        Good(ROBOT.replace("{}", "gz_ros2_control/GazeboSimSystem")),
        Good(ROBOT.replace("{}", "ign_ros2_control/IgnitionSystem"), why="an old name that still works"),
        Good(ROBOT.replace("{}", "my_robot/Hardware"), why="not known"),
        Good(
            ROBOT.replace("{}", "gz_ros2_control/GazeboSimSystem")
            + '<ros2_control name="tool" type="system"><hardware>'
            "<plugin>mock_components/GenericSystem</plugin></hardware></ros2_control>",
            why="part of the robot is made up",
        ),
        Good(
            '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="mode" default="mock"/>'
            '<link name="base"/>'
            + ROBOT.replace(
                "<plugin>{}</plugin>",
                """<xacro:if value="${'$(arg mode)' == 'mock'}"><plugin>mock_components/GenericSystem</plugin>"""
                """</xacro:if><xacro:if value="${'$(arg mode)' == 'gz'}"><plugin>gz_ros2_control/GazeboSimSystem"""
                "</plugin></xacro:if>",
            )
            + "</robot>",
            why="an argument chooses the hardware",
            file="arm.urdf.xacro",
            scaffold="{}",
        ),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return (block.is_simulated or is_only_foreign(block)) and loader(block) is not None

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        plugin, value = loader(block), block.plugin_value
        assert plugin is not None
        assert value is not None
        library = library_of(plugin)
        message = f"`{library}` does not load `{value.text}`"
        labels = {plugin.filename_value or plugin: "starts ros2_control"}
        severity = self.severity if block.is_simulated else Severity.WARNING
        yield self.diagnostic(value, message, meant=SYSTEMS[library][0], labels=labels, severity=severity)


def library_of(plugin: Plugin) -> str:
    """The name of its library without `lib` and `.so`."""
    return plugin.filename.removeprefix("lib").removesuffix(".so")


def is_only_foreign(block: Ros2Control) -> bool:
    """Is its hardware none of Gazebo's, while no other block of the robot has any?"""
    value = block.plugin_value
    if value is None or value.text.strip() not in FOREIGN or block.model.has_simulated_hardware:
        return False
    return not block.document.may_write(SIMULATED)


def loader(block: Ros2Control) -> Plugin | None:
    """The plugin that is to load a block's hardware, and does not know it; None where one does."""
    value = block.plugin_value
    known = [plugin for plugin in block.model.plugins if library_of(plugin) in SYSTEMS]
    for plugin in known:
        library = library_of(plugin)
        is_misnamed = library in CLASSES and plugin.name not in CLASSES[library]
        if is_misnamed or (value is not None and value.text in SYSTEMS[library]):
            return None
    return known[0] if known else None
