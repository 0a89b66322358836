"""The facts about a place, as Markdown: documentation, parts of the robot, values, and the call of a macro."""

from __future__ import annotations

import ast
import math
import operator
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from sdfcheck.formats import plugins
from sdfcheck.formats.describe import HOW_OFTEN, Description, Spot, describe_custom, spot, summary
from sdfcheck.formats.sdf.survey import version_of
from sdfcheck.formats.vendor import known_tables
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lsp.context import Context, Where, context, without_conditions
from sdfcheck.lsp.cursor import Cursor, at
from sdfcheck.lsp.names import descriptions_for, expansions, is_made, occurrences, pieces, roots_of
from sdfcheck.lsp.outline import target_of
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, symbol_of
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Comment, Document, Element
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import KEYWORDS, PREFIX, Parameter, matches
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.static.definitions import Definitions, Macro, visible_definitions

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Joint, Link
    from sdfcheck.robot.motion.mass import MassProperties
    from sdfcheck.robot.part import Node


# The parameters of a macro, while its call is typed.


class Signature(NamedTuple):
    """A call as it could be written; ``parameters`` are places in the label, ``active`` the number of one."""

    label: str
    parameters: tuple[tuple[int, int], ...]
    notes: tuple[str, ...]
    """A note about each parameter."""
    active: int | None
    story: str
    """The comment before the macro."""


def signature(workspace: Workspace, buffer: Buffer, offset: int) -> Signature | None:
    """The macro whose call is being typed at a place."""
    place = context(buffer.source.text, offset, buffer.checkpoints)
    if place.where not in {Where.ATTRIBUTE, Where.VALUE} or not place.tag.startswith(PREFIX):
        return None
    name = place.tag.removeprefix(PREFIX)
    if name == "call":
        name = dict(place.given).get("macro", "")
    document = workspace.document(buffer.path)
    macro = None if document is None or name in KEYWORDS else macro_of(document, name)
    return None if macro is None else _signature(macro, place)


def macro_of(document: Document, name: str) -> Macro | None:
    """The macro that a call in a document means."""
    known = visible_definitions(document).macros
    found = known.get(name) or known.get(name.rpartition(".")[2])
    return found[-1] if found else None


def described(macro: Macro) -> Iterator[str]:
    """The comment before a macro, and its parameters."""
    if story := _story(macro):
        yield story
    if rows := [f"- `{_written(each)}`: {_note(each)}" for each in macro.parameters]:
        yield "\n".join(rows)


def _signature(macro: Macro, place: Context) -> Signature:
    label = f"{PREFIX}{macro.name}"
    places: list[tuple[int, int]] = []
    for parameter in macro.parameters:
        text = _written(parameter)
        places.append((len(label) + 1, len(label) + 1 + len(text)))
        label = f"{label} {text}"
    notes = tuple(map(_note, macro.parameters))
    return Signature(label, tuple(places), notes, _active(macro, place), _story(macro))


def _written(parameter: Parameter) -> str:
    if not parameter.is_optional:
        return parameter.name
    marks = ("^|" if parameter.default else "^") if parameter.forwards else ""
    return f"{parameter.name}:={marks}{parameter.default or ''}"


def _note(parameter: Parameter) -> str:
    if parameter.name.startswith("**"):
        return "all that an element inside of the call holds"
    if parameter.is_block:
        return "an element inside of the call"
    if parameter.forwards:
        return "if it is not given, that of the caller"
    return "required" if parameter.default is None else "optional"


def _active(macro: Macro, place: Context) -> int | None:
    """The parameter whose attribute is being typed, or else the first that is not given yet."""
    names = [parameter.name for parameter in macro.parameters]
    typed = place.attribute if place.where is Where.VALUE else ""
    if typed:
        return names.index(typed) if typed in names else None
    given = dict(place.given)
    return next((n for n, name in enumerate(names) if not name.startswith("*") and name not in given), None)


def _story(macro: Macro) -> str:
    last = next(macro.element.before, None)
    return " ".join(last.text.split()) if isinstance(last, Comment) else ""


# The values of xacro's expressions: those of the last expansion, else of plain arithmetic with known
# properties.


_MOST = 6
_DEEPEST = 12
_LARGEST = 1e12
_OPERATORS: Mapping[type[ast.AST], Callable[..., Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
}
_FUNCTIONS = {
    name: getattr(math, name)
    for name in "acos asin atan atan2 ceil cos degrees fabs floor hypot radians sin sqrt tan".split()
} | {"abs": abs, "max": max, "min": min}


def expression_at(cursor: Cursor, offset: int) -> Span | None:
    """The expression or substitution of xacro at a place."""
    if cursor.value is None:
        return None
    span = cursor.span
    for match in matches(span.text):
        if match.start() <= offset - span.start <= match.end():
            return span.source.span(span.start + match.start(), span.start + match.end())
    return None


def values(workspace: Workspace, document: Document, cursor: Cursor, expression: Span) -> list[str]:
    """The values that an expression has, one for each way that leads there; empty where none is known."""
    found: dict[str, None] = {}
    for one in expansions(workspace, roots_of(document), only_known=True):
        if isinstance(one.document, ExpandedDocument):
            for value in _expanded(one.document, cursor):
                found.update(dict.fromkeys(_piece(cursor.span, value, expression)))
    if not found:
        match = next(matches(expression.text), None)
        known = None if match is None or match["code"] is None else number(match["code"], document)
        return [] if known is None else [str(known)]
    return list(found)[:_MOST]


def _expanded(document: ExpandedDocument, cursor: Cursor) -> Iterator[str]:
    """The texts that the elements which are written at a place have in that value."""
    place = (
        cursor.element.document.source.real_path,
        cursor.element.document.scan.starts[cursor.element.index],
    )
    for element in document.view(_by_place).get(place, ()):
        if cursor.attribute:
            text = element.text_of(cursor.attribute)
            if text is not None:
                yield text
        else:
            yield element.content


def _by_place(document: Document) -> dict[tuple[str, int], list[Element]]:
    assert isinstance(document, ExpandedDocument)
    found: dict[tuple[str, int], list[Element]] = {}
    provenance = document.provenance
    for element in document.elements:
        source = provenance.source(element.index)
        found.setdefault((source.real_path, provenance.offset(element.index)), []).append(element)
    return found


def _piece(span: Span, value: str, expression: Span) -> Iterator[str]:
    """The part of a value that comes from an expression."""
    if expression == span:
        yield value.strip()
        return
    for piece in pieces(span.text.strip(), value.strip()):
        if not piece.is_literal and span.start + piece.start == expression.start:
            yield value.strip()[piece.first : piece.last]


def number(code: str, document: Document) -> float | int | None:
    """The value of arithmetic with numbers and with properties that have one value each; None if it is not that."""
    return _number(code, visible_definitions(document), 0)


def _number(code: str, visible: Definitions, depth: int) -> float | int | None:
    if depth > _DEEPEST or len(code) > 500:
        return None
    try:
        value = _of(ast.parse(code.strip(), mode="eval").body, visible, depth)
    except (SyntaxError, LookupError, ValueError, ArithmeticError, TypeError, RecursionError, MemoryError):
        return None
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return value if is_number and abs(value) < _LARGEST else None


def _of(node: ast.AST, visible: Definitions, depth: int) -> Any:
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        return node.value
    if isinstance(node, ast.BinOp):
        left, right = _of(node.left, visible, depth), _of(node.right, visible, depth)
        if isinstance(node.op, ast.Pow):
            return left**right if abs(right) < 20 and abs(left) < _LARGEST else math.nan
        return _OPERATORS[type(node.op)](left, right)
    if isinstance(node, ast.UnaryOp):
        return _OPERATORS[type(node.op)](_of(node.operand, visible, depth))
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
        return _FUNCTIONS[node.func.id](*(_of(each, visible, depth) for each in node.args))
    if isinstance(node, ast.Name):
        return math.pi if node.id == "pi" else _property(node.id, visible, depth)
    raise ValueError("not arithmetic")


def _property(name: str, visible: Definitions, depth: int) -> float | int:
    if name in visible.parameters:
        raise ValueError("a parameter has no value of its own")
    texts = {each.value or "" for read in visible.readings for each in read.properties if each.name == name}
    if len(texts) != 1:
        raise ValueError("not one value")
    text = texts.pop().strip()
    match = next(matches(text), None)
    code = match["code"] if match is not None and match[0] == text else text
    value = _number(code or "", visible, depth + 1)
    if value is None:
        raise ValueError("not a number")
    return value


# Facts about a named part of a robot: its place, its mass, the parts that are joined to it.


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
    if (written := _node_of(document, symbol)) is not None:
        return written
    for scope in root_of(document).scopes:
        joints = scope.joints if document.kind is Kind.URDF else ()  # which are no nodes there
        for node in (scope, *(node for _, node in scope.all_nodes()), *joints):
            if _matches(node, symbol):
                return node
    return None


def _node_of(document: Document, symbol: Symbol) -> Node | None:
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
    place = " ".join(_rounded(each) for each in xyz)
    if not any(abs(angle) > 1e-9 for angle in rpy):
        return f"`{place}` m"
    turn = " ".join(_rounded(math.degrees(each)) for each in rpy)
    return f"`{place}` m, rpy `{turn}`°"


def _rounded(value: float) -> str:
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
    yield f"{links} on it: {_rounded(total)} kg"


def _mass(body: MassProperties) -> str:
    center = " ".join(_rounded(each) for each in body.center.tolist())
    moments = " ".join(f"{body.moments[n, n]:.4g}" for n in range(3))
    return f"{_rounded(body.mass)} kg, center of mass `{center}` m, ixx iyy izz `{moments}` kg·m²"


def _joint(joint: Joint) -> Iterator[str]:
    kind = joint.element.attributes.get("type", "") or "no type"
    yield f"{kind}: `{joint.parent_name or '?'}` → `{joint.child_name or '?'}`"
    if joint.type in {"revolute", "prismatic"}:
        low, high = joint.axis.limit.range
        unit = "rad" if joint.type == "revolute" else "m"
        yield f"from `{_rounded(low)}` to `{_rounded(high)}` {unit}"


def element_of(document: Document, symbol: Symbol) -> Element | None:
    """The element that gives a symbol its name, in the document itself."""
    from sdfcheck.lsp.cursor import at

    cursor = at(document, symbol.span.start)
    return None if cursor is None else cursor.element


_MOST_CHOICES = 12
_FORMATS = {"srdf": "SRDF"}


class Hover(NamedTuple):
    """A text about a place, in Markdown."""

    text: str
    span: Span


def hover(
    document: Document, offset: int, found: Sequence[Diagnostic] = (), workspace: Workspace | None = None
) -> Hover | None:
    """The facts about a place; ``found`` are the diagnostics of the document, and a workspace has its expansions."""
    cursor = at(document, offset)
    if cursor is None:
        return None
    sections: list[str] = []
    named = occurrences(document).at(offset)
    span = cursor.span
    if named is not None:
        sections.append("\n\n".join(of_symbol(document, named)))
        span = named.span
    elif cursor.value is not None and (target := target_of(document, cursor.value)) is not None:
        sections.append(f"`{target}`" + _size(target))
    if workspace is not None and is_made(document):
        sections += _values(workspace, document, cursor, offset)
    description = describe_at(document, cursor)
    if description is not None:
        sections.append("\n\n".join(_described(description)))
    reactions = list(_reactions(cursor.span, found))
    if reactions:
        sections.append("\n".join(reactions))
    return Hover("\n\n---\n\n".join(filter(None, sections)), span) if any(sections) else None


def _values(workspace: Workspace, document: Document, cursor: Cursor, offset: int) -> Iterator[str]:
    """The values of the expression at a place, and of a whole name with expressions."""
    expression = expression_at(cursor, offset)
    places = [cursor.span] if expression is None and "$" in cursor.span.text else [expression]
    for place in places:
        if place is None or cursor.value is None:
            continue
        whole = cursor.span if place == cursor.span else place
        known = values(workspace, document, cursor, whole)
        if known:
            shown = ", ".join(f"`{value}`" for value in known)
            yield f"`{whole.text}` is {shown}"


def _size(path: Path) -> str:
    try:
        size = path.stat().st_size
    except OSError:
        return ""
    return "" if os.path.isdir(path) else f" ({size / 1024:.1f} kB)"


def names_around(element: Element) -> list[str]:
    """The names of the elements that lead to one, from the root's to its own."""
    names = [element.name]
    while (parent := element.parent) is not None:
        element = parent
        names.append(element.name)
    return names[::-1]


def spot_of(element: Element) -> Spot | None:
    """The definition at the place of an element; of one that came or went, another version's."""
    names = names_around(element)
    found = spot(names, version_of(element.document))
    return found if found is not None else spot(names)


def describe_at(document: Document, cursor: Cursor) -> Description | None:
    """The definition of the element or attribute at a place."""
    element, attribute = cursor.element, cursor.attribute
    names = list(without_conditions(names_around(element)))
    if names[-1:] != [element.name]:
        names.append(element.name)
    if element.name.startswith(PREFIX):
        own = element.name[len(PREFIX) :]
        return _in_words("xacro", [own], attribute) if own in KEYWORDS else None
    if document.kind is Kind.SRDF:
        return _in_words("srdf", names, attribute)
    is_urdf, tables = names[0] == "robot", known_tables(document.library)
    if attribute and ":" in attribute and not attribute.startswith("xmlns"):
        return describe_custom(f"@{attribute}", names, tables, is_urdf=is_urdf)
    if ":" in element.name:
        name = f"{element.name}/@{attribute}" if attribute else element.name
        return describe_custom(name, names[:-1], tables, is_urdf=is_urdf)
    if is_urdf and "ros2_control" in names:
        return _in_words("ros2_control", names[names.index("ros2_control") :], attribute)
    if "plugin" in names[:-1]:
        return _of_plugin(element, names)
    place = spot_of(element)
    return None if place is None else place.describe(attribute)


def _in_words(dialect: str, names: list[str], attribute: str) -> Description | None:
    """The facts about a place that the descriptions alone know."""
    inner = [*names, *([f"@{attribute}"] if attribute else [])]
    text = summary(dialect, inner)
    what = "attribute" if attribute else "element"
    return Description("/".join(inner), _FORMATS.get(dialect, dialect), what, summary=text) if text else None


def _of_plugin(element: Element, names: list[str]) -> Description | None:
    """A parameter of one of Gazebo's plugins."""
    plugin = next((each for each in element.around if each.name == "plugin"), None)
    path = "/".join(names[len(names) - names[::-1].index("plugin") :])
    for facts in () if plugin is None else plugins.known(plugin.attributes.get("filename", "")):
        if path not in facts.parameters and not any(path == naming.path for naming in facts.namings):
            continue
        naming = next((each for each in facts.namings if each.path == path), None)
        text = f"A parameter of `{facts.file}` ({facts.generation})."
        if naming is not None:
            text += f" It names a {naming.kind}" + (" by its scoped name." if naming.is_scoped else ".")
        if path in facts.required:
            text += " The plugin does not run without it."
        return Description(path, facts.generation, "parameter", summary=text)
    return None


def _described(one: Description) -> Iterator[str]:
    nature = f"deprecated {one.what}" if one.deprecated else one.what
    yield f"**`{one.name}`** · {one.format} {nature}"
    if one.summary:
        yield one.summary
    facts = [
        f"`{one.type}`" if one.type else "",
        f"in {one.unit}" if one.unit else "",
        f"default `{one.default}`" if one.default else "",
        f"range {one.range}" if one.range else "",
        _often(one),
        f"since {one.since}" if one.since else "",
        f"until {one.until}" if one.until else "",
    ]
    if line := ", ".join(filter(None, facts)):
        yield line
    if one.choices:
        shown = ", ".join(f"`{choice}`" for choice in one.choices[:_MOST_CHOICES])
        yield f"one of {shown}" + (", …" if len(one.choices) > _MOST_CHOICES else "")
    if one.successor:
        yield f"use `{one.successor}` instead"
    yield from one.notes


def _often(one: Description) -> str:
    if len(one.parents) != 1:
        return ""
    often = one.parents[0].multiplicity
    if one.what == "attribute":
        return "required" if often == "1" else "optional"
    return HOW_OFTEN.get(often, "")


def _reactions(span: Span, found: Sequence[Diagnostic]) -> Iterator[str]:
    """The reaction of each consumer to the defects here."""
    known = dict.fromkeys(
        (consumer, reaction.words)
        for diagnostic in found
        if diagnostic.span.start <= span.end and span.start <= diagnostic.span.end
        for consumer, reaction in diagnostic.affects
    )
    for consumer, words in known:
        yield f"- {consumer}: {words}"
