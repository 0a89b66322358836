"""Shapes as both formats write them, read as numbers."""

from __future__ import annotations

from sdfcheck.robot.motion.mechanism import Geometry
from sdfcheck.robot.motion.rotations import Array
from sdfcheck.source.element import Element

_SIZES = {
    "box": ("size",),
    "capsule": ("radius", "length"),
    "cone": ("radius", "length"),
    "cylinder": ("radius", "length"),
    "ellipsoid": ("radii",),
    "mesh": ("scale",),
    "plane": ("normal", "size"),
    "sphere": ("radius",),
}
_DEFAULTS = {
    "cone": (0.5, 1.0),
    "capsule": (0.5, 1.0),
    "cylinder": (0.5, 1.0),
    "box": (1.0, 1.0, 1.0),
    "ellipsoid": (1.0, 1.0, 1.0),
    "mesh": (1.0, 1.0, 1.0),
    "plane": (0.0, 0.0, 1.0, 1.0, 1.0),
    "sphere": (1.0,),
}
"""What readers take where a size is left out (libsdformat 17)."""


def read_geometry(role: str, part: Element, pose: Array) -> Geometry | None:
    """The shape of a visual or collision; None where it has none."""
    geometry = part.find("geometry")
    shape = next(geometry.children(), None) if geometry is not None else None
    if shape is None:
        return None
    kind = shape.name
    uri = ""
    if kind in {"mesh", "heightmap", "image"}:
        written = shape.value("filename") or shape.value("uri")
        uri = written.text.strip() if written is not None else ""
    return Geometry(role, kind, _size(kind, shape), pose, part, part.attributes.get("name", ""), uri)


def _size(kind: str, shape: Element) -> tuple[float, ...]:
    numbers: list[float] = []
    for name in _SIZES.get(kind, ()):
        value = shape.value(name)
        if value is None or not value.text.strip():
            return _DEFAULTS.get(kind, ())
        try:
            numbers += [float(part) for part in value.text.split()]
        except ValueError:
            return _DEFAULTS.get(kind, ())
    return tuple(numbers)
