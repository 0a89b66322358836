"""Shapes and materials by themselves: what they are, and how large."""

from __future__ import annotations

import math
import os
from functools import partial
from typing import TYPE_CHECKING, TypeVar

from sdfcheck.bodies.box import Box
from sdfcheck.files.regular import SIZE_LIMIT
from sdfcheck.robot import solids
from sdfcheck.robot.part import Part
from sdfcheck.robot.values import Number, Vector, lazy

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from sdfcheck.bodies.mesh import Mesh, Open
    from sdfcheck.bodies.solid import Skin
    from sdfcheck.files.library import Shelves
    from sdfcheck.robot.motion.origin import Triple
    from sdfcheck.robot.motion.poses import Array
    from sdfcheck.robot.solids import Solid
    from sdfcheck.source.document import Element, Value


Measured = TypeVar("Measured")


# Materials: colors and textures.


_WITHOUT_ALPHA = 3


class Material(Part):
    """The material of a visual, or one that a URDF robot defines for all its links."""

    __slots__ = ()
    kind = "material"

    @property
    def color(self) -> Vector | None:
        """Red, green, blue, alpha: in SDFormat the diffuse color; None where there is none."""
        if self.is_urdf:
            color = self.find("color")
            return Vector.of(color.attribute("rgba"), color, ()) if color is not None else None
        return self.light("diffuse")

    def light(self, name: str) -> Vector | None:
        """The color of ``ambient``, ``diffuse``, ``specular`` or ``emissive`` light; None where it is not given.

        An alpha that SDFormat leaves out is 1.
        """
        child = self.find(name)
        if child is None:
            return None
        color = Vector.of(child.own_value, child, ())
        if len(color) != _WITHOUT_ALPHA:
            return color
        whole = Vector((*color, 1.0))
        whole.value, whole.element = color.value, color.element
        return whole

    @property
    def texture(self) -> str:
        """The file of the texture of URDF; empty if there is none."""
        texture = self.find("texture") if self.is_urdf else None
        return texture.attributes.get("filename", "") if texture is not None else ""

    @property
    def script(self) -> Element | None:
        """The script of Gazebo Classic."""
        return None if self.is_urdf else self.find("script")

    @property
    def has_look(self) -> bool:
        """Does it say what it looks like, instead of naming another?"""
        return self.has("color") or self.has("texture") if self.is_urdf else self.is_given

    @property
    def has_foreign_colors(self) -> bool:
        """Has it colors of SDFormat in URDF, where nobody reads them?"""
        if not self.is_urdf:
            return False
        from sdfcheck.formats.urdf.findings import COLORS_OF_SDFORMAT

        return any(map(self.has, COLORS_OF_SDFORMAT))

    @property
    def look(self) -> tuple[object, object]:
        """In URDF: color and texture, to be compared; None for one that it does not have."""
        color = self.color
        return (
            None if color is None else tuple(color) or color.text,
            self.texture if self.has("texture") else None,
        )


_DEFAULT_SIZES: dict[str, dict[str, tuple[float, ...]]] = {
    "box": {"size": (1.0, 1.0, 1.0)},
    "capsule": {"radius": (0.5,), "length": (1.0,)},
    "cone": {"radius": (0.5,), "length": (1.0,)},
    "cylinder": {"radius": (0.5,), "length": (1.0,)},
    "ellipsoid": {"radii": (1.0, 1.0, 1.0)},
    "mesh": {"scale": (1.0, 1.0, 1.0)},
    "plane": {"normal": (0.0, 0.0, 1.0), "size": (1.0, 1.0)},
    "sphere": {"radius": (1.0,)},
}
"""Shape → its measures, and what simulators take where one is left out (libsdformat 17)."""


_UPRIGHT, _PARTS = 1e-3, 8
"""The sine of the tilt from which on a cylinder rests on its edges, and points of the rim of one that does not."""


class Geometry(Part):
    """The shape of a visual or collision; lengths in m."""

    __slots__ = ()
    kind = "geometry"

    @lazy
    def shape_element(self) -> Element | None:
        """The element of the shape; None if there is none. urdfdom takes the first element."""
        return next(self.children(), None) if self.is_urdf else shape_in(self.element)

    @property
    def shape(self) -> str:
        """``box``, ``sphere``, ``mesh`` …; empty if there is none."""
        return self.shape_element.name if self.shape_element is not None else ""

    @property
    def meant(self) -> str:
        """Its shape in the format's words, also where a vendor's tag says it (``drake:capsule``)."""
        return self.shape.removeprefix("drake:")

    @property
    def size(self) -> Vector:
        """Of a box: lengths along x, y, z; of a plane: along x and y."""
        return self._measures("size")

    @property
    def radius(self) -> Number:
        """Of a sphere, cylinder, capsule or cone."""
        return self._measure("radius")

    @property
    def length(self) -> Number:
        """Of a cylinder, capsule or cone, along z; of a capsule without its caps."""
        return self._measure("length")

    @property
    def radii(self) -> Vector:
        """Of an ellipsoid."""
        return self._measures("radii")

    @property
    def normal(self) -> Vector:
        """Of a plane."""
        return self._measures("normal")

    @property
    def scale(self) -> Vector:
        """Of a mesh."""
        return self._measures("scale")

    @lazy
    def uri_value(self) -> Value | None:
        """The file of a mesh, heightmap or image, with its place."""
        shape = self.shape_element
        if shape is None:
            return None
        value = shape.attribute("filename") if self.is_urdf else None
        if value is None and not self.is_urdf:
            child = shape.find("uri")
            value = child.own_value if child is not None else None
        return value

    @property
    def uri(self) -> str:
        """The file of a mesh, heightmap or image; empty if there is none."""
        return self.uri_value.text.strip() if self.uri_value is not None else ""

    @lazy
    def mesh(self) -> Mesh | None:
        """The content of its mesh file; None without one on this computer, and where only a part of it is meant."""
        from sdfcheck.bodies.mesh import mesh_at

        return self._measured_by(partial(mesh_at, with_skin=self.is_urdf and self._is_on_surface))

    @property
    def _is_on_surface(self) -> bool:
        """Is its file that of a visual of its link, or has the link none? Then its surface is asked for, too."""
        shape = self.element.parent
        link = shape.parent if shape is not None else None
        visuals = tuple(link.children("visual")) if link is not None else ()
        drawn = (each.find("mesh") for visual in visuals for each in visual.children("geometry"))
        names = {mesh.attributes.get("filename", "").strip() for mesh in drawn if mesh is not None}
        return not visuals or self.uri in names

    @lazy
    def skin(self) -> Skin | None:
        """Points of its surface (m), as it is along its own axes; None where that is not known."""
        if self.shape == "mesh":
            from sdfcheck.bodies.mesh import skin_at

            skin, scale = self._measured_by(skin_at), self.scale
            return skin.scaled(scale) if skin is not None and len(scale) == 3 and all(scale) else None
        if self.solid is None:
            return None
        from sdfcheck.bodies.solid import of_shape

        return of_shape(self.shape, self.measures)

    @lazy
    def pixels(self) -> tuple[int, int] | None:
        """Width and height of the picture of a heightmap, if it is a PNG or PGM file on this computer."""
        return self._measured_by(_pixels_at, of="heightmap")

    def _measured_by(
        self, measure: Callable[[Path, Open, Shelves], Measured | None], of: str = "mesh"
    ) -> Measured | None:
        """A measurement of the file of its shape; None where it is not there."""
        if self.shape != of or not self.uri or (not self.is_urdf and self._shape_place.has("submesh")):
            return None
        from sdfcheck.files.library import library_of
        from sdfcheck.files.uris import locate

        path, library = locate(self.document, self.uri).path, library_of(self.document)
        if path is None or library is None or not os.path.isfile(path):
            return None
        return measure(path, lambda file, limit: library.open(file, self.document, limit), library.shelves)

    @lazy
    def missing_files(self) -> tuple[str, ...]:
        """The files that its mesh file names, such as pictures, and that are not where it says."""
        from sdfcheck.files.uris import locate

        names = self.mesh.files if self.mesh is not None else ()
        path = locate(self.document, self.uri).path if names else None
        return () if path is None else tuple(name for name in names if not _is_beside(path, name))

    @lazy
    def box(self) -> Box | None:
        """The box around it along its own axes (m), in plain numbers; of what is round, around its own axes.

        None for planes, submeshes, meshes that are not there, and what cannot be read.
        """
        if self.shape == "mesh":
            mesh, scale = self.mesh, self.scale
            if mesh is None or mesh.bounds is None or len(scale) != 3:
                return None
            scaled = mesh.bounds.scaled(scale)
            return scaled if scaled.diagonal < float("inf") else None
        halves = self._halves if self.solid is not None else None
        return None if halves is None else Box(tuple(-length for length in halves), halves)

    @property
    def _halves(self) -> tuple[float, ...]:
        """Half of the lengths of a solid (m)."""
        if self.shape == "box":
            return tuple(size / 2 for size in self.size)
        if self.shape == "ellipsoid":
            return tuple(self.radii)
        radius = float(self.radius)
        if self.shape == "sphere":
            return radius, radius, radius
        ends = radius if self.shape == "capsule" else 0.0
        return radius, radius, float(self.length) / 2 + ends

    def footing(self, down: Triple) -> tuple[Triple, ...]:
        """The points on which a plain shape may rest, along its own axes; ``down`` has the length 1. None of others."""
        if self.solid is None:
            return ()
        x, y, z = down
        if self.shape == "box" and self.box is not None:
            return tuple((along, beside, above) for along, beside, above in self.box.corners())
        radius, half = float(self.radius), float(self.length) / 2
        ends = (half, -half)
        if self.shape == "sphere":
            return ((radius * x, radius * y, radius * z),)
        if self.shape == "capsule":
            return tuple((radius * x, radius * y, end + radius * z) for end in ends)
        if self.shape != "cylinder":
            return ()
        across = math.hypot(x, y)
        if across > _UPRIGHT:
            return tuple((radius * x / across, radius * y / across, end) for end in ends)
        turns = (math.tau * part / _PARTS for part in range(_PARTS))
        around = [(radius * math.cos(turn), radius * math.sin(turn)) for turn in turns]
        return tuple((along, beside, end) for end in ends for along, beside in around)

    @property
    def measures(self) -> tuple[float, ...]:
        """All numbers of the shape in one row: the radius and the length of a cylinder, the scale of a mesh.

        Of a row that has another length than it should, the default, if there is one.
        """
        if self.shape == "drake:ellipsoid":
            return tuple(float(self._measure(name)) for name in "abc")
        defaults = _DEFAULT_SIZES.get(self.meant, {})
        rows = ((tuple(self._measures(name)), default) for name, default in defaults.items())
        return tuple(
            n for row, default in rows for n in (row if len(row) == len(default) else default or row)
        )

    @lazy
    def solid(self) -> Solid | None:
        """Volume and inertia of a primitive shape; None for meshes, planes and what cannot be read."""
        makers = {
            "box": lambda: solids.box(*_count(self.size, 3)),
            "ellipsoid": lambda: solids.ellipsoid(*_count(self.radii, 3)),
            "sphere": lambda: solids.sphere(self._written("radius")),
            "cylinder": lambda: solids.cylinder(self._written("radius"), self._written("length")),
            "capsule": lambda: solids.capsule(self._written("radius"), self._written("length")),
            "cone": lambda: solids.cone(self._written("radius"), self._written("length")),
        }
        make = makers.get(self.shape)
        try:
            solid = make() if make is not None else None
        except (ValueError, ZeroDivisionError):
            return None
        return solid if solid is not None and 0 < solid.volume < float("inf") else None

    def _written(self, name: str) -> float:
        number = self._measure(name)
        if not number.is_given:
            raise ValueError(name)
        return number.number

    def _measure(self, name: str) -> Number:
        default = _DEFAULT_SIZES.get(self.shape, {}).get(name, (1.0,))[0]
        return Number.of(self._shape_value(name), self._shape_place, default)

    def _measures(self, name: str) -> Vector:
        default = _DEFAULT_SIZES.get(self.shape, {}).get(name, ())
        return Vector.of(self._shape_value(name), self._shape_place, default)

    @property
    def _shape_place(self) -> Element:
        return self.element if self.shape_element is None else self.shape_element

    def _shape_value(self, name: str) -> Value | None:
        shape = self.shape_element
        if shape is None:
            return None
        if self.is_urdf:
            return shape.attribute(name)
        child = shape.find(name)
        return child.own_value if child is not None else None


_PIXELS = slice(16, 24)
"""Where a PNG file says its width and height: at the beginning of its first part."""
_PICTURES = "../materials/textures"
"""Where Gazebo looks for the pictures of a mesh, from its folder, if they are not there."""


def _is_beside(path: Path, name: str) -> bool:
    """Is there a file of this name, relative to a mesh? Some formats take several names with blanks between."""

    def is_there(each: str) -> bool:
        return any(os.path.isfile(path.parent / folder / each) for folder in ("", _PICTURES))

    return is_there(name) or all(map(is_there, name.split()))


def _pixels_at(path: Path, open: Open, _: Shelves) -> tuple[int, int] | None:
    """The size that the head of a PNG file says, or that of a PGM file; None for other pictures."""
    try:
        with open(path, SIZE_LIMIT) as file:
            head = file.read(_PIXELS.stop)
    except OSError:
        return None
    if head.startswith(b"\x89PNG\r\n\x1a\n") and len(head) == _PIXELS.stop:
        pixels = head[_PIXELS]
        return int.from_bytes(pixels[:4], "big"), int.from_bytes(pixels[4:], "big")
    words = head.split()[:3] if head.startswith((b"P2", b"P5")) else []
    return (int(words[1]), int(words[2])) if len(words) == 3 and all(map(bytes.isdigit, words[1:])) else None


def _count(numbers: Vector, count: int) -> Vector:
    if len(numbers) != count or not numbers.is_given:
        raise ValueError(numbers.text)
    return numbers


def shape_in(geometry: Element) -> Element | None:
    """The element of the shape in a ``geometry`` of SDFormat: libsdformat takes one that it knows."""
    first = next(geometry.children(), None)
    if first is None or ":" not in first.name:
        return first
    return next((child for child in geometry.children() if ":" not in child.name), first)


class Surface(Part):
    """How a collision slides and bounces."""

    __slots__ = ()
    kind = "surface"


def as_array(box: Box | None) -> Array | None:
    """The lowest and highest x, y, z of a box, shape (2, 3)."""
    import numpy as np

    return None if box is None else np.array([box.low, box.high])
