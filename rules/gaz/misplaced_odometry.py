from collections.abc import Iterator
from math import dist

from sdfcheck import (
    IN_ROBOT,
    Bad,
    Diagnostic,
    Drive,
    Good,
    Link,
    Model,
    Parameter,
    Plugin,
    Rule,
    Severity,
    Value,
)
from sdfcheck_rules.gaz.unknown_sensor_frame import is_in_robot, robot_of

DRIVE = (
    '<link name="wheel"/><joint name="j" type="continuous"><parent link="base"/><child link="wheel"/></joint><gazebo>'
    '<plugin filename="libgazebo_ros_planar_move.so" name="d"><robotBaseFrame>{}</robotBaseFrame></plugin></gazebo>'
)
CONTROLLED = (
    '<link name="wheel"/><joint name="j" type="continuous"><parent link="base"/><child link="wheel"/></joint>'
    '<ros2_control name="c" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="j"><command_interface name="velocity"/></joint></ros2_control><gazebo>'
    '<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<{}>c.yaml</parameters></plugin></gazebo>"
)
COUNTED = "".join(
    f'<link name="{side}"/><joint name="{side}_joint" type="continuous"><origin xyz="{{x}} {y} 0"/>'
    f'<parent link="base"/><child link="{side}"/><axis xyz="0 1 0"/></joint>'
    for side, y in (("left", 0.2), ("right", -0.2))
) + (
    '<gazebo><{plugin} filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">'
    "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint></plugin></gazebo>"
)


def controller(base: str, more: str = "") -> dict[str, str]:
    kind = "diff_drive_controller/DiffDriveController"
    wheels = "left_wheel_names: [$(var left)], right_wheel_names: [$(var right)]"
    given = f"{wheels}, wheel_separation: 0.3, wheel_radius: 0.1, base_frame_id: {base}{more}"
    return {"c.yaml": f"drive: {{ros__parameters: {{type: {kind}, {given}}}}}\n"}


NAMES = ("robot_base_frame", "robotBaseFrame", "child_frame_id")
SWITCHES = {
    "gazebo_ros_skid_steer_drive": ("broadcastTF", False),
    "gazebo_ros_diff_drive": ("publishOdomTF", True),
}
"""Plugin of ROS 1 → what switches its transform, and whether it is on by default."""


NEAR, PART = 0.02, 0.05
"""m, and of the distance of the wheels: of 24 robots with a drive of two wheels 21 have their base between these."""
COUNTING = ("gz-sim-diff-drive-system", "gazebo_ros_diff_drive")
"""Plugins that compute the odometry from the turns of two wheels; those of Gazebo Classic where a parameter says so."""


class MisplacedOdometry(Rule):
    """A drive publishes the odometry of a link that is not the root of the robot, or not between its wheels.

    In the tree of tf a frame has one parent. `robot_state_publisher` says that the link hangs on another one, and the
    plugin that it hangs on `odom`: the tree falls into two, and what looks up a transform fails or sees the robot jump.
    A link that the robot does not have is not tied to the robot at all. The drives of ros2_control say the link as
    `base_frame_id`, in the file that the plugin of the simulator names.

    A drive of two wheels counts their turns, from which follows how the middle between them moves. Where the link is
    beside it, all sensors are elsewhere after each turn than the odometry says.
    """

    code = "GAZ020"
    name = "misplaced-odometry"
    severity = Severity.WARNING
    remedy = """Name the root link of the robot, such as `base_footprint`, and put it between the driven wheels.

    A root in the middle of the chassis can stay, if another link between the wheels becomes its parent.
    """
    looks_at = (Plugin,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            DRIVE.format("«wheel»"),
            says="link `wheel` hangs on link `base`, and `robotBaseFrame` would hang it on the odometry",
        ),
        Bad(
            DRIVE.format("«bases»"),
            fixed=DRIVE.format("base"),
            unsafe=True,
            says="`bases` is not a link of robot `r`, and nothing ties",
        ),
        Bad(
            CONTROLLED.format("«parameters»"),
            files=controller("wheel"),
            says="link `wheel` hangs on link `base`, and `base_frame_id` of controller `drive` would hang it",
        ),
        Bad(
            COUNTED.format(x="-0.1", plugin="«plugin»"),
            says="is that of the middle between its wheels, and link `base` is 0.1 m beside it",
        ),
    )
    good = (
        Good(DRIVE.format("base")),
        Good(COUNTED.format(x="0.01", plugin="plugin")),
        Good(DRIVE.format("robot1/base"), why="with the prefix that robot_state_publisher adds"),
        Good(
            DRIVE.format("wheel"),
            files={
                "package.xml": "<package><name>r</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
            },
            why="the plugin of ROS 2 does not read it",
        ),
        Good(CONTROLLED.format("parameters"), files=controller("base")),
        Good(
            CONTROLLED.format("parameters"),
            files=controller("wheel", ", enable_odom_tf: false"),
            why="something else publishes it",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        if not plugin.is_extension:
            return False
        return carried(plugin) is not None or bool(written(plugin)) or any(beside(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for parameter, hanging in written(plugin):
            above = hanging.parent_joints[0]
            by = f"`base_frame_id` of controller `{parameter.name}` would hang it on the odometry"
            yield self.diagnostic(
                plugin.file_of_controllers or plugin,
                f"{hanging.title} hangs on link `{above.parent_name}`, and {by}",
                labels={parameter.span: "written here", above: "hangs it there"},
            )
        for drive, base, apart in beside(plugin):
            yield self.diagnostic(
                plugin.file_of_controllers or plugin,
                f"the odometry of {drive.title} is that of the middle between its wheels, and {base.title} is"
                f" {apart:.3g} m beside it",
                labels={
                    base: "this link",
                    drive.left.joint: "the left wheel",
                    drive.right.joint: "the right wheel",
                },
            )
        found = carried(plugin)
        if found is None:
            return
        value, robot, link = found
        if link is None:
            name = value.text.strip()
            message = f"`{name}` is not a link of {robot.title}, and nothing ties the odometry to the robot"
            yield self.diagnostic(value, message, meant=plugin.nearest(name, robot.tree.links))
            return
        joint = link.parent_joints[0]
        parent, name = joint.parent_name, value.element.name
        message = f"{link.title} hangs on link `{parent}`, and `{name}` would hang it on the odometry"
        yield self.diagnostic(value, message, labels={joint: "hangs it there"})


def written(plugin: Plugin) -> list[tuple[Parameter, Link]]:
    """The links that controllers carry about in tf, if a joint leads to them."""
    if "ros2_control" not in plugin.filename or not plugin.controllers.frames:
        return []
    links = robot_of(plugin).tree.links
    found = ((each, links.get(each.content)) for each in plugin.controllers.frames)
    return [(parameter, link) for parameter, link in found if link is not None and link.parent_joints]


def carried(plugin: Plugin) -> tuple[Value, Model, Link | None] | None:
    """The link that a plugin carries about in tf, if a joint leads to it or it is not there."""
    value = next((found for name in NAMES if (found := plugin.value(name)) is not None), None)
    facts = plugin.known
    if value is None or facts is None or not plugin.is_extension or not facts.reads(value.element.name):
        return None
    switch, default = SWITCHES.get(facts.file, ("", True))
    if facts.generation == "gazebo_ros2":
        switch, default = "publish_odom_tf", False
    given = (plugin.get(switch) or "").strip().lower() if switch else ""
    if given in {"false", "0"} or (not given and not default):
        return None
    robot, name = robot_of(plugin), value.text.strip()
    links = robot.tree.links
    if facts.generation == "gz-sim" and (name in links or "/" in name):
        return None  # its transforms reach ROS only where somebody asks for them
    if name in links:
        return (value, robot, links[name]) if links[name].parent_joints else None
    is_other = not name or "$" in name or any(name.endswith(link) for link in links)
    return None if is_other or not robot.is_complete else (value, robot, None)


def beside(plugin: Plugin) -> Iterator[tuple[Drive, Link, float]]:
    """The drives of two wheels that publish the odometry of a link which is not between them, and how far it is."""
    for drive in plugin.drives if is_in_robot(plugin) else ():
        base = base_of(plugin, drive)
        if len(drive.lefts) != 1 or base is None or base.at_rest is None or abs(drive.left.axis[2]) > PART:
            continue
        ends = (drive.left.position, drive.right.position)
        apart = dist([sum(each) / 2 for each in zip(*ends, strict=True)][:2], base.at_rest.position[:2])
        if apart > max(NEAR, PART * abs(drive.distance)):
            yield drive, base, apart


def base_of(plugin: Plugin, drive: Drive) -> Link | None:
    """The root of the robot, if a drive that counts the turns of its wheels publishes its odometry."""
    if "ros2_control" in plugin.filename:
        named = [each.content for each in plugin.controllers.frames if drive.title.endswith(f"`{each.name}`")]
        is_counted = bool(named)
    else:
        named = [text for name in NAMES if (text := plugin.get(name))]
        source = plugin.get("odometry_source") or plugin.get("odometrySource") or ""
        facts = plugin.known
        is_counting = facts is not None and (
            facts.generation == "gz-sim" or source.strip().lower() in {"0", "encoder"}
        )
        is_counted = facts is not None and facts.file in COUNTING and is_counting
    if not is_counted:
        return None
    roots = [link for link in robot_of(plugin).tree.links.values() if not link.parent_joints]
    is_root = len(roots) == 1 and all(name.strip().endswith(roots[0].name) for name in named)
    return roots[0] if is_root else None
