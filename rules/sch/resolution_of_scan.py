from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Rule, Sensor, Severity, Value

MOST = 0.2
"""A resolution of less is a step in radians or degrees."""
COARSE = 0.0175
"""rad: no scanner has its beams farther apart; some take a tenth of very many samples on purpose."""
LIDAR = (
    '<sensor name="s" type="gpu_lidar"><lidar><scan><horizontal><samples>920</samples><resolution>{}</resolution>'
    "<min_angle>-3</min_angle><max_angle>3</max_angle></horizontal></scan>"
    "<range><min>0.1</min><max>9</max></range></lidar></sensor>"
)


class ResolutionOfScan(Rule):
    """The resolution of a scan is given as an angle.

    `resolution` multiplies `samples`: with 0.03 of 920 samples 27 are left. The angle between two beams follows from
    the angles and the number of samples; the resolution is 1.
    """

    code = "SCH032"
    name = "resolution-of-scan"
    severity = Severity.WARNING
    remedy = """Write `<resolution>1</resolution>`, and the number of beams in `<samples>`.

    The number of samples is (max_angle - min_angle) / angle between two beams + 1: 1° over 270° makes 271.
    """
    looks_at = (Sensor,)
    needs = ("<resolution",)
    scaffold = IN_LINK

    bad = (
        Bad(LIDAR.format("«0.03»"), says="a resolution of 0.03 leaves 27 of 920 samples; it is not an angle"),
    )
    good = (
        Good(LIDAR.format("1")),
        Good(LIDAR.format("0.5"), why="every other one"),
        Good(LIDAR.format("0.1").replace("920", "10000"), why="1000 beams are enough"),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return any(True for _ in thinned(sensor))

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        for resolution, samples in thinned(sensor):
            left = int(resolution.number * samples.number)
            yield self.diagnostic(
                resolution,
                f"a resolution of {resolution.text.strip()} leaves {left} of {samples.text.strip()} samples;"
                " it is not an angle",
                labels={samples: "the samples"},
            )


def thinned(sensor: Sensor) -> Iterator[tuple[Value, Value]]:
    """The resolutions that leave next to nothing, each with the samples."""
    for name in ("lidar", "ray"):
        settings = sensor.find(name)
        scan = None if settings is None else settings.find("scan")
        for direction in () if scan is None else scan.children():
            resolution, samples = direction.value("resolution"), direction.value("samples")
            low, high = direction.value("min_angle"), direction.value("max_angle")
            if resolution is None or samples is None or low is None or high is None or not samples.number > 1:
                continue
            beams = resolution.number * samples.number
            if 0 < resolution.number < MOST and high.number - low.number > COARSE * beams:
                yield resolution, samples
