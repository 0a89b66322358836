from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Mistyped, Model, Rule, Semantics, Severity
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
WORDS = {
    "number": "a number with a point",
    "integer": "a whole number",
    "bool": "true or false",
    "text": "one text",
    "list": "a list",
    "numbers": "a list of numbers with points",
}
SIDES = "left_wheel_names: [$(var left)], right_wheel_names: [$(var right)]"
DRIVE = "diff_drive_controller/DiffDriveController"
FORWARD = "forward_command_controller/ForwardCommandController"
MANAGER = "controller_manager: {{ros__parameters: {{update_rate: {}}}}}\n"


def files(kind: str, parameters: str) -> dict[str, str]:
    return {"controllers.yaml": f"drive: {{ros__parameters: {{type: {kind}, {parameters}}}}}\n"}


class MistypedParameter(Rule):
    """A parameter of a controller or of MoveIt is of another type than the one that it is declared with.

    ROS 2 tells whole numbers from others by the point: `wheel_radius: 1` is refused where `1.0` is asked for, and a
    list where a text is. The controller is not loaded then, and the controller manager or RViz ends. Looked at are the
    file that the simulator's plugin names and, beside an SRDF file, `joint_limits.yaml` in a package of ROS 2.
    """

    code = "R2C043"
    name = "mistyped-parameter"
    severity = Severity.ERROR
    remedy = "Write the value as its type: numbers with a point, counts without, lists in brackets."
    looks_at = (Model, Semantics)
    scaffold = IN_ROBOT
    sources = ("https://github.com/ros-controls/ros2_controllers", "https://github.com/moveit/moveit2")

    bad = (
        Bad(
            ROBOT,
            files=files(DRIVE, f"{SIDES}, wheel_radius: 1, wheel_separation: 2"),
            says="`wheel_radius` of `drive` in `controllers.yaml` is `1`, and a number with a point is asked for, "
            "such as 1.0 (and 1 more)",
        ),
        Bad(
            ROBOT,
            files=files(FORWARD, "joints: [lift], interface_name: [position]"),
            says="`interface_name` of `drive` in `controllers.yaml` is `[position]`, and one text is asked for",
        ),
        Bad(ROBOT, files={"controllers.yaml": MANAGER.format("30.0")}, says="a whole number is asked for"),
    )
    good = (
        Good(SOUND, files=files(DRIVE, "wheel_radius: 1.0, velocity_rolling_window_size: 10")),
        Good(SOUND, files=files(DRIVE, "wheel_radius: $(var radius)"), why="it is written later"),
        Good(SOUND, files=files("my_controllers/Own", "wheel_radius: 1"), why="nothing is known about it"),
    )

    @staticmethod
    def applies(part: Model | Semantics) -> bool:
        return any(True for _ in part.mistyped) if isinstance(part, Model) else bool(part.mistyped)

    def check(self, part: Model | Semantics) -> Iterator[Diagnostic]:
        if isinstance(part, Semantics):
            for found in part.mistyped:
                yield self.diagnostic(part, said(found), labels={found.parameter.span: "written here"})
            return
        for plugin, found in part.mistyped:
            place = plugin.file_of_controllers or plugin
            yield self.diagnostic(place, said(found), labels={found.parameter.span: "written here"})


def said(found: Mistyped) -> str:
    name, text, span = found.parameter
    like = f", such as {text}.0" * (found.asked == "number" and text.lstrip("-+").isdigit())
    more = f" (and {found.more} more)" * bool(found.more)
    where = f"`{name}` of `{found.owner}` in `{span.source.path.name}`"
    return f"{where} is `{text}`, and {WORDS[found.asked]} is asked for{like}{more}"
