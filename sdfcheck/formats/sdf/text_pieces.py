"""Texts that an element holds in several pieces, and which of them consumers ignore."""

from __future__ import annotations

import re

from sdfcheck.source.document import Aside, Element, Value
from sdfcheck.source.text import Span

_PIECE = re.compile(r"<!--.*?(?:-->|\Z)|<!\[CDATA\[.*?(?:\]\]>|\Z)|<\?.*?(?:\?>|\Z)|([^<]+)|<", re.DOTALL)


def part(value: Value, start: int, end: int) -> Span:
    """The place of a part of a value; all of it where the file has another text (entities, an expression)."""
    span = value.span
    if value.text in {span.text, blanks_as_spaces(span.text)}:
        return value.element.document.spans.span(value.element, span.start + start, span.start + end)
    return span


def blanks_as_spaces(text: str) -> str:
    """The value that a parser makes of the text of an attribute, entities aside."""
    return text.replace("\r\n", " ").translate({ord(blank): " " for blank in "\t\n\r"})


def cut_text(element: Element) -> Span | None:
    """The text after a comment in the middle of a value, which no consumer sees."""
    pieces = [element.text, *(node.tail for node in element.nodes if isinstance(node, Aside))]
    filled = [piece for piece in pieces if piece.strip()]
    if len(filled) < 2:
        return None
    spans = element.document.spans
    place = spans.place(element)
    first = spans.text(element)
    for piece in _PIECE.finditer(spans.home(element).text, first.end, place.close):
        if (found := _filled(piece)) is not None:
            return spans.span(element, *found)
    return None


def stray_line(element: Element) -> Span | None:
    """The first line of the text between an element's children; None if it is in CDATA sections only.

    A CDATA section beside elements is a way to write notes, never a value.
    """
    spans = element.document.spans
    if element.document.is_expanded:
        return spans.text(element)  # the children may have been written elsewhere
    source = element.document.source
    place = spans.place(element)
    edges = [place.end]
    for child in element.children():
        edges += [spans.place(child).start, spans.place(child).close_end]
    edges.append(place.close)
    for start, end in zip(edges[::2], edges[1::2], strict=True):
        for piece in _PIECE.finditer(source.text, start, end):
            if (found := _filled(piece)) is not None:
                line = source.text[slice(*found)].splitlines()[0].rstrip()
                return source.span(found[0], found[0] + len(line))
    return None


def _filled(piece: re.Match[str]) -> tuple[int, int] | None:
    """Where the text of a piece begins and ends; None if it is blank, or no text."""
    text = piece[1] or ""
    if not text.strip():
        return None
    start = piece.start(1) + len(text) - len(text.lstrip())
    return start, start + len(text.strip())
