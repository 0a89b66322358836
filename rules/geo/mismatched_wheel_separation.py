from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import rover

MOST = 0.1
"""Of the distance: of 57 drives in public robots two differ by more, and one of these by a factor of two."""

SKID = 2.2
"""Times: vehicles that skid with several wheels a side turn as if their wheels were up to twice as far apart."""


class MismatchedWheelSeparation(Rule):
    """The wheels of a differential drive are not as far apart as the plugin says.

    It computes the speeds of the wheels and the odometry from `wheel_separation`: with half of the distance
    the robot turns half as far as it believes.
    """

    code = "GEO011"
    name = "mismatched-wheel-separation"
    severity = Severity.WARNING
    remedy = """Write the distance between the middles of the wheels as `wheel_separation`, in meters.

    `sdfcheck graph poses FILE` shows where the joints of the wheels are: the separation is the difference
    of the two y of a robot that drives along x. The distance counts between the middles of the treads, not
    between the sides of the chassis.
    """
    looks_at = (Plugin,)

    bad = (
        Bad(
            rover(wheel_separation="«0.17»"),
            says="the wheels are 0.34 m apart, and `wheel_separation` says 0.17",
        ),
    )
    good = (
        Good(rover(wheel_separation="0.34")),
        Good(rover(wheel_separation="0.33"), why="measured between other points of the wheels"),
        Good(rover(wheel_separation="0.44", beyond=0.05), why="the joints are on the inner sides"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return is_mismatched(plugin)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        drive = plugin.drive
        if drive is None or drive.separation is None:
            return
        yield self.diagnostic(
            drive.separation.own_value,
            f"the wheels are {abs(drive.distance):.3g} m apart, and `{drive.separation.name}` says"
            f" {drive.separation.content.strip()}",
            labels={drive.left.joint: "the left wheel", drive.right.joint: "the right wheel"},
        )


def is_mismatched(plugin: Plugin) -> bool:
    """Is the written distance another one than that of the wheels?"""
    drive = plugin.drive
    if drive is None or drive.separation is None or not drive.separation.own_value.number > 0:
        return False
    written, skids = drive.separation.own_value.number, len(drive.lefts) > 1 and drive.base is None
    return is_other(written, drive.distance, skids) and is_other(written, drive.distance_of_middles, skids)


def is_other(written: float, distance: float, skids: bool) -> bool:
    """Is it far from a distance, measured or nan for none?"""
    distance = abs(distance)
    if skids:
        return not distance < 0.01 and not distance / SKID <= written <= SKID * distance
    return not distance < 0.01 and not abs(written - distance) <= MOST * distance
