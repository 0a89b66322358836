from collections.abc import Iterator

from sdfcheck import Bad, Collision, Diagnostic, Drive, Good, Joint, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import controlled, controllers, rover

MOST = 0.1
"""Of the radius that the plugin says."""
ALIKE = 0.01
"""Of the radius of the other wheel of a pair; wheels of other axles may differ by a tenth."""
CAR, MEASURED = "gazebo_ros_ackermann_drive", "front_right_joint"
BACK = "".join(
    f'<link name="back_{side}"><collision><origin rpy="1.5708 0 0"/>'
    f'<geometry><cylinder radius="{{{side}}}" length="0.04"/></geometry></collision></link>'
    f'<joint name="back_{side}_joint" type="continuous"><origin xyz="-0.4 {y} 0"/>'
    f'<parent link="base"/><child link="back_{side}"/><axis xyz="0 1 0"/></joint>'
    for side, y in (("left", 0.17), ("right", -0.17))
)
NAMES = "<left_joint>back_left_joint</left_joint><right_joint>back_right_joint</right_joint></plugin>"


def four(*, left: str, right: str) -> str:
    """The rover with two more wheels of such radii."""
    wheels = BACK.format(left=left, right=right)
    return rover().replace("<gazebo>", f"{wheels}<gazebo>").replace("</plugin>", NAMES)


def car(shape: str) -> str:
    """The rover with the drive for cars, whose right wheel has such a shape."""
    text = rover(radius="@").replace('<cylinder radius="@" length="0.04"/>', shape)
    text = text.replace("gz-sim-diff-drive-system", f"lib{CAR}.so").replace(
        "gz::sim::systems::DiffDrive", "car"
    )
    for side in ("left", "right"):
        text = text.replace(f"{side}_joint>", f"front_{side}_joint>")
    return text


class MismatchedWheelRadius(Rule):
    """The wheels of a differential drive have another radius than the plugin or controller says, or two different ones.

    Speed and odometry are computed from one radius. Of two wheels that differ the larger one gets ahead: the robot
    drives in a circle. Of two axles one slides, or does not touch the floor.

    The drive of ROS 2 for cars in Gazebo Classic, `gazebo_ros_ackermann_drive`, takes the radius of its wheels from the
    first collision of the right wheel in front. A cylinder and a sphere have one; for a mesh or a box it takes 0, and
    divides by that.
    """

    code = "GEO012"
    name = "mismatched-wheel-radius"
    severity = Severity.WARNING
    remedy = """Write the radius of the wheels, in meters, in the plugin and in the collisions of both wheels.

    The radius is that of the tread under load, not the diameter. Of several numbers take the measured one;
    the same number belongs into the visual, the collision and the configuration of the controller, best
    from one property of xacro.
    """
    looks_at = (Plugin,)

    bad = (
        Bad(
            rover(wheel_radius="«0.15»"),
            says="the wheels have a radius of 0.1 m, and `wheel_radius` says 0.15",
        ),
        Bad(
            controlled(rover(), "«parameters»"),
            files=controllers(wheel_radius="0.2"),
            says="and `wheel_radius` of `c.yaml` says 0.2",
        ),
        Bad(
            rover(radius="«0.096»"),
            says="the right wheel has a radius of 0.096 m, and the left one of 0.1 m",
        ),
        Bad(
            four(left="«0.06»", right="0.06"),
            says="wheel `back_left` has a radius of 0.06 m, and wheel `left` one of 0.1 m",
        ),
        Bad(
            car('<«box» size="0.2 0.2 0.2"/>'),
            says="`front_right_joint` takes the radius from the first collision of its wheel, and a `box` has none",
        ),
    )
    good = (
        Good(rover(wheel_radius="0.1")),
        Good(rover(wheel_radius="0.095"), why="a soft tire"),
        Good(four(left="0.095", right="0.095")),
        Good(car('<cylinder radius="0.1" length="0.04"/>')),
        Good(
            rover(wheel_diameter="0.1"),
            why="the plugin does not read it: misspelled-plugin-parameter owns this one",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        drives = plugin.drives
        return any(
            other_wheel(drive) is not None or is_mismatched(drive) or edged(plugin, drive) for drive in drives
        )

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for drive in plugin.drives:
            yield from self.of_drive(plugin, drive)
            for collision in edged(plugin, drive):
                shape = collision.geometry.shape
                yield self.diagnostic(
                    collision.geometry.element.find(shape) or collision,
                    f"`{MEASURED}` takes the radius from the first collision of its wheel, and a `{shape}` has none",
                    labels={plugin: "this drive"},
                    help="make the first collision of the wheel a cylinder or a sphere",
                )

    def of_drive(self, plugin: Plugin, drive: Drive) -> Iterator[Diagnostic]:
        left, right, other = drive.left, drive.right, other_wheel(drive)
        if other is not None:
            joint, radius = other
            links = [each for each in (joint.child_link, left.joint.child_link) if each is not None]
            shapes = [(each.collisions or each.visuals)[0] for each in links]
            words = [f"wheel `{links[0].name}`", f"wheel `{links[-1].name}` one"]
            one, two = ["the right wheel", "the left one"] if joint is right.joint else words
            yield self.diagnostic(
                shapes[0].geometry.radius,
                f"{one} has a radius of {radius:.3g} m, and {two} of {left.radius:.3g} m",
                labels={
                    shapes[1].geometry.radius: "the other radius",
                    plugin: f"this {drive.title.split()[0]} takes one for both",
                },
            )
        elif drive.radius is not None and is_mismatched(drive):
            labels = {left.joint: "the left wheel", right.joint: "the right wheel"}
            yield self.diagnostic(
                drive.place(drive.radius) or plugin,
                f"the wheels have a radius of {left.radius:.3g} m, and {drive.called(drive.radius)} says"
                f" {drive.radius.content.strip()}",
                labels={**drive.labels(drive.radius), **labels},
            )


def edged(plugin: Plugin, drive: Drive) -> list[Collision]:
    """The collision of which the drive for cars takes the radius, if it has none."""
    if plugin.known is None or plugin.known.file != CAR:
        return []
    links = [wheel.joint.child_link for wheel in drive.wheels if wheel.name.name == MEASURED]
    first = [link.collisions[0] for link in links if link is not None and link.collisions]
    return [each for each in first if each.geometry.shape not in {"", "cylinder", "sphere"}]


def other_wheel(drive: Drive) -> tuple[Joint, float] | None:
    """The joint and the radius of the first wheel that has another radius than the first on the left."""
    left, right = drive.left.radius, drive.right
    wheels = [(each, ALIKE if each is right else MOST) for each in (right, *drive.wheels)]
    found = (each for each, most in wheels if abs(each.radius - left) > most * left)
    return next(((each.joint, each.radius) for each in found), None)


def is_mismatched(drive: Drive) -> bool:
    """Is the written radius another one than that of all wheels?"""
    return all(abs(drive.written_radius - wheel.radius) > MOST * wheel.radius for wheel in drive.wheels)
