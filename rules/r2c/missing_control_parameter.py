from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = (
    '<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="lift"><command_interface name="velocity"/><state_interface name="position"/>'
    '<state_interface name="velocity"/></joint></ros2_control>'
)
PLUGIN = (
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<{}>controllers.yaml</parameters></plugin></gazebo>"
)
ROBOT, SOUND = BLOCK + PLUGIN.format("«parameters»"), BLOCK + PLUGIN.format("parameters")
FORWARD = "forward_command_controller/ForwardCommandController"
TRAJECTORIES = "joint_trajectory_controller/JointTrajectoryController"
PLANNED = "joints: [lift], command_interfaces: [velocity], state_interfaces: [position, velocity]"


def files(kind: str, parameters: str) -> dict[str, str]:
    return {"controllers.yaml": f"lift: {{ros__parameters: {{type: {kind}, {parameters}}}}}\n"}


class MissingControlParameter(Rule):
    """A controller lacks a parameter without which it does not start, or does not move its joints.

    A drive without `wheel_separation` takes 0, which newer releases refuse and older ones divide by; a list of joints
    or interfaces must not be empty. A JointTrajectoryController that commands velocities or efforts alone makes them
    of the error by its gains, which are 0 where none are given: the joints do not move, and nobody says so. Looked at
    is the only file that the simulator's plugin names.
    """

    code = "R2C049"
    name = "missing-control-parameter"
    severity = Severity.WARNING
    remedy = """Add the parameter that the message names.

    Gains are given for each joint: `gains: {joint1: {p: 10.0, i: 0.0, d: 0.1, ff_velocity_scale: 1.0}}`. Hardware
    that takes positions needs none: `command_interfaces: [position]`.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("ros2_control",)
    scaffold = IN_ROBOT
    sources = ("https://github.com/ros-controls/ros2_controllers",)

    bad = (
        Bad(
            ROBOT,
            files=files(FORWARD, "joints: [lift]"),
            says="`lift` in `controllers.yaml` has no `interface_name`, without which a ForwardCommandController does",
        ),
        Bad(
            ROBOT,
            files=files(TRAJECTORIES, PLANNED),
            says="`lift` in `controllers.yaml` commands velocity or effort and has no gains for joint `lift`",
        ),
    )
    good = (
        Good(SOUND, files=files(FORWARD, "joints: [lift], interface_name: velocity")),
        Good(SOUND, files=files(TRAJECTORIES, f"{PLANNED}, gains: {{lift: {{p: 5.0}}}}")),
        Good(
            SOUND,
            files=files(TRAJECTORIES, f"{PLANNED}, open_loop_control: true"),
            why="velocities are passed on",
        ),
        Good(SOUND, files=files("my_controllers/Own", "joints: [lift]"), why="nothing is known about it"),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return any(True for _ in robot.lacking_parameters)

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        for plugin, each in robot.lacking_parameters:
            article = "an" if each.kind[0] in "AEIO" else "a"
            where = f"`{each.owner}` in `{each.span.source.path.name}`"
            message = f"{where} has no `{each.name}`, without which {article} {each.kind} does not run"
            if each.joint:
                lost = f"and has no gains for joint `{each.joint}`, which stays where it is"
                message = f"{where} commands velocity or effort {lost}"
            yield self.diagnostic(plugin.file_of_controllers or plugin, message, labels={each.span: "here"})
