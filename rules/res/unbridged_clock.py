from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Root, Rule, Severity

ROBOT = '<{} name="r"><link name="a"/></robot>'
CREATE = 'Node(package="ros_gz_sim", executable="create", arguments=["-file", "robot.urdf"])\n'
TIMED = 'Node(package="robot_state_publisher", parameters=[{"use_sim_time": True}])\n'
BRIDGE = 'Node(package="ros_gz_bridge", arguments=["/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry"{}])\n'
CLOCK = ', "/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"'


def launch(text: str) -> dict[str, str]:
    return {"sim.launch.py": text}


class UnbridgedClock(Rule):
    """Nodes take the time of Gazebo, and no bridge carries its clock.

    With `use_sim_time` a node waits for `/clock`, which the new Gazebo has in its own messages alone: the time stays 0,
    transforms are never new enough, timers do not run, and controllers say "No clock received". Nothing is said if any
    launch file, YAML or program of the project speaks of a clock, or the launch file includes one of another package
    that may carry it.
    """

    code = "RES032"
    name = "unbridged-clock"
    severity = Severity.WARNING
    remedy = """Add the clock to the bridge: `/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock`.

    In its YAML:

    ```yaml
    - ros_topic_name: /clock
      gz_topic_name: /clock
      ros_type_name: rosgraph_msgs/msg/Clock
      gz_type_name: gz.msgs.Clock
      direction: GZ_TO_ROS
    ```
    """
    looks_at = (Root,)
    scaffold = "{}"

    bad = (
        Bad(
            ROBOT.format("«robot»"),
            file="robot.urdf",
            files=launch(CREATE + TIMED + BRIDGE.format("")),
            says="`sim.launch.py` takes the time of Gazebo, and no bridge carries its clock",
        ),
    )
    good = (
        Good(ROBOT.format("robot"), file="robot.urdf", files=launch(CREATE + TIMED + BRIDGE.format(CLOCK))),
        Good(
            ROBOT.format("robot"),
            file="robot.urdf",
            files=launch(CREATE + BRIDGE.format("")),
            why="all nodes have their own time",
        ),
        Good(
            ROBOT.format("robot"),
            file="robot.urdf",
            files=launch(CREATE + TIMED),
            why="nobody knows how messages get to ROS",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return root.unbridged_clock is not None

    def check(self, root: Root) -> Iterator[Diagnostic]:
        span = root.unbridged_clock
        assert span is not None
        file = span.source.path.name
        message = f"`{file}` takes the time of Gazebo, and no bridge carries its clock"
        yield self.diagnostic(root.element, message, labels={span: "taken here"})
