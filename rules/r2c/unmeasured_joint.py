from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Good, Ros2Control, Rule, Severity
from sdfcheck_rules.r2c.alike import alike
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = (
    '<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="{}"><command_interface name="position"/><state_interface name="position"/>{}</joint></ros2_control>'
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<parameters>controllers.yaml</parameters></plugin></gazebo>"
)
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"
PARAMETERS = "joints: [lift], command_interfaces: [position], state_interfaces: [{}]"
FILE = {
    "controllers.yaml": f"arm: {{ros__parameters: {{type: {TRAJECTORY}, {PARAMETERS.format('position, velocity')}}}}}\n"
}
DRIVE = {
    "controllers.yaml": "drive: {ros__parameters: {type: diff_drive_controller/DiffDriveController, "
    "left_wheel_names: [lift], right_wheel_names: [lift], "
    "wheel_separation: 0.5, wheel_radius: 0.1}}\n"
}
STATES = {
    "controllers.yaml": "controller_manager: {ros__parameters: {states: {type: "
    "joint_state_broadcaster/JointStateBroadcaster}}}\n"
}
TWO = {
    "controllers.yaml": FILE["controllers.yaml"]
    + f"slow: {{ros__parameters: {{type: {TRAJECTORY}, {PARAMETERS.format('position')}}}}}\n"
}


class UnmeasuredJoint(Rule):
    """A controller reads a state that its joint does not have.

    A controller of trajectories claims all states that its parameters name. Where one is missing, the controller
    manager says that the state interface does not exist and does not activate the controller. A differential drive
    claims the positions of its wheels, or their velocities if `position_feedback` is false, and the broadcaster of
    joint states at least one state. Looked at are the files that the simulator's plugin names.
    """

    code = "R2C040"
    name = "unmeasured-joint"
    severity = Severity.WARNING
    remedy = """Add `<state_interface name="…"/>` to the joint, or remove the state from `state_interfaces`.

    Simulators have `position`, `velocity` and `effort` of each joint, as far as they are listed.
    """
    looks_at = (Ros2Control,)
    needs = ("<parameters",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            BLOCK.format("«lift»", ""),
            files=FILE,
            says="joint `lift` has no state `velocity`, which controller `arm` reads",
        ),
        Bad(
            BLOCK.format("«lift»", "").replace('_interface name="position"', '_interface name="velocity"'),
            files=DRIVE,
            says="joint `lift` has no state `position`, which controller `drive` reads",
        ),
        Bad(
            BLOCK.format("«lift»", "").replace('<state_interface name="position"/>', ""),
            files=STATES,
            says="no joint has a state, so that controller `states` has nothing to publish",
        ),
    )
    good = (
        Good(BLOCK.format("lift", '<state_interface name="velocity"/>'), files=FILE),
        Good(BLOCK.format("lift", ""), files=TWO, why="another controller reads the position alone"),
    )

    @staticmethod
    def applies(block: Ros2Control) -> bool:
        return is_idle(block) or any(map(unmeasured, block.components))

    def check(self, block: Ros2Control) -> Iterator[Diagnostic]:
        if is_idle(block):
            first = block.components[0]
            idle = f"controller `{block.model.idle_broadcaster}` has nothing to publish"
            yield self.diagnostic(first.name_value or first, f"no joint has a state, so that {idle}")
            return
        for (controller, interface), joints in alike(block, unmeasured).items():
            others = " has" if len(joints) == 1 else f" and {len(joints) - 1} more have"
            message = (
                f"{joints[0].title}{others} no state `{interface}`, which controller `{controller}` reads"
            )
            places = [each.name_value or each for each in joints]
            yield self.diagnostic(places[0], message, repeats=places[1:])


def is_idle(block: Ros2Control) -> bool:
    """Is it the first block of a robot without a state, which a broadcaster of states is to publish?"""
    return (
        bool(block.model.idle_broadcaster) and bool(block.components) and block is block.model.ros2_control[0]
    )


def unmeasured(component: ControlComponent) -> tuple[str, str] | None:
    """A controller and the state that it does not find, where all controllers that read states lack one."""
    own = {each.name for each in component.interfaces if not each.is_command}
    reads = [claim for claim in component.claims if not claim.is_command] if own else []
    lacking = {claim.controller: claim.interface for claim in reversed(reads) if claim.interface not in own}
    if not lacking or any(claim.controller not in lacking for claim in reads):
        return None
    return reads[0].controller, lacking[reads[0].controller]
