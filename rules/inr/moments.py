"""What the rules of this family ask of moments of inertia.

The hard conditions are those of libsdformat 17 (gz-math's MassMatrix3): positive
definite, and no principal moment above the sum of the other two. The soft ones compare
with homogeneous solids of the link's own primitive shapes; only traces are compared,
which no rotation changes.
"""

from __future__ import annotations

import math

from sdfcheck import Inertial

_ROUNDING = 2.3e-15
"""So much of the largest moment may be lost by rounding."""
_FACTOR = 100.0
"""More than this off a solid of the same mass and shape is no modelling choice any more."""


def is_remarkable(inertial: Inertial) -> bool:
    """Are the numbers of a body that moves written, and not beyond doubt?"""
    return not (inertial.is_unremarkable or inertial.is_automatic or inertial.link.may_be_static)


def has_moments(inertial: Inertial) -> bool:
    """The same of moments that can be read, with a mass that no rule reports."""
    if not is_remarkable(inertial) or not inertial.is_legible:
        return False
    mass = inertial.mass
    return not mass.is_given or mass.number > 0 or "$" in mass.text  # which xacro has yet to fill in


def is_indefinite(inertial: Inertial) -> bool:
    """Is a principal moment negative?"""
    return inertial.principal[0] < -rounding(inertial)


def is_impossible(inertial: Inertial) -> bool:
    """Is a principal moment larger than the sum of the other two?"""
    low, middle, high = inertial.principal
    return low + middle + rounding(inertial) < high


def rounding(inertial: Inertial) -> float:
    """How far off the principal moments may be because the moments were rounded."""
    return _ROUNDING * max(map(abs, inertial.tensor))


def ratio(inertial: Inertial) -> float:
    """The moments to those of a solid of this mass in the link's shapes; nan where that says nothing."""
    if not has_moments(inertial) or is_indefinite(inertial) or is_impossible(inertial):
        return math.nan
    expected, trace = inertial.solid_trace, inertial.tensor.trace
    return trace / expected if 0 < expected < math.inf and 0 < trace < math.inf else math.nan


def is_far_off(inertial: Inertial) -> bool:
    """Is it off by more than any choice of modelling explains?"""
    found = ratio(inertial)
    return (found < 1 / _FACTOR or found > _FACTOR) and not is_about_origin(inertial)


def is_about_origin(inertial: Inertial) -> bool:
    """Do moments that are too large fit once they are shifted from the link's origin to the center of mass?"""
    if inertial.inertia is None or inertial.center is None or not ratio(inertial) > 10:
        return False
    offset = math.hypot(*inertial.center)
    shifted = (inertial.tensor.trace - 2 * inertial.mass.number * offset * offset) / inertial.solid_trace
    return offset > 0 and 1 / 3 < shifted < 3


def is_unit(inertial: Inertial) -> bool:
    """Are the moments 1 kg·m² about each axis?"""
    return inertial.tensor == (1, 1, 1, 0, 0, 0)
