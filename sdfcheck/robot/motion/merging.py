"""The moments of inertia of links that fixed joints tie together in URDF."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import TYPE_CHECKING

from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.motion.origin import Origin, Triple, origin_in, urdf_number
from sdfcheck.robot.parts.inertial import MOMENTS
from sdfcheck.robot.parts.solids import Moments

if TYPE_CHECKING:
    from sdfcheck.robot.parts.link import Link


def merged_moments(links: Iterable[Link]) -> Moments:
    """The moments (kg·m²) of links about their center of mass, in the axes of the first one.

    Each of the others comes after the link that it is fixed to. The moments are nan where a number or
    the mass is missing.
    """
    try:
        return _sum(links)
    except (DescriptionError, ArithmeticError):
        return Moments(math.nan, math.nan, math.nan)


def _sum(links: Iterable[Link]) -> Moments:
    places: dict[Link, Origin] = {}
    bodies: list[tuple[float, Triple, Moments]] = []
    for link in links:
        joint = link.parent_joints[0] if places else None
        if joint is None or joint.parent_link is None:
            places[link] = Origin()
        else:
            places[link] = places[joint.parent_link].followed_by(origin_in(joint.element))
        inertial = link.inertial
        if inertial.is_given:
            mass, inertia = inertial.find("mass"), inertial.inertia
            place = places[link].followed_by(origin_in(inertial.element))
            moments = Moments(0.0, 0.0, 0.0)
            if inertia is not None:
                moments = Moments(**{name: urdf_number(inertia, name, 0.0) for name in MOMENTS})
            weight = 0.0 if mass is None else urdf_number(mass, "value", 0.0)
            bodies.append((weight, place.position, place.turned_moments(moments)))
    whole = sum(mass for mass, _, _ in bodies)
    x, y, z = (sum(mass * at[i] for mass, at, _ in bodies) / whole for i in range(3))
    total = Moments(0.0, 0.0, 0.0)
    for weight, at, moments in bodies:
        total = total.plus(moments.moved(weight, at[0] - x, at[1] - y, at[2] - z))
    return total
