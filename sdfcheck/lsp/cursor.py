"""The element at a place in a text, and which part of it."""

from __future__ import annotations

from bisect import bisect_right
from enum import Enum

from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span


class Part(Enum):
    """A part of an element."""

    NAME = "name"
    ATTRIBUTE = "attribute"
    VALUE = "value"
    TEXT = "text"


class Cursor(NamedTuple):
    """A part of an element at a place; ``attribute`` is empty but for attributes and their values."""

    element: Element
    part: Part
    span: Span
    attribute: str = ""

    @property
    def value(self) -> Value | None:
        """The value or text that the place is in."""
        if self.part is Part.VALUE:
            return self.element.attribute(self.attribute)
        return self.element.own_value if self.part is Part.TEXT else None


class Elements:
    """The elements of a document in its order, and which is around a place."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self.all = document.elements

    def around(self, offset: int) -> Element | None:
        """The innermost element whose tags or content are at a place."""
        scan = self.document.scan
        number = bisect_right(scan.starts, offset) - 1
        if number < 0 or number >= len(self.all):
            return None
        element: Element | None = self.all[number]
        spans = self.document.spans
        while element is not None:
            place = spans.place(element)
            if offset < place.close_end or (
                offset == place.close_end and place.close_end == place.close > place.end
            ):
                return element
            element = element.parent
        return None


def elements(document: Document) -> Elements:
    """The elements of a document, listed once."""
    return document.view(Elements)


def at(document: Document, offset: int) -> Cursor | None:
    """The part at a place; None between elements, in comments, and where the text was read by a guess."""
    if document.root is None:
        return None
    element = elements(document).around(offset)
    if element is None or any(start < offset < end for start, end in document.scan.comments):
        return None
    spans = document.spans
    tag = spans.start_tag(element)
    if tag.name_start <= offset <= tag.name_end:
        return Cursor(element, Part.NAME, spans.name(element))
    end = spans.end_name(element)
    if end is not None and end.start <= offset <= end.end:
        return Cursor(element, Part.NAME, end)
    for attribute in tag.attributes:
        if attribute.name_start <= offset <= attribute.name_end:
            span = document.source.span(attribute.name_start, attribute.name_end)
            return Cursor(element, Part.ATTRIBUTE, span, attribute.name)
        if attribute.value_start <= offset <= attribute.value_end:
            span = document.source.span(attribute.value_start, attribute.value_end)
            return Cursor(element, Part.VALUE, span, attribute.name)
    if element.content:
        text = spans.text(element)
        if text.start <= offset <= text.end:
            return Cursor(element, Part.TEXT, text)
    return None
