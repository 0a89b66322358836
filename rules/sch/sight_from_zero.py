from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Rule, Sensor, Severity, Value

PATHS = {"gpu_lidar": (("lidar", "range", "min"), ("ray", "range", "min"))}
"""Where sensors that are rendered say from which distance on they see; all others are cameras."""
CAMERA = (("camera", "clip", "near"),)
LIDAR = (
    '<sensor name="s" type="{}"><lidar><scan><horizontal><samples>9</samples><min_angle>-1</min_angle>'
    "<max_angle>1</max_angle></horizontal></scan><range><min>{}</min><max>9</max></range></lidar></sensor>"
)
VIEW = (
    '<sensor name="s" type="depth_camera"><camera><clip><near>{}</near><far>9</far></clip></camera></sensor>'
)


class SightFromZero(Rule):
    """A camera or lidar is to see from a distance of 0 on.

    Its picture is drawn by OGRE, which refuses to begin at 0: Gazebo ends with "Near clip distance must be greater than
    zero" as soon as the sensor is made. A lidar whose rays are those of physics may begin at 0.
    """

    code = "SCH039"
    name = "sight-from-zero"
    severity = Severity.WARNING
    remedy = """Write a small distance, such as 0.01 for a camera and 0.08 for a lidar.

    Nothing nearer is seen: a distance larger than the housing of the sensor keeps it out of its own sight.
    """
    looks_at = (Sensor,)
    needs = ("<near", "<min>")
    scaffold = IN_LINK

    bad = (
        Bad(
            LIDAR.format("gpu_lidar", "«0.0»"),
            says="sensor `s` is to see from 0.0 on, from where nothing is drawn",
        ),
        Bad(VIEW.format("«0»")),
    )
    good = (
        Good(LIDAR.format("gpu_lidar", "0.08")),
        Good(LIDAR.format("ray", "0"), why="its rays are not drawn"),
        Good(VIEW.format("0.05")),
        Good(VIEW.format("-1"), why="out-of-range owns this one"),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return near(sensor) is not None

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        value = near(sensor)
        assert value is not None
        message = f"{sensor.title} is to see from {value.text.strip()} on, from where nothing is drawn"
        yield self.diagnostic(value, message)


def near(sensor: Sensor) -> Value | None:
    """The distance from which it sees, where that is 0."""
    paths = PATHS.get(sensor.type, CAMERA if "camera" in sensor.type else ())
    for path in paths:
        element = sensor.find(path[0])
        for name in path[1:]:
            element = element.find(name) if element is not None else None
        if element is not None and element.content and element.own_value.number == 0:
            return element.own_value
    return None
