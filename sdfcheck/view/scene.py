"""A description as numbers and names that a page can draw: links, joints, shapes, inertias, sensors, frames.

Poses are 4×4 transforms as 16 numbers, column by column, as WebGL has them. Those of links and
joints are relative to the model, at the zero configuration; all others to their link.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np

from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.model import Model
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.robot.motion.mechanism import Axis, Geometry, Joint, Link, Mechanism
from sdfcheck.robot.motion.rotations import Array
from sdfcheck.robot.parts.sensor import Sensor
from sdfcheck.robot.parts.shape import Visual
from sdfcheck.robot.root import Root, root_of
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.view.meshes import Meshes

Json = dict[str, Any]

MOST_SHAPES = 2000
"""Shapes that are drawn each for itself; beyond that the page draws boxes, and says so."""


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
        notes.append(f"{shapes} shapes: meshes are drawn as boxes")
    return {"file": document.source.path.name, "models": models, "notes": notes}


def _models(root: Root) -> Iterator[tuple[Model, Array]]:
    for model in root.models:
        yield model, np.eye(4)
    for world in root.worlds:
        for model in world.models:
            yield model, _pose_of(model)


def _pose_of(part: Model | Sensor) -> Array:
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
    sensors: dict[str, list[Json]] = {}
    for link in made.links.values():
        sensors[link.name] = [_sensor(sensor) for sensor in _sensors(link.element)]
    return {
        "name": model.name,
        "pose": flat(placed),
        "links": [_link(link, sensors[link.name], made, meshes) for link in made.links.values()],
        "joints": [_joint(joint) for joint in _ordered(made)],
    }


def _ordered(made: Mechanism) -> list[Joint]:
    """Joints that carry links, parents first; the others after them."""
    tree = made.tree()
    names = {joint.name for joint in tree}
    return [*tree, *(joint for joint in made.joints.values() if joint.name not in names)]


def _link(link: Link, sensors: list[Json], made: Mechanism, meshes: Meshes) -> Json:
    return {
        "name": link.name,
        "pose": flat(link.pose),
        "place": place(link.element),
        "shapes": [_shape(geometry, meshes) for geometry in link.geometries],
        "inertia": _inertia(link.body),
        "sensors": sensors,
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
        "color": _color(geometry.element),
        "mesh": meshes.add(geometry.element.document, geometry.uri) if geometry.uri else None,
    }


def _color(element: Element) -> list[float] | None:
    part = root_of(element.document).part_of(element)
    if not isinstance(part, Visual):
        return None
    color = part.material.color
    return [finite(number, 1.0) for number in color] if color is not None and len(color) == 4 else None


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
        "mass": finite(body.mass),
        "pose": flat(transform),
        "box": [math.sqrt(side) if side > 0 else 0.0 for side in sides],
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
        "mimic": None
        if mimic is None
        else {
            "leader": mimic.leader,
            "multiplier": finite(mimic.multiplier),
            "offset": finite(mimic.offset),
            "reference": finite(mimic.reference),
        },
    }


def _sensors(element: Element) -> Sequence[Sensor]:
    link = root_of(element.document).part_of(element)
    return getattr(link, "sensors", ())


def _sensor(sensor: Sensor) -> Json:
    return {"name": sensor.name, "type": sensor.type, "pose": flat(_pose_of(sensor)), "view": _view(sensor)}


def _view(sensor: Sensor) -> Json | None:
    """The field of view: angles (rad) and range (m)."""
    camera, scan = sensor.element.find("camera"), _first(sensor.element, ("lidar", "ray"))
    if camera is not None:
        return {
            "kind": "camera",
            "horizontal": _number(camera, ("horizontal_fov",), 1.047),
            "aspect": _number(camera, ("image", "width"), 320.0)
            / max(_number(camera, ("image", "height"), 240.0), 1.0),
            "near": _number(camera, ("clip", "near"), 0.1),
            "far": min(_number(camera, ("clip", "far"), 100.0), 2.0),
        }
    if scan is not None:
        return {
            "kind": "scan",
            "from": _number(scan, ("scan", "horizontal", "min_angle"), 0.0),
            "to": _number(scan, ("scan", "horizontal", "max_angle"), 0.0),
            "near": _number(scan, ("range", "min"), 0.0),
            "far": min(_number(scan, ("range", "max"), 2.0), 2.0),
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


def place(element: Element) -> str:
    """``file:line`` of an element."""
    return f"{element.span.source.path.name}:{element.span.begin.line}"


def flat(transform: Array) -> list[float]:
    """A transform column by column; what is no number is 0, so that the page can draw it."""
    return [finite(number) for number in np.asarray(transform).T.ravel().tolist()]


def finite(number: float, default: float = 0.0) -> float:
    return float(number) if math.isfinite(number) else default


def bound(number: float) -> float | None:
    """A limit; None for none."""
    return float(number) if math.isfinite(number) and abs(number) < 1e15 else None
