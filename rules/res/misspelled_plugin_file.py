from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Consumer, Diagnostic, Good, Plugin, Rule, Severity, warns


class MisspelledPluginFile(Rule):
    """The file of a plugin is nearly, but not quite, that of a system of Gazebo.

    Gazebo reports that it does not find the library, and goes on without the system.
    """

    code = "RES015"
    name = "misspelled-plugin-file"
    severity = Severity.WARNING
    preview = True
    affects = {Consumer.GAZEBO: warns("does not find the plugin")}
    looks_at = (Plugin,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            '<plugin filename="«gz-sim-phyics-system»" name="gz::sim::systems::Physics"/>',
            fixed='<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>',
            unsafe=True,
            says="no system of Gazebo is called `gz-sim-phyics-system`; did you mean `gz-sim-physics-system`?",
        ),
    )
    good = (
        Good('<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'),
        Good('<plugin filename="gz-sim-conveyor-plant-system" name="p::Conveyor"/>', why="somebody's own"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return plugin.meant_file is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        value, meant = plugin.filename_value, plugin.meant_file
        assert value is not None
        assert meant is not None
        yield self.diagnostic(value, f"no system of Gazebo is called `{plugin.filename}`", meant=meant)
