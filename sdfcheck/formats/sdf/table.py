"""Reading data/sdf.txt: the lines as they are, parsed block by block when somebody asks."""

from __future__ import annotations

from functools import cache
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
    """The minor versions of a life such as ``2-6,10``, both ends included."""
    found = []
    for span in life.split(","):
        first, _, last = span.partition("-")
        found.append((int(first), int(last or first)))
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
