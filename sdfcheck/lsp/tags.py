"""The tags around a place: the two names that are edited as one, and the ranges to which a selection grows."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.lsp.cursor import Part, at, elements
from sdfcheck.source.document import Document, Element
from sdfcheck.source.text import Span

NAME_PATTERN = r"[^\s<>/\"'=]+"
"""The names that stay linked while they are edited."""

_WORD = re.compile(r"\$\{[^}]*\}|\$\([^)]*\)|[\w.+:-]+")


def linked(document: Document, offset: int) -> tuple[Span, Span] | None:
    """The names in the start tag and the end tag of an element, at one of which a place is."""
    cursor = at(document, offset)
    if cursor is None or cursor.part is not Part.NAME:
        return None
    start, end = document.spans.name(cursor.element), document.spans.end_name(cursor.element)
    return (start, end) if end is not None and start.text == end.text else None


def selections(document: Document, offset: int) -> list[Span]:
    """The ranges around a place, the smallest first, each within the next."""
    found = [document.source.span(offset, offset)]
    for span in _around(document, offset):
        last = found[-1]
        if span.start <= last.start and last.end <= span.end and span != last:
            found.append(span)
    return found[1:] or found


def _around(document: Document, offset: int) -> Iterator[Span]:
    source = document.source
    if (cursor := at(document, offset)) is not None:
        if cursor.part in {Part.VALUE, Part.TEXT}:
            words = _WORD.finditer(source.text, cursor.span.start, cursor.span.end)
            yield from (source.span(*word.span()) for word in words if word.start() <= offset <= word.end())
        yield cursor.span
        if cursor.attribute:
            whole = document.spans.attribute_whole(cursor.element, cursor.attribute)
            yield source.span(whole.end - len(whole.text.lstrip()), whole.end)
    yield from (source.span(start, end) for start, end in document.scan.comments if start < offset < end)
    element = None if document.root is None else elements(document).around(offset)
    while element is not None:
        yield from _of_element(element)
        element = element.parent
    yield source.span(0, len(source.text))


def _of_element(element: Element) -> Iterator[Span]:
    """Its start tag, its end tag, what is between them, and all of it."""
    place = element.document.spans.place(element)
    source = element.document.source
    yield source.span(place.start, place.end)
    if place.close > place.end:
        yield source.span(place.end, place.close)
    yield source.span(place.close, place.close_end)
    yield source.span(place.start, place.close_end)
