"""The rows of the formats' tables: the lines as they are, taken apart block by block when somebody asks.

One line an element or ``@attribute``, below its parent: name, life, type, multiplicity, default, ``key=value`` …,
separated by tabs. A life is the versions 1.x that have it (``6-``: since 1.6), empty as long as its parent. A type
``^stem`` goes on in the block ``stem``. Blank lines separate the blocks; the first holds comments.
"""

from __future__ import annotations

import os
from functools import cache
from math import inf
from pathlib import Path

DATA = Path(__file__).parent / "data"


class Row:
    """One line: an element or attribute over all versions. The lines below it are split when asked for."""

    __slots__ = ("_below", "_depth", "_rows", "default", "extras", "life", "multiplicity", "name", "type")

    def __init__(self, text: str, depth: int = 0) -> None:
        line, _, self._below = text.partition("\n")
        fields = line.split("\t")
        if len(fields) < 5:
            fields += [""] * (5 - len(fields))
        self.name, self.life, self.type, self.multiplicity, self.default, *self.extras = fields
        self._depth = depth + 1
        self._rows: list[Row] | None = None

    @property
    def rows(self) -> list[Row]:
        """The element's attributes and children."""
        if self._rows is None:
            self._rows = [Row(text, self._depth) for text in self._split()]
        return self._rows

    def _split(self) -> list[str]:
        if not self._below:
            return []
        indent = " " * self._depth
        texts: list[str] = []
        for piece in self._below[self._depth :].split("\n" + indent):
            if piece[0] == " ":
                texts[-1] += "\n" + indent + piece
            else:
                texts.append(piece)
        return texts

    def extra(self, key: str) -> str:
        """The text of a ``key=value`` field, empty without one."""
        start = f"{key}="
        for field in self.extras:
            if field.startswith(start):
                return field[len(start) :]
        return ""

    def lives(self, minor: int) -> bool:
        """Whether version 1.``minor`` has it, given that it has the parent."""
        return not self.life or any(first <= minor <= last for first, last in spans(self.life))


def at(field: str, minor: float) -> str:
    """The value of a field of the form ``first|5:later`` in version 1.``minor``."""
    if "|" not in field:
        return field
    value, *changes = field.split("|")
    for change in changes:
        since, _, later = change.partition(":")
        if int(since) > minor:
            break
        value = later
    return value


def newest_name(top: Row) -> str:
    """The name of a block's element, without its path."""
    return at(top.extra("name"), inf) or top.name


@cache
def spans(life: str) -> tuple[tuple[int, float], ...]:
    """The minor versions of a life such as ``2-6,10-``, both ends included."""
    found = []
    for span in life.split(","):
        first, is_open, last = span.partition("-")
        found.append((int(first), int(last or first) if last or not is_open else inf))
    return tuple(found)


class Table:
    """The blocks of one file in ``data``, by the name of their first row."""

    __slots__ = ("_blocks", "_notes", "_rows", "_stem")

    def __init__(self, stem: str) -> None:
        self._stem = stem
        self._blocks: dict[str, str] = {}
        self._rows: dict[str, Row] = {}
        self._notes: dict[str, list[tuple[str, ...]]] | None = None

    def block(self, stem: str) -> Row:
        """The element that a block defines."""
        if stem not in self._rows:
            self._rows[stem] = Row(self._texts()[stem])
        return self._rows[stem]

    def stems(self) -> list[str]:
        """The names of all blocks, sorted."""
        return sorted(self._texts())

    def notes(self, kind: str) -> list[tuple[str, ...]]:
        """The fields of the notes of a kind, which only explanations need; none where there is no such file."""
        if self._notes is None:
            self._notes = {}
            file = DATA / f"{self._stem}-notes.txt"
            for line in file.read_text("utf-8").splitlines() if os.path.exists(file) else ():
                first, *fields = line.split("\t")
                self._notes.setdefault(first, []).append(tuple(fields))
        return self._notes.get(kind, [])

    def _texts(self) -> dict[str, str]:
        if not self._blocks:
            _, *blocks = (DATA / f"{self._stem}.txt").read_text("utf-8").rstrip("\n").split("\n\n")
            self._blocks = {whole[: whole.index("\t")]: whole for whole in blocks}
        return self._blocks


class Range:
    """The numbers that make sense at one place; of a vector every component is meant."""

    __slots__ = ("high", "high_open", "instead", "low", "low_open", "refused")

    def __init__(self, low: float, high: float, is_open: tuple[bool, bool] = (False, False)) -> None:
        self.low = low
        self.high = high
        self.low_open, self.high_open = is_open
        self.refused = True
        """The consumer does not read a document with a value outside."""
        self.instead: str | None = None
        """The value that libsdformat takes instead of one outside."""

    @classmethod
    def of(cls, row: Row, minor: int) -> Range | None:
        """The range of a place in version 1.``minor``: by meaning, else by the table; None without one."""
        if interval := row.extra("range"):
            found = cls.within(interval)
            found.refused = row.extra("refused") != ""
            found.instead = row.extra("instead") or None
            return found
        low, high = at(row.extra("min"), minor), at(row.extra("max"), minor)
        if not low and not high:
            return None
        found = cls(float(low.split(" ")[0] or -inf), float(high.split(" ")[0] or inf))
        # Those of vectors and attributes are not read.
        found.refused = row.name[0] != "@" and not at(row.type, minor).startswith("vector")
        return found

    @classmethod
    def within(cls, interval: str) -> Range:
        """The range that an interval such as ``(0,inf]`` writes."""
        low, _, high = interval[1:-1].partition(",")
        return cls(float(low), float(high), (interval[0] == "(", interval[-1] == ")"))

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
