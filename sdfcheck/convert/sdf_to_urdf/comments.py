"""Comments go where what they speak of goes."""

from __future__ import annotations

from collections.abc import Iterator

from lxml import etree

from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.writer import Comment, Node, comment_of
from sdfcheck.source.element import Element


def carry_comments(context: Context, node: Node, element: Element) -> None:
    """Write the comments right before an element at the end of a node."""
    found: list[etree._Comment] = []
    before = element.getprevious()
    while isinstance(before, etree._Comment):
        found.insert(0, before)
        before = before.getprevious()
    node.children.extend(_taken(context, iter(found)))


def carry_inside(context: Context, node: Node, element: Element) -> None:
    """Write what comments an element has that are not written yet at the start of a node."""
    node.children[:0] = _taken(context, element.iter(etree.Comment))


def carry_around(context: Context, node: Node, model: Element) -> None:
    """Write the comments of a model that are before no written element: at the start, or at the end."""
    written = ("link", "joint", "model", "include", "frame")
    last = next((child for child in reversed(list(model.children())) if child.name in written), None)
    comments = [child for child in model if isinstance(child, etree._Comment)]
    following = [] if last is None else [c for c in last.itersiblings() if isinstance(c, etree._Comment)]
    node.children.extend(_taken(context, iter(following)))
    node.children[:0] = _taken(context, iter(comments))


def around_root(element: Element, *, preceding: bool) -> list[Comment]:
    """The comments before or after the root of a document."""
    root = element.getroottree().getroot()
    found = [comment_of(node) for node in root.itersiblings(preceding=preceding)]
    comments = [comment for comment in found if comment is not None]
    return comments[::-1] if preceding else comments


def _taken(context: Context, comments: Iterator[etree._Element]) -> list[Comment]:
    """Those that are not written yet."""
    new = [comment for comment in comments if context.ledger.take_comment(comment)]
    return [written for comment in new if (written := comment_of(comment)) is not None]
