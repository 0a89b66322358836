import re
from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Plugin, Root, Rule, Severity, used

NEWEST = "the new Gazebo"
ROS = ("Gazebo Classic with ROS 1", "Gazebo Classic with ROS 2")
ORDER = {"classic": "Gazebo Classic", "ros1": ROS[0], "ros2": ROS[1], "gz": NEWEST}
"""Generation of a plugin → its home, from the oldest to the newest."""
_AROUND = re.compile(
    r"^/?(?:lib)?(?:gazebo_ros_|gazebo_|gz-sim-|ignition-gazebo-)|(?:[-_](?:system|plugin))?(?:\.so)?$"
)
NEW = (
    '<gazebo><plugin filename="gz-sim-joint-state-publisher-system"'
    ' name="gz::sim::systems::JointStatePublisher"/></gazebo>'
)
ROS2 = (
    '<gazebo><plugin filename="libgazebo_ros2_control.so" name="c">'
    "<parameters>c.yaml</parameters></plugin></gazebo>"
)
SENSOR = (
    '<gazebo reference="base"><sensor name="s" type="camera"><camera/>'
    '<plugin filename="{}" name="p"/></sensor></gazebo>'
)


class ForeignPlugin(Rule):
    """A plugin is for another generation of Gazebo or of ROS than the other plugins of its robot.

    Gazebo Classic loads `libgazebo_ros_….so`, its successor `gz-sim-…-system`; neither loads a plugin of the other.
    Plugins that came to ROS 2 under another name, such as `libgazebo_ros_laser.so`, are not there. The simulator logs
    an error and goes on without it: what the plugin does is missing.
    """

    code = "GAZ019"
    name = "foreign-plugin"
    severity = Severity.WARNING
    remedy = """Replace it with the plugin that does the same there, or remove it.

    - New Gazebo: sensors need no plugin of their own, but a system in the world (`gz-sim-sensors-system`,
      `gz-sim-imu-system` …), and `ros_gz_bridge` brings their topics to ROS; drives and joint states have systems
      (`gz-sim-diff-drive-system`, `gz-sim-joint-state-publisher-system`).
    - Gazebo Classic with ROS 2: `libgazebo_ros_ray_sensor.so` for lasers and ranges, `libgazebo_ros_camera.so` for
      cameras of all kinds, `libgazebo_ros_imu_sensor.so`, `libgazebo_ros2_control.so`.

    In a file for several, conditions of xacro choose one of them.
    """
    looks_at = (Root,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            NEW + SENSOR.format("«libgazebo_ros_camera.so»"),
            says="plugin `libgazebo_ros_camera.so` is for Gazebo Classic, and `gz-sim-joint-state-publisher-system` "
            "for the new Gazebo",
        ),
        Bad(
            ROS2 + SENSOR.format("«libgazebo_ros_openni_kinect.so»"),
            says="plugin `libgazebo_ros_openni_kinect.so` is for Gazebo Classic with ROS 1, and "
            "`libgazebo_ros2_control.so` for Gazebo Classic with ROS 2",
        ),
    )
    good = (
        Good(ROS2 + SENSOR.format("libgazebo_ros_camera.so")),
        Good(
            '<gazebo><plugin filename="libgazebo_ros_diff_drive.so" name="old"/>'
            '<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"/></gazebo>',
            why="its successor is beside it: the robot is for both simulators",
        ),
        Good(
            ROS2 + SENSOR.format("libgazebo_ros_depth_camera_of_mine.so"),
            why="nobody knows for whom it was built",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return len(root.elements.get("plugin", ())) > 1 and bool(foreign(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for plugin, where, newest, there, count in foreign(root):
            message = (
                f"plugin `{plugin.filename}` is for {where}, and `{newest.filename}` for {there}{used(count)}"
            )
            yield self.diagnostic(
                plugin.filename_value or plugin, message, labels={newest.filename_value or newest: there}
            )


def foreign(root: Root) -> list[tuple[Plugin, str, Plugin, str, int]]:
    """The plugins that what loads the newest one does not: where they belong, the newest, its home, how many."""
    found: dict[str, dict[str, list[Plugin]]] = {}
    for plugin in root.each(Plugin):
        if plugin.filename_value is not None and (where := ORDER.get(plugin.generation)) is not None:
            found.setdefault(where, {}).setdefault(plugin.filename, []).append(plugin)
    there = next((home for home in reversed(ORDER.values()) if home in found), "")
    if there not in (ROS[1], NEWEST):
        return []
    new = found.pop(there)
    newest = next(iter(new.values()))[0]
    jobs = set(map(job, new))
    return [
        (plugins[0], where, newest, there, len(plugins))
        for where, files in found.items()
        for file, plugins in files.items()
        if (where in ROS or there == NEWEST) and job(file) not in jobs
    ]


def job(filename: str) -> str:
    """The job of a plugin, by the name of its library: ``diff-drive``."""
    return _AROUND.sub("", filename).replace("_", "-")
