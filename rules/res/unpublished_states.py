from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Plugin, Root, Rule, Severity

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
WRONG, SOUND = ROBOT.format("«plugin»", ""), ROBOT.format("plugin", STATES)
LAUNCH = {"sim.launch.py": 'Node(package="robot_state_publisher", executable="robot_state_publisher")\n'}
SLIDERS = {"view.launch.py": 'Node(package="joint_state_publisher_gui")\n'}


class UnpublishedStates(Rule):
    """Nothing publishes the states of the wheels that a drive turns in Gazebo.

    `robot_state_publisher` makes transforms of them: without any RViz says "no transform" for the wheels, and whatever
    hangs on them has no place. The drives of Gazebo move the joints, and publish the odometry alone. Nothing is said if
    any description, launch file, YAML or program of the project speaks of states of joints.
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

    In Gazebo Classic that is `libgazebo_ros_joint_state_publisher.so`.
    """
    looks_at = (Root,)
    needs = ("drive",)

    bad = (
        Bad(
            WRONG,
            files=LAUNCH,
            says="nothing publishes the states of `left_joint` and the other wheels of drive "
            "`gz::sim::systems::DiffDrive`, of which `sim.launch.py` makes transforms",
        ),
    )
    good = (
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
        return root.is_urdf and driver(root) is not None and root.lost_states is not None

    def check(self, root: Root) -> Iterator[Diagnostic]:
        plugin, span = driver(root), root.lost_states
        assert plugin is not None
        assert plugin.drive is not None
        assert span is not None
        joint, drive = plugin.drive.left.joint.name, plugin.drive.title
        yield self.diagnostic(
            plugin,
            f"nothing publishes the states of `{joint}` and the other wheels of {drive}, of which "
            f"`{span.source.path.name}` makes transforms",
            labels={span: "here"},
        )


def driver(root: Root) -> Plugin | None:
    """The first plugin of Gazebo that turns wheels, if nothing is unknown that may publish their states."""
    plugins = list(root.each(Plugin))
    if any(plugin.known is None for plugin in plugins):
        return None
    return next((plugin for plugin in plugins if plugin.drive is not None), None)
