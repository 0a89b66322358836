"""Custom elements and attributes: carried over for whoever reads them, spelled as they are in URDF."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.references import follow_names
from sdfcheck.convert.writer import Node, copied
from sdfcheck.formats.vendor.definitions import Tag
from sdfcheck.formats.vendor.files import BUILT_IN, prefix_of
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.element import Element


def carry_custom(context: Context, node: Node, element: Element, scope: str) -> None:
    """Write the custom attributes and children of an element of a nested model ``scope`` into its equal."""
    for name, text in element.attributes.items():
        if ":" in name and not name.startswith("xml"):
            _declare(context, element, name)
            node.attributes[name] = text
    for child in element.children():
        if not child.is_custom:
            continue
        _declare(context, child, child.name)
        copy = copied(child)
        copy.attributes.pop(f"xmlns:{child.name.partition(':')[0]}", None)
        _spell(copy)
        follow_names(context, copy, child, scope)
        node.append(copy)
        message = f"`{child.name}` is carried over for those who read it; poses in it are not translated"
        context.ledger.cover(child)
        context.ledger.note(LossKind.KEPT_AS_EXTENSION, child, message, Severity.INFO)


def _declare(context: Context, element: Element, name: str) -> None:
    prefix = name.partition(":")[0]
    if uri := element.nsmap.get(prefix):
        context.root.attributes.setdefault(f"xmlns:{prefix}", uri)


def namespace_of(prefix: str) -> str:
    """What to declare for a prefix that its document does not declare."""
    known = (vendor(table, "urdf").namespace for table in BUILT_IN if prefix_of(table) == prefix)
    return next(known, f"urn:{prefix}")


def _spell(node: Node) -> None:
    """Let values be attributes where the readers of a known prefix look for them so in URDF."""
    for table in BUILT_IN:
        if node.name.startswith(f"{prefix_of(table)}:"):
            tag = vendor(table, "urdf").tags.get(node.name)
            if tag is not None:
                _move_values(node, tag)
    for child in node.children:
        if isinstance(child, Node):
            _spell(child)


def _move_values(node: Node, tag: Tag) -> None:
    carrier = next((place.carrier for place in tag.places if place.carrier.startswith("@")), "")
    if carrier and node.text and not node.children:
        node.attributes[carrier[1:]], node.text = node.text, None
    for part in [part for part in node.children if isinstance(part, Node)]:
        own = part.name.rpartition(":")[2]
        if own in tag.attributes and part.text and not part.children:
            node.attributes[own] = part.text
            node.children.remove(part)
