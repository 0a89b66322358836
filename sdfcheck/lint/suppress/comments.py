"""Comments that may be directives of sdfcheck, and the elements after them."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from itertools import islice

from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.text import Source, Span

MARK = "sdfcheck:"


class Comment(NamedTuple):
    """A comment, and what it covers of the element after it: see :func:`reach`."""

    span: Span
    target: Span | None


def comments(source: Source, scan: Scan) -> list[Comment]:
    """The comments of a text that hold a word for sdfcheck."""
    text = source.text
    found = []
    for start, end in scan.comments:
        if MARK not in text[start:end]:
            continue
        number = bisect_left(scan.starts, end)
        target = source.span(*reach(source, scan, number)) if number < len(scan.starts) else None
        found.append(Comment(source.span(start, end), target))
    return found


def touched(comments: Sequence[Comment], span: Span) -> Iterator[Comment]:
    """Those of the comments of one text, in its order, of which a change of a place changes something."""
    for comment in islice(comments, bisect_right(comments, span.start, key=lambda each: each.span.end), None):
        if comment.span.start >= span.end:
            break
        yield comment


def reach(source: Source, scan: Scan, number: int) -> tuple[int, int]:
    """The reach of a comment before an element: its start tag, and all of a leaf or an include."""
    place = scan.place(number)
    is_leaf = number + 1 == len(scan.starts) or scan.starts[number + 1] >= place.close_end
    is_whole = is_leaf or is_include(source, place.start)
    return place.start, place.close_end if is_whole else place.end


def is_include(source: Source, start: int) -> bool:
    """Is the element that starts there one that brings in another file?"""
    return source.text.startswith("<include", start)


def includes(source: Source, scan: Scan) -> list[Span]:
    """The elements that bring in other files."""
    return [
        source.span(start, scan.close_ends[number])
        for number, start in enumerate(scan.starts)
        if is_include(source, start)
    ]
