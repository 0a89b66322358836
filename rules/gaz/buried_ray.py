from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Element, Good, Rule, Sensor, Severity, Shape

MODEL = (
    '<sdf version="1.6"><model name="m"><link name="l"><collision name="c">{}<geometry><box><size>1 1 1</size></box>'
    '</geometry></collision><sensor name="s" type="ray">{}<ray><scan><horizontal><samples>9</samples>'
    "<min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan><range><min>{}</min><max>9</max></range></ray>"
    "</sensor></link></model></sdf>"
)
ROBOT = (
    '<robot name="r"><link name="root"/><link name="base"><collision><geometry><box size="1 1 1"/></geometry>'
    '</collision></link><link name="eye"/>'
    '<joint name="k" type="fixed"><parent link="root"/><child link="base"/></joint>'
    '<joint name="j" type="fixed"><origin xyz="0 0 {}"/><parent link="base"/><child link="eye"/></joint>'
    '<gazebo reference="eye"><sensor name="s" type="ray"><ray><scan><horizontal><samples>9</samples>'
    "<min_angle>-1</min_angle><max_angle>1</max_angle></horizontal></scan><range><min>{}</min><max>9</max></range></ray>"
    "</sensor></gazebo></robot>"
)


class BuriedRay(Rule):
    """All rays of a lidar begin inside of a collision of its own robot.

    The `ray` sensor of Gazebo Classic asks the physics what its rays meet, and its own link counts: each of them ends
    where it leaves the collision, so the sensor always says the same. Rays begin at the smallest range. Sensors on the
    graphics card (`gpu_ray`, `gpu_lidar`) see visuals, and are left out.
    """

    code = "GAZ027"
    name = "buried-ray"
    severity = Severity.WARNING
    remedy = """Move the sensor out of the collision, or make `<range><min>` so large that the rays begin outside.

    The collision may also be smaller, or left out, where it is only the housing of the sensor.
    """
    looks_at = (Sensor,)
    needs = ("<ray>",)
    scaffold = "{}"

    bad = (
        Bad(
            MODEL.format("", "", "«0.1»"),
            says="the rays of sensor `s` begin 0.1 m from it, and it is 0.5 m deep in a collision of link `l`",
        ),
        Bad(ROBOT.format("0.3", "«0.1»")),
    )
    good = (
        Good(MODEL.format("", "", "0.6"), why="they begin outside"),
        Good(MODEL.format("<pose>0.6 0 0 0 0 0</pose>", "", "0.01")),
        Good(MODEL.format("", "<pose>0.45 0 0 0 0 0</pose>", "0.1"), why="those ahead begin outside"),
        Good(ROBOT.format("0.6", "0.1")),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return sensor.type == "ray" and cover(sensor) is not None

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        found = cover(sensor)
        assert found is not None
        least, shape, depth = found
        message = (
            f"the rays of {sensor.title} begin {least.own_value.number:.3g} m from it, and it is {depth:.3g} m deep in"
            f" a collision of {shape.link.title}"
        )
        yield self.diagnostic(least.own_value, message, labels={shape: "around it"})


def cover(sensor: Sensor) -> tuple[Element, Shape, float] | None:
    """The least range of a lidar, and the deepest of the collisions that are around the beginnings of all rays."""
    at = sensor.find("ray")
    for name in ("range", "min"):
        at = at.find(name) if at is not None else None
    if at is None:
        return None
    around = [(at, shape, depth) for shape, depth in sensor.covers if depth > at.own_value.number >= 0]
    return max(around, key=lambda each: each[2], default=None)
