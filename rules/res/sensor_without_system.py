from collections.abc import Iterator

from sdfcheck import SDF, Bad, Diagnostic, Good, Plugin, Rule, Severity, World, named

WORLD = (
    '<world name="w">{}<model name="m"><link name="l">'
    "<inertial><mass>1</mass></inertial>{}</link></model></world>"
)
PHYSICS = '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'
USUAL = frozenset(("gz-sim-physics-system", "gz-sim-user-commands-system", "gz-sim-scene-broadcaster-system"))
"""The systems that Gazebo brings where a world lists none."""
SCREEN = (
    PHYSICS
    + '<plugin filename="gz-sim-user-commands-system" name="gz::sim::systems::UserCommands"/>'
    + '<plugin filename="gz-sim-scene-broadcaster-system" name="gz::sim::systems::SceneBroadcaster"/>'
)
IMU = '<plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>'


class SensorWithoutSystem(Rule):
    """A sensor is of a type for which the world lists no system.

    In Gazebo every type of sensor needs its system among the plugins of the world, or of a model; without it the
    sensor never publishes, and nobody says so. Systems may also be added by programs that start Gazebo: where the world
    lists neither a system for another type of sensor nor all that Gazebo brings by itself, this is for information.
    """

    code = "RES018"
    name = "sensor-without-system"
    severity = Severity.WARNING
    remedy = """Add the system for this type of sensor to the plugins of the world.

    - cameras, depth cameras and lidars: `gz-sim-sensors-system`, with
      `<render_engine>ogre2</render_engine>`
    - `imu`: `gz-sim-imu-system`; `contact`: `gz-sim-contact-system`; `force_torque`:
      `gz-sim-forcetorque-system`
    - `navsat`: `gz-sim-navsat-system`; `magnetometer`: `gz-sim-magnetometer-system`; `altimeter`:
      `gz-sim-altimeter-system`; `air_pressure`: `gz-sim-air-pressure-system`

    Once a world lists any plugin, the ones that Gazebo loads by default (physics, user commands, scene
    broadcaster) have to be listed as well.
    """
    looks_at = (World,)
    scaffold = SDF

    bad = (
        Bad(
            WORLD.format(SCREEN, '<sensor name="s" type="«imu»"/>'),
            says="no system of world `w` serves sensors of type `imu`: `gz-sim-imu-system` is missing",
        ),
        Bad(WORLD.format(PHYSICS + IMU, '<sensor name="s" type="«altimeter»"/>')),
        Bad(WORLD.format(PHYSICS, '<sensor name="s" type="«imu»"/>')),
    )
    good = (
        Good(WORLD.format(PHYSICS + IMU, '<sensor name="s" type="imu"/>')),
        Good(WORLD.format("", '<sensor name="s" type="imu"/>'), why="Gazebo brings its own list of systems"),
    )

    @staticmethod
    def applies(world: World) -> bool:
        return any(world.unserved_sensors)

    def check(self, world: World) -> Iterator[Diagnostic]:
        seen: set[str] = set()
        severity = None if is_whole(world) else Severity.INFO
        for sensor, systems in world.unserved_sensors:
            if sensor.type not in seen and sensor.type_value is not None:
                seen.add(sensor.type)
                what = f"no system of {world.title} serves sensors of type `{sensor.type}`"
                message = f"{what}: {named(systems, 'or')} is missing"
                yield self.diagnostic(sensor.type_value, message, severity=severity)


def is_whole(world: World) -> bool:
    """Does it list what sensors need, or at least what a world needs?"""
    known = [plugin.known for plugin in world.root.each(Plugin) if plugin.known is not None]
    return any(facts.serves for facts in known) or {facts.file for facts in known} >= USUAL
