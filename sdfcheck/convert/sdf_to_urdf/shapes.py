"""Shapes that URDF can hold, and what the others are made of."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.uris import mesh_uri
from sdfcheck.convert.writer import Node, number, numbers
from sdfcheck.model.robot import Geometry
from sdfcheck.model.rotations import transform

if TYPE_CHECKING:
    from sdfcheck.convert.sdf_to_urdf.context import Context

HELD = frozenset({"box", "cylinder", "sphere", "mesh"})
"""The shapes that every reader of URDF knows."""


def pieces(geometry: Geometry) -> list[Geometry]:
    """The shapes that together fill what one fills: a capsule is a cylinder with a sphere at either end."""
    if geometry.kind != "capsule":
        return [geometry]
    radius, length = geometry.size
    parts = [replace(geometry, kind="cylinder", size=(radius, length))]
    for end, where in (("top", length / 2), ("bottom", -length / 2)):
        pose = geometry.pose @ transform(np.eye(3), (0.0, 0.0, where))
        name = f"{geometry.name}_{end}" if geometry.name else ""
        parts.append(replace(geometry, kind="sphere", size=(radius,), pose=pose, name=name))
    return parts


def add_shape(context: Context, node: Node, geometry: Geometry) -> None:
    """Write the geometry of a visual or collision."""
    element = geometry.element.find("geometry")
    shape = next(element.children(), None) if element is not None else None
    if shape is None:
        return
    context.ledger.take_parts(shape, "size", "radius", "length", "uri", "scale")
    attributes = {}
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
    else:
        attributes["radius"], attributes["length"] = (number(size) for size in geometry.size)
    node.add("geometry").add(geometry.kind, **attributes)
