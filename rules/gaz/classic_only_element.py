import re
from collections.abc import Iterator

from sdfcheck import (
    IN_LINK,
    IN_MODEL,
    IN_WORLD,
    Bad,
    Diagnostic,
    Good,
    Plugin,
    Root,
    Rule,
    Sensor,
    Severity,
    Target,
    used,
)

ELEMENTS = {
    "audio": "world",
    "audio_sink": "link",
    "audio_source": "link",
    "camera": "gui",
    "gripper": "model",
    "population": "world",
    "road": "world",
    "state": "world",
}
"""Element → the parent in which it is meant."""

SENSORS = frozenset(("multicamera", "rfid", "rfidtag", "sonar", "wireless_receiver", "wireless_transmitter"))

PLUGIN = re.compile(r"libgazebo_\w+\.so|lib\w+Plugin\.so")
"""The bridges to ROS, and the plugins that came with it, such as ``libDiffDrivePlugin.so``."""


class ClassicOnlyElement(Rule):
    """An element, sensor type or plugin that only Gazebo Classic reads.

    Gazebo Classic came to its end in 2025. Its successor loads other plugins, does
    sound, grippers and the view with plugins, and has no populations, roads or saved states.
    The elements are ignored; a plugin that cannot be loaded is an error on the console.
    """

    code = "GAZ002"
    name = "classic-only-element"
    severity = Severity.WARNING
    remedy = """Replace it with the system of new Gazebo that does the same, or remove it.

    Most plugins of Classic have a successor: `gz-sim-diff-drive-system` for the drives,
    `gz-sim-joint-state-publisher-system` for joint states, sensors without any plugin, but with their
    system in the world (`gz-sim-sensors-system`, `gz-sim-imu-system` …), and the bridge `ros_gz_bridge` for
    topics of ROS. `gazebo_ros2_control` is `gz_ros2_control`. In a file for both, conditions of xacro
    choose one of them.
    """
    default = False
    looks_at = (Root,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            '<plugin filename="«libgazebo_ros_diff_drive.so»" name="drive"/>',
            says="plugin `libgazebo_ros_diff_drive.so` is for Gazebo Classic only",
        ),
        Bad(
            '<«road» name="a"><point>0 0 0</point><point>1 0 0</point></road>',
            says="`road` in `world` is for Gazebo Classic only",
            scaffold=IN_WORLD,
        ),
        Bad(
            '<sensor name="s" type="«sonar»"><sonar><min>0</min><max>1</max></sonar></sensor>',
            scaffold=IN_LINK,
        ),
        Bad("<«audio_sink»/><audio_sink/>", says="(used 2 times)", scaffold=IN_LINK),
    )
    good = (
        Good('<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"/>'),
        Good('<plugin filename="libmine.so" name="mine"/>', why="nobody knows for whom it was built"),
        Good(
            '<sensor name="s" type="camera"><camera/></sensor>',
            why="a sensor, not the view",
            scaffold=IN_LINK,
        ),
    )

    def check(self, root: Root) -> Iterator[Diagnostic]:
        found: dict[str, list[Target]] = {}
        for target, what in _uses(root):
            found.setdefault(what, []).append(target)
        for what, targets in found.items():
            yield self.diagnostic(targets[0], f"{what} is for Gazebo Classic only{used(len(targets))}")


def _uses(root: Root) -> Iterator[tuple[Target, str]]:
    if not root.is_urdf:
        for name, parent in ELEMENTS.items():
            for element in root.elements.get(name, ()):
                if element.parent is not None and element.parent.name == parent:
                    yield element, f"`{name}` in `{parent}`"
        for sensor in root.each(Sensor):
            if sensor.type in SENSORS and sensor.type_value is not None:
                yield sensor.type_value, f"sensor type `{sensor.type}`"
    for plugin in root.each(Plugin):
        if plugin.filename_value is not None and PLUGIN.fullmatch(plugin.filename):
            yield plugin.filename_value, f"plugin `{plugin.filename}`"
