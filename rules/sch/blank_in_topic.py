from collections.abc import Iterator

from sdfcheck import IN_LINK, Bad, Consumer, Diagnostic, Good, Rule, Sensor, Severity, Value, warns


class BlankInTopic(Rule):
    """The topic of a sensor contains a space.

    Names of topics have no spaces in Gazebo and in ROS. Gazebo reports an error and
    publishes on a topic of its own choice, or not at all.
    """

    code = "SCH030"
    name = "blank-in-topic"
    severity = Severity.WARNING
    preview = True
    affects = {Consumer.GAZEBO: warns("does not publish on it")}
    looks_at = (Sensor,)
    scaffold = IN_LINK

    bad = (
        Bad(
            '<sensor name="s" type="imu"><topic>«imu data»</topic></sensor>',
            says="the topic `imu data` of sensor `s` contains a space",
        ),
    )
    good = (Good('<sensor name="s" type="imu"><topic> /imu/data </topic></sensor>', why="trimmed"),)

    @staticmethod
    def applies(sensor: Sensor) -> bool:
        return sensor.has("topic") and topic(sensor) is not None

    def check(self, sensor: Sensor) -> Iterator[Diagnostic]:
        value = topic(sensor)
        assert value is not None
        yield self.diagnostic(value, f"the topic `{value.text.strip()}` of {sensor.title} contains a space")


def topic(sensor: Sensor) -> Value | None:
    """Its topic, if there is a space in it."""
    value = sensor.value("topic")
    return value if value is not None and len(value.text.split()) > 1 else None
