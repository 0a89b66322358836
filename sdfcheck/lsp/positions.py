"""Places as editors count them: lines from 0, columns in the units that client and server agreed on."""

from __future__ import annotations

from collections.abc import Iterable
from enum import Enum

from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Source


class Units(Enum):
    """The units of a column, by the names of the protocol."""

    UTF8 = "utf-8"
    UTF16 = "utf-16"
    UTF32 = "utf-32"

    def width(self, text: str) -> int:
        """How many units a text takes."""
        if self is Units.UTF32 or text.isascii():
            return len(text)
        if self is Units.UTF8:
            return len(text.encode("utf-8", "surrogatepass"))
        return len(text.encode("utf-16-le", "surrogatepass")) // 2

    def cut(self, text: str, width: int) -> int:
        """How many characters of a text fill so many units; a character that is cut in two does not count."""
        if self is Units.UTF32 or text.isascii():
            return min(width, len(text))
        used = 0
        for number, character in enumerate(text):
            used += self.width(character)
            if used > width:
                return number
        return len(text)


class Place(NamedTuple):
    """A line and a column, both from 0."""

    line: int
    column: int


class Change(NamedTuple):
    """A new text for a range of the old one; without a range, for all of it."""

    text: str
    start: Place | None = None
    end: Place | None = None


def place_of(source: Source, offset: int, units: Units) -> Place:
    """Where a character is."""
    line, column = source.position(offset)
    if column == 1 or units is Units.UTF32:
        return Place(line - 1, column - 1)
    return Place(line - 1, units.width(source.text[offset - column + 1 : offset]))


def offset_of(source: Source, place: Place, units: Units) -> int:
    """The character at a place; past the end of a line, that end."""
    starts = source.line_starts
    if place.line >= len(starts):
        return len(source.text)
    if place.line < 0:
        return 0
    return starts[place.line] + units.cut(source.line(place.line + 1), max(0, place.column))


def changed(source: Source, changes: Iterable[Change], units: Units) -> tuple[Source, int]:
    """The text after changes, of which each counts on those before it; and how much of its beginning is as it was."""
    kept = len(source.text)
    for text, start, end in changes:
        if start is None or end is None:
            source, kept = Source(source.path, text), 0
            continue
        first, last = sorted((offset_of(source, start, units), offset_of(source, end, units)))
        source = source.edited(first, last, text)
        kept = min(kept, first)
    return source, kept
