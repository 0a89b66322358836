"""Sensors with what they see, and lights, as the page draws them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np

from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.parts.sensor import Light, Sensor
from sdfcheck.robot.values import Vector
from sdfcheck.source.document import Element
from sdfcheck.view.numbers import Json, finite, flat

REACH = 2.0
"""m: fields of view are drawn so far at most."""


def sensor_of(sensor: Sensor) -> Json:
    """A sensor; its pose is relative to its link."""
    return {"name": sensor.name, "type": sensor.type, "pose": _pose(sensor), "view": _view(sensor)}


def light_of(light: Light) -> Json:
    """A light; its pose is relative to its link, or to the world."""
    spot = light.element.find("spot")
    return {
        "name": light.name,
        "type": light.type,
        "pose": _pose(light),
        "direction": _three(light.direction, (0.0, 0.0, -1.0)),
        "color": [min(max(number, 0.0), 1.0) for number in _three(light.diffuse, (1.0, 1.0, 1.0))],
        "angle": _number(spot, ("outer_angle",), 1.0) if spot is not None else 0.0,
    }


def _pose(part: Sensor | Light) -> list[float]:
    """Its pose; where that cannot be worked out, none."""
    try:
        return flat(np.asarray(part.pose()))
    except (DescriptionError, ValueError):
        return flat(np.eye(4))


def _three(vector: Vector, default: Sequence[float]) -> list[float]:
    numbers = list(vector)[:3]
    return [finite(number) for number in (numbers if len(numbers) == 3 else default)]


def _view(sensor: Sensor) -> Json | None:
    """The field of view: angles (rad) and range (m)."""
    camera, scan = sensor.element.find("camera"), _first(sensor.element, ("lidar", "ray"))
    if camera is not None:
        width, height = (
            _number(camera, ("image", name), size) for name, size in (("width", 320.0), ("height", 240.0))
        )
        return {
            "kind": "camera",
            "horizontal": _number(camera, ("horizontal_fov",), 1.047),
            "aspect": max(width, 1.0) / max(height, 1.0),
            "near": min(max(_number(camera, ("clip", "near"), 0.1), 0.0), REACH),
            "far": min(_number(camera, ("clip", "far"), 100.0), REACH),
        }
    if scan is not None:
        return {
            "kind": "scan",
            "from": _number(scan, ("scan", "horizontal", "min_angle"), 0.0),
            "to": _number(scan, ("scan", "horizontal", "max_angle"), 0.0),
            "down": _number(scan, ("scan", "vertical", "min_angle"), 0.0),
            "up": _number(scan, ("scan", "vertical", "max_angle"), 0.0),
            "near": _number(scan, ("range", "min"), 0.0),
            "far": min(_number(scan, ("range", "max"), REACH), REACH),
        }
    return None


def _first(element: Element, names: Iterable[str]) -> Element | None:
    return next((found for name in names if (found := element.find(name)) is not None), None)


def _number(element: Element, path: Sequence[str], default: float) -> float:
    found: Element | None = element
    for name in path:
        found = found.find(name) if found is not None else None
    try:
        return finite(float(found.content), default) if found is not None else default
    except ValueError:
        return default
