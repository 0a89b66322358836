from collections.abc import Iterator

from sdfcheck import IN_WORLD, Bad, Diagnostic, Good, Plugin, Rule, Severity, named

DRIVE = (
    '<{} name="gz::sim::systems::DiffDrive" filename="gz-sim-diff-drive-system">'
    "<left_joint>left</left_joint><right_joint>right</right_joint></plugin>"
)
BROADCAST = '<{} name="gz::sim::systems::SceneBroadcaster" filename="gz-sim-scene-broadcaster-system"/>'
CAMERA = '<{} name="camera" filename="libgazebo_ros_camera.so"/>'
IN_ROBOT = '<robot name="r"><link name="base"/><gazebo{}</gazebo></robot>'
WHEELS = '<static>true</static><link name="base"/>'


class MisplacedPlugin(Rule):
    """A plugin of Gazebo is in an element in which it does not run.

    Systems that drive a robot belong to its model, those of a camera to the sensor, and a few to the world. Elsewhere
    they report an error and stay off; Gazebo Classic compares the kind of the plugin with its place, and does not load
    it. Some run, and take the name of a model for that of the world, so that their topics and services have names that
    nobody asks for.
    """

    code = "RES026"
    name = "misplaced-plugin"
    severity = Severity.ERROR
    remedy = """Move the plugin into the element that the message names.

    In a world file that is the `<model>` that it drives, in URDF a `<gazebo>` block without `reference`. A plugin of a
    sensor goes into the `<sensor>`, which URDF has in `<gazebo reference="LINK">`.
    """
    looks_at = (Plugin,)
    scaffold = IN_WORLD
    sources = ("https://github.com/gazebosim/gz-sim/tree/main/src/systems",)

    bad = (
        Bad(
            DRIVE.format("«plugin»"),
            says="plugin `gz::sim::systems::DiffDrive` runs in `model` only, and is in world `w`",
        ),
        Bad(
            CAMERA.format("«plugin»"),
            scaffold=IN_ROBOT.format(">{}"),
            says="plugin `camera` runs in `sensor` only, and is in the robot",
        ),
        Bad(
            f'<model name="m">{WHEELS}{BROADCAST.format("«plugin»")}</model>',
            says="takes the name of model `m` for that of the world, so its topics and services are not found",
        ),
    )
    good = (
        Good(BROADCAST.format("plugin")),
        Good(
            CAMERA.format("plugin"),
            scaffold=IN_ROBOT.format(
                ' reference="base"><sensor name="c" type="camera"><camera><horizontal_fov>1</horizontal_fov><image>'
                "<width>320</width><height>240</height></image><clip><near>0.1</near><far>9</far></clip></camera>{}"
                "</sensor>"
            ),
        ),
        Good(
            '<model name="m"><static>true</static><link name="l"/>'
            '<plugin name="gz::sim::systems::Imu" filename="gz-sim-imu-system"/></model>',
            why="it serves the sensors of the whole world from there, too",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return plugin.is_misplaced

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        facts, parent = plugin.known, plugin.element.parent
        assert facts is not None
        assert parent is not None
        here = "the robot" if parent.name == "gazebo" else parent.title
        if facts.runs_elsewhere:
            words = (
                f"takes the name of {here} for that of the world, so its topics and services are not found"
            )
            yield self.diagnostic(plugin, f"{plugin.title} {words}", severity=Severity.WARNING)
        else:
            words = f"runs in {named(facts.places, 'or')} only, and is in {here}"
            yield self.diagnostic(plugin, f"{plugin.title} {words}")
