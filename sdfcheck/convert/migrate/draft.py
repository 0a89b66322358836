"""A description on its way to another version: nodes that change, and what they mean at the moment."""

from __future__ import annotations

import re
from collections.abc import Iterator

from lxml import etree

from sdfcheck.convert.loss import refusal
from sdfcheck.convert.migrate.node import Node
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.text import Source

_ENCODING = re.compile(
    r"""(<\?xml[^<>]*?encoding\s*=\s*["'])(?!utf-8["']|(?:us-)?ascii["'])[\w.:-]+""", re.IGNORECASE
)
_LONE = re.compile(r"(?<!\r)\n")


class Draft:
    """The nodes of a document, and the document that they make when written."""

    def __init__(self, document: Document) -> None:
        assert document.root is not None
        self.source = document
        self.root = _nodes(document)
        place = document.spans.place(document.root)
        # Results are written as UTF-8, whatever the source was.
        self._before = _ENCODING.sub(r"\1UTF-8", document.source.text[: place.start])
        self._after = document.source.text[place.close_end :]
        whole = document.source.text
        self._has_crlf = "\r\n" in whole and not _LONE.search(whole)
        self.document = document
        self._elements: dict[Node, Element] = {}
        self._nodes: dict[Element, Node] = {}
        self._pair()

    def text(self) -> str:
        text = self._before + self.root.text() + self._after
        return _LONE.sub("\r\n", text) if self._has_crlf else text

    def read(self) -> Document:
        """Read what has been written so far; nodes and elements know each other again."""
        if (text := self.text()) != self.document.source.text:
            document = Document(Source(self.source.path, text), self.source.kind, [])
            document.library = self.source.library
            document.included_by = self.source.included_by
            self.document = document
            self._pair()
        return self.document

    def element(self, node: Node) -> Element:
        """The element of a node, as of the last reading."""
        return self._elements[node]

    def node(self, element: Element) -> Node | None:
        """The node of an element; None for one of another file."""
        return self._nodes.get(element)

    def _pair(self) -> None:
        root = self.document.root
        assert root is not None
        elements: Iterator[Element] = root.iter(etree.Element)  # type: ignore[assignment]
        try:
            pairs = list(zip(self.root.walk(), elements, strict=True))
        except ValueError:
            # A parser guesses otherwise at broken text once something around it has changed.
            raise refusal(root, "the text is broken, so that it cannot be changed and read again") from None
        self._elements = dict(pairs)
        self._nodes = {element: node for node, element in pairs}


def _nodes(document: Document) -> Node:
    text, spans = document.source.text, document.spans

    def build(element: Element) -> Node:
        place = spans.place(element)
        node = Node(element.name, text[place.start : place.end], text[place.close : place.close_end], element)
        at = place.end
        for child in element.children():
            inner = build(child)
            start = spans.place(child)
            if start.start > at:
                node.parts.append(text[at : start.start])
            inner.parent = node
            node.parts.append(inner)
            at = start.close_end
        if place.close > at:
            node.parts.append(text[at : place.close])
        return node

    assert document.root is not None
    return build(document.root)


def copy(element: Element) -> Node:
    """The node of an element of another document, with its text."""
    return Draft(element.document).node(element) or Node(element.name)
