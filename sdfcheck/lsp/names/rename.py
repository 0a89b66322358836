"""Giving something another name, wherever it is named."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from sdfcheck.lint.fix import Edit
from sdfcheck.lsp.names.index import everywhere, occurrences
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.robot.model import Model
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, name_refusal, symbol_of, taken_by
from sdfcheck.robot.root import root_of
from sdfcheck.robot.scope import Scope
from sdfcheck.source.document import Document
from sdfcheck.source.references import IN_QUOTES, escape
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.language import BUILT_IN, KEYWORDS, matches
from sdfcheck.xacro.static.definitions import Definitions, visible_definitions
from sdfcheck.xacro.static.reading import Macro, reading

_IN_EXPRESSIONS = frozenset({"property", "parameter"})
_IN_XACRO = _IN_EXPRESSIONS | {"macro", "argument"}
_IDENTIFIER = re.compile(r"[^\W\d]\w*")
_XML_NAME = re.compile(r"[^\W\d][\w.-]*")
_ENDS = ("link", "joint", "reference")


class Refused(Exception):
    """A name that cannot be given; the message says why."""


def rename(workspace: Workspace, document: Document, occurrence: Occurrence, name: str) -> list[Edit]:
    """The edits that give a symbol another name, in all files of the project.

    Raises:
        Refused: the name is taken, or cannot be one.
    """
    symbol = occurrence.symbol
    if name == symbol.name:
        return []
    _check_form(symbol, name)
    found = everywhere(workspace, document, symbol)
    if not any(each.is_definition for each in found):
        raise Refused(f"the file that defines {symbol.kind} `{symbol.name}` cannot be read")
    documents = {each.span.source.path: workspace.document(each.span.source.path) for each in found}
    for other in filter(None, documents.values()):
        _check_free(other, symbol, name)
        _check_expanded(other, symbol)
    return [Edit(each.span, _written(each, name)) for each in found]


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
    if symbol.kind not in _IN_XACRO and (reason := name_refusal(symbol.kind, name)) is not None:
        raise Refused(reason)
    if symbol.kind == "argument" and (not name or re.search(r"[\s$(){}]", name)):
        raise Refused(f"`{name}` cannot be the name of an argument")


def _check_free(document: Document, symbol: Symbol, name: str) -> None:
    """Is the name taken where the symbol is known?"""
    if document.kind is Kind.SRDF:
        return  # it defines none of them
    taken = _taken_in_xacro if document.kind is Kind.XACRO else _taken_in_robot
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


def _check_expanded(document: Document, symbol: Symbol) -> None:
    """A name that expressions make may be written out elsewhere, where it would not change."""
    pieces, at = [], 0
    for match in matches(symbol.name):
        pieces += [re.escape(symbol.name[at : match.start()]), ".*"]
        at = match.end()
    if not pieces or document.kind is not Kind.XACRO:
        return
    written_out = re.compile("".join([*pieces, re.escape(symbol.name[at:])]))
    for element, _ in reading(document).elements:
        for name in _ENDS:
            value = element.attribute(name)
            if value is None or value.text == symbol.name or not written_out.fullmatch(value.text):
                continue
            known = occurrences(document).at(value.span.start)
            if known is None:
                line = value.span.begin.line
                raise Refused(
                    f"`{value.text}` in {document.path.name}, line {line}, may be what `{symbol.name}` makes"
                )
