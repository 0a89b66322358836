import re
from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Good, Rule, Sensor, Severity, Value

PART = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
"""A part of a topic between two slashes, as ROS 2 allows it."""
SENSOR = '<gazebo reference="base"><sensor name="s" type="imu"><topic>{}</topic></sensor></gazebo>'


class UnbridgeableTopic(Rule):
    """The topic of a sensor has a name that ROS 2 does not allow.

    In ROS 2 each part of a topic begins with a letter, and has letters, digits and `_` alone. Gazebo allows more: it
    publishes, and the bridge to ROS ends with "topic name token must not start with a number" or the like. Looked at
    are robots in URDF.
    """

    code = "SCH040"
    name = "unbridgeable-topic"
    severity = Severity.WARNING
    remedy = """Use letters, digits and `_` for each part of the topic, with a letter first.

    `scan_2d` instead of `2d_scan`, `front_camera` instead of `front-camera`. The bridge may also give it another name
    in ROS; the one of Gazebo has to be allowed in any case where both are one.
    """
    looks_at = (Sensor,)
    needs = ("<topic>",)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            SENSOR.format("«sensors/2d_scan»"),
            says="the topic of sensor `s` has `2d_scan`, which ROS 2 does not allow",
        ),
        Bad(SENSOR.format("«front-camera»")),
    )
    good = (
        Good(SENSOR.format("sensors/scan_2d")),
        Good(SENSOR.format("~/imu"), why="the node's own"),
        Good(SENSOR.format("my imu"), why="blank-in-topic owns this one"),
    )

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return sensor.root.is_urdf and sensor.has("topic") and any(offending(sensor))

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        value: Value | None = sensor.value("topic")
        assert value is not None
        part = offending(sensor)[0]
        yield self.diagnostic(value, f"the topic of {sensor.title} has `{part}`, which ROS 2 does not allow")


def offending(sensor: Sensor) -> list[str]:
    """The parts of its topic that ROS does not allow; none where another rule has something to say."""
    text = sensor.topic
    if not text or len(text.split()) > 1 or any(mark in text for mark in "'\"$"):
        return []
    return [part for part in text.removeprefix("~").strip("/").split("/") if not PART.fullmatch(part)]
