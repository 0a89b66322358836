"""From an element to its characters."""

from __future__ import annotations

import re

from sdfcheck.source.element import Element
from sdfcheck.source.scanner.parse_tag import parse_start_tag
from sdfcheck.source.scanner.scan import ElementPlace, Scan
from sdfcheck.source.scanner.start_tag import AttributePlace, StartTag
from sdfcheck.source.text import Source, Span

_PIECE = re.compile(
    r"<!--.*?(?:-->|\Z)|<!\[CDATA\[(?P<cdata>.*?)(?:\]\]>|\Z)|<\?.*?(?:\?>|\Z)|(?P<markup><)|(?P<text>[^<]+)",
    re.DOTALL,
)
_WORD = re.compile(r"\S+")


class Spans:
    """Places of one document's elements, attributes and texts.

    Element number ``n`` of the tree, in document order, is start tag ``n`` of the scan.
    """

    __slots__ = ("scan", "source")

    def __init__(self, source: Source, scan: Scan) -> None:
        self.source = source
        self.scan = scan

    def place(self, element: Element) -> ElementPlace:
        """Offsets of the element's start and end tags in its :meth:`home`."""
        scan, index = self.found(element)
        return scan.place(index)

    def found(self, element: Element) -> tuple[Scan, int]:
        """The scan that has the element, and its number there."""
        return self.scan, element.index

    def home(self, element: Element) -> Source:
        """The text in which the element is."""
        return self.source

    def span(self, element: Element, start: int, end: int) -> Span:
        """A range of the text in which the element is."""
        return self.source.span(start, end)

    def name(self, element: Element) -> Span:
        tag = self.start_tag(element)
        return self.span(element, tag.name_start, tag.name_end)

    def whole(self, element: Element) -> Span:
        """From the start tag's ``<`` to after the end tag."""
        place = self.place(element)
        return self.span(element, place.start, place.close_end)

    def end_name(self, element: Element) -> Span | None:
        """The name in the end tag; None if there is no end tag."""
        place = self.place(element)
        if place.close == place.close_end:
            return None
        name = self.start_tag(element).name
        return self.span(element, place.close + 2, place.close + 2 + len(name))

    def start_tag(self, element: Element) -> StartTag:
        odd = self.scan.odd.get(element.index)
        return odd or parse_start_tag(self.source, self.scan.starts[element.index])[0]

    def attribute_name(self, element: Element, name: str) -> Span:
        place = self._attribute(element, name)
        return self.span(element, place.name_start, place.name_end) if place else self.name(element)

    def attribute_value(self, element: Element, name: str) -> Span:
        """The value between its quotes; the attribute's name where the value is empty."""
        place = self._attribute(element, name)
        if place is None:
            return self.name(element)
        if place.value_start == place.value_end:
            return self.span(element, place.name_start, place.name_end)
        return self.span(element, place.value_start, place.value_end)

    def attribute_whole(self, element: Element, name: str) -> Span:
        """Name, equals sign and quoted value, with the spaces before them: what deleting it takes."""
        place = self._attribute(element, name)
        if place is None:
            return self.name(element)
        text = self.home(element).text
        start = place.name_start
        while text[start - 1].isspace():
            start -= 1
        end = place.value_end
        if text[end : end + 1] in {'"', "'"}:
            end += 1
        return self.span(element, start, end)

    def text(self, element: Element) -> Span:
        """The text that simulators read, without spaces around it; the element's name if there is none."""
        scan, index = self.found(element)
        for piece in _PIECE.finditer(self.home(element).text, *scan.inside(index, self.start_tag(element))):
            if piece["markup"]:
                break
            group = "cdata" if piece["cdata"] is not None else "text"
            raw = piece[group] or ""
            if raw.strip():
                start = piece.start(group) + len(raw) - len(raw.lstrip())
                return self.span(element, start, start + len(raw.strip()))
        return self.name(element)

    def part(self, span: Span, index: int) -> Span:
        """The ``index``-th word inside a span; the whole span if it has fewer."""
        for number, word in enumerate(_WORD.finditer(span.source.text, span.start, span.end)):
            if number == index:
                return span.source.span(word.start(), word.end())
        return span

    def _attribute(self, element: Element, name: str) -> AttributePlace | None:
        return next((a for a in self.start_tag(element).attributes if a.name == name), None)
