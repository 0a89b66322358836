from collections.abc import Iterable, Iterator

from sdfcheck import (
    IN_MODEL,
    Bad,
    Diagnostic,
    Element,
    Fix,
    Good,
    Plugin,
    Rule,
    Severity,
    make_fix,
    named,
    rename,
)

ROS_2 = {"package.xml": "<package><name>arm</name><buildtool_depend>ament_cmake</buildtool_depend></package>"}
CAMERA = (
    '<link name="eye"><sensor name="eye" type="camera"><camera><image><width>640</width><height>480</height></image>'
    '</camera><plugin name="camera" filename="libgazebo_ros_camera.so">{}</plugin></sensor></link>'
)
MOVE = '<plugin name="move" filename="libgazebo_ros_planar_move.so">{}</plugin>'
BUMPER = (
    '<link name="a"><sensor name="touch" type="contact"><contact><collision>a</collision></contact>'
    '<plugin name="bumper" filename="libgazebo_ros_bumper.so">{}</plugin></sensor></link>'
)
MANAGERS = ("gz_ros2_control", "ign_ros2_control")
OF_NODE = frozenset(("namespace", "remapping"))
"""Settings that a controller manager of the new Gazebo reads within `<ros>` alone."""
DRIVE = '<plugin name="gz::sim::systems::DiffDrive" filename="gz-sim-diff-drive-system">{}</plugin>'


class MisspelledPluginParameter(Rule):
    """A parameter is nearly, but not quite, one that the plugin reads, or one of another generation of Gazebo.

    Plugins ask for their parameters by name, and never say what they did not ask for: the default is
    taken. Case counts. In a package of ROS 2, plugins of Gazebo Classic are those of ROS 2, whose
    parameters have other names than those of ROS 1: `frame_name`, not `frameName`, and whose topics get theirs by a
    `<remapping>`. The `<namespace>` of the controller manager in the new Gazebo is read within `<ros>` alone.
    """

    code = "RES019"
    name = "misspelled-plugin-parameter"
    severity = Severity.WARNING
    remedy = """Write the parameter as the plugin reads it.

    Its page in the documentation of Gazebo, or the header of the system, lists the parameters. For a
    parameter that is your own, ignore this.
    """
    looks_at = (Plugin,)
    scaffold = IN_MODEL

    bad = (
        Bad(
            DRIVE.format("<«wheel_seperation»>1.2</wheel_seperation>"),
            fixed=DRIVE.format("<wheel_separation>1.2</wheel_separation>"),
            unsafe=True,
            says="does not read `wheel_seperation`; did you mean `wheel_separation`?",
            also=("RES021",),
        ),
        Bad(
            '<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
            "<parameters>c.yaml</parameters><«controller_manager_node_name»>cm</controller_manager_node_name></plugin>",
            fixed='<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
            "<parameters>c.yaml</parameters><controller_manager_name>cm</controller_manager_name></plugin>",
            unsafe=True,
            says="did you mean `controller_manager_name`?",
        ),
        Bad(
            '<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
            "<parameters>c.yaml</parameters><«namespace»>left</namespace></plugin>",
            says="does not read `namespace` here, but within `<ros>`",
        ),
        Bad(
            DRIVE.format("<«wheel_diameter»>0.2</wheel_diameter>"),
            says="does not read `wheel_diameter`, which is a parameter of `gazebo_ros_diff_drive`",
            also=("RES021",),
        ),
        Bad(
            '<plugin name="drive" filename="libgazebo_ros_diff_drive.so"><«leftFrontJoint»>wheel</leftFrontJoint>'
            "<wheelDiameter>0.2</wheelDiameter></plugin>",
            says="does not read `leftFrontJoint`, which is a parameter of `gazebo_ros_skid_steer_drive`",
        ),
        Bad(
            CAMERA.format("<«cameraName»>eye</cameraName><frameName>eye_link</frameName><Cx>0</Cx>"),
            fixed=CAMERA.format("<camera_name>eye</camera_name><frame_name>eye_link</frame_name><Cx>0</Cx>"),
            unsafe=True,
            says="of ROS 2 does not read `cameraName` or `frameName`, as that of ROS 1 does; did you mean",
            files=ROS_2,
        ),
        Bad(
            MOVE.format("<odometryRate>20</odometryRate><«odometryFrame»>odom</odometryFrame>"),
            fixed=MOVE.format("<odometryRate>20</odometryRate><odometry_frame>odom</odometry_frame>"),
            unsafe=True,
            says="does not read `odometryFrame`, as that of ROS 1 does",
            files=ROS_2,
        ),
        Bad(
            BUMPER.format("<«bumperTopicName»>touch</bumperTopicName>"),
            says="of ROS 2 does not read `bumperTopicName`, as that of ROS 1 does",
            files=ROS_2,
            also=("RES011",),
        ),
    )
    good = (
        Good(DRIVE.format("<topic>cmd_vel</topic>")),
        Good(
            '<plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
            "<parameters>c.yaml</parameters><ros><namespace>left</namespace></ros></plugin>"
        ),
        Good(DRIVE.format("<wheel_separation>1.2</wheel_separation>")),
        Good(CAMERA.format("<frame_name>eye_link</frame_name><focalLength>0</focalLength>"), files=ROS_2),
        Good(
            BUMPER.format(
                "<ros><remapping>bumper_states:=touch</remapping></ros><bumperTopicName>a</bumperTopicName>"
            ),
            files=ROS_2,
            why="the remapping gives the topic its name",
        ),
        Good(
            CAMERA.format("<frame_name>eye_link</frame_name><Cx>1</Cx><Cy>1</Cy>"),
            why="nobody knows for which ROS",
        ),
        Good(DRIVE.format("<comment>fast</comment>"), why="like nothing that it reads"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return bool(
            plugin.misspelled_parameters
            or plugin.outdated_parameters
            or plugin.foreign_parameters
            or outside(plugin)
        )

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for parameter, meant in plugin.misspelled_parameters:
            message = f"{plugin.title} does not read `{parameter.name}`"
            yield self.diagnostic(parameter, message, meant=meant, fix=rename(meant, parameter))
        for parameter, today in plugin.outdated_parameters[:1]:
            others = [each for each, _ in plugin.outdated_parameters[1:]]
            names = named((each.name for each in (parameter, *others)), "or", most=3)
            yield self.diagnostic(
                parameter,
                f"{plugin.title} of ROS 2 does not read {names}, as that of ROS 1 does",
                meant=today,
                labels=dict.fromkeys(others, "the same"),
                help=None if today else "give its topic another name by a `<remapping>` in `<ros>`",
                fix=renamed(plugin.outdated_parameters),
            )
        for parameter, other in plugin.foreign_parameters:
            message = f"{plugin.title} does not read `{parameter.name}`, which is a parameter of `{other}`"
            yield self.diagnostic(parameter, message)
        for parameter in outside(plugin):
            message = f"{plugin.title} does not read `{parameter.name}` here, but within `<ros>`"
            yield self.diagnostic(parameter, message, help="put it into `<ros>`")


def outside(plugin: Plugin) -> list[Element]:
    """The settings of the node of a controller manager that are beside ``<ros>``."""
    if plugin.known is None or not plugin.known.file.startswith(MANAGERS):
        return []
    return [each for each in plugin.parameters if each.name in OF_NODE]


def renamed(parameters: Iterable[tuple[Element, str | None]]) -> Fix | None:
    """The fix that gives parameters the names that they have today."""
    fixes = [fix for parameter, name in parameters if name and (fix := rename(name, parameter)) is not None]
    if not fixes:
        return None
    title = fixes[0].title if len(fixes) == 1 else "give them their names in ROS 2"
    return make_fix(title, tuple(edit for fix in fixes for edit in fix.edits), unsafe=True)
