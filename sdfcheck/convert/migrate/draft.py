"""A description on its way to another version: nodes that change, and what they mean at the moment."""

from __future__ import annotations

import re

from sdfcheck.convert.loss import refusal
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.result import with_text
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element

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
        self._pair()

    def text(self) -> str:
        text = self._before + self.root.text() + self._after
        return _LONE.sub("\r\n", text) if self._has_crlf else text

    def read(self) -> Document:
        """Read what has been written so far; nodes and elements know each other again."""
        if (text := self.text()) != self.document.source.text:
            self.document = with_text(self.source, text)
            self._pair()
        return self.document

    def element(self, node: Node) -> Element:
        """The element of a node, as of the last reading."""
        return self._elements[node]

    def _pair(self) -> None:
        root = self.document.root
        assert root is not None
        try:
            pairs = list(zip(self.root.walk(), root.walk(), strict=True))
        except ValueError:
            # A parser guesses otherwise at broken text once something around it has changed.
            raise refusal(root, "the text is broken, so that it cannot be changed and read again") from None
        self._elements = dict(pairs)


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
