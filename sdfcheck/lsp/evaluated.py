"""The values of xacro's expressions: those of the last expansion, else of plain arithmetic with known properties."""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from sdfcheck.lsp.cursor import Cursor
from sdfcheck.lsp.names.expanded import expansions, pieces, roots_of
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.source.document import Document, Element
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import matches
from sdfcheck.xacro.origins import ExpandedDocument
from sdfcheck.xacro.static.definitions import Definitions, visible_definitions

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
