"""Inertials as they are written, in SDFormat and URDF alike."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.robot import solids
from sdfcheck.robot.solids import Moments, Solid
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record

COMPONENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")


class Inertial(Record):
    """The ``inertial`` of a link.

    ``mass`` and ``moments`` hold what is written and reads as a number. ``centre`` is the
    centre of mass in the link's frame (m), None where its pose is relative to another.
    """

    element: Element
    link: Element
    mass: Value | None
    inertia: Element | None
    moments: dict[str, Value]
    centre: tuple[float, float, float] | None
    is_automatic: bool

    @property
    def is_complete(self) -> bool:
        """Are all six components written? (A product that is left out is zero in SDFormat.)"""
        return all(name in self.moments for name in COMPONENTS[:3])

    def tensor(self) -> Moments:
        """The tensor; what is not written has the default of SDFormat."""
        defaults = dict(zip(COMPONENTS, (1.0, 1.0, 1.0, 0.0, 0.0, 0.0), strict=True))
        return Moments(*(self.moments[n].number if n in self.moments else defaults[n] for n in COMPONENTS))


class Shape(Record):
    """A solid of a link, and where its origin is in the link's frame (m)."""

    solid: Solid
    at: tuple[float, float, float]
    element: Element


def read_inertial(link: Element) -> Inertial | None:
    """The inertial of a link, None if it has none."""
    element = link.find("inertial")
    if element is None:
        return None
    inertia = element.find("inertia")
    mass = element.find("mass")
    moments = {}
    if inertia is not None:
        found = ((name, inertia.number(name)) for name in COMPONENTS)
        moments = {name: value for name, value in found if value is not None}
    weight = None
    if mass is not None:
        weight = mass.attribute("value") or mass.own_value
        weight = weight if weight.text.strip() else None
    automatic = element.attributes.get("auto", "").strip().lower() in {"true", "1"}
    return Inertial(element, link, weight, inertia, moments, position(element), automatic)


def position(element: Element) -> tuple[float, float, float] | None:
    """The position that an element's ``pose`` or ``origin`` writes; None if it cannot be told here."""
    origin = element.find("origin")
    if origin is not None:
        return _three(origin.attributes.get("xyz", "0 0 0"))
    pose = element.find("pose")
    if pose is None or not pose.content:
        return (0.0, 0.0, 0.0)
    if pose.attributes.get("relative_to", "").strip():
        return None
    return _three(pose.content)


def shapes(link: Element) -> Iterator[Shape]:
    """The solids of a link's collisions, or of its visuals if it has no collision."""
    for kind in ("collision", "visual"):
        parts = list(link.children(kind))
        for part in parts:
            at = position(part)
            geometry = part.find("geometry")
            solid = solid_of(geometry) if geometry is not None else None
            if solid is not None and at is not None:
                yield Shape(solid, at, part)
        if parts:
            return


def solid_of(geometry: Element) -> Solid | None:
    """The solid of a primitive shape; None for meshes, planes and what cannot be read."""
    for shape in geometry.children():
        size, radii = shape.value("size"), shape.value("radii")
        radius, length = shape.number("radius"), shape.number("length")
        name = shape.name
        try:
            if name == "box" and size is not None:
                return _positive(solids.box(*_numbers(size, 3)))
            if name == "ellipsoid" and radii is not None:
                return _positive(solids.ellipsoid(*_numbers(radii, 3)))
            if name == "sphere" and radius is not None:
                return _positive(solids.sphere(radius.number))
            make = {"cylinder": solids.cylinder, "capsule": solids.capsule, "cone": solids.cone}.get(name)
            if make is not None and radius is not None and length is not None:
                return _positive(make(radius.number, length.number))
        except (ValueError, ZeroDivisionError):
            return None
    return None


def _positive(solid: Solid) -> Solid | None:
    return solid if 0 < solid.volume < float("inf") else None


def _numbers(value: Value, count: int) -> list[float]:
    numbers = [float(part) for part in value.text.split()]
    if len(numbers) != count:
        raise ValueError(value.text)
    return numbers


def _three(text: str) -> tuple[float, float, float] | None:
    try:
        x, y, z = (float(part) for part in text.split()[:3])
    except ValueError:
        return None
    return x, y, z
