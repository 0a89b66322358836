"""Facts about a named part of a robot: its place, its mass, the parts that are joined to it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, cast

from sdfcheck.lsp.names.index import descriptions_for
from sdfcheck.lsp.signature import described, macro_of
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, symbol_of
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Joint, Link
    from sdfcheck.robot.motion.mass import MassProperties
    from sdfcheck.robot.part import Node


def of_symbol(document: Document, named: Occurrence) -> Iterator[str]:
    """The facts about a name, a paragraph each."""
    symbol = named.symbol
    where = "" if symbol.span.source is document.source else f" ({symbol.span.source.path.name})"
    yield f"**{symbol.kind} `{symbol.name}`**{where}"
    if document.kind is Kind.XACRO:
        yield from _of_xacro(document, symbol)
        return
    plain = [each for each in descriptions_for(document) if each.kind is Kind.URDF]
    node = _node(plain[0] if plain else document, named)
    if node is not None:
        if node.scoped_name != symbol.name:
            yield f"`{node.scoped_name}`"
        yield from _poses(node)
        if node.kind == "link":
            yield from _masses(cast("Link", node))
        elif node.kind == "joint":
            yield from _joint(cast("Joint", node))


def _of_xacro(document: Document, symbol: Symbol) -> Iterator[str]:
    from sdfcheck.lsp.cursor import at

    source = symbol.span.source
    cursor = at(document, symbol.span.start) if source is document.source else None
    text = source.line(symbol.span.begin.line).strip()
    if symbol.kind in {"property", "argument", "macro", "parameter"}:
        yield f"set in line {symbol.span.begin.line}: `{text.replace('`', ' ')}`"
    if symbol.kind == "macro" and (macro := macro_of(document, symbol.name)) is not None:
        yield from described(macro)
    if (
        cursor is not None
        and symbol.kind == "property"
        and (value := cursor.element.attribute("value")) is not None
    ):
        yield f"value `{value.text}`" if value.text else "value: empty"


def _node(document: Document, named: Occurrence) -> Node | None:
    """The node that a name means, in the scope that the file itself sees."""
    symbol = named.symbol
    if symbol.kind not in {"link", "joint", "frame", "model", "world"}:
        return None
    if (written := _written(document, symbol)) is not None:
        return written
    for scope in root_of(document).scopes:
        joints = scope.joints if document.kind is Kind.URDF else ()  # which are no nodes there
        for node in (scope, *(node for _, node in scope.all_nodes()), *joints):
            if _matches(node, symbol):
                return node
    return None


def _written(document: Document, symbol: Symbol) -> Node | None:
    """The node of an element that a document writes."""
    from sdfcheck.robot.part import Node

    element = element_of(document, symbol) if symbol.span.source is document.source else None
    part = None if element is None else root_of(document).part_of(element)
    return part if isinstance(part, Node) and _matches(part, symbol) else None


def _matches(node: Node, symbol: Symbol) -> bool:
    own = symbol_of(node)
    return own is not None and own.key == symbol.key and node.kind == symbol.kind


def _poses(node: Node) -> Iterator[str]:
    if node.kind == "world":
        return
    try:
        own, outer = node.pose(), node.pose("world")
    except DescriptionError as error:
        yield f"its pose is not known: {error}"
        return
    yield f"in its {getattr(node.holder, 'kind', '') or 'model'}: {_pose(own.xyz, own.rpy)}"
    if _pose(own.xyz, own.rpy) != _pose(outer.xyz, outer.rpy):
        yield f"in the world: {_pose(outer.xyz, outer.rpy)}"


def _pose(xyz: Sequence[float], rpy: Sequence[float]) -> str:
    place = " ".join(_number(each) for each in xyz)
    if not any(abs(angle) > 1e-9 for angle in rpy):
        return f"`{place}` m"
    turn = " ".join(_number(math.degrees(each)) for each in rpy)
    return f"`{place}` m, rpy `{turn}`°"


def _number(value: float) -> str:
    return f"{round(value, 6) + 0.0:g}"


def _masses(link: Link) -> Iterator[str]:
    try:
        own = link.mass_properties
    except DescriptionError as error:
        yield f"its mass is not known: {error}"
        return
    yield "no inertial" if own is None else _mass(own)
    below = [each for each in link.below() if each is not link]
    if not below:
        return
    try:
        bodies = [each.mass_properties for each in below]
    except DescriptionError:
        bodies = []
    total = sum(body.mass for body in bodies if body is not None)
    links = "1 link hangs" if len(below) == 1 else f"{len(below)} links hang"
    yield f"{links} on it: {_number(total)} kg"


def _mass(body: MassProperties) -> str:
    center = " ".join(_number(each) for each in body.center.tolist())
    moments = " ".join(f"{body.moments[n, n]:.4g}" for n in range(3))
    return f"{_number(body.mass)} kg, center of mass `{center}` m, ixx iyy izz `{moments}` kg·m²"


def _joint(joint: Joint) -> Iterator[str]:
    kind = joint.element.attributes.get("type", "") or "no type"
    yield f"{kind}: `{joint.parent_name or '?'}` → `{joint.child_name or '?'}`"
    if joint.type in {"revolute", "prismatic"}:
        low, high = joint.axis.limit.range
        unit = "rad" if joint.type == "revolute" else "m"
        yield f"from `{_number(low)}` to `{_number(high)}` {unit}"


def element_of(document: Document, symbol: Symbol) -> Element | None:
    """The element that gives a symbol its name, in the document itself."""
    from sdfcheck.lsp.cursor import at

    cursor = at(document, symbol.span.start)
    return None if cursor is None else cursor.element
