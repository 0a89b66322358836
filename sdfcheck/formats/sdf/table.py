"""Reading data/sdf.txt: the lines as they are, parsed block by block when somebody asks."""

from __future__ import annotations

from functools import cache
from math import inf
from pathlib import Path

from sdfcheck.formats.sdf.version import NEWEST

_FILE = Path(__file__).parents[1] / "data" / "sdf.txt"


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


def at(field: str, minor: int) -> str:
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
    """The name of a definition's element, without its path."""
    return at(top.extra("name"), NEWEST.minor) or top.name


@cache
def spans(life: str) -> tuple[tuple[int, int], ...]:
    """The minor versions of a life such as ``2-6,10-``, both ends included."""
    found = []
    for span in life.split(","):
        first, is_open, last = span.partition("-")
        found.append((int(first), int(last or (NEWEST.minor if is_open else first))))
    return tuple(found)


@cache
def block(stem: str) -> Row:
    """One definition."""
    return Row(_blocks()[stem])


def stems() -> list[str]:
    return sorted(_blocks())


@cache
def _blocks() -> dict[str, str]:
    _, *blocks = _FILE.read_text("utf-8").rstrip("\n").split("\n\n")
    return {whole[: whole.index("\t")]: whole for whole in blocks}


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
