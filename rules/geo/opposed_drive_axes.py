from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Joint, Plugin, Rule, Severity
from sdfcheck_rules.geo.scaffolds import rover


class OpposedDriveAxes(Rule):
    """The wheels of a differential drive turn in opposite directions.

    The plugin gives both the same speed to drive straight on. With opposite axes the robot spins on its place, and
    drives on the command to turn.
    """

    code = "GEO010"
    name = "opposed-drive-axes"
    severity = Severity.WARNING
    remedy = """Turn the axis of one wheel around: `0 1 0` for both in a robot that drives along x.

    The axis is in the frame of the joint, so a wheel that is mounted by `rpy="… … 3.14159"` or turned by
    its pose needs `0 -1 0`. The speed is positive forwards when the axes point to the left of the robot.
    Signs in controllers that made up for the difference have to go with it.
    """
    looks_at = (Plugin,)

    bad = (
        Bad(
            rover(axis="«0 -1 0»"),
            says="the axes of `left_joint` and `right_joint` are opposite, and drive `gz::sim::systems::DiffDrive`"
            " turns both alike",
        ),
    )
    good = (Good(rover()),)

    @staticmethod
    def applies(plugin: Plugin) -> bool:
        return bool(opposed(plugin))

    def check(self, plugin: Plugin) -> Iterator[Diagnostic]:
        drive = plugin.drive
        for joint in opposed(plugin)[:1]:
            assert drive is not None
            yield self.diagnostic(
                joint.axis.xyz,
                f"the axes of `{drive.left.joint.name}` and `{joint.name}` are opposite, and drive"
                f" `{plugin.name}` turns both alike",
                labels={drive.left.joint.axis.xyz: "the other axis", plugin: "this drive"},
            )


def opposed(plugin: Plugin) -> list[Joint]:
    """The joints whose axes point to the other side than that of the first wheel on the left."""
    drive = plugin.drive
    if drive is None:
        return []
    along = drive.left.axis
    return [
        wheel.joint
        for wheel in drive.wheels
        if sum(one * other for one, other in zip(along, wheel.axis, strict=True)) < -0.5
    ]
