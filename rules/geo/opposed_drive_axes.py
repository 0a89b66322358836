from collections.abc import Iterator

from sdfcheck import Bad, ControlComponent, Diagnostic, Drive, Good, Joint, Link, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import controlled, controllers, rover

STEERED = "".join(
    f'<link name="{side}_knuckle"/><joint name="{side}_steer" type="revolute"><origin xyz="0.3 {y} 0"/>'
    f'<parent link="base"/><child link="{side}_knuckle"/><axis xyz="{{{side}}}"/>'
    '<limit lower="-1" upper="1" effort="9" velocity="1"/></joint>'
    for side, y in (("left", 0.17), ("right", -0.17))
)


def steered(*, left: str, right: str) -> str:
    """A car with such axes of steering."""
    plugin = "".join(
        f"<{side}_steering_joint>{side}_steer</{side}_steering_joint>" for side in ("left", "right")
    )
    made = rover().replace("<gazebo>", STEERED.format(left=left, right=right) + "<gazebo>")
    return (
        made.replace("diff-drive", "ackermann-steering")
        .replace("DiffDrive", "AckermannSteering")
        .replace("</plugin>", plugin + "</plugin>")
    )


CONTROLLED = (
    '<robot name="r"><link name="base"/>'
    + STEERED.format(left="{}", right="{}")
    + '<ros2_control name="c" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>'
    + "".join(
        f'<joint name="{side}_steer"><command_interface name="position"/></joint>'
        for side in ("left", "right")
    )
    + '</ros2_control><gazebo><plugin filename="gz_ros2_control-system" '
    'name="gz_ros2_control::GazeboSimROS2ControlPlugin"><parameters>car.yaml</parameters></plugin></gazebo></robot>'
)
AHEAD_ALONG_Y = (
    rover(axis="-1 0 0")
    .replace('xyz="0 0.17 0"', 'xyz="-0.17 0 0"')
    .replace('xyz="0 -0.17 0"', 'xyz="0.17 0 0"')
    .replace("1.5708 0 0", "0 1.5708 0")
    .replace('axis xyz="0 1 0"', 'axis xyz="{1}"')
    .replace('<link name="base"/>', '<link name="base"/>{0}')
)
TURNED_BASE = (
    '<link name="base_link"/><joint name="b" type="fixed"><origin rpy="0 0 1.5708"/><parent link="base"/>'
    '<child link="base_link"/></joint>'
)
COUNTING = frozenset(("gz-sim", "gz_ros2_control", "gazebo_ros2_control"))
"""Generations whose drives work their odometry out from the wheels; those of Classic know where the robot is."""
BASES = ("base_link", "base_footprint")
UNTURNED = 0.9
"""The x component of the x axis of a frame."""
FRAMES = ("robotBaseFrame", "robot_base_frame", "child_frame_id")
"""The parameters that name the frame of the base."""
CAR = {
    "car.yaml": "car: {ros__parameters: {type: ackermann_steering_controller/AckermannSteeringController, "
    "front_wheels_names: [left_steer, right_steer]}}\n"
}


class OpposedDriveAxes(Rule):
    """The wheels of a drive turn in opposite directions, backwards or across, or its steering turns the other way.

    The plugin gives both wheels the same speed to drive straight on. With opposite axes the robot spins on its place,
    and drives on the command to turn. Where the axes of all point to the right, it drives backwards; where they are
    along x, it drives along y, and its odometry says x. It steers to the left by positive angles: about an axis that
    points down they steer to the right. So do the controllers of ros2_control that steer, where a plugin names their
    file.
    """

    code = "GEO010"
    name = "opposed-drive-axes"
    severity = Severity.WARNING
    remedy = """Turn the axis around: `0 1 0` for all wheels in a robot that drives along x, `0 0 1` to steer.

    The axis is in the frame of the joint, so a wheel that is mounted by `rpy="… … 3.14159"` or turned by
    its pose needs `0 -1 0`. The speed is positive forwards when the axes point to the left of the robot.
    Signs in controllers that made up for the difference have to go with it.
    """
    looks_at = (Plugin, ControlComponent)

    bad = (
        Bad(
            rover(axis="«0 -1 0»"),
            says="the axes of `left_joint` and `right_joint` are opposite, and drive `gz::sim::systems::DiffDrive`"
            " turns both alike",
        ),
        Bad(
            controlled(rover(axis="«0 -1 0»")),
            files=controllers(),
            says="are opposite, and controller `drive` turns both alike",
        ),
        Bad(
            rover(axis="0 -1 0").replace('axis xyz="0 1 0"', 'axis xyz="«0 -1 0»"'),
            says="the axes of `left_joint` and `right_joint` point to the right: drive `gz::sim::systems::DiffDrive`"
            " goes backwards",
        ),
        Bad(
            AHEAD_ALONG_Y.format("", "«-1 0 0»"),
            says="the wheels turn about x: drive `gz::sim::systems::DiffDrive` goes along y, and takes x for ahead",
        ),
        Bad(
            steered(left="«0 0 -1»", right="0 0 -1"),
            says="the axis of `left_steer` points down: a command to turn left steers to the right",
        ),
        Bad(
            CONTROLLED.format("«0 0 -1»", "0 0 1"),
            files=CAR,
            says="the axis of `left_steer` points down: a command to turn left steers to the right",
        ),
    )
    good = (
        Good(rover()),
        Good(steered(left="0 0 1", right="0 0 1")),
        Good(
            AHEAD_ALONG_Y.format(TURNED_BASE, "-1 0 0"),
            why="the frame of its base is turned as well",
        ),
        Good(CONTROLLED.format("0 0 1", "0 0 1"), files=CAR),
    )

    @staticmethod
    def applies(part: Plugin | ControlComponent) -> bool:
        if isinstance(part, Plugin):
            return bool(opposed(part) or hanging(part) or backward(part) or sideways(part))
        return turned(part) is not None

    def check(self, part: Plugin | ControlComponent) -> Iterator[Diagnostic]:
        down = "points down: a command to turn left steers to the right"
        if isinstance(part, ControlComponent):
            steered = turned(part)
            assert steered is not None
            yield self.diagnostic(steered.axis.xyz, f"the axis of `{steered.name}` {down}")
            return
        plugin = part
        for drive, joint in opposed(plugin)[:1]:
            yield self.diagnostic(
                joint.axis.xyz,
                f"the axes of `{drive.left.joint.name}` and `{joint.name}` are opposite, and {drive.title}"
                " turns both alike",
                labels={
                    drive.left.joint.axis.xyz: "the other axis",
                    plugin: f"this {drive.title.split()[0]}",
                },
            )
        for drive in backward(plugin)[:1]:
            one, other = drive.left.joint, drive.right.joint
            yield self.diagnostic(
                one.axis.xyz,
                f"the axes of `{one.name}` and `{other.name}` point to the right: {drive.title} goes backwards",
                labels={other.axis.xyz: "the other axis", plugin: f"this {drive.title.split()[0]}"},
            )
        for drive in sideways(plugin)[:1]:
            message = f"the wheels turn about x: {drive.title} goes along y, and takes x for ahead"
            yield self.diagnostic(drive.left.joint.axis.xyz, message, labels={plugin: "drives them"})
        for joint in hanging(plugin)[:1]:
            message = f"the axis of `{joint.name}` {down}"
            yield self.diagnostic(joint.axis.xyz, message, labels={plugin: "this drive"})


def turned(component: ControlComponent) -> Joint | None:
    """The joint that a controller steers by, if its axis points down and it is the first such of its robot."""
    joint = component.joint if any(claim.steers for claim in component.claims) else None
    direction = joint.direction if joint is not None else None
    if direction is None or direction[2] > -0.5:
        return None
    names = list(component.block.joints)
    before = (component.block.joints[name] for name in names[: names.index(component.name)])
    return None if any(turned(other) is not None for other in before) else joint


def backward(plugin: Plugin) -> list[Drive]:
    """The drives whose wheels all turn about axes that point to the right of the robot."""
    return [drive for drive in plugin.drives if drive.is_backward]


def sideways(plugin: Plugin) -> list[Drive]:
    """The drives that count the turns of wheels which all roll along y, where the frame of their base is not turned."""
    if plugin.known is None or plugin.known.generation not in COUNTING:
        return []
    found = [drive for drive in plugin.drives if drive.is_sideways]
    model = found[0].left.joint.model if found else None
    named = (plugin.get(name) or "" for name in FRAMES)
    bases = [model.resolve(name.strip()) for name in (*named, *BASES)] if model is not None else []
    frames = [base.at_rest for base in bases if isinstance(base, Link) and base.at_rest is not None]
    return found if all(frame.rotation[0][0] > UNTURNED for frame in frames) else []


def hanging(plugin: Plugin) -> list[Joint]:
    """The steering joints whose axes point down."""
    steering = plugin.drive.steering if plugin.drive is not None else ()
    return [each.joint for each in steering if each.axis[2] < -0.5]


def opposed(plugin: Plugin) -> list[tuple[Drive, Joint]]:
    """The joints whose axes point to the other side than that of the first wheel on the left, with their drive."""
    return [
        (drive, wheel.joint)
        for drive in plugin.drives
        for wheel in drive.wheels
        if sum(one * other for one, other in zip(drive.left.axis, wheel.axis, strict=True)) < -0.5
    ]
