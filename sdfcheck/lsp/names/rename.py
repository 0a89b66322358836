"""Giving something another name, wherever it is named."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from sdfcheck.lint.fix import TextEdit
from sdfcheck.lsp.names.expanded import pieces
from sdfcheck.lsp.names.index import IN_XACRO, everywhere, is_made, occurrences
from sdfcheck.lsp.names.spread import Refused, Spread
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.robot.graph import Model, Scope
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, name_refusal, symbol_of, taken_by
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import IN_QUOTES, Span, escape
from sdfcheck.xacro.language import BUILT_IN, KEYWORDS
from sdfcheck.xacro.static.definitions import Definitions, Macro, visible_definitions

_IN_EXPRESSIONS = frozenset({"property", "parameter"})
_IDENTIFIER = re.compile(r"[^\W\d]\w*")
_XML_NAME = re.compile(r"[^\W\d][\w.-]*")


class Target(NamedTuple):
    """A name that can be given anew, and the piece of its place that a person writes: the rest are expressions."""

    named: Occurrence
    piece: Span


def target(document: Document, offset: int) -> Target | None:
    """The name that would be given anew at a place; of a name with expressions the literal piece there, or the nearest.

    Raises:
        Refused: all of the name is made by expressions.
    """
    named = occurrences(document).at(offset)
    if named is None:
        return None
    span = named.span
    if named.symbol.kind in IN_XACRO or not is_made(document) or "$" not in span.text:
        return Target(named, span)
    literal = [each for each in pieces(span.text) if each.is_literal]
    if not literal:
        words = [each for each in occurrences(document).all if _is_within(each.span, span)]
        if not words:
            raise Refused(f"`{span.text}` is made of expressions: rename what they take")
        word = min(words, key=lambda each: abs(each.span.start - offset))
        return Target(word, word.span)
    at = offset - span.start
    nearest = min(literal, key=lambda each: max(each.start - at, at - each.end, 0))
    return Target(named, span.source.span(span.start + nearest.start, span.start + nearest.end))


def _is_within(inner: Span, outer: Span) -> bool:
    return outer.start <= inner.start and inner.end <= outer.end and inner != outer


def rename(
    workspace: Workspace, document: Document, named: Occurrence, name: str, piece: Span | None = None
) -> list[TextEdit]:
    """The edits that give a symbol another name, in all files of the project; ``piece`` is the part that is replaced.

    Raises:
        Refused: the name is taken, or cannot be one; or the robots would not stay the same but for the name.
    """
    symbol, span = named.symbol, named.span
    piece = piece or span
    if name == (symbol.name if piece == span else piece.text):
        return []
    spread = Spread(workspace, document)
    if symbol.kind in IN_XACRO or not spread.is_needed:
        edits = _everywhere(workspace, document, symbol, name)
        spread.prove(edits)
        return edits
    text = span.text[: piece.start - span.start] + name + span.text[piece.end - span.start :]
    return spread.renamed(named, text)


def _everywhere(workspace: Workspace, document: Document, symbol: Symbol, name: str) -> list[TextEdit]:
    """The edits where a name is written the same way everywhere."""
    _check_form(symbol, name)
    found = everywhere(workspace, document, symbol)
    if not any(each.is_definition for each in found):
        raise Refused(f"no file is known that defines {symbol.kind} `{symbol.name}`")
    documents = {each.span.source.path: workspace.document(each.span.source.path) for each in found}
    for other in filter(None, documents.values()):
        _check_free(other, symbol, name)
    return [TextEdit(each.span, _written(each, name)) for each in found]


def _written(occurrence: Occurrence, name: str) -> str:
    return escape(f"{occurrence.before}{name}{occurrence.after}", IN_QUOTES)


def _check_form(symbol: Symbol, name: str) -> None:
    """Can this be a name at all?"""
    if symbol.kind in _IN_EXPRESSIONS and not _IDENTIFIER.fullmatch(name):
        raise Refused(f"`{name}` cannot be used in expressions: write letters, digits and underscores")
    if symbol.kind == "macro" and (not _XML_NAME.fullmatch(name) or name in KEYWORDS):
        raise Refused(f"`{name}` cannot be the name of an element")
    if symbol.kind in _IN_EXPRESSIONS and name in BUILT_IN:
        raise Refused(f"`{name}` means something else in expressions")
    if symbol.kind not in IN_XACRO and (reason := name_refusal(symbol.kind, name)) is not None:
        raise Refused(reason)
    if symbol.kind == "argument" and (not name or re.search(r"[\s$(){}]", name)):
        raise Refused(f"`{name}` cannot be the name of an argument")


def _check_free(document: Document, symbol: Symbol, name: str) -> None:
    """Is the name taken where the symbol is known?"""
    if document.kind is Kind.SRDF and not is_made(document):
        return  # it defines groups only
    taken = _taken_in_xacro if is_made(document) else _taken_in_robot
    for kind in taken(document, symbol, name):
        raise Refused(f"there is a {kind} `{name}` already in {document.path.name}")


def _taken_in_xacro(document: Document, symbol: Symbol, name: str) -> Iterator[str]:
    visible = visible_definitions(document)
    if symbol.kind == "macro":
        yield from ["macro"] * (name in visible.macros)
    elif symbol.kind == "argument":
        yield from ["argument"] * any(name in read.arguments for read in visible.readings)
    elif symbol.kind in _IN_EXPRESSIONS:
        yield from _taken_in_expressions(visible, symbol, name)
    else:
        others = (each.symbol for each in occurrences(document).all)
        yield from (other.kind for other in others if other.name == name and other.kind == symbol.kind)


def _taken_in_expressions(visible: Definitions, symbol: Symbol, name: str) -> Iterator[str]:
    """Would the name be taken for another, or another for it?"""
    macros = [macro for read in visible.readings for macro in read.macros]
    own = next((macro for macro in macros if _is_in(symbol, macro)), None)
    if own is not None:
        if name in own.words or name in _parameters_of(own):
            yield f"name in macro `{own.name}`"
        return
    if name in visible.properties:
        yield "property"
    for macro in macros:
        if symbol.name in macro.words and name in _parameters_of(macro):
            yield f"parameter of macro `{macro.name}`"


def _parameters_of(macro: Macro) -> set[str]:
    return {parameter.name.lstrip("*") for parameter in macro.parameters}


def _is_in(symbol: Symbol, macro: Macro) -> bool:
    """Is a symbol a macro's own: a parameter, or a property in its body?"""
    whole = macro.element.document.spans.whole(macro.element)
    return whole.source is symbol.span.source and whole.start < symbol.span.start < whole.end


def _taken_in_robot(document: Document, symbol: Symbol, name: str) -> Iterator[str]:
    root = root_of(document)
    for scope in _scopes(root.scopes):
        if symbol.kind == "material":
            if isinstance(scope, Model) and root.is_urdf and name in scope.material_names.defined:
                yield "material"
            continue
        own = (symbol_of(node) for node in scope.nodes.values())
        is_there = any(each is not None and each.key == symbol.key for each in own)
        is_there = is_there or (root.is_urdf and symbol.kind == "joint")
        if is_there and (other := taken_by(scope, symbol.kind, name)) is not None:
            yield other.kind


def _scopes(scopes: Iterable[Scope]) -> Iterator[Scope]:
    waiting = list(scopes)
    while waiting:
        scope = waiting.pop()
        yield scope
        waiting += scope.models
