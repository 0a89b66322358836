from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Root, Rule, Severity

SENSOR = '<sensor name="imu" type="imu"><topic>«data»</topic></sensor>'
SOUND = SENSOR.replace("«", "").replace("»", "")
ROBOT = '<robot name="r"><link name="a"/><gazebo reference="a">{}</gazebo></robot>'
TYPES = "ros_type_name: sensor_msgs/msg/Imu, gz_type_name: gz.msgs.IMU"
DRIVE = (
    '<plugin filename="gz-sim-velocity-control-system" name="gz::sim::systems::VelocityControl">'
    "<topic>{}</topic></plugin>"
)
IN_ROBOT = '<robot name="r"><link name="a"/><gazebo>{}</gazebo></robot>'
TWIST = "topic_name: speed, ros_type_name: geometry_msgs/msg/{}, gz_type_name: gz.msgs.Twist"


def bridge(entry: str, before: str = "- ") -> dict[str, str]:
    return {"bridge.yaml": f"{before}{{{entry}}}\n"}


class RefusedBridge(Rule):
    """The file of a bridge to ROS has an entry that `ros_gz_bridge` does not take, for the topic of this robot.

    It reads a list of entries, and leaves out those that it cannot read or whose types of messages it does not have as
    a pair; names that ROS refuses end it. Types of packages that it may be built with are not judged. Looked at is the
    YAML of the project.
    """

    code = "RES028"
    name = "refused-bridge"
    severity = Severity.WARNING
    remedy = """Correct the entry in the file that the message names.

    `- {topic_name: data, ros_type_name: sensor_msgs/msg/LaserScan, gz_type_name: gz.msgs.LaserScan, direction:
    GZ_TO_ROS}` is one. Where ROS refuses a name of Gazebo, as `/model/arm/joint/lift/0/cmd_pos`, give another one by
    `ros_topic_name`.
    """
    looks_at = (Root,)
    scaffold = ROBOT
    sources = ("https://github.com/gazebosim/ros_gz",)

    bad = (
        Bad(
            SENSOR,
            files=bridge(f"topic_name: data, {TYPES}", ""),
            says="sensor `imu` is not bridged: `bridge.yaml` is one mapping, and a bridge reads a list of them",
        ),
        Bad(
            DRIVE.format("«speed»"),
            scaffold=IN_ROBOT,
            files=bridge(TWIST.format("twist")),
            says="`bridge.yaml` bridges `geometry_msgs/msg/twist` with `gz.msgs.Twist`, whose partner is "
            "`geometry_msgs/msg/Twist`",
        ),
        Bad(
            SENSOR,
            files=bridge("topic_name: data, ros_type_name: sensor_msgs/Imu, gz_type_name: gz_msgs.IMU"),
            says="has the type `gz_msgs.IMU`, and Gazebo calls it `gz.msgs.IMU`",
        ),
        Bad(
            SENSOR,
            files=bridge(f"gz_topic_name: data, ros_topic_name: /2d/data, {TYPES}"),
            says="gives the topic `/2d/data`, which ROS refuses: a part of it begins with a digit",
        ),
        Bad(
            SENSOR,
            files=bridge(f"topic_name: data, {TYPES}, direction: GZ_TO_RO"),
            says="gives the direction `GZ_TO_RO`, one of BIDIRECTIONAL, GZ_TO_ROS, ROS_TO_GZ is asked for",
        ),
        Bad(
            SENSOR,
            files=bridge(f"topic_name: data, ros_topic_name: data, {TYPES}"),
            says="has both `topic_name` and `ros_topic_name`, which exclude each other",
        ),
    )
    good = (
        Good(SOUND, files=bridge(f"topic_name: data, {TYPES}, direction: GZ_TO_ROS")),
        Good(
            SOUND,
            files=bridge(f"topic_name: data, {TYPES}, direction: $(var way)"),
            why="the launch file gives the direction",
        ),
        Good(SOUND, files=bridge(f"topic_name: other, {TYPES}", ""), why="it is for something else"),
        Good(
            DRIVE.format("speed"),
            scaffold=IN_ROBOT,
            files=bridge("topic_name: speed, ros_type_name: my_msgs/msg/Speed, gz_type_name: gz.msgs.Twist"),
            why="a bridge may be built with other packages",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(root.bridge_faults)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for fault in root.bridge_faults:
            file, more = fault.span.source.path.name, f" (and {fault.more} more)" * (fault.more > 0)
            message = f"{fault.part.title} is not bridged: `{file}` {fault.words}{more}"
            value = next(
                (found for name in ("topic", "odom_topic") if (found := fault.part.value(name))), None
            )
            yield self.diagnostic(
                value or fault.part, message, labels={fault.span: "in the file of the bridge"}
            )
