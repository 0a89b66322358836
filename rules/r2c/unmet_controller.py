from collections.abc import Iterator

from sdfcheck import Bad, ControllerNeed, Diagnostic, Good, Model, Rule, Severity, named, suggest
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

PLUGIN = (
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<«parameters»>controllers.yaml</parameters></plugin></gazebo>"
)
BLOCK = (
    '<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="lift"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>'
)
ROBOT = PLUGIN + BLOCK
SOUND = ROBOT.replace("«", "").replace("»", "")
CONTROLLERS = """controller_manager:
  ros__parameters:
    update_rate: 100
    arm_controller:
      type: {}
arm_controller:
  ros__parameters:
    {}
"""
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"


def files(kind: str, parameters: str) -> dict[str, str]:
    return {"controllers.yaml": CONTROLLERS.format(kind, parameters)}


class UnmetController(Rule):
    """A controller asks for a joint, a sensor or an interface that the `ros2_control` blocks of the robot do not have.

    It is that in the file of `<parameters>` of Gazebo's plugin. When the controller is started, the controller manager
    says that the interface is not available, and the controller stays inactive: commands do nothing.
    """

    code = "R2C040"
    name = "unmet-controller"
    severity = Severity.WARNING
    remedy = """Correct the name in the file of parameters, or add the joint or interface to a `ros2_control` block.

    A trajectory controller asks for each of its `command_interfaces` and `state_interfaces` at each of its `joints`, a
    `DiffDriveController` for the command `velocity` at each wheel.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("ros2_control",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            ROBOT,
            files=files(
                TRAJECTORY, "{joints: [lfit], command_interfaces: [position], state_interfaces: [position]}"
            ),
            says="asks for joint `lfit`, which no `ros2_control` block of robot `r` has, but `lift`",
        ),
        Bad(
            ROBOT,
            files=files(
                TRAJECTORY, "{joints: [lift], command_interfaces: [position], state_interfaces: [velocity]}"
            ),
            says="asks joint `lift` for the state `velocity`, and it has `position`",
        ),
        Bad(
            ROBOT,
            files=files("velocity_controllers/JointGroupVelocityController", "joints: [lift]"),
            says="asks joint `lift` for the command `velocity`, and it has `position`",
        ),
    )
    good = (
        Good(
            SOUND,
            files=files(
                TRAJECTORY, "{joints: [lift], command_interfaces: [position], state_interfaces: [position]}"
            ),
        ),
        Good(
            SOUND,
            files=files(TRAJECTORY, "joints: [$(var prefix)lift]"),
            why="the launch file gives the name",
        ),
        Good(SOUND, files=files("my_controllers/Own", "joints: [all]"), why="nothing is known about it"),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return any(True for _ in robot.unmet_needs)

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        seen = set()
        for plugin, need in robot.unmet_needs:
            problem = need.controller, need.interface, need.is_command
            if problem not in seen:
                seen.add(problem)
                place = next(plugin.children("parameters"))
                message = f"`{need.controller}` of `{need.span.source.path.name}` asks {asked(robot, need)}"
                yield self.diagnostic(place, message, labels={need.span: "asked for here"})


def asked(robot: Model, need: ControllerNeed) -> str:
    """What a controller asks for, and what is there instead."""
    if not need.interface:
        near = suggest(need.name, robot.control_joints) if need.what == "joint" else None
        there = f", but `{near}`" if near else ""
        return f"for {need.what} `{need.name}`, which no `ros2_control` block of {robot.title} has{there}"
    kind = "command" if need.is_command else "state"
    given = [each for joint in robot.control_joints[need.name] for each in joint.interfaces]
    names = {each.name for each in given if each.is_command == need.is_command}
    there = named(sorted(names)) if names else f"no {kind}"
    return f"{need.what} `{need.name}` for the {kind} `{need.interface}`, and it has {there}"
