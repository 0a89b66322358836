from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Plugin, Root, Rule, Sensor, Severity, replace, used

SUCCESSORS = {"lidar": "gpu_lidar", "ray": "gpu_lidar"}
"""Types that gz-sim 11 makes with the system of ``gz-sim-cpu-lidar-system``, and earlier releases not at all."""
CLASSIC = frozenset(("multicamera", "rfid", "rfidtag", "sonar", "wireless_receiver", "wireless_transmitter"))
DRIVE = (
    '<gazebo><plugin filename="gz-sim-joint-state-publisher-system"'
    ' name="gz::sim::systems::JointStatePublisher"/></gazebo>'
)
SENSOR = (
    '<gazebo reference="base"><sensor name="s" type="{}"><ray><scan><horizontal><samples>9</samples><min_angle>-1'
    "</min_angle><max_angle>1</max_angle></horizontal></scan><range><min>0.1</min><max>9</max></range></ray></sensor>"
    "</gazebo>"
)
CPU_LIDAR = '<gazebo><plugin filename="gz-sim-cpu-lidar-system" name="gz::sim::systems::CpuLidar"/></gazebo>'


class UnmadeSensor(Rule):
    """A sensor is of a type that the new Gazebo does not make, and the plugins beside it are for the new Gazebo.

    Gazebo logs that the type is not supported, and goes on without the sensor: its topic never appears. A `ray` or
    `lidar` is made from release 11 on, if the world lists `gz-sim-cpu-lidar-system`; other types, such as `sonar` and
    `multicamera`, stayed behind in Gazebo Classic.
    """

    code = "GAZ022"
    name = "unmade-sensor"
    severity = Severity.WARNING
    remedy = """Give the sensor a type that the new Gazebo makes.

    - `ray` and `lidar`: `gpu_lidar`, with `gz-sim-sensors-system` in the world. Its `<ray>` stays.
    - `multicamera`: a `camera` for each of its cameras.
    - `sonar`: a `gpu_lidar` with few rays.
    """
    looks_at = (Root,)
    needs = ("<sensor",)
    scaffold = IN_ROBOT
    sources = ("https://github.com/gazebosim/gz-sim/blob/gz-sim9/src/SdfEntityCreator.cc",)

    bad = (
        Bad(
            DRIVE + SENSOR.format("«ray»"),
            fixed=DRIVE + SENSOR.format("gpu_lidar"),
            unsafe=True,
            says="gz-sim before release 11 makes no sensor of type `ray`, and "
            "`gz-sim-joint-state-publisher-system` is for it",
        ),
        Bad(
            DRIVE + '<gazebo reference="base"><sensor name="s" type="«sonar»"/></gazebo>',
            says="gz-sim makes no sensor of type `sonar`",
        ),
    )
    good = (
        Good(DRIVE + SENSOR.format("gpu_lidar")),
        Good(SENSOR.format("ray"), why="nothing says for which Gazebo it is"),
        Good(DRIVE + CPU_LIDAR + SENSOR.format("lidar"), why="release 11 makes it"),
        Good(
            DRIVE
            + SENSOR.format("ray")
            + '<gazebo><plugin filename="libgazebo_ros_diff_drive.so" name="d"/></gazebo>',
            why="the robot is for both simulators",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(unmade(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for plugin, sensors in unmade(root):
            first, value = sensors[0], sensors[0].type_value
            which = "gz-sim before release 11" if first.type in SUCCESSORS else "gz-sim"
            message = f"{which} makes no sensor of type `{first.type}`, and `{plugin.filename}` is for it"
            fix = None
            if value is not None and first.type in SUCCESSORS:
                meant = SUCCESSORS[first.type]
                fix = replace(value, meant, f"write `{meant}`", unsafe=True)
            yield self.diagnostic(
                value or first,
                message + used(len(sensors)),
                labels={plugin.filename_value or plugin: "for the new Gazebo"},
                fix=fix,
            )


def unmade(root: Root) -> list[tuple[Plugin, list[Sensor]]]:
    """The sensors that the Gazebo of its plugins does not make, by type, each with a plugin that shows which it is."""
    found: dict[str, list[Sensor]] = {}
    for sensor in root.each(Sensor):
        if sensor.type in SUCCESSORS or sensor.type in CLASSIC:
            found.setdefault(sensor.type, []).append(sensor)
    if not found:
        return []
    plugins = [plugin for plugin in root.each(Plugin) if plugin.generation]
    if not plugins or any(plugin.generation != "gz" or "cpu-lidar" in plugin.filename for plugin in plugins):
        return []
    return [(plugins[0], sensors) for sensors in found.values()]
