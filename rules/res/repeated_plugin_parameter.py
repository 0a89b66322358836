from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Plugin, Rule, Severity

FORCE = (
    '<link name="w"/><joint name="j" type="revolute"><parent>base</parent><child>w</child>'
    "<axis><xyz>0 1 0</xyz></axis></joint>"
    '<plugin name="gz::sim::systems::JointPositionController" filename="gz-sim-joint-position-controller-system">'
    "<joint_name>j</joint_name>{}</plugin>"
)


class RepeatedPluginParameter(Rule):
    """A parameter of a plugin is given twice with two values, and the plugin reads one.

    Plugins of Gazebo ask for the first element of a name. Parameters that they read several times are no findings.
    """

    code = "RES022"
    name = "repeated-plugin-parameter"
    severity = Severity.WARNING
    remedy = """Remove the value that is not meant; the first one counts.

    If two things are to be controlled, write the plugin twice: one for each joint.
    """
    looks_at = (Plugin,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            FORCE.format("<p_gain>1</p_gain><«p_gain»>2</p_gain>"),
            says="`p_gain` is given again, and the plugin reads the first: `1`, not `2`",
        ),
    )
    good = (
        Good(FORCE.format("<p_gain>1</p_gain><p_gain>1</p_gain>"), why="the same twice"),
        Good(FORCE.format("<p_gain>1</p_gain>")),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return bool(plugin.repeated_parameters)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for first, again in plugin.repeated_parameters:
            name = first.name
            what = f"`{name}` is given again, and the plugin reads the first: `{first.content}`, not `{again.content}`"
            yield self.diagnostic(again, what, labels={first: "read"})
