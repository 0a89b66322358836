from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Ros2Control, Rule, Severity, replace
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = '<ros2_control name="arm" type="system"><hardware><plugin>{}</plugin></hardware></ros2_control>'


class ClassAsControlPlugin(Rule):
    """The plugin of `ros2_control` is written as a C++ class instead of a plugin's name.

    Plugins go by the name that their package declares, `package/Class` by custom. Only a package that
    declares none can be reached by its class; else loading fails and all hardware is given up.
    """

    code = "R2C008"
    name = "class-as-control-plugin"
    severity = Severity.WARNING
    remedy = """Write the plugin's name as its package declares it: `package/Class`.

    It is the `name` of the `<class>` in the plugin description of that package, an XML file in its share
    folder. If no name is declared there, the C++ class is right.
    """
    looks_at = (Ros2Control,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.replace("{}", "«mock_components::GenericSystem»"),
            fixed=BLOCK.replace("{}", "mock_components/GenericSystem"),
            unsafe=True,
            says="`mock_components::GenericSystem` is a C++ class; plugins are named `mock_components/GenericSystem`",
        ),
    )
    good = (Good(BLOCK.replace("{}", "mock_components/GenericSystem")),)

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        plugin = block.plugin_value
        return (
            plugin is not None and "::" in plugin.text and "/" not in plugin.text and "$" not in plugin.text
        )

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        plugin = block.plugin_value
        assert plugin is not None
        name = plugin.text.replace("::", "/")
        message = f"`{plugin.text}` is a C++ class; plugins are named `{name}`"
        yield self.diagnostic(plugin, message, fix=replace(plugin, name, f"write `{name}`", unsafe=True))
