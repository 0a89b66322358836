from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Root, Rule, Severity

SENSOR = '<sensor name="imu" type="imu">{}</sensor>'
ROBOT = '<robot name="r"><link name="a"/><gazebo reference="a">{}</gazebo></robot>'
DRIVE = '<{} filename="gz-sim-velocity-control-system" name="gz::sim::systems::VelocityControl">{}</plugin>'
IN_ROBOT = '<robot name="r"><link name="a"/><gazebo>{}</gazebo></robot>'
IMU = "gz_topic_name: /imu/data, gz_type_name: gz.msgs.IMU"
MADE = "gz_topic_name: world/w/model/r/link/{}/sensor/imu/imu, gz_type_name: gz.msgs.IMU"
LAUNCH = (
    "Node(package='ros_gz_bridge', executable='parameter_bridge', arguments=["
    "'/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist', '/odom@nav_msgs/msg/Odometry[gz.msgs.Odometry'])\n"
)


def bridge(entry: str) -> dict[str, str]:
    return {"bridge.yaml": f"- {{{entry}, ros_topic_name: /imu, direction: GZ_TO_ROS}}\n"}


class UnbridgedTopic(Rule):
    """A bridge to ROS carries a topic that nobody has, or in the wrong direction, and not that which was meant.

    `ros_gz_bridge` compares names of topics and waits for those that are not there: it says nothing, the topic in ROS
    is listed, and stays empty. One that goes in the wrong direction alone, `[` or `GZ_TO_ROS` for commands, leaves the
    robot without them. Looked at are the YAML and launch files of the project. Nothing is said where a launch
    file computes a topic for messages of that type, where a topic comes from an expression of xacro, and where another
    description of the project may have the topic.
    """

    code = "RES030"
    name = "unbridged-topic"
    severity = Severity.WARNING
    remedy = """Write one topic in both files, and the direction in which the messages go.

    In arguments of `parameter_bridge` `[` is from Gazebo to ROS, `]` to Gazebo, and `@` both.
    `gz topic -l` lists the topics of a simulation that runs. A sensor without `<topic>` publishes on
    `/world/W/model/M/link/L/sensor/S/scan` or the like, where the link is the one that fixed joints of URDF
    are merged into, and a drive listens to `/model/M/cmd_vel`.
    """
    looks_at = (Root,)
    scaffold = ROBOT

    bad = (
        Bad(
            SENSOR.format("<topic>«imu»</topic>"),
            files=bridge(IMU),
            says="sensor `imu` publishes on `imu`, and `bridge.yaml` takes `imu/data` to ROS, on which nobody "
            "publishes",
        ),
        Bad(
            SENSOR.format("").replace("sensor", "«sensor»", 1),
            files=bridge(IMU),
            says="sensor `imu` has no `<topic>`, and `bridge.yaml` takes `imu/data` to ROS, on which nobody publishes",
        ),
        Bad(
            SENSOR.format("").replace("sensor", "«sensor»", 1),
            files=bridge(MADE.format("imu_link")),
            says="publishes on a topic with `link/a/sensor/imu`, and `bridge.yaml` takes "
            "`world/w/model/r/link/imu_link/sensor/imu/imu` to ROS",
        ),
        Bad(
            DRIVE.format("«plugin»", ""),
            scaffold=IN_ROBOT,
            files={"launch/sim.launch.py": LAUNCH},
            says="has no `<topic>`, and `sim.launch.py` takes `cmd_vel` to Gazebo, to which nobody listens",
        ),
        Bad(
            DRIVE.format("plugin", "<topic>«cmd_vel»</topic>"),
            scaffold=IN_ROBOT,
            files={"launch/sim.launch.py": LAUNCH.replace("/cmd_vel", "/model/r/cmd_vel")},
            says="listens to `cmd_vel`, and `sim.launch.py` takes `model/r/cmd_vel` to Gazebo, to which nobody listens",
        ),
        Bad(
            DRIVE.format("plugin", "<topic>«cmd_vel»</topic>"),
            scaffold=IN_ROBOT,
            files={"launch/sim.launch.py": LAUNCH.replace("]", "[", 1)},
            says="listens to `cmd_vel`, and `sim.launch.py` takes that from Gazebo to ROS alone",
        ),
    )
    good = (
        Good(SENSOR.format(""), files=bridge(MADE.format("a"))),
        Good(SENSOR.format("<topic>imu/data</topic>"), files=bridge(IMU)),
        Good(SENSOR.format("<topic>/imu/data</topic>"), files=bridge(IMU)),
        Good(
            SENSOR.format("<topic>imu</topic>"),
            files={
                **bridge(IMU),
                "other.sdf": "<sdf><model><plugin><topic>imu/data</topic></plugin></model></sdf>",
            },
            why="another model may publish there",
        ),
        Good(
            SENSOR.format("<topic>imu</topic>"),
            files={
                **bridge(IMU),
                "b.yaml": "- {gz_topic_name: $(var n), gz_type_name: gz.msgs.IMU}\n",
            },
            why="a topic is computed",
        ),
        Good(
            DRIVE.format("plugin", "<topic>cmd_vel</topic>"),
            scaffold=IN_ROBOT,
            files={"launch/sim.launch.py": LAUNCH},
        ),
        Good(
            DRIVE.format("plugin", "<topic>cmd_vel</topic>"),
            scaffold=IN_ROBOT,
            files={"launch/sim.launch.py": LAUNCH.replace("]", "@", 1)},
            why="in both directions",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(root.bridge_gaps)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for gap in root.bridge_gaps:
            verb = "listens to" if gap.is_command else "publishes on"
            own = f"{verb} `{gap.topic}`" if gap.topic else f"has no `<{gap.parameter}>`"
            if gap.names:
                own = f"publishes on a topic with `{gap.names}`"
            end = (
                "to Gazebo, to which nobody listens"
                if gap.is_command
                else "to ROS, on which nobody publishes"
            )
            file, topic = gap.bridged.span.source.path.name, gap.bridged.topic
            message = f"{gap.part.title} {own}, and `{file}` takes `{topic}` {end}"
            if gap.is_backwards:
                way = "from Gazebo to ROS" if gap.is_command else "from ROS to Gazebo"
                message = f"{gap.part.title} {verb} `{topic}`, and `{file}` takes that {way} alone"
            yield self.diagnostic(gap.value or gap.part, message, labels={gap.bridged.span: "taken here"})
