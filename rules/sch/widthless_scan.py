from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Element, Good, Rule, Sensor, Severity

ROWS = ("horizontal", "vertical")
LIDAR = (
    '<sensor name="s" type="gpu_lidar"><lidar><scan><horizontal><samples>{}</samples><min_angle>-1</min_angle>'
    "<max_angle>1</max_angle></horizontal><vertical><samples>{}</samples>{}</vertical></scan>"
    "<range><min>0.1</min><max>9</max></range></lidar></sensor>"
)
ANGLES = "<min_angle>{}</min_angle><max_angle>{}</max_angle>"


class WidthlessScan(Rule):
    """A lidar has several beams, all of which go one way.

    Without `min_angle` and `max_angle` both are 0, and so is the angle between the beams: a scan of 16 rows measures
    one row 16 times, and points lie on each other.
    """

    code = "SCH038"
    name = "widthless-scan"
    severity = Severity.WARNING
    remedy = """Write the angles of the first and the last beam, in radians, as `min_angle` and `max_angle`.

    A lidar with 16 rows and 30° has -0.2618 and 0.2618. For a single beam write 1 for `samples`.
    """
    looks_at = (Sensor,)
    needs = ("<samples",)
    scaffold = IN_LINK

    bad = (
        Bad(LIDAR.format(360, "«16»", ANGLES.format(0, 0)), says="the 16 beams of `vertical` all go one way"),
        Bad(LIDAR.format(360, "«16»", ""), also=("SCH004",)),
    )
    good = (
        Good(LIDAR.format(360, 16, ANGLES.format(-0.2, 0.2))),
        Good(LIDAR.format(360, 1, ANGLES.format(0, 0)), why="one row"),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return next(flat(sensor), None) is not None

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        for samples in flat(sensor):
            row = samples.parent
            assert row is not None
            yield self.diagnostic(
                samples.own_value, f"the {samples.content} beams of `{row.name}` all go one way"
            )


def flat(sensor: Sensor) -> Iterator[Element]:
    """The numbers of beams above 1 whose first and last one have one angle."""
    lidar = sensor.find("lidar") or sensor.find("ray")
    scan = lidar.find("scan") if lidar is not None else None
    for row in ROWS if scan is not None else ():
        given = scan.find(row) if scan is not None else None
        samples = given.find("samples") if given is not None else None
        if given is None or samples is None or not samples.content.isdecimal() or int(samples.content) < 2:
            continue
        angles = [given.find(name) for name in ("min_angle", "max_angle")]
        first, last = (0.0 if angle is None else angle.own_value.number for angle in angles)
        if first == last:
            yield samples
