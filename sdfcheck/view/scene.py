"""A description as numbers and names that a page can draw: links, joints, shapes, inertias, sensors, frames.

Poses are 4×4 transforms as 16 numbers, column by column, as WebGL has them. Those of links and
joints are relative to the model, at the zero configuration; all others to their link.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from sdfcheck.robot.graph import Light, Model, Sensor, Visual
from sdfcheck.robot.graph import Link as LinkPart
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mass import MassProperties
from sdfcheck.robot.motion.mechanism import Axis, Geometry, Joint, Link, Mechanism
from sdfcheck.robot.motion.poses import Array
from sdfcheck.robot.root import Root, root_of
from sdfcheck.robot.values import Vector
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import DescriptionError
from sdfcheck.view.meshes import Json, Meshes, bound, finite, flat, place

# Sensors with what they see, and lights, as the page draws them.

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


MOST_SHAPES = 2000
"""Shapes that are drawn in full; beyond that round ones have few corners and meshes are boxes, and the page says so."""


def scene(document: Document, meshes: Meshes) -> Json:
    """The models of a description, each with what it has, and what could not be shown."""
    root = root_of(document)
    models: list[Json] = []
    notes: list[str] = []
    for model, placed in _models(root):
        shown = _model(model, placed, meshes)
        if isinstance(shown, str):
            notes.append(f"model {model.name} is not shown: {shown}")
        else:
            models.append(shown)
    shapes = sum(len(link["shapes"]) for model in models for link in model["links"])
    if shapes > MOST_SHAPES:
        notes.append(f"{shapes} shapes: drawn with few corners, and meshes as boxes")
    lights = [light_of(light) for light in _lights(root)]
    return {"file": document.source.path.name, "models": models, "lights": lights, "notes": notes}


def _models(root: Root) -> Iterator[tuple[Model, Array]]:
    for model in root.models:
        yield model, np.eye(4)
    for world in root.worlds:
        for model in world.models:
            yield model, _pose_of(model)


def _lights(root: Root) -> Iterator[Light]:
    yield from root.lights
    for world in root.worlds:
        yield from world.lights


def _pose_of(part: Model) -> Array:
    """Its pose; where that cannot be worked out, none."""
    try:
        return np.asarray(part.pose())
    except (DescriptionError, ValueError):
        return np.eye(4)


def _model(model: Model, placed: Array, meshes: Meshes) -> Json | str:
    """The model, or why it cannot be shown."""
    try:
        made = mechanism_of(model, vendors=True)
    except (DescriptionError, OverflowError, ValueError, np.linalg.LinAlgError) as error:
        return str(error)
    return {
        "name": model.name,
        "pose": flat(placed),
        "links": [_link(link, made, meshes) for link in made.links.values()],
        "joints": [_joint(joint) for joint in _ordered(made)],
    }


def _ordered(made: Mechanism) -> list[Joint]:
    """Joints that carry links, parents first; the others after them."""
    tree = made.tree()
    names = {joint.name for joint in tree}
    return [*tree, *(joint for joint in made.joints.values() if joint.name not in names)]


def _link(link: Link, made: Mechanism, meshes: Meshes) -> Json:
    part = root_of(link.element.document).part_of(link.element)
    has = part if isinstance(part, LinkPart) else None
    return {
        "name": link.name,
        "pose": flat(link.pose),
        "place": place(link.element),
        "shapes": [_shape(geometry, meshes) for geometry in link.geometries],
        "mass": None if link.body is None else bound(link.body.mass),
        "inertia": _inertia(link.body),
        "sensors": [sensor_of(sensor) for sensor in has.sensors] if has is not None else [],
        "lights": [light_of(light) for light in has.lights] if has is not None else [],
        "frames": [
            {"name": name, "pose": flat(pose)}
            for name, (carrier, pose) in made.frames.items()
            if carrier == link.name
        ],
    }


def _shape(geometry: Geometry, meshes: Meshes) -> Json:
    return {
        "role": geometry.role,
        "kind": geometry.kind,
        "name": geometry.name,
        "size": [finite(number) for number in geometry.size],
        "pose": flat(geometry.pose),
        **_material(geometry.element),
        "mesh": meshes.add(geometry.element.document, geometry.uri) if geometry.uri else None,
    }


def _material(element: Element) -> Json:
    """The color and the name of the material of a visual; None where it has none."""
    part = root_of(element.document).part_of(element)
    if not isinstance(part, Visual):
        return {"color": None, "material": None}
    color = part.material.color
    known = color is not None and len(color) == 4
    return {
        "color": [finite(number, 1.0) for number in color] if color is not None and known else None,
        "material": part.material.name or None,
    }


def _inertia(body: MassProperties | None) -> Json | None:
    """The center of mass, and the box of even density with the same moments (the equivalent cuboid)."""
    if body is None or not np.isfinite(body.moments).all() or not body.mass > 0:
        return None
    moments, axes = np.linalg.eigh(body.moments)
    if np.linalg.det(axes) < 0:
        axes[:, 0] = -axes[:, 0]
    total = float(moments.sum())
    sides = [6 * (total - 2 * float(moment)) / body.mass for moment in moments]
    transform = np.eye(4)
    transform[:3, :3] = axes
    transform[:3, 3] = body.center
    return {
        "moments": [finite(body.moments[at]) for at in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))],
        "pose": flat(transform),
        "box": [finite(math.sqrt(side)) if side > 0 else 0.0 for side in sides],
        "isPossible": all(side >= -1e-9 * max(map(abs, sides), default=0.0) for side in sides),
    }


def _joint(joint: Joint) -> Json:
    return {
        "name": joint.name,
        "kind": joint.kind,
        "parent": joint.parent,
        "child": joint.child,
        "pose": flat(joint.pose),
        "pitch": finite(joint.pitch),
        "axes": [_axis(axis) for axis in joint.axes],
        "place": place(joint.element),
    }


def _axis(axis: Axis) -> Json:
    mimic = axis.mimic
    return {
        "direction": [finite(number) for number in np.asarray(axis.direction).tolist()],
        "lower": bound(axis.lower),
        "upper": bound(axis.upper),
        "effort": bound(axis.effort),
        "velocity": bound(axis.velocity),
        "mimic": None
        if mimic is None
        else {
            "leader": mimic.leader,
            "multiplier": finite(mimic.multiplier),
            "offset": finite(mimic.offset),
            "reference": finite(mimic.reference),
        },
    }
