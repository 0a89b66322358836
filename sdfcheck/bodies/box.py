"""Boxes along the axes of a frame, in plain numbers: lint knows most shapes without numpy."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator
from itertools import product
from typing import TypeAlias

from sdfcheck.source.record import NamedTuple

Point: TypeAlias = tuple[float, ...]
"""x, y, z (m)."""


_HALVINGS = 40
"""Enough for the place on a line that is nearest."""


class Box(NamedTuple):
    """The lowest and the highest x, y, z (m)."""

    low: Point
    high: Point

    @property
    def size(self) -> Point:
        """Its lengths along x, y and z."""
        return tuple(high - low for low, high in zip(self.low, self.high, strict=True))

    @property
    def center(self) -> Point:
        return tuple((low + high) / 2 for low, high in zip(self.low, self.high, strict=True))

    @property
    def diagonal(self) -> float:
        """The distance of two opposite corners."""
        return math.hypot(*self.size)

    def corners(self) -> Iterator[Point]:
        """Its eight corners."""
        return product(*zip(self.low, self.high, strict=True))

    def moved_by(self, offset: Point) -> Box:
        """The same elsewhere."""
        (x, y, z), (a, b, c), (d, e, f) = offset, self.low, self.high
        return Box((a + x, b + y, c + z), (d + x, e + y, f + z))

    def scaled(self, factors: Point) -> Box:
        """The same with each coordinate multiplied; a negative factor mirrors."""
        ends = [
            sorted((low * factor, high * factor))
            for low, high, factor in zip(self.low, self.high, factors, strict=True)
        ]
        return Box(tuple(end[0] for end in ends), tuple(end[1] for end in ends))

    def distance_to(self, other: Box | Point) -> float:
        """How far another box, or a point, is outside of it; 0 where they touch."""
        low, high = (other.low, other.high) if isinstance(other, Box) else (other, other)
        ends = zip(self.low, self.high, low, high, strict=True)
        return math.hypot(*(max(0.0, first - top, bottom - last) for bottom, top, first, last in ends))

    def distance_to_line(self, direction: Point) -> float:
        """How far a line through the origin, in a direction of length 1, passes from it."""
        reach = math.hypot(*(max(-low, high) for low, high in zip(self.low, self.high, strict=True)))

        def at(place: float) -> float:
            return self.distance_to((direction[0] * place, direction[1] * place, direction[2] * place))

        first, last = -reach, reach
        for _ in range(_HALVINGS):  # the distance falls to its least value, and rises from there
            one, other = first + (last - first) / 3, last - (last - first) / 3
            first, last = (first, other) if at(one) < at(other) else (one, last)
        return at((first + last) / 2)


def around(boxes: Iterable[Box | None]) -> Box | None:
    """The box around boxes; None around nothing."""
    known = [box for box in boxes if box is not None]
    if not known:
        return None
    return of_points(point for box in known for point in (box.low, box.high))


def of_points(points: Iterable[Point]) -> Box:
    """The box around points, of which there is one at least."""
    columns = list(zip(*points, strict=True))
    return Box(tuple(map(min, columns)), tuple(map(max, columns)))
