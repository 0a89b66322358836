"""Sensors: which element configures one of a type, and which has a newer name.

Source: libsdformat 17's Sensor.cc and gz-sensors.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats import history, problems
from sdfcheck.formats.sdf.survey import Survey
from sdfcheck.source.document import Element

_CAMERAS = tuple(
    """
    boundingbox boundingbox_camera camera depth depth_camera multicamera rgbd rgbd_camera segmentation
    segmentation_camera thermal thermal_camera wide_angle_camera wideanglecamera
    """.split()
)
_LIDARS = ("lidar", "gpu_lidar", "ray", "gpu_ray")

SETTINGS = {
    **dict.fromkeys(_CAMERAS, ("camera",)),
    **dict.fromkeys(_LIDARS, ("lidar", "ray")),
    "air_pressure": ("air_pressure",),
    "air_speed": ("air_speed",),
    "altimeter": ("altimeter",),
    "contact": ("contact",),
    "force_torque": ("force_torque",),
    "gps": ("navsat", "gps"),
    "imu": ("imu",),
    "logical_camera": ("logical_camera",),
    "magnetometer": ("magnetometer",),
    "navsat": ("navsat", "gps"),
    "rfid": ("rfid",),
    "rfidtag": ("rfidtag",),
    "sonar": ("sonar",),
    "wireless_receiver": ("transceiver",),
    "wireless_transmitter": ("transceiver",),
}
"""Sensor type → the elements that may hold its settings; the second is the older name of the first."""

NEWEST_TYPES = {"gps": "navsat", "gpu_ray": "gpu_lidar", "ray": "lidar"}
"""Older word for a type of sensor, or for its settings → that of the newest version."""

ALL_SETTINGS = frozenset(name for names in SETTINGS.values() for name in names)
"""The elements that configure sensors of any type."""


def sensor_problems(surveyed: Survey) -> Iterator[object]:
    """The problems of all sensors of a document."""
    for sensor in surveyed.index.get("sensor", ()):
        kind = sensor.attribute("type")
        expected = SETTINGS.get(kind.text.strip()) if kind is not None else None
        if kind is None or expected is None:
            continue
        if any((sensor, name) in surveyed.noted.misspelled for name in expected):
            continue
        if len(expected) > 1:
            yield from _renamed(surveyed, sensor, expected)


def _renamed(surveyed: Survey, sensor: Element, expected: tuple[str, ...]) -> Iterator[object]:
    """Types and settings with an older name, once their version has the new one."""
    from sdfcheck.formats.sdf.schema import schema

    definition = schema(surveyed.version).at("sensor:sensor")
    assert definition is not None
    attribute = definition.attributes["type"]
    new, old = expected
    if new not in definition.children:
        return
    settings = sensor.find(old)
    kind = sensor.attribute("type")
    assert kind is not None
    name = history.renamed_value(attribute, kind.text.strip())
    choices = attribute.choices
    if name is not None and choices is not None:
        since = choices.since(name)
        yield problems.DeprecatedElement(sensor, kind, name, str(since), announced=True, settings=settings)
    elif settings is not None:
        since = history.versions(definition, new)[0]
        yield problems.DeprecatedElement(settings, None, new, str(since), announced=True)
