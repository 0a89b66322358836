from collections.abc import Iterator
from itertools import takewhile

from sdfcheck import Bad, Diagnostic, Element, Good, Plugin, Rule, Severity, Target

YES = frozenset({"true", "1"})
WHEELS = ("publish_wheel_tf", "publishWheelTF")
STATES = "gazebo_ros_joint_state_publisher"
BASES = ("child_frame_id", "robot_base_frame", "robotBaseFrame")
SIDES = ("left_joint", "right_joint", "leftJoint", "rightJoint")
ROBOT = '<robot name="r"><link name="base"/>{}<gazebo>{}</gazebo></robot>'
WHEEL = (
    '<link name="{0}"/><joint name="{0}_joint" type="continuous"><parent link="base"/><child link="{0}"/>'
    '<axis xyz="0 1 0"/></joint>'
)
LEFT, RIGHT = WHEEL.format("left"), WHEEL.format("right")
JOINTS = "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>"
ROS = "<ros><namespace>r</namespace></ros>"
STATE = (
    f'<plugin name="s" filename="libgazebo_ros_joint_state_publisher.so">{ROS}<joint_name>left_joint</joint_name>'
    "</plugin>"
)
POSE = (
    '<plugin filename="gz-sim-odometry-publisher-system" name="gz::sim::systems::OdometryPublisher">'
    "<robot_base_frame>base</robot_base_frame>{}</plugin>"
)


def drive(publish: str) -> str:
    """The drive of Gazebo Classic."""
    return f'<plugin name="d" filename="libgazebo_ros_diff_drive.so">{ROS}{JOINTS}{publish}</plugin>'


def gz_drive(publish: str) -> str:
    """That of the new Gazebo."""
    return (
        '<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">'
        f"{JOINTS}{publish}<child_frame_id>base</child_frame_id></plugin>"
    )


class ContestedFrame(Rule):
    """Two plugins of a robot publish where one frame is.

    Both send transforms of the frame, which do not agree in time, and after some way not in place: the robot flickers
    in RViz, and jumps between two odometries. The states of joints are made into transforms by
    `robot_state_publisher`, so that a drive that sends those of its wheels is the second to do so.
    """

    code = "GAZ032"
    name = "contested-frame"
    severity = Severity.WARNING
    remedy = """Let one of the two publish the frame, and turn the other off.

    `<publish_wheel_tf>false</publish_wheel_tf>` leaves the wheels to the states of the joints. Of two odometries take
    the one that navigation is to use, and give the other a `<tf_topic>` of its own.
    """
    looks_at = (Plugin,)
    needs = ("tf_topic", *WHEELS)
    scaffold = ROBOT.format(LEFT + RIGHT, "{}")

    bad = (
        Bad(
            drive("<publish_wheel_tf>«true»</publish_wheel_tf>") + STATE,
            says="the frame of the child of `left_joint` is published by plugin `s` as well",
        ),
        Bad(
            gz_drive("<tf_topic>/tf</tf_topic>") + POSE.format("<tf_topic>«/tf»</tf_topic>"),
            says="the odometry is published on `/tf` by plugin `gz::sim::systems::DiffDrive` as well",
        ),
    )
    good = (
        Good(drive("<publish_wheel_tf>false</publish_wheel_tf>") + STATE),
        Good(drive("<publish_wheel_tf>true</publish_wheel_tf>"), why="nobody else does"),
        Good(gz_drive("<tf_topic>/tf</tf_topic>") + POSE.format("<tf_topic>/true_tf</tf_topic>")),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return next(rivals(plugin), None) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for target, other, words in rivals(plugin):
            yield self.diagnostic(
                target, f"{words} by {other.title} as well", labels={other: "the other one"}
            )


def rivals(plugin: Plugin) -> Iterator[tuple[Target, Plugin, str]]:
    """The parameters by which it publishes a frame, the other plugin that does so, and the words for the frame."""
    siblings = plugin.siblings
    wheels = given(plugin, WHEELS)
    if wheels is not None and wheels.content in YES:
        joints = [each.content for side in SIDES for each in plugin.children(side)]
        for other in siblings:
            names = {each.content for name in ("joint_name", "jointName") for each in other.children(name)}
            shared = next((joint for joint in joints if joint in names), None)
            if other.known is not None and other.known.file == STATES and shared is not None:
                yield wheels.own_value, other, f"the frame of the child of `{shared}` is published"
                break
    topic = plugin.find("tf_topic")
    for other in takewhile(lambda each: each.element is not plugin.element, siblings):
        its = other.find("tf_topic")
        is_one = topic is not None and its is not None and "" != its.content == topic.content
        if topic is not None and is_one and is_alike(plugin, other):
            yield topic.own_value, other, f"the odometry is published on `{topic.content}`"
            break


def is_alike(one: Plugin, other: Plugin) -> bool:
    """Is the odometry that of one link?"""
    bases = [given(plugin, BASES) for plugin in (one, other)]
    return len({base.content for base in bases if base is not None}) < 2


def given(plugin: Plugin, names: tuple[str, ...]) -> Element | None:
    """The first parameter of some names."""
    return next((found for name in names if (found := plugin.find(name)) is not None), None)
