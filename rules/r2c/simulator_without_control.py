from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Plugin, Rule, Severity
from sdfcheck_rules.r2c.mixed_control_generations import SYSTEMS, library_of
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

ROS_CONTROL = "gazebo_ros_control"
PLUGIN = '<gazebo><«plugin» filename="{}" name="c"><parameters>c.yaml</parameters></plugin></gazebo>'
BLOCK = (
    '<ros2_control name="arm" type="system"><hardware><plugin>gazebo_ros2_control/GazeboSystem</plugin></hardware>'
    "</ros2_control>"
)


class SimulatorWithoutControl(Rule):
    """A robot starts the controllers of Gazebo and has nothing for them to control.

    Gazebo's plugins for ros2_control read the `ros2_control` blocks of the robot, and that of ros_control its
    transmissions. Without any, no joint has an interface, and each controller that asks for one fails to start. In ROS
    1 that is a hint, as other plugins may move the robot.
    """

    code = "R2C037"
    name = "simulator-without-control"
    severity = Severity.WARNING
    remedy = """Add a `ros2_control` block with the joints, directly in the robot.

    ```xml
    <ros2_control name="arm" type="system">
      <hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
      <joint name="elbow">
        <command_interface name="position"/>
        <state_interface name="position"/>
      </joint>
    </ros2_control>
    ```

    `libgazebo_ros_control.so`, of ROS 1, wants a `<transmission>` for each joint instead.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("ros_control", "ros2_control")
    scaffold = IN_ROBOT

    bad = (
        Bad(
            PLUGIN.format("libgazebo_ros2_control.so"),
            says="`gazebo_ros2_control` finds no `ros2_control` block in robot `r`",
        ),
        Bad(
            PLUGIN.format("libgazebo_ros_control.so"),
            says="`gazebo_ros_control` finds no transmission in robot `r`",
            also=("GAZ016",),
        ),
    )
    good = (
        Good(PLUGIN.replace("«", "").replace("»", "").format("libgazebo_ros2_control.so") + BLOCK),
        Good(
            PLUGIN.replace("«", "").replace("»", "").format("libgazebo_ros2_control.so"),
            scaffold='<robot name="r"><link name="a"/>{}</robot>',
            why="part of a robot, which has no joints yet",
        ),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return idle(robot) is not None

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        plugin = idle(robot)
        assert plugin is not None
        library = library_of(plugin)
        wanted = "transmission" if library == ROS_CONTROL else "`ros2_control` block"
        message = f"`{library}` finds no {wanted} in {robot.title}, so no joint has an interface"
        if library == ROS_CONTROL:
            advice = "add a `<transmission>` for each joint that controllers move"
            yield self.diagnostic(plugin, message, severity=Severity.INFO, help=advice)
        else:
            yield self.diagnostic(plugin, message)


def idle(robot: Model) -> Plugin | None:
    """The plugin that is to control a robot which moves, and which says of no joint how."""
    source = robot.document.source
    if (
        robot.ros2_control
        or source.contains("<ros2_control")
        or not any(joint.moves for joint in robot.joints)
    ):
        return None
    for plugin in robot.plugins:
        library = library_of(plugin)
        if library == ROS_CONTROL and not robot.transmissions and not source.contains("transmission>"):
            return plugin
        if library in SYSTEMS:
            return plugin
    return None
