"""The scan of a text that is known to be well formed: no more of it than is asked for."""

from __future__ import annotations

import re
from bisect import bisect_right
from typing import Any

from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.scanner.start_tag import StartTag
from sdfcheck.source.text import Source

_START = re.compile(r"<(?![/!?])")
_ASIDE = re.compile(r"<!--[\s\S]*?-->|<!\[CDATA\[[\s\S]*?\]\]>|<\?[\s\S]*?\?>")
"""Where a ``<`` may be that does not begin a tag."""
MARKUP = re.compile(
    r"<(?:!--[\s\S]*?--|!\[CDATA\[[\s\S]*?\]\]|\?[\s\S]*?\?|(/)[^>]*"
    r"|[^\s>/\"'!?][^>/\"']*(?:\"[^\"]*\"[^>/\"']*|'[^']*'[^>/\"']*|/(?!>))*(/)?)>"
)


class QuickScan(Scan):
    """Places of start tags and comments at once; ends of tags, and which belong together, when asked for."""

    __slots__ = ("_asides", "_source")

    def __init__(self, source: Source) -> None:
        text = source.text
        self._source = source
        self._asides = [match.span() for match in _ASIDE.finditer(text)]
        self.comments = [aside for aside in self._asides if text.startswith("<!--", aside[0])]
        self.starts = [match.start() for match in _START.finditer(text)]
        for start, end in self._asides:
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
