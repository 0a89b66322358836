from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Model, Rule, Severity
from sdfcheck_rules.r2c.scaffold import IN_ROBOT

PLUGIN = (
    '<ros2_control name="arm" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    '<joint name="lift"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>'
    '<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">'
    "{}<{}>controllers.yaml</parameters></plugin></gazebo>"
)
SPACE = "<ros><namespace>{}</namespace></ros>"
MANAGER = "{}: {{ros__parameters: {{update_rate: 100, arm: {{type: {}{}}}}}}}\n"
ARM = "{}: {{ros__parameters: {{joints: [lift], command_interfaces: [position], state_interfaces: [position]}}}}\n"
TRAJECTORY = "joint_trajectory_controller/JointTrajectoryController"


def files(manager: str, arm: str, inner: str = "") -> dict[str, str]:
    own = ARM.format(arm) if arm else ""
    return {"controllers.yaml": MANAGER.format(manager, TRAJECTORY, inner) + own}


class UnreachedParameters(Rule):
    """Parameters are in a file under a name or namespace that none of the controllers has.

    A file of parameters says for which node they are, by its name and its namespace. A controller whose name differs,
    or whose parameters are beside its type, has none, and is not configured: its list of joints is empty. With a
    namespace in the plugin of Gazebo, `controller_manager:` at the top of the file is about another node, and no
    controller has a type.
    """

    code = "R2C042"
    name = "unreached-parameters"
    severity = Severity.WARNING
    remedy = """Give the parameters the name of their controller, at the top of the file.

    Below a namespace that the launch file gives, write `/**/controller_manager:` and `/**/arm_controller:`, which are
    right for all.
    """
    looks_at = (Model,)
    selects = ("urdf:robot",)
    needs = ("ros2_control",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            PLUGIN.format("", "«parameters»"),
            files=files("controller_manager", "arms"),
            says="controller `arm` has no parameters in `controllers.yaml`, and nothing reads those of `arms`",
        ),
        Bad(
            PLUGIN.format("", "«parameters»"),
            files=files("controller_manager", "", ", joints: [lift]"),
            says="controller `arm` does not read the parameters beside its type in `controllers.yaml`",
        ),
        Bad(
            PLUGIN.format(SPACE.format("«/r1»"), "parameters"),
            files=files("controller_manager", "arm"),
            says="the controllers are in namespace `/r1`, and `controllers.yaml` is about `/controller_manager`",
        ),
    )
    good = (
        Good(PLUGIN.format("", "parameters"), files=files("controller_manager", "arm")),
        Good(
            PLUGIN.format("", "parameters"), files=files("controller_manager", ""), why="they are elsewhere"
        ),
        Good(
            PLUGIN.format(SPACE.format("/r1"), "parameters"), files=files("/**/controller_manager", "/**/arm")
        ),
        Good(
            PLUGIN.format(SPACE.format("/r1"), "parameters"), files=files("/r1/controller_manager", "/r1/arm")
        ),
    )

    @staticmethod
    def applies(robot: Model) -> bool:
        return any(plugin.controllers.unreached or plugin.lost_namespace for plugin in robot.control_plugins)

    def check(self, robot: Model) -> Iterator[Diagnostic]:
        for plugin in robot.control_plugins:
            name, manager = plugin.lost_namespace, plugin.controllers.manager
            if name is not None and manager is not None:
                file = manager.span.source.path.name
                message = f"the controllers are in namespace `{name.text.strip()}`, and `{file}` is about"
                yield self.diagnostic(
                    name, f"{message} `/controller_manager`", labels={manager.span: "written here"}
                )
            for each in plugin.controllers.unreached:
                file = each.span.source.path.name
                message = f"does not read the parameters beside its type in `{file}`"
                if each.stray:
                    message = f"has no parameters in `{file}`, and nothing reads those of `{each.stray}`"
                message = f"controller `{each.controller}` {message}"
                place = plugin.file_of_controllers or plugin
                yield self.diagnostic(place, message, labels={each.span: "written here"})
