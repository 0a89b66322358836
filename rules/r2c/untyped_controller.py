from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Root, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

BLOCK = (
    '<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="lift"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>'
)
PLUGIN = (
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "<{}>controllers.yaml</parameters></plugin></gazebo>"
)
ROBOT, SOUND = BLOCK + PLUGIN.format("«parameters»"), BLOCK + PLUGIN.format("parameters")
STATES = "joint_state_broadcaster: {type: joint_state_broadcaster/JointStateBroadcaster}"
TRAJECTORY = "lift_controller: {type: joint_trajectory_controller/JointTrajectoryController}"
LAUNCH = 'Node(package="controller_manager", executable="spawner", arguments=["{}"])\n'


def files(types: str, started: str = "lift_controller") -> dict[str, str]:
    own = "{joints: [lift], command_interfaces: [position], state_interfaces: [position]}"
    return {
        "controllers.yaml": f"controller_manager: {{ros__parameters: {{{types}}}}}\n"
        f"lift_controller: {{ros__parameters: {own}}}\n",
        "launch/sim.launch.py": LAUNCH.format(started),
    }


class UntypedController(Rule):
    """A launch file starts a controller that has parameters and no type.

    The controller manager says that the parameter `type` was not defined for it, and loads nothing: commands do
    nothing. Looked at are the file that the simulator's plugin names, the other YAML of the project, and its launch
    files; nothing is said where one of these gives types or other files of parameters.
    """

    code = "R2C045"
    name = "untyped-controller"
    severity = Severity.WARNING
    remedy = """Write its type below `controller_manager`.

    As in `lift_controller: {type: joint_trajectory_controller/JointTrajectoryController}`.
    """
    looks_at = (Root,)
    needs = ("ros2_control",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            ROBOT,
            files=files(STATES),
            says="controller `lift_controller` has parameters in `controllers.yaml` and no type",
        ),
    )
    good = (
        Good(SOUND, files=files(f"{STATES}, {TRAJECTORY}")),
        Good(SOUND, files=files(STATES, "other_controller"), why="nothing starts it"),
        Good(
            SOUND,
            files=files(STATES)
            | {"more.yaml": f"controller_manager: {{ros__parameters: {{{TRAJECTORY}}}}}\n"},
            why="another file gives the type",
        ),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return bool(root.untyped_controllers)

    def check(self, root: Root) -> Iterator[Diagnostic]:
        for plugin, each in root.untyped_controllers:
            file = each.span.source.path.name
            message = f"controller `{each.name}` has parameters in `{file}` and no type"
            yield self.diagnostic(
                plugin.file_of_controllers or plugin, message, labels={each.span: "its parameters"}
            )
