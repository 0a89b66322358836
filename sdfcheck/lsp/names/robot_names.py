"""The names in a file of SDFormat or URDF: of links, joints, frames, models and materials."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.formats.vendor import BUILT_IN, prefix_of
from sdfcheck.formats.vendor.definitions import Slot
from sdfcheck.lsp.names.symbol import Occurrence, Symbol, steps
from sdfcheck.robot.model import Model
from sdfcheck.robot.naming.references import references
from sdfcheck.robot.root import Root, root_of
from sdfcheck.robot.scope import Scope
from sdfcheck.robot.vendor.references import owner_of
from sdfcheck.robot.vendor.tags import values as vendor_values
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.robot.node import Node
    from sdfcheck.robot.part import Part

_NAMED = ("World", "Model", "Link", "Joint", "Frame")


def robot_names(document: Document) -> Iterator[Occurrence]:
    """Every place in a document where something of the robot is named, definitions first."""
    root = root_of(document)
    for kind in _NAMED:
        for node in root.each(kind):
            value = node.name_value
            if value is not None and value.text.strip() and node.element.document is document:
                yield from _defined(value, node.kind)
    for include in root.elements.get("include", ()):
        name = include.find("name")
        if name is not None and name.content:
            yield from _defined(name.own_value, "model")
    for value, nodes in references(root):
        for (span, before, after), node in zip(steps(value), nodes, strict=False):
            symbol = symbol_of(node)
            if symbol is not None and _names(span, before, after, value, symbol):
                yield Occurrence(span, symbol, False, before, after)
    yield from _materials(root)
    yield from _of_vendors(document, root)


def _defined(value: Value, kind: str) -> Iterator[Occurrence]:
    span = value.span
    trimmed = value.text.strip()
    start = span.start + len(span.text) - len(span.text.lstrip())
    if span.text.strip() == trimmed:
        span = span.source.span(start, start + len(trimmed))
    yield Occurrence(span, Symbol(kind, trimmed, span), True)


def _names(span: Span, before: str, after: str, value: Value, symbol: Symbol) -> bool:
    """Does the text have the symbol's own name? ``world`` and ``__model__`` name things that are called otherwise."""
    text = (
        value.text.strip()
        if span.text.strip() != value.text.strip() and (before or after)
        else span.text.strip()
    )
    return text.removeprefix(before).removesuffix(after) == symbol.name


def symbol_of(node: Node) -> Symbol | None:
    """The symbol of a node, wherever its name is written; None where it is written nowhere."""
    value: Value | None = node.name_value
    if isinstance(node, Model) and node.include is not None:
        given = node.include.find("name")
        if given is not None and given.content:
            value = given.own_value
        elif node.element is node.include:
            value = None
    if value is None or not value.text.strip() or (value.attribute is None and not value.element.content):
        return None
    return next(_defined(value, node.kind)).symbol


def _materials(root: Root) -> Iterator[Occurrence]:
    """Materials of URDF, which visuals call by their names."""
    if not root.is_urdf:
        return
    for scope in root.scopes:
        assert isinstance(scope, Model)
        defined = scope.material_names.defined
        symbols: dict[str, Symbol] = {}
        for name, material in defined.items():
            value = material.name_value
            if value is not None:
                occurrence = next(_defined(value, "material"))
                symbols[name] = occurrence.symbol
                yield occurrence
        parts: list[Part] = [*scope.materials]
        parts += [visual.own_material for link in scope.links for visual in link.visuals]
        for part in parts:
            value = part.name_value
            if value is None or value.text not in symbols or part is defined[value.text]:
                continue
            yield Occurrence(value.span, symbols[value.text])


def _of_vendors(document: Document, root: Root) -> Iterator[Occurrence]:
    """The parts that vendors' own elements name."""
    used = [path for path in BUILT_IN if f"{prefix_of(path)}:" in document.source.text]
    for found in vendor_values(document, used):
        owner = owner_of(found.value.element) if found.slot.references else None
        if owner is not None:
            yield from _of_tag(found.value, found.slot, owner, root)


def _of_tag(value: Value, slot: Slot, owner: Element, root: Root) -> Iterator[Occurrence]:
    """The target of one value of a vendor's tag: another such tag, or a part of the robot."""
    own = {kind for kind in slot.references if ":" in kind}
    for kind in own:
        for tag in owner.children(kind):
            name = tag.attribute("name")
            if name is None or not name.text.strip():
                continue
            definition = next(_defined(name, kind))
            yield definition
            if name.text.strip() == value.text.strip():
                yield Occurrence(value.span, definition.symbol)
    scope = root.scopes[0] if root.is_urdf else root.part_of(owner)
    if isinstance(scope, Scope) and len(own) < len(slot.references):
        yield from _path(scope, value)


def _path(scope: Scope, value: Value) -> Iterator[Occurrence]:
    at: Node | None = scope
    for (span, before, after), name in zip(steps(value), value.text.strip().split("::"), strict=True):
        at = at.resolve(name) if isinstance(at, Scope) else None
        symbol = symbol_of(at) if at is not None and at is not scope else None
        if symbol is not None and symbol.name == name:
            yield Occurrence(span, symbol, False, before, after)
