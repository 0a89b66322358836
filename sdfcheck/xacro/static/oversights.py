"""Oversights that xacro accepts, as far as reading a file shows them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import BUILT_IN, DEPRECATED, KEYWORDS, ONLY_IN_MODULE, PREFIX, is_literal
from sdfcheck.xacro.oversights import (
    DeprecatedFunction,
    EmptiedBlock,
    NeverEqualText,
    OddParameter,
    Oversight,
    OverwrittenParameter,
    OverwrittenProperty,
    ParameterFlaw,
    PrefixedMacroName,
    RedefinedMacro,
    RedefinedSymbol,
    UnknownPropertyScope,
    UnusedArgument,
    UnusedMacro,
    UnusualXacroNamespace,
)
from sdfcheck.xacro.parameters import Parameter
from sdfcheck.xacro.static.definitions import Definitions, knows_all
from sdfcheck.xacro.static.elements import is_conditional, is_outside
from sdfcheck.xacro.static.prefixes import missing_prefixes
from sdfcheck.xacro.static.reading import Macro, Property, Reading, own_words, place, reading
from sdfcheck.xacro.static.suggestions import nearest

_SYMBOLS = BUILT_IN - ONLY_IN_MODULE
_SCOPES = ("global", "local", "parent")
_NAMESPACE = "http://www.ros.org/wiki/xacro"
_CUSTOMARY = re.compile(r"https?://(www\.|wiki\.)?ros\.org/(wiki/)?xacro/?#?$")
_DEPRECATED = re.compile(rf"(?<![\w.])({'|'.join(sorted(DEPRECATED))})\s*\(")
_COMPARED = re.compile(
    r"(['\"])\$\(arg\s+(?P<arg>\w+)\)\1\s*[!=]=\s*(['\"])(?P<text>[^'\"]*)\3"
    r"|(['\"])(?P<first>[^'\"]*)\5\s*[!=]=\s*(['\"])\$\(arg\s+(?P<last>\w+)\)\7"
)


def oversights(document: Document, visible: Definitions) -> Iterator[Oversight]:
    """The oversights in a document."""
    read = reading(document)
    yield from _symbols(read)
    yield from _macros(read)
    yield from _functions(read)
    yield from _overwritten(read)
    yield from _scopes(read)
    yield from _comparisons(read, visible)
    yield from _blocks(read, visible)
    yield from _namespace(document)
    if knows_all(document):
        yield from _unused(document, read, visible)


def _symbols(read: Reading) -> Iterator[Oversight]:
    for found in read.properties:
        if found.name in _SYMBOLS and "remove" not in found.element.attributes:
            yield RedefinedSymbol(_named(found.element), found.name)
    for macro in read.macros:
        for parameter in macro.parameters:
            if parameter.name in _SYMBOLS:
                yield RedefinedSymbol(parameter_place(macro, parameter), parameter.name)


def _macros(read: Reading) -> Iterator[Oversight]:
    first: dict[str, Macro] = {}
    for macro in read.macros:
        if macro.element.attributes.get("name", "").startswith(PREFIX):
            yield PrefixedMacroName(_named(macro.element), macro.name)
        if macro.name and is_literal(macro.name) and is_outside(macro.element):
            earlier = first.setdefault(macro.name, macro)
            if earlier is not macro:
                yield RedefinedMacro(_named(macro.element), macro.name, _named(earlier.element))
        yield from _parameters(macro)


def _parameters(macro: Macro) -> Iterator[Oversight]:
    value = macro.element.attribute("params")
    seen: dict[str, Parameter] = {}
    has_comma = False
    for parameter in macro.written if value is not None else ():
        span = parameter_place(macro, parameter)
        name = parameter.name.strip(",")
        if "," in parameter.name or (parameter.default or "").endswith(","):
            if not has_comma:
                yield OddParameter(span, name, flaw=ParameterFlaw.COMMA)
            has_comma = True
        elif parameter.name in seen:
            other = parameter_place(macro, seen[parameter.name])
            yield OddParameter(span, name, other, flaw=ParameterFlaw.DOUBLED)
        elif parameter.is_optional and value is not None:
            sign = re.match(r"\s*(:?=)(\s*)", value.text[parameter.end :])
            if sign and sign[2] and parameter.default is not None:
                yield OddParameter(span, name, flaw=ParameterFlaw.BLANK)
            elif sign and sign[1] == "=":
                yield OddParameter(span, name, flaw=ParameterFlaw.NO_COLON)
        seen.setdefault(parameter.name, parameter)


def _functions(read: Reading) -> Iterator[Oversight]:
    seen: set[str] = set()
    own = {found.name for found in read.properties}
    for found in read.expressions:
        for match in _DEPRECATED.finditer(found.code):
            name = match[1]
            if name not in own and name not in seen:
                seen.add(name)
                span = place(found.element, found.attribute, found.code, name)
                yield DeprecatedFunction(span, name, near=DEPRECATED[name])


def _overwritten(read: Reading) -> Iterator[Oversight]:
    """Properties that get two values in a row, and parameters that a property replaces."""
    waiting: dict[tuple[Element | None, str], Property] = {}
    properties = {found.element: found for found in read.properties}
    parameters = {macro.element: macro for macro in read.macros}
    for element, macro in read.elements:
        found = properties.get(element)
        plain = found is not None and _is_plain(found)
        words = own_words(element)
        if found is not None and plain and macro is not None and macro in parameters:
            yield from _replaced(found, parameters[macro], read)
        if not plain or not words.isdisjoint(name for _, name in waiting):
            # A callee, an include or a block may read any of them.
            name = element.name
            if name.startswith(PREFIX) and name[len(PREFIX) :] not in KEYWORDS - {
                "include",
                "call",
                "if",
                "unless",
            }:
                waiting.clear()
            waiting = {key: each for key, each in waiting.items() if key[1] not in words}
        if found is None or not plain:
            continue
        key = macro, found.name
        earlier = waiting.get(key)
        if earlier is not None and found.name not in words:
            yield OverwrittenProperty(_named(earlier.element), found.name, _named(element))
        waiting[key] = found


def _is_plain(found: Property) -> bool:
    """Does a property get a value of its own, whatever came before?"""
    given = found.element.attributes
    is_plain = "value" in given and "scope" not in given and is_literal(found.name)
    return is_plain and not is_conditional(found.element)


def _replaced(found: Property, macro: Macro, read: Reading) -> Iterator[Oversight]:
    if found.name in own_words(found.element):
        return
    for parameter in macro.parameters:
        if parameter.name == found.name and not _is_read_before(found, macro, read):
            yield OverwrittenParameter(_named(found.element), found.name, parameter_place(macro, parameter))


def _is_read_before(found: Property, macro: Macro, read: Reading) -> bool:
    for element, holder in read.elements:
        if element is found.element:
            return False
        if holder is macro.element and element is not holder and found.name in own_words(element):
            return True
    return False


def _scopes(read: Reading) -> Iterator[Oversight]:
    for found in read.properties:
        value = found.element.attribute("scope")
        if value is not None and is_literal(value.text) and value.text not in _SCOPES:
            yield UnknownPropertyScope(value.span, value.text, near=nearest(value.text, _SCOPES))


def _comparisons(read: Reading, visible: Definitions) -> Iterator[Oversight]:
    for found in read.expressions:
        for match in _COMPARED.finditer(found.code):
            name, text = match["arg"] or match["last"], match["text"] or match["first"] or ""
            homes = [each for each in visible.readings if name in each.arguments]
            default = homes[0].arguments[name] if homes else ""
            if len(homes) == 1 and default != text and default.casefold() == text.casefold():
                span = place(found.element, found.attribute, match[0])
                given = homes[0].argument_elements[name]
                other = given.document.spans.attribute_value(given, "default")
                yield NeverEqualText(span, text, other, default)


def _blocks(read: Reading, visible: Definitions) -> Iterator[Oversight]:
    for call in read.calls:
        macros = visible.macros.get(call.name, [])
        children = list(call.element.children())
        if len(macros) != 1 or any(child.name.startswith(PREFIX) for child in children):
            continue
        blocks = [parameter for parameter in macros[0].parameters if parameter.is_block]
        for parameter, child in zip(blocks, children, strict=False):
            if parameter.name.startswith("**") and child.attributes and not child.nodes and not child.content:
                other = parameter_place(macros[0], parameter)
                yield EmptiedBlock(child.span, child.name, other, parameter.name)


def _namespace(document: Document) -> Iterator[Oversight]:
    assert document.root is not None
    tag = document.spans.start_tag(document.root)
    for attribute in tag.attributes:
        if attribute.name == "xmlns:xacro":
            span = document.source.span(attribute.value_start, attribute.value_end)
            if not _CUSTOMARY.match(span.text) and nearest(span.text, (_NAMESPACE,), 0.9):
                yield UnusualXacroNamespace(span, span.text, near=_NAMESPACE)


def _unused(document: Document, read: Reading, visible: Definitions) -> Iterator[Oversight]:
    called = {call.name.rpartition(".")[2] for each in visible.readings for call in each.calls}
    called.update(each.name for each in missing_prefixes(document))
    for macro in read.macros:
        if macro.name and macro.name not in called and macro.name not in visible.words:
            yield UnusedMacro(_named(macro.element), macro.name)
    for name, element in read.argument_elements.items():
        if name and "default" in element.attributes and is_literal(name) and name not in visible.words:
            yield UnusedArgument(_named(element), name)


def parameter_place(macro: Macro, parameter: Parameter) -> Span:
    """Where a parameter is written."""
    span = macro.element.document.spans.attribute_value(macro.element, "params")
    start = span.text.find(parameter.name, parameter.start)
    if start == parameter.start:
        return span.source.span(span.start + start, span.start + start + len(parameter.name))
    return span


def _named(element: Element) -> Span:
    """The name that an element gives."""
    spans = element.document.spans
    return spans.attribute_value(element, "name") if "name" in element.attributes else element.span
