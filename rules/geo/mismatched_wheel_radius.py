from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Drive, Good, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import controlled, controllers, rover

MOST = 0.1
"""Of the radius that the plugin says."""
ALIKE = 0.01
"""Of the radius of the other wheel."""


class MismatchedWheelRadius(Rule):
    """The wheels of a differential drive have another radius than the plugin or controller says, or two different ones.

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
            controlled(rover(), "«parameters»"),
            files=controllers(wheel_radius="0.2"),
            says="and `wheel_radius` of `c.yaml` says 0.2",
        ),
        Bad(
            rover(radius="«0.096»"),
            says="the right wheel has a radius of 0.096 m, and the left one of 0.1 m",
        ),
    )
    good = (
        Good(rover(wheel_radius="0.1")),
        Good(rover(wheel_radius="0.095"), why="a soft tire"),
        Good(
            rover(wheel_diameter="0.1"),
            why="the plugin does not read it: misspelled-plugin-parameter owns this one",
        ),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return any(differ(drive) or is_mismatched(drive) for drive in plugin.drives)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for drive in plugin.drives:
            yield from self.of_drive(plugin, drive)

    def of_drive(self, plugin: Plugin, drive: Drive) -> Iterator[Diagnostic]:
        left, right = drive.left, drive.right
        if differ(drive):
            link, other = right.joint.child_link, left.joint.child_link
            shapes = [(each.collisions or each.visuals)[0] for each in (link, other) if each is not None]
            yield self.diagnostic(
                shapes[0].geometry.radius,
                f"the right wheel has a radius of {right.radius:.3g} m, and the left one of {left.radius:.3g} m",
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


def differ(drive: Drive) -> bool:
    """Have the two wheels different radii?"""
    return abs(drive.left.radius - drive.right.radius) > ALIKE * drive.left.radius


def is_mismatched(drive: Drive) -> bool:
    """Is the written radius another one than that of all wheels?"""
    return all(abs(drive.written_radius - wheel.radius) > MOST * wheel.radius for wheel in drive.wheels)
