from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Drive, Good, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import controlled, controllers, rover

MOST = 0.1
"""Of the distance: of 57 drives in public robots two differ by more, and one of these by a factor of two."""

SKID = 2.2
"""Times: vehicles that skid with several wheels a side turn as if their wheels were up to twice as far apart."""


class MismatchedWheelSeparation(Rule):
    """The wheels of a differential drive are not as far apart as the plugin says, or its controller.

    It computes the speeds of the wheels and the odometry from `wheel_separation`: with half of the distance
    the robot turns half as far as it believes. A `diff_drive_controller` has it in the file of parameters that the
    plugin of ros2_control names.
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
        Bad(
            controlled(rover(), "«parameters»"),
            files=controllers(wheel_separation="1.7"),
            says="the wheels are 0.34 m apart, and `wheel_separation` of `c.yaml` says 1.7",
        ),
    )
    good = (
        Good(rover(wheel_separation="0.34")),
        Good(
            controlled(rover()),
            files=controllers(wheel_separation="0.17", wheel_separation_multiplier="2.0"),
            why="it is corrected",
        ),
        Good(rover(wheel_separation="0.33"), why="measured between other points of the wheels"),
        Good(rover(wheel_separation="0.44", beyond=0.05), why="the joints are on the inner sides"),
    )

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return any(is_mismatched(drive) for drive in plugin.drives)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        for drive in plugin.drives:
            written = drive.separation
            if written is None or not is_mismatched(drive):
                continue
            labels = {drive.left.joint: "the left wheel", drive.right.joint: "the right wheel"}
            yield self.diagnostic(
                drive.place(written) or plugin,
                f"the wheels are {abs(drive.distance):.3g} m apart, and {drive.called(written)} says"
                f" {written.content.strip()}",
                labels={**drive.labels(written), **labels},
            )


def is_mismatched(drive: Drive) -> bool:
    """Is the written distance another one than that of the wheels?"""
    if drive.separation is None or not drive.separation.own_value.number > 0:
        return False
    written, skids = drive.separation.own_value.number, len(drive.lefts) > 1 and drive.base is None
    return is_other(written, drive.distance, skids) and is_other(written, drive.distance_of_middles, skids)


def is_other(written: float, distance: float, skids: bool) -> bool:
    """Is it far from a distance, measured or nan for none?"""
    distance = abs(distance)
    if skids:
        return not distance < 0.01 and not distance / SKID <= written <= SKID * distance
    return not distance < 0.01 and not abs(written - distance) <= MOST * distance
