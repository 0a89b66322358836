"""Mass properties of homogeneous solids, in closed form.

Lengths in m, masses in kg, moments in kg·m². Moments are about the solid's center of
mass, in axes parallel to its own; lengths of cylinders, capsules and cones run along z.
"""

from __future__ import annotations

import math

from sdfcheck.source.record import NamedTuple

_ROUNDING = 2.3e-15
"""So much of the largest moment may be lost by rounding."""


class Moments(NamedTuple):
    """A symmetric 3×3 inertia tensor."""

    ixx: float
    iyy: float
    izz: float
    ixy: float = 0.0
    ixz: float = 0.0
    iyz: float = 0.0

    @property
    def trace(self) -> float:
        """The sum of the diagonal, which no rotation changes."""
        return self.ixx + self.iyy + self.izz

    @property
    def is_indefinite(self) -> bool:
        """Is a principal moment negative, by more than rounding explains? Source: gz-math's MassMatrix3."""
        return self.principal()[0] < -self._rounding

    @property
    def is_impossible(self) -> bool:
        """Is a principal moment larger than the sum of the other two? Source: the same."""
        low, middle, high = self.principal()
        return low + middle + self._rounding < high

    @property
    def _rounding(self) -> float:
        """How far off the principal moments may be because the moments were rounded."""
        return _ROUNDING * max(map(abs, self))

    def plus(self, other: Moments) -> Moments:
        return Moments(*(a + b for a, b in zip(self, other, strict=True)))

    def times(self, factor: float) -> Moments:
        return Moments(*(value * factor for value in self))

    def moved(self, mass: float, x: float, y: float, z: float) -> Moments:
        """About a point ``(x, y, z)`` off the center of mass (parallel-axis theorem)."""
        return self.plus(
            Moments(y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z).times(mass)
        )

    def principal(self) -> tuple[float, float, float]:
        """The principal moments, the smallest first (closed form for symmetric 3×3 matrices); nan for infinite ones."""
        if not all(map(math.isfinite, self)):
            return math.nan, math.nan, math.nan
        # Halved or doubled as often as it takes, which rounds nothing, squares neither overflow nor vanish.
        _, halvings = math.frexp(max(abs(value) for value in self))
        ixx, iyy, izz, ixy, ixz, iyz = (math.ldexp(value, -halvings) for value in self)
        off = ixy * ixy + ixz * ixz + iyz * iyz
        if off <= 1e-30:
            low, middle, high = sorted(self[:3])
            return low, middle, high
        mean = (ixx + iyy + izz) / 3
        spread = sum((value - mean) ** 2 for value in (ixx, iyy, izz)) + 2 * off
        size = math.sqrt(spread / 6)
        a, b, c = ((value - mean) / size for value in (ixx, iyy, izz))
        d, e, f = (value / size for value in (ixy, ixz, iyz))
        half = (a * (b * c - f * f) - d * (d * c - f * e) + e * (d * f - b * e)) / 2
        angle = math.acos(max(-1.0, min(1.0, half))) / 3
        high = mean + 2 * size * math.cos(angle)
        low = mean + 2 * size * math.cos(angle + 2 * math.pi / 3)
        half_unit = math.ldexp(1, halvings - 1)
        return low * half_unit * 2, (ixx + iyy + izz - low - high) * half_unit * 2, high * half_unit * 2


class Solid(NamedTuple):
    """Volume (m³), moments per kg, and the height of the center of mass along z."""

    volume: float
    moments: Moments
    center: float = 0.0


def box(x: float, y: float, z: float) -> Solid:
    return Solid(x * y * z, Moments((y * y + z * z) / 12, (x * x + z * z) / 12, (x * x + y * y) / 12))


def cylinder(radius: float, length: float) -> Solid:
    square = radius * radius
    side = (3 * square + length * length) / 12
    return Solid(math.pi * square * length, Moments(side, side, square / 2))


def sphere(radius: float) -> Solid:
    return ellipsoid(radius, radius, radius)


def ellipsoid(a: float, b: float, c: float) -> Solid:
    moments = Moments((b * b + c * c) / 5, (a * a + c * c) / 5, (a * a + b * b) / 5)
    return Solid(4 / 3 * math.pi * a * b * c, moments)


def capsule(radius: float, length: float) -> Solid:
    """A cylinder of ``length`` between two half balls."""
    tube, ball = cylinder(radius, length), sphere(radius)
    volume = tube.volume + ball.volume
    part, cap = tube.volume / volume, ball.volume / volume
    # A half ball's center of mass is 3/8 of the radius off its flat side.
    offset = length / 2 + 3 / 8 * radius
    square = radius * radius
    side = cap * (2 / 5 * square - 9 / 64 * square + offset * offset)
    caps = Moments(side, side, cap * 2 / 5 * square)
    return Solid(volume, tube.moments.times(part).plus(caps))


def cone(radius: float, length: float) -> Solid:
    """A cone with its tip up, whose origin is half way up; the center of mass is lower."""
    square = radius * radius
    side = 3 / 80 * (4 * square + length * length)
    return Solid(math.pi * square * length / 3, Moments(side, side, 3 / 10 * square), -length / 4)
