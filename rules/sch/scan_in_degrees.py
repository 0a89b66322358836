from collections.abc import Iterator
from math import pi, radians

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Rule, Sensor, Severity, Value, replace

TURN = 2 * pi * 1.01
"""A turn, with room for how it is rounded."""
NAMES = ("min_angle", "max_angle")
LIDAR = (
    '<sensor name="s" type="gpu_lidar"><lidar><scan><horizontal><samples>9</samples>'
    "<min_angle>{}</min_angle><max_angle>{}</max_angle></horizontal></scan>"
    "<range><min>0.1</min><max>9</max></range></lidar></sensor>"
)


class ScanInDegrees(Rule):
    """A lidar scans over more than a turn.

    The angles of a scan are in radians. Beyond 2π the beams go round again; such numbers were
    most likely meant in degrees.
    """

    code = "SCH025"
    name = "scan-in-degrees"
    severity = Severity.WARNING
    remedy = """Write the angles of the scan in radians: degrees × π / 180.

    A full turn is from -3.1415927 to 3.1415927. Beams at both ends fall together then, so use one sample
    less of the turn if that matters.
    """
    looks_at = (Sensor,)
    scaffold = IN_LINK

    bad = (
        Bad(
            LIDAR.format("-1.5708", "«90»"),
            fixed=LIDAR.format("-1.5708", "1.5707963"),
            unsafe=True,
            says="`max_angle` 90 rad is more than a turn; 90 degrees are 1.5707963 rad",
        ),
    )
    good = (Good(LIDAR.format("-3.1416", "3.1416")), Good(LIDAR.format("0", "6.28319"), why="one turn"))

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return (sensor.has("lidar") or sensor.has("ray")) and any(wide_angles(sensor))

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        for value in wide_angles(sensor):
            meant = f"{radians(value.number):.8g}"
            message = f"`{value.element.name}` {value.text.strip()} rad is more than a turn"
            yield self.diagnostic(
                value,
                f"{message}; {value.text.strip()} degrees are {meant} rad",
                fix=replace(value, meant, "convert it from degrees", unsafe=True),
            )


def wide_angles(sensor: Sensor) -> Iterator[Value]:
    """The angles of its scan beyond a turn."""
    for name in ("lidar", "ray"):
        settings = sensor.find(name)
        scan = None if settings is None else settings.find("scan")
        for direction in () if scan is None else scan.children():
            for angle in NAMES if direction.name in {"horizontal", "vertical"} else ():
                value = direction.value(angle)
                if value is not None and TURN < abs(value.number) < 1e6:
                    yield value
