from collections.abc import Iterator

from sdfcheck import (
    Bad,
    ControlComponent,
    Diagnostic,
    Element,
    Good,
    Model,
    Part,
    Rule,
    Sensor,
    Severity,
    Value,
    replace,
)

FRAMES = ("gz_frame_id", "ignition_frame_id", "frame_id")
"""Elements of a sensor that say in which frame its messages are."""
OF_PLUGINS = ("frameName", "frame_name")
FIXED = frozenset(("map", "odom", "world"))
SENSOR = (
    '<robot name="r"><link name="base"/><link name="scan"/>'
    '<joint name="j" type="fixed"><parent link="base"/><child link="scan"/></joint>'
    '<gazebo reference="scan"><sensor name="s" type="imu">{}</sensor></gazebo></robot>'
)
CONTROL = (
    '<robot name="r"><link name="base"/><link name="scan"/>'
    '<joint name="j" type="fixed"><parent link="base"/><child link="scan"/></joint>'
    '<ros2_control name="c" type="sensor"><hardware><plugin>p/P</plugin></hardware><sensor name="s">'
    '<state_interface name="force.x"/><param name="frame_id">{}</param></sensor></ros2_control></robot>'
)
PLUGIN = '<plugin name="laser" filename="libgazebo_ros_ray_sensor.so"><frame_name>{}</frame_name></plugin>'


class UnknownSensorFrame(Rule):
    """The messages of a sensor are in a frame that the robot does not have.

    The frame is a label that Gazebo copies into each message. The names that robot_state_publisher gives to frames
    are those of the links, without a slash before them; in any other frame RViz, navigation and point clouds drop the
    message. Names of links with a prefix, and `map`, `odom` and `world`, count as known.
    """

    code = "GAZ012"
    name = "unknown-sensor-frame"
    severity = Severity.WARNING
    remedy = """Name a link of the robot, without a slash, as it is in the tree of tf2.

    robot_state_publisher publishes the names of the links of the URDF, with its `frame_prefix` before them.
    A camera that ROS processes wants an optical frame: a link turned by `rpy="-1.5708 0 -1.5708"`. If
    another program publishes the frame, ignore this with a comment that names it.
    """
    looks_at = (Sensor, ControlComponent)
    scaffold = SENSOR

    bad = (
        Bad(
            "<gz_frame_id>«/scan»</gz_frame_id>",
            fixed="<gz_frame_id>scan</gz_frame_id>",
            unsafe=True,
            says="frame `/scan` of sensor `s` begins with `/`, which no frame of tf2 does",
        ),
        Bad(
            "<gz_frame_id>«scn»</gz_frame_id>",
            fixed="<gz_frame_id>scan</gz_frame_id>",
            unsafe=True,
            says="frame `scn` of sensor `s` is not a link of robot `r`; did you mean `scan`?",
        ),
        Bad(
            '<camera><optical_frame_id>«"scan"»</optical_frame_id></camera>',
            fixed="<camera><optical_frame_id>scan</optical_frame_id></camera>",
            scaffold=SENSOR.replace("imu", "rgbd_camera"),
            unsafe=True,
            says='frame `"scan"` of sensor `s` is not a link of robot `r`; did you mean `scan`?',
        ),
        Bad(
            PLUGIN.format("«laser_link»"), says="frame `laser_link` of sensor `s` is not a link of robot `r`"
        ),
        Bad(
            "«tool_link»", scaffold=CONTROL, says="frame `tool_link` of sensor `s` is not a link of robot `r`"
        ),
    )
    good = (
        Good("<gz_frame_id>scan</gz_frame_id>", why="a link, also where libsdformat merges it"),
        Good("<gz_frame_id>robot1/scan</gz_frame_id>", why="with the prefix that the publisher adds"),
        Good("<gz_frame_id>odom</gz_frame_id>"),
        Good(PLUGIN.format("scan")),
        Good("scan", scaffold=CONTROL),
        Good(
            "<gz_frame_id>imu</gz_frame_id>",
            scaffold=SENSOR.replace('reference="scan"', 'reference="imu"'),
            why="unreferenced-extension reports the block",
        ),
    )

    @staticmethod
    def applies(part: Sensor | ControlComponent) -> bool:
        return any(foreign(part))

    def check(self, part: Sensor | ControlComponent) -> Iterator[Diagnostic]:
        for value in foreign(part):
            name = value.text.strip()
            message = f"frame `{name}` of {part.title}"
            if name.startswith("/"):
                fix = replace(value, name.lstrip("/"), f"write `{name.lstrip('/')}`", unsafe=True)
                message += " begins with `/`, which no frame of tf2 does"
                yield self.diagnostic(value, message, fix=fix)
                continue
            robot = robot_of(part)
            message += f" is not a link of {robot.title}"
            bare = name.strip("\"'")
            meant = bare if bare in robot.tree.links else part.nearest(name, robot.tree.links)
            yield self.diagnostic(value, message, meant=meant)


def robot_of(part: Part) -> Model:
    """The robot of the URDF file that a part is in."""
    return next(model for model in part.root.each(Model) if model.is_urdf)


def is_in_robot(part: Part) -> bool:
    """Is the robot there, and the part not in one of its parts alone?"""
    return any(model.is_urdf for model in part.root.each(Model))


def foreign(part: Sensor | ControlComponent) -> Iterator[Value]:
    """The frames of a sensor that no link has, with a prefix or without; not the link that its own block lacks."""
    if not is_in_robot(part):
        return
    robot = robot_of(part)
    for element in frames(part):
        name = element.content.strip()
        if not name or "$" in name or "{" in name or name in robot.lost_references:
            continue
        links = robot.tree.links
        is_known = name in FIXED or not robot.is_complete or name.rpartition("/")[2] in links
        is_known |= any(name.endswith(link) for link in links)
        if name.startswith("/") or not is_known:
            yield element.own_value


def frames(part: Sensor | ControlComponent) -> Iterator[Element]:
    """The elements that name the frame of a sensor in URDF: its own, those of its plugins and of ros2_control."""
    if isinstance(part, ControlComponent):
        if part.what == "sensor":
            yield from (each for each in part.children("param") if each.attributes.get("name") == "frame_id")
    elif part.is_extension:
        for name in FRAMES:
            yield from part.children(name)
        for camera in part.children("camera"):
            yield from camera.children("optical_frame_id")
        for plugin in part.plugins:
            yield from (child for child in plugin.parameters if child.name in OF_PLUGINS)
