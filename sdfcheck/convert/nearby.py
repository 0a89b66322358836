"""Things with numbers, such as poses and sizes, found by numbers that are nearly the same."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from itertools import cycle
from typing import Generic, TypeVar

T = TypeVar("T")

_WEIGHTS = tuple(1 + math.sin(number) / 2 for number in range(1, 17))
"""Irregular, so that different numbers seldom have the same sum."""


class Nearby(Generic[T]):
    """Things in the order of a sum of their numbers, in which those that are nearly the same are side by side."""

    def __init__(self, things: Iterable[tuple[Sequence[float], T]]) -> None:
        pairs = sorted(((_sum(numbers), thing) for numbers, thing in things), key=lambda pair: pair[0])
        self._sums = [each for each, _ in pairs]
        self._things = [thing for _, thing in pairs]

    def copy(self) -> Nearby[T]:
        made: Nearby[T] = Nearby(())
        made._sums, made._things = self._sums.copy(), self._things.copy()
        return made

    def near(self, numbers: Sequence[float], tolerance: float) -> Iterator[T]:
        """All whose numbers are within ``tolerance``, or a part of 1e-9, of these, one by one; and seldom others."""
        wanted = _sum(numbers)
        margin = sum(tolerance + 1e-8 * abs(number) for number in _finite(numbers)) * max(_WEIGHTS)
        at = bisect_left(self._sums, wanted - margin)
        while at < len(self._sums) and self._sums[at] <= wanted + margin:
            yield self._things[at]
            at += 1

    def __iter__(self) -> Iterator[T]:
        return iter(self._things)

    def remove(self, numbers: Sequence[float], thing: T) -> None:
        """Take out a thing with its numbers, which must be there."""
        at = bisect_left(self._sums, _sum(numbers))
        while self._things[at] is not thing:
            at += 1
        del self._things[at], self._sums[at]


def _sum(numbers: Sequence[float]) -> float:
    return sum(number * weight for number, weight in zip(_finite(numbers), cycle(_WEIGHTS), strict=False))


def _finite(numbers: Iterable[float]) -> list[float]:
    return [number if math.isfinite(number) else 0.0 for number in numbers]
