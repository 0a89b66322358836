from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Plugin, Rule, Severity

SIDES = ("left_joint", "right_joint")
WHEEL = (
    '<link name="{0}"/><joint name="{0}_joint" type="continuous"><parent link="base"/><child link="{0}"/>'
    '<axis xyz="0 1 0"/></joint>'
)
NAMES = ("left", "right", "left_rear", "right_rear")


def drive(pairs: str, count: int, plugin: str = "plugin") -> str:
    """A robot with four wheels, and a drive that turns so many of them."""
    sides = [name.partition("_")[0] for name in NAMES[:count]]
    joints = "".join(
        f"<{side}_joint>{name}_joint</{side}_joint>" for side, name in zip(sides, NAMES, strict=False)
    )
    return (
        f'<robot name="r"><link name="base"/>{"".join(map(WHEEL.format, NAMES))}<gazebo>'
        f'<{plugin} name="drive" filename="libgazebo_ros_diff_drive.so"><ros><namespace>r</namespace></ros>{pairs}'
        f"{joints}</plugin></gazebo></robot>"
    )


CONTROLLED = (
    f'<robot name="r"><link name="base"/>{"".join(map(WHEEL.format, NAMES))}<ros2_control name="c" type="system">'
    "<hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>"
    + "".join(
        f'<joint name="{name}_joint"><command_interface name="{command}"/><state_interface name="position"/></joint>'
        for name, command in zip(NAMES, ("velocity", "velocity", "position", "position"), strict=True)
    )
    + '</ros2_control><gazebo><plugin filename="gz_ros2_control-system" '
    'name="gz_ros2_control::GazeboSimROS2ControlPlugin"><{}>c.yaml</parameters></plugin></gazebo></robot>'
)
CAR = (
    "car: {{ros__parameters: {{type: ackermann_steering_controller/AckermannSteeringController, "
    "traction_joints_names: [{}], steering_joints_names: [left_rear_joint, right_rear_joint]}}}}\n"
)


class MiscountedWheels(Rule):
    """A drive of ROS 2 has another number of joints than it has pairs of wheels, or than it takes.

    `num_wheel_pairs` is 1 where it is not written, so that four wheels need a 2. The plugin reports inconsistent
    numbers of joints, and switches itself off: the robot does not move, and there is no odometry. The controllers for
    cars take two joints that drive and two that steer, for tricycles two and one, for bicycles one of each; a
    differential drive has as many on both sides. With others the controller is not configured.
    """

    code = "RES025"
    name = "miscounted-wheels"
    severity = Severity.ERROR
    remedy = """Write `<num_wheel_pairs>` with the number of joints of each side.

    Each pair has a `<left_joint>`, a `<right_joint>`, a `<wheel_separation>` and a `<wheel_diameter>`, in one order.
    """
    looks_at = (Plugin,)
    needs = ("plugin",)
    scaffold = "{}"
    sources = (
        "https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp",
    )

    bad = (
        Bad(
            drive("", 4, "«plugin»"),
            says="drives 1 pair of wheels, and names 2 left and 2 right joints: it does not run",
        ),
        Bad(
            drive("<num_wheel_pairs>«2»</num_wheel_pairs>", 2),
            says="drives 2 pairs of wheels, and names 1 left and 1 right joint: it does not run",
        ),
        Bad(
            CONTROLLED.format("«parameters»"),
            files={"c.yaml": CAR.format("left_joint, right_joint, right_joint")},
            says="controller `car` of `c.yaml` names 3 driven and 2 steered joints, and takes 2 and 2",
        ),
    )
    good = (
        Good(drive("", 2)),
        Good(drive("<num_wheel_pairs>2</num_wheel_pairs>", 4)),
        Good(CONTROLLED.format("parameters"), files={"c.yaml": CAR.format("left_joint, right_joint")}),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        if "ros2_control" in plugin.filename:
            return bool(plugin.controllers.miscounted)
        return counts(plugin) is not None

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        if "ros2_control" in plugin.filename:
            for each in plugin.controllers.miscounted:
                message = f"controller `{each.controller}` of `{each.span.source.path.name}` names {each.found} joints"
                place = plugin.file_of_controllers or plugin
                yield self.diagnostic(
                    place, f"{message}, and takes {each.asked}", labels={each.span: "named here"}
                )
            return
        found = counts(plugin)
        assert found is not None
        given, pairs, left, right = found
        words = f"drives {pairs} pair{'s' * (pairs != 1)} of wheels, and names {left} left and {right} right"
        message = f"{words} joint{'s' * (right != 1)}: it does not run"
        yield self.diagnostic(plugin if given is None else given.own_value, message)


def counts(plugin: Plugin) -> tuple[Element | None, int, int, int] | None:
    """The number of pairs, as it is written and as it is, and of joints on the left and right, where these differ."""
    given = plugin.find("num_wheel_pairs")
    left, right = (len(list(plugin.children(side))) for side in SIDES)
    text = "1" if given is None else given.content
    known = plugin.known
    if known is None or known.generation != "gazebo_ros2" or not text.isdecimal() or not left or not right:
        return None
    pairs = max(int(text), 1)
    return (given, pairs, left, right) if not pairs == left == right else None
