"""Ranges of numbers."""

from __future__ import annotations

from math import inf

from sdfcheck.formats.sdf.table import Row, at


class Range:
    """The numbers that make sense at one place; of a vector every component is meant."""

    __slots__ = ("high", "high_open", "instead", "low", "low_open", "refused")

    def __init__(self, low: float, high: float, is_open: tuple[bool, bool] = (False, False)) -> None:
        self.low = low
        self.high = high
        self.low_open, self.high_open = is_open
        self.refused = True
        """libsdformat does not read a document with a value outside."""
        self.instead: str | None = None
        """The value that libsdformat takes instead of one outside."""

    @classmethod
    def of(cls, row: Row, minor: int) -> Range | None:
        """The range of a place in version 1.``minor``: by meaning, else by the table; None without one."""
        if interval := row.extra("range"):
            low, _, high = interval[1:-1].partition(",")
            found = cls(float(low), float(high), (interval[0] == "(", interval[-1] == ")"))
            found.refused = False
            found.instead = row.extra("instead") or None
            return found
        low, high = at(row.extra("min"), minor), at(row.extra("max"), minor)
        if not low and not high:
            return None
        found = cls(float(low.split(" ")[0] or -inf), float(high.split(" ")[0] or inf))
        # Those of vectors and attributes are not read.
        found.refused = row.name[0] != "@" and not at(row.type, minor).startswith("vector")
        return found

    def __repr__(self) -> str:
        return f"Range({self})"

    def __str__(self) -> str:
        if self.high == inf:
            return f"{'above' if self.low_open else 'at least'} {self.low:.16g}"
        if self.low == -inf:
            return f"{'below' if self.high_open else 'at most'} {self.high:.16g}"
        between = "between {} and {}" if self.low_open else "from {} to {}"
        return between.format(f"{self.low:.16g}", f"{self.high:.16g}")

    def holds(self, number: float) -> bool:
        """Whether a number is inside; nan is."""
        below = number <= self.low if self.low_open else number < self.low
        above = number >= self.high if self.high_open else number > self.high
        return not below and not above
