"""Texts, places in them, the units in which the world counts columns, and the paths of files."""

from __future__ import annotations

import os
import re
from bisect import bisect_right
from collections.abc import Mapping
from functools import partial
from pathlib import Path
from typing import cast

from sdfcheck.source.record import NamedTuple


class _Pattern:
    """A regular expression before its first use; then it has the methods of what was compiled."""

    def __init__(self, text: str, flags: int) -> None:
        self.pattern, self.flags = text, flags

    def __getattr__(self, name: str) -> object:
        found = self.__dict__[name] = getattr(re.compile(self.pattern, self.flags), name)
        return found


def pattern(text: str, flags: int = 0) -> re.Pattern[str]:
    """A regular expression that is compiled when it is first used: a small file needs few of them."""
    return cast("re.Pattern[str]", _Pattern(text, flags))


_LINE_END = pattern(r"\r\n?|\n")
_LINE_FEED = re.compile("\n")


class Position(NamedTuple):
    """A place as people count it: line and column from 1, columns in code points."""

    line: int
    column: int


class Source:
    """The decoded text of one file, and the arithmetic of places in it.

    ``text`` holds the file's characters unchanged (line ends included, byte order
    mark excluded), so that offsets into it can be used for edits. Reports do not show the
    lines of a file that ``is_foreign``: no description, and perhaps not meant to be seen.
    """

    __slots__ = ("_contains", "_line_starts", "_real_path", "is_foreign", "path", "text")

    def __init__(self, path: Path, text: str, *, is_foreign: bool = False) -> None:
        self.path = path
        self.text = text
        self.is_foreign = is_foreign
        self._line_starts: list[int] | None = None
        self._real_path = ""
        self._contains: dict[str, bool] = {}

    def __reduce__(self) -> tuple[object, ...]:
        return partial(Source, is_foreign=self.is_foreign), (self.path, self.text)

    def __repr__(self) -> str:
        return f"Source({str(self.path)!r}, {len(self.text)} characters)"

    @property
    def real_path(self) -> str:
        """Where the file is, whatever links lead to it; looked up once."""
        if not self._real_path:
            self._real_path = os.path.realpath(self.path)
        return self._real_path

    @property
    def line_starts(self) -> list[int]:
        """Offsets at which lines begin; LF, CRLF and CR all end a line."""
        if self._line_starts is None:
            ends = _LINE_END if "\r" in self.text else _LINE_FEED
            self._line_starts = [0, *[match.end() for match in ends.finditer(self.text)]]
        return self._line_starts

    def edited(self, start: int, end: int, text: str) -> Source:
        """The same with another text in place of a range; what is known of the lines and words is not lost."""
        result = Source(self.path, self.text[:start] + text + self.text[end:])
        for words, found in self._contains.items():
            margin = len(words) - 1
            if not found:
                result._contains[words] = (
                    words in result.text[max(0, start - margin) : start + len(text) + margin]
                )
            elif words not in self.text[max(0, start - margin) : end + margin]:
                result._contains[words] = True
        known = self._line_starts
        if known is not None and "\r" not in self.text and "\r" not in text:
            first, last = bisect_right(known, start), bisect_right(known, end)
            new = [start + match.end() for match in _LINE_END.finditer(text)]
            shift = len(text) - (end - start)
            result._line_starts = [*known[:first], *new, *(each + shift for each in known[last:])]
        return result

    def contains(self, words: str) -> bool:
        """Does the text contain them? Searched once, however often it is asked."""
        found = self._contains.get(words)
        if found is None:
            found = self._contains[words] = words in self.text
        return found

    def position(self, offset: int) -> Position:
        """Line and column of an offset, both from 1, in code points."""
        line = bisect_right(self.line_starts, offset)
        return Position(line, offset - self.line_starts[line - 1] + 1)

    def utf8_position(self, offset: int) -> tuple[int, int]:
        """Line and column from 1, in UTF-8 bytes, as reviewdog counts."""
        line = bisect_right(self.line_starts, offset)
        before = self.text[self.line_starts[line - 1] : offset]
        return line, len(before.encode("utf-8", "surrogatepass")) + 1

    def offset(self, line: int, column: int) -> int:
        """The offset of a line and column counted from 1; past the end of the line is cut."""
        starts = self.line_starts
        if line > len(starts):
            return len(self.text)
        start = starts[line - 1]
        return min(start + column - 1, start + len(self.line(line)))

    def line(self, number: int) -> str:
        """The text of a line (from 1) without its line end; empty past the last."""
        starts = self.line_starts
        if not 1 <= number <= len(starts):
            return ""
        end = starts[number] if number < len(starts) else len(self.text)
        return self.text[starts[number - 1] : end].rstrip("\r\n")

    def span(self, start: int, end: int) -> Span:
        return Span(self, start, end)


class Span(NamedTuple):
    """A half-open range of characters, ``start`` to ``end``, of one source."""

    source: Source
    start: int
    end: int

    @property
    def text(self) -> str:
        return self.source.text[self.start : self.end]

    @property
    def begin(self) -> Position:
        return self.source.position(self.start)

    @property
    def finish(self) -> Position:
        """The position just after the last character."""
        return self.source.position(self.end)

    def __repr__(self) -> str:
        return f"Span({self.source.path}:{self.begin.line}:{self.begin.column} {self.text[:40]!r})"


class Step(NamedTuple):
    """One step of how a place was reached, for example by a macro call or an include."""

    span: Span
    text: str


def is_expression(text: str) -> bool:
    """Whether xacro should have replaced something in a text."""
    return "${" in text or "$(" in text


# Paths seen from a folder.


def relative_path(path: str | os.PathLike[str], start: str | os.PathLike[str] = os.curdir) -> str:
    """A path as seen from a folder; the whole path where no way leads there: on another drive of Windows."""
    try:
        return os.path.relpath(path, start)
    except ValueError:
        return os.path.abspath(path)


def shown(path: Path) -> str:
    """The path as people call it: relative, where it lies below the current folder."""
    relative = relative_path(path)
    return (str(path) if relative.startswith("..") else relative).replace(os.sep, "/")


# Characters that XML writes as references, such as ``&amp;``.

IN_QUOTES = {'"': "&quot;", "'": "&apos;"}
"""The characters that a value in quotes of either kind cannot hold."""
IN_ATTRIBUTE = {'"': "&quot;", "\n": "&#10;", "\t": "&#9;", "\r": "&#13;"}
"""The characters that an attribute in double quotes cannot hold, or that would be read as a space."""


def escape(text: str, others: Mapping[str, str] | None = None) -> str:
    """A text as XML writes it; ``others``: further characters, with what is written for them."""
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    for character, reference in (others or {}).items():
        text = text.replace(character, reference)
    return text


def unescape(text: str) -> str:
    """The text before :func:`escape`."""
    for character, reference in IN_QUOTES.items():
        text = text.replace(reference, character)
    return text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
