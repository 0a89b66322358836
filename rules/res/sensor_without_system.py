from collections.abc import Iterator

from sdfcheck import SDF, Bad, Diagnostic, Good, Plugin, Root, Rule, Severity, World, named

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
ROBOT = '<robot name="r"><link name="a"/><gazebo reference="a"><sensor name="s" type="{}"/></gazebo></robot>'
LAUNCH = (
    'Node(package="ros_gz_sim", executable="create", arguments=["-file", "robot.urdf"])\n'
    'gz = {"gz_args": "-r yard.sdf"}\n'
)
YARD = '<sdf version="1.9"><world name="yard">{}</world></sdf>'
IMU = '<plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>'


class SensorWithoutSystem(Rule):
    """A sensor is of a type for which the world lists no system.

    In Gazebo every type of sensor needs its system among the plugins of the world, or of a model; without it the
    sensor never publishes, and nobody says so. Systems may also be added by programs that start Gazebo: where the world
    lists neither a system for another type of sensor nor all that Gazebo brings by itself, this is for information. So
    it is with a robot that a launch file creates in a world of the project, if no description there lists the system.
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
    looks_at = (World, Root)
    scaffold = SDF

    bad = (
        Bad(
            WORLD.format(SCREEN, '<sensor name="s" type="«imu»"/>'),
            says="no system of world `w` serves sensors of type `imu`: `gz-sim-imu-system` is missing",
        ),
        Bad(WORLD.format(PHYSICS + IMU, '<sensor name="s" type="«altimeter»"/>')),
        Bad(WORLD.format(PHYSICS, '<sensor name="s" type="«imu»"/>')),
        Bad(
            ROBOT.format("«imu»"),
            scaffold="{}",
            file="robot.urdf",
            files={"sim.launch.py": LAUNCH, "yard.sdf": YARD.format(SCREEN)},
            says="no system of world `yard` in `yard.sdf`, in which `sim.launch.py` creates it, serves sensors of type",
        ),
    )
    good = (
        Good(WORLD.format(PHYSICS + IMU, '<sensor name="s" type="imu"/>')),
        Good(
            ROBOT.format("imu"),
            scaffold="{}",
            file="robot.urdf",
            files={"sim.launch.py": LAUNCH, "yard.sdf": YARD.format(SCREEN + IMU)},
        ),
        Good(
            ROBOT.format("imu"),
            scaffold="{}",
            file="robot.urdf",
            files={
                "sim.launch.py": LAUNCH,
                "yard.sdf": YARD.format(f"{SCREEN}{IMU}").replace("gz-sim-", "libignition-gazebo-"),
            },
            why="the same of an older release",
        ),
        Good(WORLD.format("", '<sensor name="s" type="imu"/>'), why="Gazebo brings its own list of systems"),
    )

    @staticmethod
    def applies(part: World | Root) -> bool:
        return any(part.unserved_sensors)

    def check(self, part: World | Root) -> Iterator[Diagnostic]:
        seen: set[str] = set()
        severity = Severity.INFO if isinstance(part, World) and not is_whole(part) else None
        where = part.title if isinstance(part, World) else launched(part)
        for sensor, systems in part.unserved_sensors:
            if sensor.type not in seen and sensor.type_value is not None:
                seen.add(sensor.type)
                what = f"no system of {where} serves sensors of type `{sensor.type}`"
                message = f"{what}: {named(systems, 'or')} is missing"
                yield self.diagnostic(sensor.type_value, message, severity=severity)


def launched(root: Root) -> str:
    """The world in which a robot is created, in words."""
    world = root.launched_world
    assert world is not None
    return f"world `{world.name}` in `{world.file}`, in which `{world.span.source.path.name}` creates it,"


def is_whole(world: World) -> bool:
    """Does it list what sensors need, or at least what a world needs?"""
    known = [plugin.known for plugin in world.root.each(Plugin) if plugin.known is not None]
    return any(facts.serves for facts in known) or {facts.file for facts in known} >= USUAL
