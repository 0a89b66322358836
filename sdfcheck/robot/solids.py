"""Volumes and inertias of primitive shapes, and the look at a link that takes most of them for sound."""

from __future__ import annotations

import math
import sys
from collections.abc import Sequence
from functools import lru_cache

from sdfcheck.source.document import Element
from sdfcheck.source.record import NamedTuple

# Mass properties of homogeneous solids, in closed form.
#
# Lengths in m, masses in kg, moments in kg·m². Moments are about the solid's center of mass, in axes parallel
# to its own; lengths of cylinders, capsules and cones run along z.


_ROUNDING = 5 * sys.float_info.epsilon
"""So much of the sum of the moments may be lost by rounding. Source: gz-math's MassMatrix3, as for the next."""
_DIAGONAL = 1e-6
"""Products that are smaller than this beside the largest moment are left out."""
_SWEEPS = 6
"""Jacobi's method squares what is left in each."""


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
        """Is it impossible because a principal moment is negative?"""
        return self.is_impossible and self.principal()[0] < -_ROUNDING * abs(self.trace)

    @property
    def is_impossible(self) -> bool:
        """Is a principal moment larger for libsdformat than the sum of the other two? So it is if one is negative."""
        low, middle, high = self.computed_by_gazebo()
        return low + middle + _ROUNDING * abs(low + middle + high) < high

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
        """The principal moments, the smallest first, to the last digits; nan for infinite ones."""
        scaled = self._scaled()
        if scaled is None:
            return math.nan, math.nan, math.nan
        ixx, iyy, izz, ixy, ixz, iyz = scaled.moments
        matrix = [[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]]
        for _ in range(_SWEEPS if ixy or ixz or iyz else 0):
            _turn(matrix, 0, 1)
            _turn(matrix, 0, 2)
            _turn(matrix, 1, 2)
        return scaled.back(matrix[0][0], matrix[1][1], matrix[2][2])

    def computed_by_gazebo(self) -> tuple[float, float, float]:
        """The principal moments with the errors that libsdformat makes; nan for infinite ones.

        It takes the roots of the characteristic polynomial, which are off by 1e-8 where two are nearly equal: of thin
        rods and discs, which are at the edge of what is possible, it refuses some and takes others.
        """
        scaled = self._scaled()
        if scaled is None:
            return math.nan, math.nan, math.nan
        ixx, iyy, izz, ixy, ixz, iyz = scaled.moments
        little = _DIAGONAL * max(ixx, iyy, izz)
        if max(abs(ixy), abs(ixz), abs(iyz)) <= little:
            return scaled.back(ixx, iyy, izz)
        trace = ixx + iyy + izz
        minors = ixx * iyy - ixy**2 + ixx * izz - ixz**2 + iyy * izz - iyz**2
        constant = ixx * iyz**2 + iyy * ixz**2 + izz * ixy**2 - ixx * iyy * izz - 2 * ixy * ixz * iyz
        spread = trace**2 - 3 * minors
        if spread < little**2:
            return scaled.back(trace / 3, trace / 3, trace / 3)
        cosine = 0.5 * (2 * trace**3 - 9 * trace * minors - 27 * constant) / spread**1.5
        angle = math.acos(max(-1.0, min(1.0, cosine)))
        radius = 2 * math.sqrt(spread)
        turns = (angle / 3, (angle + 2 * math.pi) / 3, (angle - 2 * math.pi) / 3)
        return scaled.back(*((trace + radius * math.cos(turn)) / 3 for turn in turns))

    def _scaled(self) -> _Scaled | None:
        """Near 1, where squares neither overflow nor vanish; None for infinite ones."""
        if not all(map(math.isfinite, self)):
            return None
        _, halvings = math.frexp(max(map(abs, self)))
        return _Scaled([math.ldexp(value, -halvings) for value in self], halvings)


class _Scaled(NamedTuple):
    """``ixx, iyy, izz, ixy, ixz, iyz`` that were halved or doubled so often, which rounds nothing."""

    moments: list[float]
    halvings: int

    def back(self, *moments: float) -> tuple[float, float, float]:
        """Moments as large as the first ones, the smallest first."""
        half_unit = math.ldexp(1, self.halvings - 1)
        low, middle, high = (moment * half_unit * 2 for moment in sorted(moments))
        return low, middle, high


def _turn(matrix: list[list[float]], a: int, b: int) -> None:
    """Make the product of two axes 0 by a rotation (Jacobi's method)."""
    product = matrix[a][b]
    if product == 0:
        return
    angle = math.atan2(2 * product, matrix[b][b] - matrix[a][a]) / 2
    cosine, sine = math.cos(angle), math.sin(angle)
    for row in matrix:
        row[a], row[b] = cosine * row[a] - sine * row[b], sine * row[a] + cosine * row[b]
    first, second = matrix[a], matrix[b]
    matrix[a] = [cosine * one - sine * other for one, other in zip(first, second, strict=True)]
    matrix[b] = [sine * one + cosine * other for one, other in zip(first, second, strict=True)]


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


# A quick look at a link's mass and inertia, for the many that are sound.
#
# It reads the numbers straight from the tree. An inertial that this look does not accept is looked at
# again, with places, by the rules about inertials.


_PLAUSIBLE = (0.01, 10.0)
"""Traces within these factors of a solid's are beyond suspicion."""
_REACH = 5.0
"""So are centers of mass this near to the origin, and links without shapes whose mass is not farther out (m)."""

_EDGE = 1e-7
"""So near to the edge of what is possible it depends on the errors of libsdformat."""

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
    "box": lambda t: box(*_three(t["size"])),
    "ellipsoid": lambda t: ellipsoid(*_three(t["radii"])),
    "sphere": lambda t: sphere(float(t["radius"])),
    "cylinder": lambda t: cylinder(float(t["radius"]), float(t["length"])),
    "capsule": lambda t: capsule(float(t["radius"]), float(t["length"])),
    "cone": lambda t: cone(float(t["radius"]), float(t["length"])),
}


def quick_inertia(link: Element) -> int:
    """The facts that are sure of a link's mass properties: the sum of the constants above."""
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
    low, middle, high = Moments(*moments).principal()
    return moments if low > 0 and low + middle > high * (1 + _EDGE) else ()


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
    facts = (
        (SOUND if low <= ratio <= high else 0)
        | (NEAR if low <= ratio <= 2 else 0)
        | (INSIDE if is_inside else 0)
    )
    if mass > _DENSEST * volume:
        return facts
    facts |= LIGHT
    if is_turned:
        return facts | FITTING if max(moments[:3]) < _EVEN * min(moments[:3]) else facts
    ratios = (moment * volume / (mass * each) for moment, each in zip(moments[:3], diagonal, strict=True))
    fits = _are_alike(moments, diagonal) and all(1 / 2 < each < 2 for each in ratios)
    return facts | FITTING if fits else facts


def _are_alike(moments: Sequence[float], others: Sequence[float]) -> bool:
    """Are three moments ordered by size as the others are?"""
    a, b, c = moments[:3]
    x, y, z = others[:3]
    return (a - b) * (x - y) >= 0 and (b - c) * (y - z) >= 0 and (a - c) * (x - z) >= 0


def _placed(shape: Element) -> tuple[Solid, list[float], bool] | None:
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


def _solid_of(geometry: Element | None) -> Solid | None:
    if geometry is not None:
        for shape in geometry.children():
            if shape.name in _MAKERS:
                return _solid(shape.name, *_texts(shape).items())
            return None
    return None


@lru_cache(maxsize=1000)
def _solid(shape: str, *texts: tuple[str, str | None]) -> Solid:
    """The solid of a shape; worlds repeat themselves."""
    return _MAKERS[shape]({name: text or "" for name, text in texts})
