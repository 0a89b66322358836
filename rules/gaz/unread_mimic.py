from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Joint, Model, Rule, Severity

CONTROL = "libgazebo_ros_control.so"
ROBOT = (
    '<robot name="r"><link name="a"/><link name="b"/><link name="c"/>'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint>'
    '<joint name="k" type="continuous"><parent link="a"/><child link="c"/><{} joint="j"/></joint>'
    f'<gazebo><plugin name="c" filename="{CONTROL}"/>{{}}</gazebo></robot>'
)
PLUGIN = (
    '<plugin name="m" filename="libroboticsgroup_gazebo_mimic_joint_plugin.so">'
    "<joint>j</joint><mimicJoint>k</mimicJoint></plugin>"
)


class UnreadMimic(Rule):
    """A robot for Gazebo Classic has a joint that mimics another, and no plugin that makes it follow.

    Gazebo Classic does not know `mimic`: the joint hangs loose. With ros_control a plugin for mimic joints moves it;
    later releases of Gazebo do it themselves with the engine bullet-featherstone.
    """

    code = "GAZ016"
    name = "unread-mimic"
    severity = Severity.WARNING
    remedy = """Add a plugin for mimic joints to the `<gazebo>` block, or simulate it with a later Gazebo.

    For Gazebo Classic that is `libroboticsgroup_gazebo_mimic_joint_plugin.so` or one of its kind, which is
    built apart.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)

    bad = (
        Bad(
            ROBOT.replace("{}", "«mimic»", 1).replace("{}", ""),
            says="joint `k` does not follow `j` in Gazebo Classic, for which `libgazebo_ros_control.so` is",
        ),
    )
    good = (
        Good(ROBOT.replace("{}", "mimic", 1).replace("{}", PLUGIN)),
        Good(
            ROBOT.replace("{}", "mimic", 1).replace("{}", "").replace(CONTROL, "gz_ros2_control-system"),
            why="the new Gazebo",
        ),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        files = [plugin.filename for plugin in robot.plugins]
        return (
            CONTROL in files and not any("mimic" in file.lower() for file in files) and bool(followers(robot))
        )

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        first, *others = followers(robot)
        mimic = first.axis.mimic
        assert mimic is not None
        more = f" (and {len(others)} more)" if others else ""
        what = f"{first.title} does not follow `{mimic.element.get('joint')}` in Gazebo Classic{more}"
        yield self.diagnostic(mimic, f"{what}, for which `{CONTROL}` is")


def followers(robot: Model) -> list[Joint]:
    """The joints that mimic others."""
    return [
        joint for joint in robot.joints if joint.has("mimic") and joint.moves and joint.axis.mimic is not None
    ]
