"""Shapes that URDF can hold, and what the others are made of."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.carried import carry_custom
from sdfcheck.convert.sdf_to_urdf.context import mesh_uri
from sdfcheck.convert.sdf_to_urdf.options import Planes
from sdfcheck.convert.writer import number, numbers
from sdfcheck.robot.motion.mechanism import Geometry
from sdfcheck.robot.motion.poses import transform, z_towards
from sdfcheck.robot.shapes import shape_in
from sdfcheck.source.altered import Xml

if TYPE_CHECKING:
    from sdfcheck.convert.sdf_to_urdf.context import Context

HELD = frozenset({"box", "cylinder", "sphere", "mesh"})
"""The shapes that every consumer of URDF knows."""
DRAKE_SHAPES = frozenset({"capsule", "ellipsoid"})
"""Those that Drake has in addition, by names of its own."""


_THICKNESS = {"visual": 0.001, "collision": 0.1}
"""Of a box that replaces a plane, m: a thinner one would be passed through."""
_ENDLESS = 100.0
"""The least length of such a box where it collides, m: there a plane has no end."""


def pieces(geometry: Geometry, planes: Planes) -> list[Geometry]:
    """The shapes that together fill what one fills."""
    if geometry.kind == "capsule":
        return list(_capsule(geometry))
    if geometry.kind == "ellipsoid" and len(set(geometry.size)) == 1:
        return [replace(geometry, kind="sphere", size=geometry.size[:1])]
    if geometry.kind == "plane" and planes is Planes.BOX:
        return [_slab(geometry)]
    return [geometry]


def _capsule(geometry: Geometry) -> Iterator[Geometry]:
    """A cylinder with a sphere at either end."""
    radius, length = geometry.size
    yield replace(geometry, kind="cylinder", size=(radius, length))
    for end, where in (("top", length / 2), ("bottom", -length / 2)):
        pose = geometry.pose @ transform(np.eye(3), (0.0, 0.0, where))
        name = f"{geometry.name}_{end}" if geometry.name else ""
        yield replace(geometry, kind="sphere", size=(radius,), pose=pose, name=name)


def _slab(geometry: Geometry) -> Geometry:
    """A box with its upper face in a plane."""
    normal, (x, y) = np.array(geometry.size[:3]), geometry.size[3:]
    height = _THICKNESS[geometry.role]
    if geometry.role == "collision":
        x, y = max(x, _ENDLESS), max(y, _ENDLESS)
    turn = z_towards(normal / (np.linalg.norm(normal) or 1.0))
    pose = geometry.pose @ transform(turn, turn @ (0.0, 0.0, -height / 2))
    return replace(geometry, kind="box", size=(x, y, height), pose=pose)


def merged_frame(written: list[Geometry]) -> tuple[str, str]:
    """A shape that URDF does not have, and what is written for it; empty if it has it."""
    shape = written[0].element.find("geometry")
    own = shape_in(shape) if shape is not None else None
    if own is None or own.name.removeprefix("drake:") == written[0].kind:
        return "", ""
    return own.name, "a cylinder and two spheres" if len(written) > 1 else f"a {written[0].kind}"


def add_shape(context: Context, node: Xml, geometry: Geometry, scope: str) -> None:
    """Write the geometry of a visual or collision."""
    element = geometry.element.find("geometry")
    shape = shape_in(element) if element is not None else None
    if shape is None:
        return
    context.ledger.take_parts(shape, "size", "radius", "radii", "length", "normal", "uri", "scale", *"abc")
    name, attributes = geometry.kind, {}
    if geometry.kind == "mesh":
        uri = shape.find("uri")
        attributes["filename"] = mesh_uri(context, geometry.uri, shape if uri is None else uri)
        if geometry.size != (1.0, 1.0, 1.0):
            attributes["scale"] = numbers(geometry.size)
        if shape.attributes.get("optimization"):
            message = f"URDF has no mesh optimization (`{shape.attributes['optimization']}`)"
            context.ledger.note(LossKind.DROPPED_ELEMENT, shape, message)
    elif geometry.kind == "box":
        attributes["size"] = numbers(geometry.size)
    elif geometry.kind == "sphere":
        attributes["radius"] = number(geometry.size[0])
    elif geometry.kind == "ellipsoid":
        attributes = dict(zip("abc", map(number, geometry.size), strict=True))
    else:
        attributes["radius"], attributes["length"] = (number(size) for size in geometry.size)
    if geometry.kind in context.natives:
        name = f"drake:{name}"
        message = (
            f"the {geometry.kind} of {geometry.element.title} is written as `{name}`, which Drake alone reads"
        )
        context.ledger.note(LossKind.UNSUPPORTED_GEOMETRY, shape, message)
    carry_custom(context, node.add("geometry").add(name, **attributes), shape, scope)
