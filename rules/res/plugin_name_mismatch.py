from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Plugin, Rule, Severity, named

GZ_SIM = "gz-sim"
"""The generation whose systems are classes."""


class PluginNameMismatch(Rule):
    """The name of a plugin is not that of a class in its library.

    In Gazebo `name` is the class to load. The systems of gz-sim each have one or two; for
    another name Gazebo reports an error and goes on without the system. In Gazebo Classic the name is free.
    """

    code = "RES016"
    name = "plugin-name-mismatch"
    severity = Severity.ERROR
    remedy = """Write the name of the class that the message lists.

    For the systems of gz-sim it is `gz::sim::systems::` and the name of the system:
    `gz::sim::systems::Physics` in `gz-sim-physics-system`.
    """
    looks_at = (Plugin,)
    scaffold = IN_WORLD

    bad = (
        Bad(
            '<plugin filename="gz-sim-physics-system" name="«gz::sim::systems::Sensors»"/>',
            says="`gz-sim-physics-system` has no class `gz::sim::systems::Sensors`, but "
            "`gz::sim::systems::Physics`",
        ),
        Bad('<plugin filename="gz-sim-physics-system" name="«physics»"/>'),
    )
    good = (
        Good('<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'),
        Good('<plugin filename="gz-sim-physics-system" name="gz::sim::v8::systems::Physics"/>'),
        Good(
            '<plugin filename="gz-sim-physics-system" name="ignition::gazebo::systems::Physics"/>',
            why="an old name, of which another rule speaks",
        ),
        Good('<plugin filename="libgazebo_ros_init.so" name="init"/>', why="free in Gazebo Classic"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        if not plugin.name or plugin.known is None or plugin.known.generation != GZ_SIM:
            return False
        return "$" not in plugin.name and not plugin.known.is_class(plugin.name)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        known, value = plugin.known, plugin.name_value
        assert known is not None
        current = [name for name in known.classes if not name.startswith("ignition")]
        message = f"`{plugin.filename}` has no class `{plugin.name}`, but {named(current)}"
        yield self.diagnostic(value or plugin, message)
