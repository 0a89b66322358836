"""Where the shapes of links are, for the rules about centers of mass."""

from __future__ import annotations

from sdfcheck import Inertial
from sdfcheck_rules.inr.moments import is_doubtful

_LEAST = 1e-3
"""kg: lighter links mark places; where their mass is makes no difference."""
_MARK = 0.015
"""m: smaller shapes are marks."""
_APART = 0.4
"""Of the length of the shapes: so far from the middle of them is near their end."""


def has_no_place(inertial: Inertial) -> bool:
    """Does nothing say where the center of mass is, so that it is at the link's origin?"""
    place = inertial.find("origin" if inertial.is_urdf else "pose")
    if place is None:
        return True
    if inertial.is_urdf:
        return place.text_of("xyz") is None and place.text_of("rpy") is None
    return not place.content


def is_compared(inertial: Inertial) -> bool:
    """Is there a mass, and are all shapes of the link known?"""
    if not is_doubtful(inertial) or not inertial.mass.number >= _LEAST or inertial.center is None:
        return False
    return inertial.link.extent is not None and not inertial.link.size_to_reach > 100


def is_off_origin(inertial: Inertial) -> bool:
    """Is the center of mass at the origin because nothing is written, and at the end of all shapes or beyond?"""
    box = inertial.link.extent if is_compared(inertial) and has_no_place(inertial) else None
    if box is None:
        return False
    return any(abs(at) > _APART * size > 0 for at, size in zip(box.center, box.size, strict=True))


def outside(inertial: Inertial) -> float:
    """How far the center of mass is outside of the link's shapes, by their greatest length; 0 inside of them.

    The shapes of links that are fixed to it count as well.
    """
    center, box = inertial.center, inertial.link.fixed_extent if is_compared(inertial) else None
    if box is None or center is None or not max(box.size) > _MARK:
        return 0.0
    return box.distance_to(center) / max(box.size)
