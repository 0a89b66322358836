from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Plugin, Rule, Severity, named

DRIVE = (
    '<link name="w"/><joint name="wheel" type="revolute"><parent>base</parent><child>w</child>'
    "<axis><xyz>0 1 0</xyz></axis></joint>"
    '<{} name="gz::sim::systems::DiffDrive" filename="gz-sim-diff-drive-system">{}</plugin>'
)
LEFT, RIGHT = "<left_joint>wheel</left_joint>", "<right_joint>wheel</right_joint>"


class MissingPluginParameter(Rule):
    """A plugin of Gazebo lacks a parameter without which it does not run.

    It reports an error and switches itself off, or does nothing in silence.
    """

    code = "RES021"
    name = "missing-plugin-parameter"
    severity = Severity.ERROR
    remedy = """Give the plugin the parameter that the message names, as a child element.

    Names of joints and links are those of the model that the plugin is in:
    `<left_joint>left_wheel_joint</left_joint>`. If the plugin is not used, remove it.
    """
    looks_at = (Plugin,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            DRIVE.format("«plugin»", RIGHT),
            says="plugin `gz::sim::systems::DiffDrive` does not run without `left_joint`",
        ),
        Bad(DRIVE.format("«plugin»", ""), says="does not run without `left_joint` and `right_joint`"),
    )
    good = (Good(DRIVE.format("plugin", LEFT + RIGHT)),)

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return bool(plugin.missing_parameters)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        missing = named(plugin.missing_parameters)
        yield self.diagnostic(plugin, f"{plugin.title} does not run without {missing}")
