"""A quick look at a link's mass and inertia, for the many that are sound.

It reads the numbers straight from the tree. An inertial that this look does not accept is looked at
again, with places, by the rules about inertials.
"""

from __future__ import annotations

import math
from functools import lru_cache

from sdfcheck.robot.parts import solids
from sdfcheck.source.element import Element

_PLAUSIBLE = (0.01, 10.0)
"""Traces within these factors of a solid's are beyond suspicion."""
_REACH = 5.0
"""So are centers of mass this near to the origin, and links without shapes whose mass is not farther out (m)."""

SOUND = 1
"""The numbers are those of a body of about the size of the link's shapes."""
INSIDE = 2
"""The center of mass is inside of a shape."""
NEAR = 4
"""The moments are at most twice those of a solid of the shapes."""
FITTING = 8
"""They are so axis by axis, and the mass is that of a material."""
LIGHT = 16
"""The mass is that of a material."""
_DENSEST = 20_000.0
"""kg/m³: so is nothing that is heavier than any material."""
_EVEN = 1.2
"""Moments of a body within this factor of each other fit whatever way it is turned."""

_MOMENTS = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
_ORIGIN = [0.0, 0.0, 0.0]

_MAKERS = {
    "box": lambda t: solids.box(*_three(t["size"])),
    "ellipsoid": lambda t: solids.ellipsoid(*_three(t["radii"])),
    "sphere": lambda t: solids.sphere(float(t["radius"])),
    "cylinder": lambda t: solids.cylinder(float(t["radius"]), float(t["length"])),
    "capsule": lambda t: solids.capsule(float(t["radius"]), float(t["length"])),
    "cone": lambda t: solids.cone(float(t["radius"]), float(t["length"])),
}


def soundness(link: Element) -> int:
    """What is surely so of a link's mass: the sum of ``SOUND``, ``INSIDE``, ``NEAR``, ``FITTING``, ``LIGHT``."""
    inertial: Element | None = None
    collisions: list[Element] = []
    visuals: list[Element] = []
    for child in link.children():
        tag = child.name
        if tag == "collision":
            collisions.append(child)
        elif tag == "visual":
            visuals.append(child)
        elif tag == "inertial" and inertial is None:
            inertial = child
    try:
        mass, moments, center = _read(inertial)
        return _plausibility(mass, moments, center, collisions or visuals) if moments else 0
    except (KeyError, TypeError, ValueError, ZeroDivisionError):
        return 0


def _read(inertial: Element | None) -> tuple[float, tuple[float, ...], list[float]]:
    if inertial is None or "auto" in inertial.attributes:
        raise ValueError
    mass, center = "", _ORIGIN
    moments: list[str | None] = []
    for child in inertial.children():
        tag = child.name
        if tag == "mass":
            mass = child.text_of("value") or child.text or ""
        elif tag == "inertia":
            moments = list(map(_texts(child).get, _MOMENTS))
        elif tag in {"pose", "origin"}:
            center = _position(child)
        elif tag == "fluid_added_mass":
            raise ValueError
    return float(mass), _possible(mass, *moments), center


def _texts(element: Element) -> dict[str, str | None]:
    """The attributes of an element and the texts of its children, by name."""
    texts: dict[str, str | None] = dict(element.attributes)
    for child in element.children():
        texts[child.name] = child.text
    return texts


def _position(origin: Element) -> list[float]:
    if origin.name == "origin":
        return _three(origin.attributes.get("xyz", "0 0 0"))
    if origin.attributes:
        raise ValueError
    return _three(" ".join((origin.text or "0 0 0").split()[:3]))


def _three(text: str | None) -> list[float]:
    x, y, z = (text or "").split()
    return [float(x), float(y), float(z)]


@lru_cache(maxsize=1000)
def _possible(mass: str, *texts: str | None) -> tuple[float, ...]:
    """The moments of a body of this mass, in kg·m²; none if there is no such body."""
    if not (0 < float(mass) < math.inf and texts):
        return ()
    moments = tuple([float(text or 0) for text in texts])
    low, middle, high = solids.Moments(*moments).principal()
    return moments if low > 0 and low + middle >= high else ()


def _plausibility(mass: float, moments: tuple[float, ...], center: list[float], shapes: list[Element]) -> int:
    if math.hypot(*center) > _REACH:
        return 0
    placed = [found for shape in shapes if (found := _placed(shape)) is not None]
    if not placed:
        return SOUND | INSIDE | NEAR | FITTING | LIGHT if max(moments[:3]) <= _REACH * _REACH * mass else 0
    volume = total = 0.0
    is_inside = is_turned = False
    diagonal = [0.0, 0.0, 0.0]
    for solid, at, turned in placed:
        x, y, z = (a - b for a, b in zip(at, center, strict=True))
        distance = x * x + y * y + z * z
        volume += solid.volume
        total += solid.volume * (solid.moments.trace + 2 * distance)
        is_inside = is_inside or 2 * distance <= solid.moments.trace
        is_turned = is_turned or turned
        for axis, offset in enumerate((x, y, z)):
            diagonal[axis] += solid.volume * (solid.moments[axis] + distance - offset * offset)
    low, high = _PLAUSIBLE
    ratio = sum(moments[:3]) * volume / (mass * total)
    holds = (
        (SOUND if low <= ratio <= high else 0)
        | (NEAR if low <= ratio <= 2 else 0)
        | (INSIDE if is_inside else 0)
    )
    if mass > _DENSEST * volume:
        return holds
    holds |= LIGHT
    if is_turned:
        return holds | FITTING if max(moments[:3]) < _EVEN * min(moments[:3]) else holds
    ratios = (moment * volume / (mass * each) for moment, each in zip(moments[:3], diagonal, strict=True))
    return holds | FITTING if all(1 / 2 < each < 2 for each in ratios) else holds


def _placed(shape: Element) -> tuple[solids.Solid, list[float], bool] | None:
    """The solid of a visual or collision, its center, and whether it is turned; None without a solid."""
    at, is_turned, geometry = _ORIGIN, False, None
    for child in shape.children():
        tag = child.name
        if tag == "geometry":
            geometry = child
        elif tag in {"pose", "origin"}:
            at = _position(child)
            words = (
                (child.text_of("rpy") or "").split() if tag == "origin" else (child.text or "").split()[3:]
            )
            is_turned = any(map(float, words))
    solid = _solid_of(geometry)
    return None if solid is None else (solid, at, is_turned)


def _solid_of(geometry: Element | None) -> solids.Solid | None:
    if geometry is not None:
        for shape in geometry.children():
            if shape.name in _MAKERS:
                return _solid(shape.name, *_texts(shape).items())
            return None
    return None


@lru_cache(maxsize=1000)
def _solid(shape: str, *texts: tuple[str, str | None]) -> solids.Solid:
    """The solid of a shape; worlds repeat themselves."""
    return _MAKERS[shape]({name: text or "" for name, text in texts})
