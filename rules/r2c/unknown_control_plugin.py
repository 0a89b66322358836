from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity, Value, suggest
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = '<ros2_control name="arm" type="system"><hardware><plugin>{}</plugin></hardware></ros2_control>'
KNOWN = (
    "fake_components/GenericSystem",
    "gazebo_ros2_control/GazeboSystem",
    "gz_ros2_control/GazeboSimSystem",
    "ign_ros2_control/IgnitionSystem",
    "joint_state_topic_hardware_interface/JointStateTopicSystem",
    "mock_components/GenericSystem",
    "mujoco_ros2_control/MujocoSystem",
    "topic_based_ros2_control/TopicBasedSystem",
)
OWNERS = {
    "fake_components": "fake_components/GenericSystem",
    "gz_ros2_control": "gz_ros2_control/GazeboSimSystem",
    "ign_ros2_control": "ign_ros2_control/IgnitionSystem",
    "mock_components": "mock_components/GenericSystem",
}
"""Packages all of whose plugins are known → the plugin."""


def meant(plugin: str) -> str | None:
    """The known plugin that was meant; None for plugins of others."""
    return suggest(plugin, KNOWN) or OWNERS.get(plugin.partition("/")[0])


def has_blank(plugin: Value) -> bool:
    """Is there a blank in the text of an element, or around it?"""
    text = plugin.element.text or ""
    return len(text.split()) > 1 or text != text.strip()


class UnknownControlPlugin(Rule):
    """The plugin of `ros2_control` is not known, and nearly that of a known package.

    A class that is not there cannot be loaded: Gazebo ignores the block, elsewhere all hardware is given
    up. Plugins of other packages are not judged, but for a blank around the name: it counts as a part of it.
    """

    code = "R2C009"
    name = "unknown-control-plugin"
    severity = Severity.WARNING
    remedy = """Write the name as the package declares it, without blanks.

    It is the `name` of the `<class>` in the plugin description of the package.
    """
    looks_at = (Ros2Control,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.replace("{}", "«gz_ros2_control/GazebSimSystem»"),
            fixed=BLOCK.replace("{}", "gz_ros2_control/GazeboSimSystem"),
            unsafe=True,
            says="did you mean `gz_ros2_control/GazeboSimSystem`?",
        ),
        Bad(
            BLOCK.replace("{}", "«gz_ros2_control/GzSimSystem»"),
            fixed=BLOCK.replace("{}", "gz_ros2_control/GazeboSimSystem"),
            unsafe=True,
            says="`gz_ros2_control` has no plugin",
        ),
        Bad(
            BLOCK.replace("{}", " «my_robot/MySystem»"),
            says="the name of plugin `my_robot/MySystem` has a blank, which counts as part of it",
        ),
    )
    good = (
        Good(BLOCK.replace("{}", "gz_ros2_control/GazeboSimSystem")),
        Good(BLOCK.replace("{}", "my_robot/MySystem"), why="anybody may write one"),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        plugin = block.plugin_value
        if plugin is None or "/" not in plugin.text or "$" in plugin.text:
            return False
        return has_blank(plugin) or (plugin.text not in KNOWN and meant(plugin.text) is not None)

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        plugin = block.plugin_value
        assert plugin is not None
        if has_blank(plugin):
            message = f"the name of plugin `{plugin.text}` has a blank, which counts as part of it"
            yield self.diagnostic(plugin, message)
            return
        package, _, name = plugin.text.partition("/")
        near = meant(plugin.text)
        assert near is not None
        message = (
            f"`{package}` has no plugin `{name}`"
            if package in OWNERS
            else f"no package has the plugin `{plugin.text}`"
        )
        yield self.diagnostic(plugin, message, meant=near)
