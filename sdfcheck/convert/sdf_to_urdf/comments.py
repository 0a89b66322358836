"""Comments go where what they speak of goes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import takewhile

from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.writer import Node
from sdfcheck.source.element import Comment, Element
from sdfcheck.source.element import Node as Written


def carry_comments(context: Context, node: Node, element: Element) -> None:
    """Write the comments right before an element at the end of a node."""
    before = reversed(element.before)
    found = list(takewhile(lambda each: isinstance(each, Comment), before))
    node.children.extend(_taken(context, reversed(found)))


def carry_inside(context: Context, node: Node, element: Element) -> None:
    """Write what comments an element has that are not written yet at the start of a node."""
    node.children[:0] = _taken(context, _below(element))


def carry_around(context: Context, node: Node, model: Element) -> None:
    """Write the comments of a model that are before no written element: at the start, or at the end."""
    written = ("link", "joint", "model", "include", "frame")
    last = next((child for child in reversed(list(model.children())) if child.name in written), None)
    node.children.extend(_taken(context, last.after if last is not None else ()))
    node.children[:0] = _taken(context, model.nodes)


def around_root(element: Element, *, preceding: bool) -> list[Comment]:
    """The comments before or after the root of a document."""
    document = element.document
    nodes = document.prolog if preceding else document.epilog
    return [node for node in nodes if isinstance(node, Comment)]


def _below(element: Element) -> Iterator[Written]:
    """All nodes in an element, in the order of the document."""
    for node in element.nodes:
        yield node
        if isinstance(node, Element):
            yield from _below(node)


def _taken(context: Context, nodes: Iterable[Written]) -> list[Comment]:
    """The comments among nodes that are not written yet."""
    return [node for node in nodes if isinstance(node, Comment) and context.ledger.take_comment(node)]
