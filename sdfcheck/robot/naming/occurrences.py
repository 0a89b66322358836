"""Occurrences of names: every place where a description names a link, joint, frame, model or material.

Renaming, in the API and in the editor, finding references and definitions go by them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from sdfcheck.formats.vendor import used_tables
from sdfcheck.formats.vendor.definitions import Slot
from sdfcheck.robot.graph import Model, Scope
from sdfcheck.robot.naming.references import references
from sdfcheck.robot.part import Namespace
from sdfcheck.robot.root import Root, root_of
from sdfcheck.robot.vendor import owner_of
from sdfcheck.robot.vendor import values as vendor_values
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.robot.part import Node, Part

_NAMED = ("World", "Model", "Link", "Joint", "Frame")


class Symbol(NamedTuple):
    """Something with a name; ``span`` is where it gets it, which distinguishes it from others of that name."""

    kind: str
    """``link``, ``joint``, ``frame``, ``model``, ``world``, ``material``, ``macro``, ``property``, …"""
    name: str
    span: Span
    owner: str = ""
    """The link, or what else, in which no other of its kind has the name; empty: the robot."""

    @property
    def called(self) -> tuple[str, str]:
        """Its kind and name, which no other part of the robot has."""
        return f"{self.kind} in {self.owner}" if self.owner else self.kind, self.name

    @property
    def key(self) -> tuple[str, int]:
        """The identity of a symbol, the same however often its file is read."""
        return self.span.source.real_path, self.span.start


class Occurrence(NamedTuple):
    """A place where the name of a symbol is written.

    ``before`` and ``after`` is what the place holds around the name, where that cannot be taken apart.
    """

    span: Span
    symbol: Symbol
    is_definition: bool = False
    before: str = ""
    after: str = ""


def steps(value: Value) -> list[tuple[Span, str, str]]:
    """The parts of a scoped name: the place of each, and what comes before and after it in the place."""
    span, text = value.span, value.text.strip()
    names = text.split("::")
    if span.text.strip() != text:  # written with entities
        return [
            (
                span,
                "".join(f"{each}::" for each in names[:n]),
                "".join(f"::{each}" for each in names[n + 1 :]),
            )
            for n in range(len(names))
        ]
    start = span.start + len(span.text) - len(span.text.lstrip())
    found = []
    for name in names:
        found.append((span.source.span(start, start + len(name)), "", ""))
        start += len(name) + 2
    return found


class NodeName(NamedTuple):
    """A place that refers to a node by the node's own name; ``before`` and ``after`` as in :class:`Occurrence`."""

    span: Span
    node: Node
    before: str
    after: str


def node_names(root: Root) -> Iterator[NodeName]:
    """The places in a document that refer to nodes, without those that name them: ``world`` and ``__model__``
    name things that are called otherwise.
    """
    for value, nodes in references(root):
        yield from _named(value, nodes)
    yield from _of_vendors(root)


def _named(value: Value, nodes: Iterable[Node]) -> Iterator[NodeName]:
    names = value.text.strip().split("::")
    for (span, before, after), name, node in zip(steps(value), names, nodes, strict=False):
        if name == node.name:
            yield NodeName(span, node, before, after)


def robot_names(document: Document) -> Iterator[Occurrence]:
    """Every place in a document where something of the robot is named, definitions first."""
    root = root_of(document)
    for kind in _NAMED:
        for node in root.each(kind):
            value = node.name_value
            if value is not None and value.text.strip() and node.element.document.source is document.source:
                yield from _defined(value, node.kind)
    for include in root.elements.get("include", ()):
        name = include.find("name")
        if name is not None and name.content:
            yield from _defined(name.own_value, "model")
    for span, node, before, after in node_names(root):
        symbol = symbol_of(node)
        if symbol is not None and symbol.name == node.name:
            yield Occurrence(span, symbol, False, before, after)
    yield from _materials(root)
    yield from _in_links(root)
    yield from _vendor_names(root)


def _defined(value: Value, kind: str, owner: str = "") -> Iterator[Occurrence]:
    span = value.span
    trimmed = value.text.strip()
    start = span.start + len(span.text) - len(span.text.lstrip())
    if span.text.strip() == trimmed:
        span = span.source.span(start, start + len(trimmed))
    yield Occurrence(span, Symbol(kind, trimmed, span, owner), True)


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


def _in_links(root: Root) -> Iterator[Occurrence]:
    """Sensors and collisions of SDFormat; contact sensors name the collisions of their link."""
    if root.is_urdf:
        return
    known: dict[tuple[str, Element | None, str], Symbol] = {}
    for kind in ("collision", "sensor"):
        for element in root.elements.get(kind, ()):
            value = element.attribute("name")
            if value is not None and value.text.strip():
                occurrence = next(_defined(value, kind, _owner(element)))
                yield occurrence
                known.setdefault((kind, element.parent, occurrence.symbol.name), occurrence.symbol)
    for contact in root.each("Contact"):
        for value in contact.collision_names if contact.link is not None else ():
            symbol = known.get(("collision", contact.link.element, value.text.strip()))
            if symbol is not None:
                yield Occurrence(steps(value)[0][0], symbol)


def _owner(element: Element) -> str:
    """The elements around one by their names."""
    names = (each.attributes.get("name", "").strip() for each in element.around)
    return "::".join([*filter(None, names)][::-1])


def _vendor_values(root: Root) -> Iterator[tuple[Value, Slot, Element]]:
    """The values of vendors' elements that name something, and the model or robot that they are in."""
    for found in vendor_values(root.document, used_tables(root.document)):
        owner = owner_of(found.value.element) if found.slot.references else None
        if owner is not None:
            yield found.value, found.slot, owner


def _of_vendors(root: Root) -> Iterator[NodeName]:
    """The parts of the robot that vendors' own elements name."""
    for value, slot, owner in _vendor_values(root):
        scope = root.scopes[0] if root.is_urdf else root.part_of(owner)
        if isinstance(scope, Scope) and any(":" not in kind for kind in slot.references):
            yield from _named(value, _path(scope, value, slot))


def _path(scope: Scope, value: Value, slot: Slot) -> list[Node]:
    """The parts that a scoped name leads through; in URDF a joint may have the name of a link."""
    text = value.text.strip()
    if isinstance(scope, Model) and scope.is_urdf and slot.references == ("joint",):
        return [joint for joint in (scope.joints_by_name.get(text),) if joint is not None]
    found: list[Node] = []
    at: Node | None = scope
    for name in text.split("::"):
        at = at.resolve(name) if isinstance(at, Scope) else None
        if at is None:
            return []
        found.append(at)
    return found


def _vendor_names(root: Root) -> Iterator[Occurrence]:
    """Names that vendors' elements have themselves, such as groups, and the values that refer to these."""
    for value, slot, owner in _vendor_values(root):
        for kind in (kind for kind in slot.references if ":" in kind):
            for tag in owner.children(kind):
                name = tag.attribute("name")
                if name is None or not name.text.strip():
                    continue
                definition = next(_defined(name, kind))
                yield definition
                if name.text.strip() == value.text.strip():
                    yield Occurrence(value.span, definition.symbol)


def name_refusal(kind: str, former: str, name: str) -> str | None:
    """The reason why a part of a robot cannot have another name; None if it can."""
    is_reserved = name == "world" or (name.startswith("__") and name.endswith("__"))
    if not name.strip() or name != name.strip() or "::" in name or is_reserved:
        return f"`{name}` cannot be the name of a {kind}"
    if (kind, former) == ("link", "world"):
        return (
            "a link called `world` is the world to Gazebo, which would not hold the robot under another name"
        )
    return None


def taken_by(scope: Namespace, kind: str, name: str) -> Node | None:
    """The link, joint, frame or model of a scope that has a name already, for a part of this kind."""
    there = scope.nodes.get(name)
    if there is None and kind == "joint" and isinstance(scope, Model) and scope.is_urdf:
        there = scope.joints_by_name.get(name)
    return there
