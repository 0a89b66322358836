from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, ControlInterface, Diagnostic, Good, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = (
    '<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="lift"><command_interface name="{}"/><state_interface name="position"/></joint></ros2_control>'
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>controllers.yaml</parameters></plugin></gazebo>"
)
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
    looks_at = (ControlComponent,)
    needs = ("<parameters",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.format("«effort»"),
            files={"controllers.yaml": TRAJECTORY.format("position")},
            says="joint `lift` takes `effort`, and controller `arm` commands `position`",
        ),
        Bad(BLOCK.format("«position»"), files={"controllers.yaml": SECOND}),
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
    def applies(component: ControlComponent) -> bool:
        return component.what == "joint" and is_uncommanded(component)

    def check(self, component: ControlComponent) -> Iterator[Diagnostic]:
        own = commands(component)
        taken = " and ".join(f"`{each.name}`" for each in own)
        claim = next(claim for claim in component.claims if claim.is_command)
        message = f"{component.title} takes {taken}, and controller `{claim.controller}` commands `{claim.interface}`"
        yield self.diagnostic(own[0].name_value or own[0], message)


def commands(component: ControlComponent) -> list[ControlInterface]:
    """The interfaces by which it takes commands."""
    return [each for each in component.interfaces if each.is_command and each.is_readable]


def is_uncommanded(component: ControlComponent) -> bool:
    """Do its controllers command nothing that it takes?"""
    own = {each.name.removesuffix("_pid") for each in commands(component)}
    wanted = {claim.interface for claim in component.claims if claim.is_command} if own else set()
    return bool(wanted) and wanted.isdisjoint(own)
