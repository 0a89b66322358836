"""Where the shapes of links are, for the rules about centers of mass."""

from __future__ import annotations

from sdfcheck import Inertial, Value
from sdfcheck_rules.inr.moments import MARK, is_out_of_scale, is_written

_SMALLEST = 0.015
"""m: smaller shapes are marks."""
_APART, _AT_END = 0.4, 0.49
"""Of the length of the shapes: so far from the middle of them is near their end."""
_ASIDE = 0.1
"""Of the greatest length: what is nearer, as the hub of a propeller, is beside the middle of a flat part."""


def is_compared(inertial: Inertial) -> bool:
    """Is there a mass, and are all shapes of the link known?"""
    if inertial.is_inside and not inertial.link.has_mesh:
        return False
    if not is_written(inertial) or not inertial.mass.number > MARK or inertial.center is None:
        return False
    return inertial.link.extent is not None


def is_off_origin(inertial: Inertial) -> bool:
    """Is the center of mass at the origin of the link, and that near the end of its shapes or beyond?

    Where zeros are written, at the end or beyond, and of plain shapes only: they may be a rough guess.
    """
    if not is_compared(inertial) or any(inertial.center or ()):
        return False
    if place_of(inertial) is not None and inertial.link.has_mesh:
        return False
    apart = _APART if place_of(inertial) is None else _AT_END
    for name in ("extent", "fixed_extent"):  # the second costs more
        box = getattr(inertial.link, name)
        if box is None or not max(box.size) > _SMALLEST:
            return False
        aside = _ASIDE * max(box.size)
        if not any(
            abs(at) > max(apart * size, aside) and size > 0
            for at, size in zip(box.center, box.size, strict=True)
        ):
            return False
    return not is_out_of_scale(inertial)


def place_of(inertial: Inertial) -> Value | None:
    """The position that is written for the center of mass."""
    place = inertial.find("origin" if inertial.is_urdf else "pose")
    value = None if place is None else place.attribute("xyz") if inertial.is_urdf else place.own_value
    return value if value is not None and value.text.strip() else None


def outside(inertial: Inertial) -> float:
    """How far the center of mass is outside of the link's shapes, by their greatest length; 0 inside of them.

    The shapes of links that are fixed to it count as well. Beside a visual of unknown size, collisions may be a part.
    """
    center, link = inertial.center, inertial.link
    if (
        center is None
        or not is_compared(inertial)
        or link.extent is None
        or not link.extent.distance_to(center)
        or (link.visuals and link.visual_box is None)
    ):
        return 0.0
    box = link.fixed_extent
    if box is None or not max(box.size) > _SMALLEST or is_out_of_scale(inertial):
        return 0.0
    return box.distance_to(center) / max(box.size)
