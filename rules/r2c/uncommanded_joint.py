from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, ControlInterface, Diagnostic, Good, Ros2Control, Rule, Severity
from sdfcheck_rules.r2c.alike import alike
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = (
    '<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="lift"><command_interface name="{}"/><state_interface name="position"/></joint></ros2_control>'
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>controllers.yaml</parameters></plugin></gazebo>"
)
SLIDE = (
    '<link name="e"/><joint name="slide" type="prismatic"><parent link="a"/><child link="e"/>'
    '<limit lower="0" upper="1" effort="5" velocity="2"/></joint>'
)
TAKEN = '<joint name="slide"><command_interface name="effort"/><state_interface name="position"/></joint>'
MANAGER = "controller_manager:\n  ros__parameters:\n    {}:\n      type: {}\n"
TRAJECTORY = (
    MANAGER.format("arm", "joint_trajectory_controller/JointTrajectoryController")
    + "arm:\n  ros__parameters:\n    joints: [lift]\n    command_interfaces: [{}]\n    state_interfaces: [position]\n"
)
BOTH = (
    "controller_manager:\\n  ros__parameters:\\n"
    "    arm: {type: joint_trajectory_controller/JointTrajectoryController}\\n"
    "    speed: {type: velocity_controllers/JointGroupVelocityController}\\n"
    "arm: {ros__parameters: {joints: [lift], command_interfaces: [position], state_interfaces: [position]}}\\n"
    "speed: {ros__parameters: {joints: [lift]}}\\n"
)
SECOND = MANAGER.format("speed", "velocity_controllers/JointGroupVelocityController") + (
    "speed:\n  ros__parameters:\n    joints: [lift]\n"
)


class UncommandedJoint(Rule):
    """A joint takes commands of one kind, and its controllers give those of another.

    A controller claims the interfaces that its parameters name. Where the joint does not have them, the controller
    manager says "Not acceptable command interfaces combination", or that they do not exist, and does not activate the
    controller: the joint hangs or falls. Looked at are the files that the simulator's plugin names.
    """

    code = "R2C039"
    name = "uncommanded-joint"
    severity = Severity.WARNING
    remedy = """Name in `<command_interface>` what the controller commands, or change the controller's parameters.

    A joint may have several command interfaces, of which each controller claims its own.
    """
    looks_at = (Ros2Control,)
    needs = ("<parameters",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.format("«effort»"),
            files={"controllers.yaml": TRAJECTORY.format("position")},
            says="joint `lift` takes `effort`, and controller `arm` commands `position`",
        ),
        Bad(BLOCK.format("«position»"), files={"controllers.yaml": SECOND}),
        Bad(
            SLIDE + BLOCK.format("«effort»").replace("</ros2_control>", TAKEN + "</ros2_control>"),
            files={"controllers.yaml": TRAJECTORY.format("position").replace("[lift]", "[lift, slide]")},
            says="joint `lift` and 1 more take `effort`, and controller `arm` commands `position`",
        ),
    )
    good = (
        Good(BLOCK.format("position"), files={"controllers.yaml": TRAJECTORY.format("position")}),
        Good(
            BLOCK.format("velocity"),
            files={"controllers.yaml": BOTH},
            why="one of two controllers commands it",
        ),
        Good(BLOCK.format("effort"), why="there is no such file"),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return any(map(command, block.components))

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        for (taken, controller, interface), joints in alike(block, command).items():
            others = "" if len(joints) == 1 else f" and {len(joints) - 1} more"
            verb = "take" if others else "takes"
            message = f"{joints[0].title}{others} {verb} {taken}, and controller `{controller}` commands `{interface}`"
            places = [own.name_value or own for own in map(first_command, joints) if own is not None]
            yield self.diagnostic(places[0], message, repeats=places[1:])


def commands(component: ControlComponent) -> list[ControlInterface]:
    """The interfaces by which it takes commands."""
    return [each for each in component.interfaces if each.is_command and each.is_readable]


def first_command(component: ControlComponent) -> ControlInterface | None:
    return next(iter(commands(component)), None)


def command(component: ControlComponent) -> tuple[str, str, str] | None:
    """The commands that a joint takes, and a controller with its own, if all controllers give it others."""
    own = commands(component)
    wanted = [claim for claim in component.claims if claim.is_command] if own else []
    names = {each.name.removesuffix("_pid") for each in own}
    if not wanted or not names.isdisjoint(claim.interface for claim in wanted):
        return None
    return " and ".join(f"`{each.name}`" for each in own), wanted[0].controller, wanted[0].interface
