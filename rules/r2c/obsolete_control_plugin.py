from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity, replace
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = '<ros2_control name="arm" type="system"><hardware><plugin>{}</plugin></hardware></ros2_control>'
NOW = {
    "fake_components/GenericSystem": (
        "mock_components/GenericSystem",
        "gone from jazzy on",
        Severity.WARNING,
    ),
    "ign_ros2_control/IgnitionSystem": (
        "gz_ros2_control/GazeboSimSystem",
        "an old name from iron on",
        Severity.INFO,
    ),
}
"""Plugin → its name now, what became of the old one, how bad that is."""


class ObsoleteControlPlugin(Rule):
    """The plugin of `ros2_control` has another name by now.

    `fake_components/GenericSystem` is `mock_components/GenericSystem`, and gone from jazzy on;
    `ign_ros2_control/IgnitionSystem` is `gz_ros2_control/GazeboSimSystem`, and an alias of it since iron.
    """

    code = "R2C010"
    name = "obsolete-control-plugin"
    severity = Severity.WARNING
    remedy = """Write the name that the plugin has now.

    If one file has to serve Humble and later, choose the name by an argument of xacro.
    """
    default = False
    looks_at = (Ros2Control,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.replace("{}", "«fake_components/GenericSystem»"),
            fixed=BLOCK.replace("{}", "mock_components/GenericSystem"),
            unsafe=True,
            says="`fake_components/GenericSystem` is gone from jazzy on; it is `mock_components/GenericSystem` now",
        ),
        Bad(
            BLOCK.replace("{}", "«ign_ros2_control/IgnitionSystem»")
            + '<gazebo><plugin filename="libarm_ros2_control.so" name="c"/></gazebo>',
            says="is an old name from iron on",
        ),
    )
    good = (
        Good(BLOCK.replace("{}", "gazebo_ros2_control/GazeboSystem"), why="Gazebo Classic has no newer one"),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        plugin = block.plugin_value
        return plugin is not None and plugin.text in NOW

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        plugin = block.plugin_value
        assert plugin is not None
        name, what, severity = NOW[plugin.text]
        message = f"`{plugin.text}` is {what}; it is `{name}` now"
        fix = replace(plugin, name, f"write `{name}`", unsafe=True)
        yield self.diagnostic(plugin, message, severity=severity, fix=fix)
