from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Plugin, Rule, Severity, World

GZ_SIM = "gz-sim"
BROADCASTER = '<{} filename="gz-sim-scene-broadcaster-system" name="gz::sim::systems::SceneBroadcaster"/>'
PHYSICS = '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'
ARM = (
    '<model name="arm"><link name="a"/><link name="b"/><joint name="j" type="revolute"><parent>a</parent>'
    "<child>b</child><axis><xyz>0 0 1</xyz></axis></joint></model>"
)
BOX = '<model name="box"><link name="l"/></model>'


class WorldWithoutPhysics(Rule):
    """A world lists systems of Gazebo, but not physics, so that nothing moves.

    Gazebo brings physics, user commands and the scene broadcaster to a world that lists no systems. One that lists any
    has these alone before gz-sim 9: it stands still, though it seems to run.
    """

    code = "GAZ029"
    name = "world-without-physics"
    severity = Severity.WARNING
    remedy = """Add `<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>` to the world.

    Add `gz-sim-user-commands-system` and `gz-sim-scene-broadcaster-system` with it. If the program that starts Gazebo
    brings them, or nothing is to move, ignore this finding.
    """
    looks_at = (World,)
    scaffold = IN_WORLD
    sources = ("https://gazebosim.org/api/sim/8/server_config.html",)

    bad = (
        Bad(
            BROADCASTER.format("«plugin»") + ARM,
            says="world `w` lists systems of Gazebo, but not physics: before gz-sim 9 nothing moves",
        ),
    )
    good = (
        Good(BROADCASTER.format("plugin") + PHYSICS + ARM),
        Good(ARM, why="Gazebo brings its own systems"),
        Good(BROADCASTER.format("plugin") + BOX, why="nothing in it has a joint that is to move"),
    )

    @staticmethod
    def applies(world: World) -> bool:
        return bool(world.plugins) and stands_still(world)

    def check(self, world: World) -> Iterator[Diagnostic]:
        plugin = systems(world)[0]
        message = f"{world.title} lists systems of Gazebo, but not physics: before gz-sim 9 nothing moves"
        yield self.diagnostic(plugin, message)


def systems(world: World) -> list[Plugin]:
    """The systems of the new Gazebo that it lists."""
    return [p for p in world.plugins if p.known is not None and p.known.generation == GZ_SIM]


def stands_still(world: World) -> bool:
    """Does it list systems without physics, and has a joint that is to move?"""
    if (
        not systems(world)
        or world.has_unclear_system
        or any("physics" in plugin.filename for plugin in world.root.each(Plugin))
    ):
        return False
    return any(joint.moves for model in world.models if not model.may_be_static for joint in model.joints)
