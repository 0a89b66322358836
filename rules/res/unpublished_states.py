from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Joint, Plugin, Root, Rule, Severity, Span, Target

WHEELS = "".join(
    f'<link name="{side}"/><joint name="{side}_joint" type="continuous"><origin xyz="0 {y} 0"/>'
    f'<parent link="base"/><child link="{side}"/><axis xyz="0 1 0"/></joint>'
    for side, y in (("left", 0.2), ("right", -0.2))
)
ROBOT = (
    f'<robot name="r"><link name="base"/>{WHEELS}<gazebo><{{}} filename="gz-sim-diff-drive-system" '
    'name="gz::sim::systems::DiffDrive"><left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>'
    "</plugin></gazebo>{}</robot>"
)
STATES = (
    '<gazebo><plugin filename="gz-sim-joint-state-publisher-system" name="gz::sim::systems::JointStatePublisher"/>'
    "</gazebo>"
)
POSES = STATES.replace("joint-state", "pose").replace("JointState", "Pose")
SENDER = "gz-sim-joint-state-publisher-system"
WRONG, SOUND = ROBOT.format("«plugin»", ""), ROBOT.format("plugin", STATES)
LAUNCH = {"sim.launch.py": 'Node(package="robot_state_publisher", executable="robot_state_publisher")\n'}
SHOW = {"view.launch.py": LAUNCH["sim.launch.py"] + 'Node(package="rviz2", executable="rviz2")\n'}
LISTED = STATES.replace(
    '"gz::sim::systems::JointStatePublisher"/>',
    '"gz::sim::systems::JointStatePublisher"><joint_name>left_joint</joint_name></plugin>',
)
BLOCK = (
    '<ros2_control name="b" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="left_joint"><command_interface name="velocity"/><state_interface name="velocity"/></joint>'
    '</ros2_control><gazebo><plugin filename="gz_ros2_control-system" '
    'name="gz_ros2_control::GazeboSimROS2ControlPlugin"><{}>c.yaml</parameters></plugin></gazebo>'
)
CONTROLLED = f'<robot name="r"><link name="base"/>{WHEELS}{BLOCK}</robot>'
CONTROLLERS = {
    "c.yaml": "controller_manager: {ros__parameters: {wheels: {type: velocity_controllers/JointGroupVelocityController"
    "}, states: {type: joint_state_broadcaster/JointStateBroadcaster}}}\n"
    "wheels: {ros__parameters: {joints: [left_joint]}}\n"
}
SPAWNED = {
    "sim.launch.py": LAUNCH["sim.launch.py"]
    + 'Node(package="controller_manager", executable="spawner", arguments=["wheels"{}])\n'
}
SLIDERS = {"view.launch.py": 'Node(package="joint_state_publisher_gui")\n'}


class UnpublishedStates(Rule):
    """Nothing publishes the states of joints of which transforms are made.

    `robot_state_publisher` makes transforms of them: without any RViz says "no transform" for the wheels, and whatever
    hangs on them has no place. The drives of Gazebo move the joints, and publish the odometry alone; its
    JointStatePublisher has no other joints than those that it lists; and with ros2_control the
    `joint_state_broadcaster` has to be started as the other controllers are. Launch files that do nothing but show a
    robot need sliders, such as those of `joint_state_publisher_gui`. Nothing is said of wheels and of RViz if any
    description, launch file, YAML or program of the project speaks of states of joints.
    """

    code = "RES031"
    name = "unpublished-states"
    severity = Severity.WARNING
    remedy = """Add the system that publishes them, and bridge its topic to `/joint_states`.

    ```xml
    <plugin filename="gz-sim-joint-state-publisher-system" name="gz::sim::systems::JointStatePublisher">
      <topic>joint_states</topic>
    </plugin>
    ```

    For RViz alone start `joint_state_publisher_gui`; with ros2_control a `spawner` for the broadcaster.
    In Gazebo Classic the system is `libgazebo_ros_joint_state_publisher.so`.
    """
    looks_at = (Root,)
    bad = (
        Bad(
            WRONG,
            files=LAUNCH,
            says="nothing publishes the states of `left_joint` and the other wheels of drive "
            "`gz::sim::systems::DiffDrive`, of which `sim.launch.py` makes transforms",
        ),
        Bad(
            f'<«robot» name="r"><link name="base"/>{WHEELS}</robot>',
            files=SHOW,
            says="nothing publishes the states of `left_joint` and 1 more joint, of which `view.launch.py` makes trans",
        ),
        Bad(
            ROBOT.format("plugin", LISTED.replace("plugin", "«plugin»", 1)),
            files=LAUNCH,
            says="nothing publishes the state of `right_joint`, which this plugin does not list",
        ),
        Bad(
            CONTROLLED.format("«parameters»"),
            files=CONTROLLERS | {name: text.format("") for name, text in SPAWNED.items()},
            says="no launch file starts `states` of `c.yaml`, which publishes the states of joints",
        ),
    )
    good = (
        Good(
            CONTROLLED.format("parameters"),
            files=CONTROLLERS | {name: text.format(', "states"') for name, text in SPAWNED.items()},
        ),
        Good(SOUND, files=LAUNCH),
        Good(ROBOT.format("plugin", ""), files=LAUNCH | SLIDERS, why="sliders may be meant for it"),
        Good(ROBOT.format("plugin", ""), why="nothing makes transforms of them"),
        Good(
            ROBOT.format("plugin", '<gazebo><plugin filename="my-wheels" name="my::Wheels"/></gazebo>'),
            files=LAUNCH,
            why="nobody knows what it publishes",
        ),
        Good(
            ROBOT.format("plugin", POSES),
            files=LAUNCH,
            why="it publishes the transforms themselves",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return root.is_urdf and next(lost(root), None) is not None

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for target, message, span in lost(root):
            yield self.diagnostic(target, message, labels={span: "here"} if span is not None else None)


def lost(root: Root) -> Iterator[tuple[Target, str, Span | None]]:
    """The part that leaves joints without states, the words for it, and where transforms are made of them."""
    for plugin, broadcaster in root.unstarted_broadcasters:
        place = plugin.file_of_controllers
        if place is None:
            continue
        words = f"`{broadcaster}` of `{place.content.rpartition('/')[2]}`"
        yield place, f"no launch file starts {words}, which publishes the states of joints", None
    joints = moving(root)
    if (left := list(unlisted(root, joints))) and not root.has_other_states:
        more = f" and {len(left) - 1} more joint{'s' * (len(left) > 2)}" * (len(left) > 1)
        words = f"nothing publishes the state{'s' * (len(left) > 1)} of `{left[0][1].name}`{more}"
        yield left[0][0], f"{words}, which this plugin does not list", None
    turning, has_plugins = driver(root), bool(root.elements.get("plugin"))
    if not joints or (turning is None and has_plugins) or (span := root.lost_states) is None:
        return
    where = f"of which `{span.source.path.name}` makes transforms"
    if turning is not None and turning.drive is not None:
        wheels = f"`{turning.drive.left.joint.name}` and the other wheels of {turning.drive.title}"
        yield turning, f"nothing publishes the states of {wheels}, {where}", span
    elif root.is_shown_alone and not has_plugins:
        more = f" and {len(joints) - 1} more joint{'s' * (len(joints) > 2)}" * (len(joints) > 1)
        yield root.element, f"nothing publishes the states of `{joints[0].name}`{more}, {where}", span


def moving(root: Root) -> list[Joint]:
    """The joints of a robot that have a state of their own."""
    robot = root.models[0] if root.models else None
    return [] if robot is None else [each for each in robot.joints if each.moves and each.axis.mimic is None]


def unlisted(root: Root, joints: list[Joint]) -> Iterator[tuple[Plugin, Joint]]:
    """The joints that the only plugin for states does not list, with that."""
    plugins = list(root.each(Plugin))
    senders = [each for each in plugins if each.known is not None and each.known.file == SENDER]
    if len(senders) != 1 or any(plugin.known is None for plugin in plugins):
        return
    listed = {child.content for child in senders[0].children("joint_name")}
    for joint in joints if listed else ():
        if joint.name not in listed:
            yield senders[0], joint


def driver(root: Root) -> Plugin | None:
    """The first plugin of Gazebo that turns wheels, if nothing is unknown that may publish their states."""
    plugins = list(root.each(Plugin))
    if any(plugin.known is None for plugin in plugins):
        return None
    return next((plugin for plugin in plugins if plugin.drive is not None), None)
