from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Part, Plugin, Rule, Severity, Value
from sdfcheck_rules.gaz.unknown_sensor_frame import robot_of

WHEELS = "".join(
    f'<link name="{name}"/><joint name="{name}_j" type="continuous"><origin xyz="0 {y} 0"/><parent link="base"/>'
    f'<child link="{name}"/><axis xyz="0 1 0"/></joint>'
    for name, y in (("l", "0.2"), ("r", "-0.2"))
)
DRIVE = (
    '<gazebo><plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">'
    "<left_joint>{}</left_joint><right_joint>r_j</right_joint></plugin></gazebo>"
)
CONTROL = (
    '<ros2_control name="c" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="l_j"><{} name="velocity"/></joint></ros2_control>'
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>c.yaml</parameters></plugin></gazebo>"
)


class ContestedJoint(Rule):
    """Two things drive one joint in Gazebo, or one drive has it for two wheels.

    A plugin for a drive sets the speed of its wheels in each step. So does the hardware of ros2_control, or a second
    such plugin, and the one that comes last wins: the robot stutters, or does not move at all.
    """

    code = "GAZ023"
    name = "contested-joint"
    severity = Severity.WARNING
    remedy = """Keep one of the two.

    With a `diff_drive_controller` of ros2_control the plugin of the drive goes; without it, the joints of the wheels
    leave the `ros2_control` block, or keep their state interfaces only. In xacro let one condition choose.
    """
    looks_at = (Plugin,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            WHEELS + DRIVE.format("«l_j»") + CONTROL.format("command_interface"),
            says="plugin `gz::sim::systems::DiffDrive` drives joint `l_j`, and so does ros2_control `c`",
        ),
        Bad(
            WHEELS + DRIVE.format("l_j") + DRIVE.format("«l_j»"),
            says="plugin `gz::sim::systems::DiffDrive` drives joint `l_j`, and so does another plugin",
        ),
        Bad(
            WHEELS + DRIVE.format("r_j").replace(">r_j</r", ">«r_j»</r"),
            says="has joint `r_j` for two wheels",
        ),
    )
    good = (
        Good(WHEELS + DRIVE.format("l_j")),
        Good(WHEELS + DRIVE.format("l_j") + CONTROL.format("state_interface"), why="only its state is read"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return "drive" in plugin.filename and bool(again(plugin) or rivals(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for value, first in again(plugin):
            message = f"{plugin.title} has joint `{value.text.strip()}` for two wheels"
            yield self.diagnostic(
                value, message, labels={first: "the first one"}, help="name the joint of the other wheel"
            )
        drive, found = plugin.drive, rivals(plugin)
        if drive is None or not found:
            return
        name, rival = found[0]
        other = (
            rival.holder.title if rival.kind == "component" and rival.holder is not None else "another plugin"
        )
        parameter = next(wheel.name for wheel in drive.wheels if wheel.joint.name == name)
        message = f"{plugin.title} drives joint `{name}`, and so does {other}"
        yield self.diagnostic(parameter.own_value, message, labels={rival: "drives it as well"})


def again(plugin: Plugin) -> list[tuple[Value, Value]]:
    """The parameters of a drive that name the joint of another wheel, each with the parameter of that."""
    first: dict[str, Value] = {}
    found = []
    for reference in plugin.references:
        if reference.kind == "joint" and "steering" not in reference.value.element.name.lower():
            earlier = first.setdefault(reference.value.text.strip(), reference.value)
            if earlier.element is not reference.value.element:
                found.append((reference.value, earlier))
    return found


def rivals(plugin: Plugin) -> list[tuple[str, Part]]:
    """The joints of a drive that something else drives as well, each with that."""
    drive = plugin.drive
    if drive is None:
        return []
    controlled = robot_of(plugin).control_joints if plugin.is_extension else {}
    wheels = [wheel.joint for wheel in drive.wheels]
    found: list[tuple[str, Part]] = [
        (joint.name, component)
        for joint in wheels
        for component in controlled.get(joint.name, ())
        if component.commands and component.block.is_simulated
    ]
    for sibling in plugin.siblings:
        if sibling is plugin:
            break
        other = sibling.drive
        found += [
            (each.joint.name, sibling) for each in (other.wheels if other else ()) if each.joint in wheels
        ]
    return found
