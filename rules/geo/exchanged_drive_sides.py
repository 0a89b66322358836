from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import rover


class ExchangedDriveSides(Rule):
    """The left wheel of a differential drive is on the right.

    The plugin turns both wheels by their names alone: with the sides exchanged the robot turns right on the command
    to turn left, and its odometry says the opposite. Left is where the axes of the wheels point to, for positive
    speeds drive forwards.
    """

    code = "GEO009"
    name = "exchanged-drive-sides"
    severity = Severity.WARNING
    remedy = """Exchange the two joints in the parameters of the plugin.

    `left_joint` (or `left_wheel_joint`) is the one with the greater y in a robot that drives along x, as
    ROS has it. If the names of the joints themselves are wrong, rename the joints instead. A robot that
    then drives backwards has axes that point to the right: turn both around.
    """
    looks_at = (Plugin,)

    bad = (
        Bad(
            rover(left="right").replace(">right_joint</left", ">«right_joint»</left"),
            says="`left_joint` names `right_joint`, which is 0.34 m to the right of `left_joint`",
        ),
    )
    good = (Good(rover()),)

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return is_exchanged(plugin)

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        drive = plugin.drive
        if drive is None:
            return
        yield self.diagnostic(
            drive.left_name.own_value,
            f"`{drive.left_name.name}` names `{drive.left.joint.name}`, which is {-drive.distance:.3g} m to the right"
            f" of `{drive.right.joint.name}`",
            labels={drive.right_name: "the other side"},
        )


def is_exchanged(plugin: Plugin) -> bool:
    """Is the left wheel on the right, and do both axes point to one side?"""
    drive = plugin.drive
    if drive is None or not drive.distance < 0:
        return False
    return sum(left * right for left, right in zip(drive.left.axis, drive.right.axis, strict=True)) > 0.5
