"""The places of a text's elements and comments; of well-formed texts, found quickly."""

from __future__ import annotations

import re
from bisect import bisect_right
from typing import TYPE_CHECKING, Any

from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.start_tag import START, StartTag, has_names, repeated_attributes, tag_of
from sdfcheck.source.text import Source

if TYPE_CHECKING:
    from sdfcheck.source.problems import Problem


# The places of a text's elements and comments.
#
# The tree keeps what a text says, a scan keeps the places. Both number elements in document order,
# which is how they find each other.


class ElementPlace(NamedTuple):
    """Offsets of an element's tags: start tag ``start:end``, end tag ``close:close_end``.

    An element without an end tag (``<a/>``, or never closed) has ``close == close_end``.
    """

    start: int
    end: int
    close: int
    close_end: int


class Scan:
    """The places of one text's elements (in document order) and comments, and its defects."""

    __slots__ = (
        "close_ends",
        "closes",
        "comments",
        "doubtful",
        "ends",
        "odd",
        "problems",
        "starts",
        "wellformed",
    )

    def __init__(self) -> None:
        self.starts: list[int] = []
        self.ends: list[int] = []
        self.closes: list[int] = []
        self.close_ends: list[int] = []
        self.comments: list[tuple[int, int]] = []
        self.problems: list[Problem] = []
        self.doubtful: list[tuple[int, int]] = []
        """Ranges that were read by a guess: what else is wrong there follows from the guess."""
        self.odd: dict[int, StartTag] = {}
        """Start tags that are not well formed, by their place in the order."""
        self.wellformed = ""
        """The text written anew; empty for one that needs it not."""

    def place(self, index: int) -> ElementPlace:
        return ElementPlace(self.starts[index], self.ends[index], self.closes[index], self.close_ends[index])

    def inside(self, index: int, tag: StartTag) -> tuple[int, int]:
        """From after an element's start tag to where, at the latest, its first text ends."""
        return self.ends[index], self.closes[index]


# The scan of a text that is known to be well formed: no more of it than is asked for.


_START = re.compile(r"<(?![/!?])")
_ASIDE = re.compile(r"<!--[\s\S]*?-->|<!\[CDATA\[[\s\S]*?\]\]>|<\?[\s\S]*?\?>")
"""Where a ``<`` may be that does not begin a tag."""
MARKUP = re.compile(
    r"<(?:!--[\s\S]*?--|!\[CDATA\[[\s\S]*?\]\]|\?[\s\S]*?\?|(/)[^>]*"
    r"|[^\s>/\"'!?][^>/\"']*(?:\"[^\"]*\"[^>/\"']*|'[^']*'[^>/\"']*|/(?!>))*(/)?)>"
)


class QuickScan(Scan):
    """Places of start tags and comments at once; ends of tags, and which belong together, when asked for."""

    __slots__ = ("_source",)

    def __init__(self, source: Source) -> None:
        text = source.text
        self._source = source
        asides = [match.span() for match in _ASIDE.finditer(text)]
        self.comments = [aside for aside in asides if text.startswith("<!--", aside[0])]
        self.starts = [match.start() for match in _START.finditer(text)]
        for start, end in asides:
            if text.find("<", start + 1, end) >= 0:
                hidden = slice(bisect_right(self.starts, start), bisect_right(self.starts, end - 1))
                del self.starts[hidden]
        self.problems, self.doubtful, self.odd, self.wellformed = [], [], {}, ""

    def __getattr__(self, name: str) -> Any:
        if name not in {"ends", "closes", "close_ends"}:
            raise AttributeError(name)
        self._pair()
        return getattr(self, name)

    def inside(self, index: int, tag: StartTag) -> tuple[int, int]:
        # A search inside a tag ends with the next tag at the latest.
        return tag.end, tag.end if tag.empty else len(self._source.text)

    def _pair(self) -> None:
        """Find the ends of the start tags, and the end tags; wrong, but not endless, if it is not well formed."""
        text = self._source.text
        ends: list[int] = []
        closes: list[int] = []
        close_ends: list[int] = []
        unclosed: list[int] = []
        for match in MARKUP.finditer(text):
            at, end = match.span()
            kind = match.lastindex
            if kind == 1:
                if unclosed:
                    index = unclosed.pop()
                    closes[index], close_ends[index] = at, end
            elif text[at + 1] not in "!?":
                if kind is None:
                    unclosed.append(len(ends))
                ends.append(end)
                closes.append(end)
                close_ends.append(end)
        lacking = [len(text)] * (len(self.starts) - len(ends))
        self.ends, self.closes, self.close_ends = ends + lacking, closes + lacking, close_ends + lacking


def quick_scan(source: Source) -> Scan:
    """The scan of a well-formed text."""
    return QuickScan(source)


def parse_start_tag(source: Source, at: int) -> tuple[StartTag, list[Problem]]:
    """Parse the start tag whose ``<`` is at ``at``; always returns one, and what is wrong with it."""
    match = START.match(source.text, at)
    if match is None or not has_names(match):
        from sdfcheck.source.scanner.broken_tag import parse_broken_tag

        return parse_broken_tag(source, source.text, at)
    tag = tag_of(match)
    return tag, repeated_attributes(source, tag)
