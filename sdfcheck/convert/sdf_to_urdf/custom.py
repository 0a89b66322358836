"""Custom elements: carried over as they are, for whoever reads them."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.writer import Node, copied
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.element import Element


def carry_custom(context: Context, node: Node, element: Element) -> None:
    """Write the custom children of an element into its equal."""
    for child in element.children():
        if not child.is_custom:
            continue
        prefix = child.name.partition(":")[0]
        uri = child.nsmap.get(prefix)
        if uri:
            context.root.attributes.setdefault(f"xmlns:{prefix}", uri)
        copy = copied(child)
        copy.attributes.pop(f"xmlns:{prefix}", None)
        node.append(_spelled(copy) if prefix == "drake" else copy)
        message = f"`{child.name}` is written as it is; names and poses in it are not translated"
        context.ledger.cover(child)
        context.ledger.note(LossKind.KEPT_AS_EXTENSION, child, message, Severity.INFO)


def _spelled(node: Node) -> Node:
    """As Drake has it in URDF: values are attributes."""
    if node.text and not node.children:
        node.attributes["value"], node.text = node.text, None
    for child in node.children:
        if isinstance(child, Node):
            _spelled(child)
    return node
