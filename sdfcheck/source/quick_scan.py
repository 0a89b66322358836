"""The same scan for a text that is known to be well formed: five times as fast."""

from __future__ import annotations

import re

from sdfcheck.source.scan import Scan
from sdfcheck.source.text import Source

_MARKUP = re.compile(
    r"<(?:(!--)[\s\S]*?--|!\[CDATA\[[\s\S]*?\]\]|\?[\s\S]*?\?|(/)[^>]*"
    r"|[^\s>/\"'!?][^>/\"']*(?:\"[^\"]*\"[^>/\"']*|'[^']*'[^>/\"']*|/(?!>))*(/)?)>"
)


def quick_scan(source: Source) -> Scan:
    """Places of elements and comments; wrong, but not endless, on a text that is not well formed."""
    result = Scan()
    starts, ends, closes, close_ends = result.starts, result.ends, result.closes, result.close_ends
    unclosed: list[int] = []
    for match in _MARKUP.finditer(source.text):
        at, end = match.span()
        kind = match.lastindex
        if kind == 2:
            index = unclosed.pop()
            closes[index], close_ends[index] = at, end
        elif kind == 1:
            result.comments.append((at, end))
        elif source.text[at + 1] not in "!?":
            if kind is None:
                unclosed.append(len(starts))
            starts.append(at)
            ends.append(end)
            closes.append(end)
            close_ends.append(end)
    return result
