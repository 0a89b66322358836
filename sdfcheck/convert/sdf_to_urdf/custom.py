"""Custom elements and attributes: carried over for their consumers, spelled as they are in URDF."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.references import follow_names
from sdfcheck.convert.sdf_to_urdf.vendor_tags import VendorTags
from sdfcheck.convert.writer import Node, copied, declare, undeclared_prefixes
from sdfcheck.formats.sdf.survey import PARAMETERS
from sdfcheck.formats.vendor import BUILT_IN, prefix_of
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.element import Element

_OF_URDF = frozenset(("urdf:ros2_control", "urdf:transmission"))
"""The parts that the conversion from URDF to SDFormat keeps of a robot under a prefix."""


def carry_custom(context: Context, node: Node, element: Element | None, scope: str) -> None:
    """Write the custom attributes and children of an element of a nested model ``scope`` into its equal."""
    if element is None:
        return
    for name, text in element.attributes.items():
        if ":" not in name:
            continue
        declare(node, element, name.partition(":")[0], context.namespaces)
        _carry_attribute(context, node, element, name, text, VendorTags(context, scope))
    for child in element.children():
        if not child.is_custom or child.name == PARAMETERS:
            continue
        if node is context.root and child.name in _OF_URDF:
            _give_back(context, child)
            continue
        if VendorTags(context, scope).put(child, node):
            continue
        copy = copied(child)
        for prefix in {child.name.partition(":")[0], *undeclared_prefixes(copy)}:
            declare(copy, child, prefix, context.namespaces)
        follow_names(context, copy, child, scope)
        node.append(copy)
        message = f"`{child.name}` is carried over for those who read it; poses in it are not translated"
        context.ledger.copy(child)
        context.ledger.note(LossKind.KEPT_AS_EXTENSION, child, message, Severity.INFO)


def _carry_attribute(
    context: Context, node: Node, element: Element, name: str, text: str, tags: VendorTags
) -> None:
    if tags.is_ignored(name):
        message = (
            f"attribute `{name}` of {element.title} is left out: it is ignored here, and would not be in URDF"
        )
        context.ledger.lose_attribute(element, name, message)
    elif node.attributes.get(name) == text:
        context.ledger.take(element, name)  # one for both
    elif node.attributes.setdefault(name, text) == text:
        context.ledger.copy_attribute(element, name)
    else:
        message = f"attribute `{name}` of {element.title} is left out: there is another one"
        context.ledger.lose_attribute(element, name, message)


def _give_back(context: Context, element: Element) -> None:
    """Write what came from URDF, and means something there only, as it was."""
    copy = copied(element)
    for name in [name for name in copy.attributes if name.startswith("xmlns:urdf")]:
        del copy.attributes[name]
    copy.name = element.name.partition(":")[2]
    follow_names(context, copy, element, "")
    context.root.append(copy)
    context.ledger.take_whole(element)


def carry_parts(context: Context, node: Node, element: Element, scope: str, *parts: str) -> None:
    """The same for an element and parts of it that are written: ``pose=origin`` where URDF calls them otherwise."""
    carry_custom(context, node, element, scope)
    for part in parts:
        name, _, counterpart = part.partition("=")
        own = element.find(name)
        if own is None or not has_custom(own):
            continue
        # An origin may be empty; a limit may not.
        equal = node.reach(counterpart) if counterpart == "origin" else node.find(counterpart or name)
        if equal is not None:
            carry_custom(context, equal, own, scope)


def has_custom(element: Element) -> bool:
    """Are there custom attributes or children that need an equal to hang on?"""
    return any(":" in name for name in element.attributes) or any(
        child.is_custom for child in element.children()
    )


def namespace_of(prefix: str) -> str:
    """The URI to declare for a prefix that its document does not declare."""
    known = (vendor(table, "urdf").namespace for table in BUILT_IN if prefix_of(table) == prefix)
    return next(known, f"urn:{prefix}")
