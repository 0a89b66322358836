from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Joint, Plugin, Rule, Severity

READER = "gazebo_ros_ft_sensor"
"""The plugin that asks a joint for the forces in it."""
IN_URDF = (
    '<robot name="r"><link name="base"/><link name="hand"/><joint name="wrist" type="continuous">'
    '<parent link="base"/><child link="hand"/></joint>{}<gazebo><plugin filename="libgazebo_ros_ft_sensor.so" name="f">'
    "<jointName>«wrist»</jointName><topicName>force</topicName></plugin></gazebo></robot>"
)
IN_SDF = (
    '<sdf version="1.6"><model name="m"><link name="base"/><link name="hand"/><joint name="wrist" type="revolute">'
    "<parent>base</parent><child>hand</child><axis><xyz>0 0 1</xyz></axis>{}</joint>"
    '<plugin filename="libgazebo_ros_ft_sensor.so" name="f"><jointName>«wrist»</jointName>'
    "<topicName>force</topicName></plugin></model></sdf>"
)
BLOCK = '<gazebo reference="wrist"><provideFeedback>true</provideFeedback></gazebo>'
PHYSICS = "<physics><provide_feedback>true</provide_feedback></physics>"


class ForceWithoutFeedback(Rule):
    """A plugin reads the forces in a joint that keeps none.

    Gazebo Classic works out the forces in a joint only where the joint asks for it; without that all are 0. The plugin
    does not switch it on, as a sensor of type `force_torque` does.
    """

    code = "GAZ028"
    name = "force-without-feedback"
    severity = Severity.WARNING
    remedy = """Add `<gazebo reference="JOINT"><provideFeedback>true</provideFeedback></gazebo>`.

    In SDFormat, in the joint: `<physics><provide_feedback>true</provide_feedback></physics>`. A fixed joint also needs
    `<preserveFixedJoint>true</preserveFixedJoint>`, or it is merged away.
    """
    looks_at = (Plugin,)
    scaffold = "{}"
    sources = (
        "https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_plugins/src/gazebo_ros_ft_sensor.cpp",
    )

    bad = (
        Bad(
            IN_URDF.format(""),
            says="plugin `f` reads the forces in joint `wrist`, which has no `provideFeedback`: all are 0",
        ),
        Bad(IN_SDF.format("")),
    )
    good = (
        Good(IN_URDF.format(BLOCK).replace("«", "").replace("»", "")),
        Good(IN_SDF.format(PHYSICS).replace("«", "").replace("»", "")),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return plugin.known is not None and plugin.known.file == READER and any(mute(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for number, joint in enumerate(mute(plugin)):
            word = "provideFeedback" if joint.is_urdf else "provide_feedback"
            message = f"{plugin.title} reads the forces in {joint.title}, which has no `{word}`: all are 0"
            values = [found.value for found in plugin.references if found.joint is joint]
            yield self.diagnostic(values[0], message, labels={joint: "this joint"} if number == 0 else {})


def mute(plugin: Plugin) -> Iterator[Joint]:
    """The joints that it reads and that keep no forces; not those that are merged away."""
    for reference in plugin.references:
        joint = reference.joint
        if joint is not None and not reference.is_unresolved and not joint.keeps_forces:
            yield joint
