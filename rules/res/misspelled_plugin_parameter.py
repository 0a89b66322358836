from collections.abc import Iterator

from sdfcheck import IN_MODEL, Bad, Diagnostic, Good, Plugin, Rule, Severity, rename

DRIVE = '<plugin name="gz::sim::systems::DiffDrive" filename="gz-sim-diff-drive-system">{}</plugin>'


class MisspelledPluginParameter(Rule):
    """A parameter is nearly, but not quite, one that the plugin reads, or one of another generation of Gazebo.

    Plugins ask for their parameters by name, and never say what they did not ask for: the default is
    taken. Case counts.
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
            DRIVE.format("<«wheel_diameter»>0.2</wheel_diameter>"),
            says="does not read `wheel_diameter`, which is a parameter of `gazebo_ros_diff_drive`",
            also=("RES021",),
        ),
    )
    good = (
        Good(DRIVE.format("<topic>cmd_vel</topic>")),
        Good(DRIVE.format("<wheel_separation>1.2</wheel_separation>")),
        Good(DRIVE.format("<comment>fast</comment>"), why="like nothing that it reads"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return bool(plugin.misspelled_parameters or plugin.foreign_parameters)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for parameter, meant in plugin.misspelled_parameters:
            message = f"{plugin.title} does not read `{parameter.name}`"
            yield self.diagnostic(parameter, message, meant=meant, fix=rename(meant, parameter))
        for parameter, other in plugin.foreign_parameters:
            message = f"{plugin.title} does not read `{parameter.name}`, which is a parameter of `{other}`"
            yield self.diagnostic(parameter, message)
