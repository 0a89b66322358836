"""Comments go where what they speak of goes."""

from __future__ import annotations

from lxml import etree

from sdfcheck.convert.writer import Node, comment_of
from sdfcheck.source.element import Element


def carry_comments(node: Node, element: Element, *, inside: bool = False) -> None:
    """Write the comments right before an element, or those directly in it."""
    if inside:
        found = [comment for child in element if (comment := comment_of(child)) is not None]
    else:
        found = []
        before = element.getprevious()
        while isinstance(before, etree._Comment):
            if (comment := comment_of(before)) is not None:
                found.insert(0, comment)
            before = before.getprevious()
    node.children.extend(found)
