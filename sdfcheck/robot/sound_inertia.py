"""A quick look at a link's mass and inertia, for the many that are sound.

It reads the numbers straight from the tree. What it does not call sound is looked at
again, with places, by the rules about inertials.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from sdfcheck.robot import solids
from sdfcheck.source.element import Element

_PLAUSIBLE = (0.01, 10.0)
"""Traces within these factors of a solid's are beyond suspicion."""

_MAKERS = {
    "box": lambda t: solids.box(*_three(t["size"])),
    "ellipsoid": lambda t: solids.ellipsoid(*_three(t["radii"])),
    "sphere": lambda t: solids.sphere(float(t["radius"])),
    "cylinder": lambda t: solids.cylinder(float(t["radius"]), float(t["length"])),
    "capsule": lambda t: solids.capsule(float(t["radius"]), float(t["length"])),
    "cone": lambda t: solids.cone(float(t["radius"]), float(t["length"])),
}


def is_sound(link: Element) -> bool:
    """True only if there is surely nothing to say about a link's mass properties."""
    parts: dict[Any, list[Element]] = {}
    for child in link:
        parts.setdefault(child.tag, []).append(child)
    shapes = parts.get("collision") or parts.get("visual") or []
    try:
        mass, moments, centre = _read(parts["inertial"][0])
        return _is_possible(mass, moments) and _is_plausible(mass, moments, centre, shapes)
    except (KeyError, TypeError, ValueError, ZeroDivisionError):
        return False


def _read(inertial: Element) -> tuple[float, list[float], list[float]]:
    if any(key == "auto" for key, _ in inertial.items()):
        raise ValueError
    mass, moments, centre = math.nan, [], [0.0, 0.0, 0.0]
    for child in inertial:
        tag = child.tag
        if tag == "mass":
            mass = float(_texts(child).get("value") or child.text or "")
        elif tag == "inertia":
            texts = _texts(child)
            moments = [float(texts.get(name) or 0) for name in ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")]
        elif tag in {"pose", "origin"}:
            centre = _position(child)
    return mass, moments, centre


def _texts(element: Element) -> dict[str, str | None]:
    """The attributes of an element and the texts of its children, by name."""
    texts: dict[str, str | None] = dict(element.items())
    for child in element:
        texts[child.tag] = child.text
    return texts


def _position(origin: Element) -> list[float]:
    if origin.tag == "origin":
        return _three(dict(origin.items()).get("xyz", "0 0 0"))
    if origin.items():
        raise ValueError
    return _three(" ".join((origin.text or "0 0 0").split()[:3]))


def _three(text: str | None) -> list[float]:
    x, y, z = (text or "").split()
    return [float(x), float(y), float(z)]


def _is_possible(mass: float, moments: list[float]) -> bool:
    if not (mass > 0 and math.isfinite(mass) and moments):
        return False
    low, middle, high = solids.Moments(*moments).principal()
    return low > 0 and low + middle >= high


def _is_plausible(mass: float, moments: list[float], centre: list[float], shapes: list[Element]) -> bool:
    volume = total = 0.0
    for shape in shapes:
        at, geometry = [0.0, 0.0, 0.0], None
        for child in shape:
            if child.tag == "geometry":
                geometry = child
            elif child.tag in {"pose", "origin"}:
                at = _position(child)
        solid = _solid(geometry)
        if solid is not None:
            distance = math.dist(at, centre)
            volume += solid.volume
            total += solid.volume * (solid.moments.trace + 2 * distance * distance)
    if not volume:
        return True
    low, high = _PLAUSIBLE
    return low <= sum(moments[:3]) / (mass * total / volume) <= high


def _solid(geometry: Element | None) -> solids.Solid | None:
    if geometry is not None:
        for shape in geometry:
            make = _MAKERS.get(shape.tag)
            return make(_as_given(_texts(shape))) if make else None
    return None


def _as_given(texts: Mapping[str, str | None]) -> dict[str, str]:
    return {name: text or "" for name, text in texts.items()}
