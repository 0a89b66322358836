from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Diagnostic, Good, Rule, Sensor, Severity, Value

QUOTES = ("'", '"')


class BlankInTopic(Rule):
    """The topic of a sensor contains a space or a quotation mark.

    Names of topics have neither in Gazebo and in ROS. Gazebo reports an error and publishes on a topic of its own
    choice, or not at all; marks around the name become a part of it.
    """

    code = "SCH030"
    name = "blank-in-topic"
    severity = Severity.WARNING
    remedy = """Write the topic without spaces and quotation marks, such as `imu/data`.

    Letters, digits, `_` and `/` work in Gazebo and in ROS; for ROS no part begins with a digit.
    """
    looks_at = (Sensor,)
    scaffold = IN_LINK

    bad = (
        Bad(
            '<sensor name="s" type="imu"><topic>«imu data»</topic></sensor>',
            says="the topic `imu data` of sensor `s` contains a space",
        ),
        Bad(
            '<sensor name="s" type="imu"><topic>«"imu"»</topic></sensor>',
            says='the topic `"imu"` of sensor `s` contains a quotation mark',
        ),
    )
    good = (Good('<sensor name="s" type="imu"><topic> /imu/data </topic></sensor>', why="trimmed"),)

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return sensor.has("topic") and topic(sensor) is not None

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        value = topic(sensor)
        assert value is not None
        text = value.text.strip()
        what = "a space" if len(text.split()) > 1 else "a quotation mark"
        yield self.diagnostic(value, f"the topic `{text}` of {sensor.title} contains {what}")


def topic(sensor: Sensor) -> Value | None:
    """Its topic, if there is a space or a quotation mark in it."""
    value = sensor.value("topic")
    if value is None or "$" in value.text:
        return None
    return value if len(value.text.split()) > 1 or any(mark in value.text for mark in QUOTES) else None
