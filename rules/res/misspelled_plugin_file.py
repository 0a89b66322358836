from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Plugin, Rule, Severity


class MisspelledPluginFile(Rule):
    """The file of a plugin is nearly, but not quite, that of a system or of a part of the window of Gazebo.

    Gazebo reports that it does not find the library, and goes on without it. The same holds for systems that newer
    releases do not have any more, where the class is written in place of the library, and for plugins of Gazebo Classic
    whose `lib` or `.so` is missing.
    """

    code = "RES015"
    name = "misspelled-plugin-file"
    severity = Severity.WARNING
    remedy = """Write the library as this release of Gazebo calls it, or remove the plugin.

    For a system of your own that has nearly the name of one of Gazebo's, ignore this. A system that is gone
    mostly became a part of another one.
    """
    looks_at = (Plugin,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            '<plugin filename="«gz-sim-phyics-system»" name="gz::sim::systems::Physics"/>',
            fixed='<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>',
            unsafe=True,
            says="nothing in Gazebo is called `gz-sim-phyics-system`; did you mean `gz-sim-physics-system`?",
        ),
        Bad(
            '<plugin filename="«libgazebo_ros_states.so»" name="state"/>',
            fixed='<plugin filename="libgazebo_ros_state.so" name="state"/>',
            unsafe=True,
            says="did you mean `libgazebo_ros_state.so`?",
        ),
        Bad(
            '<gui><plugin filename="«WorldControls»" name="World control"/></gui>',
            fixed='<gui><plugin filename="WorldControl" name="World control"/></gui>',
            unsafe=True,
            says="did you mean `WorldControl`?",
        ),
        Bad(
            '<plugin filename="«gz-sim-particle-emitter2-system»" name="gz::sim::systems::ParticleEmitter2"/>',
            says="`gz-sim-particle-emitter2-system` is gone since Gazebo Sim 8",
        ),
        Bad(
            '<plugin filename="«gz::sim::systems::Physics»" name="gz::sim::systems::Physics"/>',
            fixed='<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>',
            unsafe=True,
            says="`gz::sim::systems::Physics` is a class, and `filename` names its library",
        ),
        Bad(
            '<plugin filename="«libgazebo_ros_state»" name="ros"/>',
            fixed='<plugin filename="libgazebo_ros_state.so" name="ros"/>',
            unsafe=True,
            says="did you mean `libgazebo_ros_state.so`?",
        ),
    )
    good = (
        Good('<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'),
        Good('<gui><plugin filename="EntityTree" name="Entities"/></gui>'),
        Good('<plugin filename="gz-sim-conveyor-plant-system" name="p::Conveyor"/>', why="somebody's own"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        is_gone = plugin.known is not None and bool(plugin.known.last) and "ignition" not in plugin.filename
        return is_gone or plugin.meant_file is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        value, meant = plugin.filename_value, plugin.meant_file
        assert value is not None
        if plugin.known is not None and plugin.known.last:
            message = f"`{plugin.known.file}` is gone since Gazebo Sim {int(plugin.known.last) + 1}"
            yield self.diagnostic(value, message)
            return
        message = f"nothing in Gazebo is called `{plugin.filename}`"
        if "::" in plugin.filename:
            message = f"`{plugin.filename}` is a class, and `filename` names its library"
        yield self.diagnostic(value, message, meant=meant)
