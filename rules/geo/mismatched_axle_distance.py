from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import car

MOST = 0.1
"""Of the distance: that of the wheels on one axle differs by less in 55 of 57 drives of public robots."""


class MismatchedAxleDistance(Rule):
    """The axles of a vehicle are not as far apart as the plugin says.

    The plugin of an Ackermann or mecanum drive computes angles of steering, speeds of the wheels and odometry from
    that distance: with half of it the robot turns in a circle of half the size, as far as it believes.
    """

    code = "GEO016"
    name = "mismatched-axle-distance"
    severity = Severity.WARNING
    remedy = """Write the distance of the front axle from the rear one, which the joints of the wheels have.

    If the number is right, move the joints.
    """
    looks_at = (Plugin,)

    bad = (Bad(car(base="«0.25»"), says="the axles are 0.5 m apart, and `wheelbase` says 0.25"),)
    good = (Good(car(base="0.5")), Good(car(base="0.52"), why="rounded by hand"))

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return is_mismatched(plugin)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        drive = plugin.drive
        if drive is None or drive.base is None or len(drive.lefts) != 2:
            return
        yield self.diagnostic(
            drive.base.own_value,
            f"the axles are {drive.axle_distance:.3g} m apart, and `{drive.base.name}` says"
            f" {drive.base.content.strip()}",
            labels={drive.left.joint: "one wheel on the left", drive.lefts[1].joint: "the other one"},
        )


def is_mismatched(plugin: Plugin) -> bool:
    """Is the written distance another one than that of the wheels?"""
    drive = plugin.drive
    if drive is None or drive.base is None or not drive.base.own_value.number > 0:
        return False
    distance = drive.axle_distance
    return distance > 0.01 and abs(drive.base.own_value.number - distance) > MOST * distance
