"""Computed poses and vectors as text."""

from __future__ import annotations

from collections.abc import Iterable

from sdfcheck.convert.writer import number
from sdfcheck.robot.motion.rotations import Array, to_rpy

_DUST = 1e-13
"""Smaller components of what was computed are what is left of rounding."""


_NOISY = 3
"""So many digits shorter is what the rounding of noise makes of a number."""


def _number(value: float) -> str:
    exact, rounded = number(value), number(round(value, 15))
    return rounded if len(rounded) <= len(exact) - _NOISY else exact


def vector(values: Iterable[float]) -> str:
    return " ".join("0" if abs(value) < _DUST else _number(float(value)) for value in values)


def pose(transform: Array) -> str:
    """``x y z roll pitch yaw`` of a 4×4 transform."""
    return vector((*transform[:3, 3], *to_rpy(transform[:3, :3])))
