"""Volumes and inertias of primitive shapes, and the look at a link that takes most of them for sound."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache

from sdfcheck.source.document import Element
from sdfcheck.source.record import NamedTuple

# Mass properties of homogeneous solids, in closed form.
#
# Lengths in m, masses in kg, moments in kg·m². Moments are about the solid's center of mass, in axes parallel
# to its own; lengths of cylinders, capsules and cones run along z.


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


# A quick look at a link's mass and inertia, for the many that are sound.
#
# It reads the numbers straight from the tree. An inertial that this look does not accept is looked at
# again, with places, by the rules about inertials.


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
