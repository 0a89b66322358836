from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Plugin, Root, Rule, Severity, Target

DRIVES = frozenset(
    f"gazebo_ros_{name}" for name in ("ackermann_drive", "diff_drive", "planar_move", "tricycle_drive")
)
YES = frozenset(("true", "1"))
ROBOT = (
    '<robot name="r"><link name="base"/><gazebo><plugin name="d" filename="libgazebo_ros_planar_move.so">'
    "<ros><namespace>r</namespace></ros><publish_odom_tf>{}</publish_odom_tf><robot_base_frame>base</robot_base_frame>"
    "</plugin></gazebo></robot>"
)
CONTROLLED = (
    '<robot name="r"><link name="base"/><gazebo><plugin filename="gz_ros2_control-system" '
    'name="gz_ros2_control::GazeboSimROS2ControlPlugin"><{}>c.yaml</parameters></plugin></gazebo></robot>'
)
FILTER = "filter:\n  ros__parameters:\n    odom_frame: odom\n    base_link_frame: base\n    world_frame: {}\n"
LAUNCH = (
    'Node(package="gazebo_ros", executable="spawn_entity.py")\n'
    'Node(package="robot_localization", parameters=["{}"])\n'
)
DRIVE = (
    "drive: {{ros__parameters: {{type: diff_drive_controller/DiffDriveController, base_frame_id: base, "
    "left_wheel_names: [$(var left)], right_wheel_names: [$(var right)], wheel_separation: 0.3, wheel_radius: 0.1, "
    "enable_odom_tf: {}}}}}\n"
)


def files(world: str = "odom", named: str = "ekf.yaml", **others: str) -> dict[str, str]:
    more = {"c.yaml": DRIVE.format(others["drive"])} if others else {}
    return {"ekf.yaml": FILTER.format(world), "sim.launch.py": LAUNCH.format(named), **more}


class ContestedOdometry(Rule):
    """The drive of a robot and a filter of its odometry publish the place of one link.

    `robot_localization` makes one odometry of those of the wheels and of an inertial sensor, and publishes it as the
    transform from `odom` to the base of the robot. Where the drive in Gazebo sends that of its wheels as well, the
    robot jumps between two places, and maps are smeared. Looked at are YAML files that a launch file names which also
    starts Gazebo, without conditions.
    """

    code = "GAZ036"
    name = "contested-odometry"
    severity = Severity.WARNING
    remedy = """Turn off the transform of the drive: `<publish_odom_tf>false</publish_odom_tf>`.

    In a `diff_drive_controller` that is `enable_odom_tf: false`. Without a filter that is wanted, `publish_tf: false`
    turns off that of the filter.
    """
    looks_at = (Root,)
    needs = ("publish_odom_tf", "ros2_control")
    sources = ("https://docs.ros.org/en/melodic/api/robot_localization/html/preparing_sensor_data.html",)

    bad = (
        Bad(
            ROBOT.format("«true»"),
            files=files(),
            says="the place of `base` is published by plugin `d` and by `filter` of `ekf.yaml`",
        ),
        Bad(
            CONTROLLED.format("«parameters»"),
            files=files(drive="true"),
            says="is published by controller `drive` and by `filter` of `ekf.yaml`",
        ),
    )
    good = (
        Good(ROBOT.format("false"), files=files()),
        Good(ROBOT.format("true"), files=files("map"), why="the filter corrects the place in the map"),
        Good(ROBOT.format("true"), files=files(named="other.yaml"), why="nothing starts the filter with it"),
        Good(CONTROLLED.format("parameters"), files=files(drive="false")),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return any(True for _ in contested(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for place, title, name in contested(root):
            found = next(each for each in root.odometry_filters if each.name == name)
            by = f"by `{found.node}` of `{found.span.source.path.name}`"
            message = f"the place of `{name}` is published by {title} and {by}"
            yield self.diagnostic(place, message, labels={found.span: "published here"})


def contested(root: Root) -> Iterator[tuple[Target, str, str]]:
    """The parameters by which a drive publishes a link that a filter publishes, its title, and that link."""
    for place, title, name in published(root):
        if any(each.name == name for each in root.odometry_filters):
            yield place, title, name


def published(root: Root) -> Iterator[tuple[Target, str, str]]:
    """The parameters by which drives publish the odometry of a link, their titles, and that link."""
    for plugin in root.each(Plugin) if root.is_urdf else ():
        for frame in plugin.controllers.frames if "ros2_control" in plugin.filename else ():
            yield plugin.file_of_controllers or plugin, f"controller `{frame.name}`", frame.content
        switch = plugin.value("publish_odom_tf")
        is_on = switch is not None and switch.text.strip().lower() in YES
        if switch is not None and is_on and plugin.known is not None and plugin.known.file in DRIVES:
            yield switch, plugin.title, (plugin.get("robot_base_frame") or "base_footprint").strip()
