"""The names in a xacro file: of macros, parameters, properties and arguments, and those of the robot as written."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from sdfcheck.robot.naming.occurrences import Occurrence, Symbol
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import PREFIX, matches
from sdfcheck.xacro.static.definitions import Definitions, visible_definitions
from sdfcheck.xacro.static.reading import Macro, reading

_WORD = re.compile(r"'[^']*'|\"[^\"]*\"|(?<![\w.])[^\W\d]\w*")
_ARGUMENT = re.compile(r"arg\s+(\S+)\s*$")
_ROBOT = {
    "link": (("parent", "link"), ("child", "link"), ("gazebo", "reference")),
    "joint": (("mimic", "joint"), ("gazebo", "reference"), ("joint", "name")),
    "material": (("material", "name"),),
}
"""Kind → the elements and attributes that name one in URDF."""


def xacro_names(document: Document) -> Iterator[Occurrence]:
    """Every place in a xacro document where something is named whose definition it can see."""
    visible = visible_definitions(document)
    known = _Known(visible)
    yield from known.own(document)
    for call in reading(document).calls:
        symbol = known.macros.get(call.name) or known.macros.get(call.name.rpartition(".")[2])
        if symbol is not None:
            for span in _called(call.element, call.name):
                yield Occurrence(span, symbol)
    yield from _words(document, known)
    yield from _of_robot(document, known)


def robot_symbols(document: Document) -> dict[tuple[str, str], Symbol]:
    """The links, joints and materials that a xacro document and what it includes define, by kind and name."""
    return _Known(visible_definitions(document)).robot


class _Known:
    """The symbols that a document can see."""

    def __init__(self, visible: Definitions) -> None:
        self.macros: dict[str, Symbol] = {}
        self.properties: dict[str, Symbol] = {}
        self.arguments: dict[str, Symbol] = {}
        self.parameters: dict[Element, Mapping[str, Symbol]] = {}
        self.local: dict[Element, dict[str, Symbol]] = {}
        self.robot: dict[tuple[str, str], Symbol] = {}
        for read in visible.readings:
            for macro in read.macros:
                value = macro.element.attribute("name")
                if value is not None and macro.name:
                    self.macros.setdefault(macro.name, _symbol("macro", macro.name, value))
                self.parameters[macro.element] = dict(_parameters(macro))
            for found in read.properties:
                value = found.element.attribute("name")
                if value is None or not found.name:
                    continue
                own = self.properties if found.macro is None else self.local.setdefault(found.macro, {})
                own.setdefault(found.name, _symbol("property", found.name, value))
            for element, _ in read.elements:
                self._take(element)

    def _take(self, element: Element) -> None:
        name = element.name
        value = element.attribute("name")
        if value is None or not value.text:
            return
        if name == "xacro:arg":
            self.arguments.setdefault(value.text, _symbol("argument", value.text, value))
        elif (name in {"link", "joint"} and not _is_reference(element)) or (
            name == "material" and bool(element.nodes)
        ):
            self.robot.setdefault((name, value.text), _symbol(name, value.text, value))

    def own(self, document: Document) -> Iterator[Occurrence]:
        """Where the document itself gives names."""
        every = [
            *self.macros.values(),
            *self.properties.values(),
            *self.arguments.values(),
            *self.robot.values(),
        ]
        for inner in (*self.parameters.values(), *self.local.values()):
            every += inner.values()
        for symbol in every:
            if symbol.span.source is document.source:
                yield Occurrence(symbol.span, symbol, True)

    def word(self, name: str, macro: Element | None) -> Symbol | None:
        """The meaning of a word in an expression, inside a macro or outside."""
        if macro is not None:
            found = self.parameters.get(macro, {}).get(name) or self.local.get(macro, {}).get(name)
            if found is not None:
                return found
        return self.properties.get(name)


def _symbol(kind: str, name: str, value: Value) -> Symbol:
    span = value.span
    if kind == "macro" and span.text.startswith(PREFIX):
        span = span.source.span(span.start + len(PREFIX), span.end)
    return Symbol(kind, name, span)


def _parameters(macro: Macro) -> Iterator[tuple[str, Symbol]]:
    if not macro.parameters:
        return
    span = macro.element.document.spans.attribute_value(macro.element, "params")
    for parameter in macro.parameters:
        name = parameter.name.lstrip("*")
        start = span.start + parameter.start + len(parameter.name) - len(name)
        place = span.source.span(start, start + len(name))
        if name and place.text == name:
            yield name, Symbol("parameter", name, place)


def _called(element: Element, name: str) -> Iterator[Span]:
    """The name of the macro in a call, and in its end tag."""
    spans = element.document.spans
    if element.name == "xacro:call":
        yield spans.attribute_value(element, "macro")
        return
    last = len(name.rpartition(".")[2])
    for span in filter(None, (element.span, spans.end_name(element))):
        yield span.source.span(span.end - last, span.end)


def _words(document: Document, known: _Known) -> Iterator[Occurrence]:
    """The words of expressions, and the attributes by which calls give parameters."""
    spans = document.spans
    for element, macro in reading(document).elements:
        for name, text in element.attributes.items():
            if "$" in text:
                yield from _in_text(spans.attribute_value(element, name), macro, known)
        if element.text and "$" in element.text:
            place = spans.place(element)
            yield from _in_text(document.source.span(place.end, place.close), macro, known, deep=False)
        if element.name == "xacro:insert_block" and (value := element.attribute("name")) is not None:
            symbol = known.word(value.text, macro)
            if symbol is not None:
                yield Occurrence(value.span, symbol)
        called = known.macros.get(element.name[len(PREFIX) :]) if element.name.startswith(PREFIX) else None
        if called is not None:
            taken = next((own for at, own in known.parameters.items() if _is_of(at, called)), {})
            for name in element.attributes:
                if name in taken:
                    yield Occurrence(spans.attribute_name(element, name), taken[name])


def _is_of(element: Element, macro: Symbol) -> bool:
    value = element.attribute("name")
    return value is not None and value.span.end == macro.span.end and value.span.source is macro.span.source


def _in_text(span: Span, macro: Element | None, known: _Known, *, deep: bool = True) -> Iterator[Occurrence]:
    text = span.text
    if not deep:
        text = text.partition("<")[0]
    for match in matches(text):
        if match["command"] is not None:
            argument = _ARGUMENT.match(match["command"])
            symbol = known.arguments.get(argument[1]) if argument else None
            if argument and symbol is not None:
                start = span.start + match.start("command") + argument.start(1)
                yield Occurrence(span.source.span(start, start + len(argument[1])), symbol)
        elif match["code"] is not None:
            for word in _WORD.finditer(match["code"]):
                symbol = known.word(word[0], macro)
                if symbol is not None:
                    start = span.start + match.start("code") + word.start()
                    yield Occurrence(span.source.span(start, start + len(word[0])), symbol)


def _of_robot(document: Document, known: _Known) -> Iterator[Occurrence]:
    """The names of links, joints and materials, which are the same where they are written the same way."""
    places = {place: kind for kind, own in _ROBOT.items() for place in own}
    for element, _ in reading(document).elements:
        for name, value in (
            (name, element.attribute(name)) for name in ("link", "joint", "reference", "name")
        ):
            kind = places.get((element.name, name))
            if value is None or kind is None:
                continue
            kinds = ("link", "joint") if name == "reference" else (kind,)
            symbol = next((s for k in kinds if (s := known.robot.get((k, value.text))) is not None), None)
            if symbol is not None and symbol.span != value.span:
                yield Occurrence(value.span, symbol)


def _is_reference(element: Element) -> bool:
    """Is a ``joint`` one that only names another: in a transmission or in ``ros2_control``?"""
    parent = element.parent
    return parent is not None and parent.name in {"transmission", "ros2_control", "mimic"}
