from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Link, Rule, Sensor, Severity, Value
from sdfcheck_rules.gaz.unknown_sensor_frame import frames, is_in_robot, robot_of

PLUGINS = frozenset(("gazebo_ros_camera", "gazebo_ros_depth_camera", "gazebo_ros_openni_kinect"))
"""Those of Gazebo Classic that make a cloud of points of the picture of a depth camera."""
ALIGNED = 0.99
"""The cosine of the angle between the view of the camera and the x axis of the frame."""
ROBOT = (
    '<robot name="r"><link name="base"/><link name="camera"/><link name="depth"/>'
    '<joint name="j" type="fixed"><parent link="base"/><child link="camera"/></joint>'
    '<joint name="k" type="fixed"><parent link="camera"/><child link="depth"/>{}</joint>'
    '<gazebo reference="camera"><sensor name="s" type="depth">{}<camera/>'
    '<plugin filename="libgazebo_ros_camera.so" name="p"><frame_name>{}</frame_name></plugin></sensor></gazebo></robot>'
)
TURN = '<origin rpy="-1.5708 0 -1.5708"/>'


class UnturnedCloudFrame(Rule):
    """The points of a depth camera are in a frame that is turned as the camera is.

    The plugins of Gazebo Classic write points as a picture has them, z forward, x to the right and y down (an optical
    frame, REP 103), whereas the camera itself looks along x. In a frame that is not turned the floor stands like a wall
    in front of the robot. The sensors of the new Gazebo write points with x forward and are left out.
    """

    code = "GAZ024"
    name = "unturned-cloud-frame"
    severity = Severity.WARNING
    remedy = """Name an optical frame in the plugin.

    That is a link without shapes, on a fixed joint with `<origin rpy="-1.5708 0 -1.5708"/>` below the link of the
    camera, usually called `camera_optical_frame`.
    """
    looks_at = (Sensor,)
    needs = ("gazebo_ros_",)

    bad = (
        Bad(
            ROBOT.format("", "", "«depth»"),
            says="the points of sensor `s` are in frame `depth`, which is turned as the sensor is",
        ),
        Bad(ROBOT.format(TURN, "", "«camera»")),
        Bad(ROBOT.format("", '<pose degrees="true">0 0 0 0 0 360</pose>', "«depth»")),
    )
    good = (
        Good(ROBOT.format(TURN, "", "depth")),
        Good(ROBOT.format("", "<pose>0 0 0 -1.5708 -1.5708 0</pose>", "depth"), why="the sensor is turned"),
        Good(ROBOT.format("", "", "depth").replace('"depth">', '"camera">'), why="pictures alone"),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return unturned(sensor) is not None

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        found = unturned(sensor)
        assert found is not None
        value, link = found
        message = f"the points of {sensor.title} are in frame `{link.name}`, which is turned as the sensor is"
        labels = {link.parent_joints[0]: "has to turn it"} if link.parent_joints else {}
        yield self.diagnostic(value, message, help="name an optical frame, where z is forward", labels=labels)


def unturned(sensor: Sensor) -> tuple[Value, Link] | None:
    """The frame of a depth camera of Gazebo Classic whose x axis is where the camera looks, and its link."""
    if sensor.type != "depth" or not sensor.is_extension or sensor.view is None or not has_cloud(sensor):
        return None
    if not is_in_robot(sensor):
        return None
    named = (each for each in frames(sensor) if each.parent is not None and each.parent.name == "plugin")
    value = next((each.own_value for each in named), None)
    link = robot_of(sensor).tree.links.get(value.text.strip()) if value is not None else None
    if value is None or link is None or link.at_rest is None:
        return None
    along = sum(a * b for a, b in zip(sensor.view, link.at_rest.turned((1.0, 0.0, 0.0)), strict=True))
    return (value, link) if along > ALIGNED else None


def has_cloud(sensor: Sensor) -> bool:
    """Does a plugin of Gazebo Classic publish its points?"""
    return any(plugin.known is not None and plugin.known.file in PLUGINS for plugin in sensor.plugins)
