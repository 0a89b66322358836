from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import rover

MOST = 0.1
"""Of the radius that the plugin says."""
ALIKE = 0.01
"""Of the radius of the other wheel."""


class MismatchedWheelRadius(Rule):
    """The wheels of a differential drive have another radius than the plugin says, or two different ones.

    Speed and odometry are computed from one radius. Of two wheels that differ the larger one gets ahead: the robot
    drives in a circle.
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
            rover(radius="«0.096»"),
            says="the right wheel has a radius of 0.096 m, and the left one of 0.1 m",
        ),
    )
    good = (Good(rover(wheel_radius="0.1")), Good(rover(wheel_radius="0.095"), why="a soft tire"))

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return differ(plugin) or is_mismatched(plugin)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        drive = plugin.drive
        if drive is None:
            return
        left, right = drive.left, drive.right
        if differ(plugin):
            link, other = right.joint.child_link, left.joint.child_link
            shapes = [(each.collisions or each.visuals)[0] for each in (link, other) if each is not None]
            yield self.diagnostic(
                shapes[0].geometry.radius,
                f"the right wheel has a radius of {right.radius:.3g} m, and the left one of {left.radius:.3g} m",
                labels={
                    shapes[1].geometry.radius: "the other radius",
                    plugin: "this drive takes one for both",
                },
            )
        elif drive.radius is not None:
            yield self.diagnostic(
                drive.radius.own_value,
                f"the wheels have a radius of {left.radius:.3g} m, and `{drive.radius.name}` says"
                f" {drive.radius.content.strip()}",
                labels={left.joint: "the left wheel", right.joint: "the right wheel"},
            )


def differ(plugin: Plugin) -> bool:
    """Have the two wheels different radii?"""
    drive = plugin.drive
    return drive is not None and abs(drive.left.radius - drive.right.radius) > ALIKE * drive.left.radius


def is_mismatched(plugin: Plugin) -> bool:
    """Is the written radius another one than that of all wheels?"""
    drive = plugin.drive
    if drive is None:
        return False
    return all(abs(drive.written_radius - wheel.radius) > MOST * wheel.radius for wheel in drive.wheels)
