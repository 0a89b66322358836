"""The names in a text with xacro: of macros, parameters, properties and arguments, and of the robot as written."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping

from sdfcheck.files.library import library_of
from sdfcheck.formats.srdf import references as names_in_srdf
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol
from sdfcheck.robot.naming.references import NAMING
from sdfcheck.robot.semantics import own_kind
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import BUILT_IN, KEYWORDS, PREFIX, is_literal, matches, parameters, replaced
from sdfcheck.xacro.static.definitions import Definitions, Macro, reading
from sdfcheck.xacro.static.project import definer

# The names in a text with xacro: of macros, parameters, properties and arguments, and of the robot as
# written.


_WORD = re.compile(r"'[^']*'|\"[^\"]*\"|(?<![\w.])[^\W\d]\w*")
_ARGUMENT = re.compile(r"(?:\$\(arg\s+|\bxacro\.arg\(\s*['\"])(?P<name>[^\s()$'\"]+)")
_NODES = ("link", "frame", "joint", "model")
_REFERENCES: Mapping[tuple[str, str], tuple[str, ...]] = {
    ("parent", "link"): ("link",),
    ("child", "link"): ("link",),
    ("mimic", "joint"): ("joint",),
    ("gazebo", "reference"): ("link", "joint"),
    ("pose", "relative_to"): _NODES,
    ("frame", "attached_to"): _NODES,
    ("xyz", "expressed_in"): _NODES,
    ("model", "canonical_link"): ("link",),
    ("model", "placement_frame"): _NODES,
    **{
        place: (kind,)
        for place, kind in names_in_srdf().items()
        if place[1] != "name" or place[0] == "passive_joint"
    },
}
"""Element and attribute → the kinds of what they refer to."""
_TEXTS = frozenset({"parent", "child"})
_DEFINED = frozenset({"link", "joint", "frame", "model", "group"})
_IN_LINKS = frozenset({"sensor", "collision"})
"""The parts of links that have names of their own in each, in SDFormat."""
_HOLDERS_OF_JOINTS = frozenset({"transmission", "ros2_control", "mimic", "group", "group_state"})


class Naming(NamedTuple):
    """A value that names a part of the robot: the kinds that it may be of, and whether it gives the name."""

    value: Value
    kinds: tuple[str, ...]
    is_definition: bool
    is_sure: bool = True
    """Does it name a part whatever it says? Parameters of plugins do where there is a part of that name."""


def namings(element: Element) -> Iterator[Naming]:
    """The values of an element that name parts of the robot, by their place alone."""
    name, root = element.name, element.document.root
    is_sdf = root is not None and root.name == "sdf"
    for attribute in element.attributes:
        kinds = _REFERENCES.get((name, attribute))
        value = element.attribute(attribute)
        if kinds is not None and value is not None and value.text.strip():
            yield Naming(value, kinds, False)
    if name in _TEXTS and not element.attributes and element.content and not element.nodes:
        yield Naming(element.own_value, _NODES, False)
    elif is_sdf and name == "collision" and element.content and not element.nodes:
        yield Naming(element.own_value, ("collision",), False)
    elif _is_parameter(element):
        yield Naming(element.own_value, _NODES, False, is_sure=False)
    value = element.attribute("name")
    if value is None or not value.text.strip():
        return
    kind = name if name in _DEFINED or (is_sdf and name in _IN_LINKS) else own_kind(element)
    if kind:
        yield Naming(value, (kind,), not _is_reference(element))
    elif name == "material":
        yield Naming(value, ("material",), bool(element.nodes))


def _is_parameter(element: Element) -> bool:
    """Is it a parameter of a plugin, called as if it named a part?"""
    is_text = element.content and not element.nodes and NAMING.search(element.name)
    return bool(is_text) and any(each.name == "plugin" for each in element.around)


def _is_reference(element: Element) -> bool:
    """Is a ``joint`` or the like one that only names another: in a transmission, ``ros2_control`` or SRDF?"""
    around = next((each for each in element.around if not each.name.startswith(PREFIX)), None)
    holder = "" if around is None else around.name
    if element.name == "joint":
        return holder in _HOLDERS_OF_JOINTS
    return holder == "group" or (holder == "state" and element.name != "group")


def xacro_names(document: Document, known: Known) -> Iterator[Occurrence]:
    """Every place in a document where something is named, by what it and the robots that include it define."""
    yield from known.own(document)
    for call in reading(document).calls:
        symbol = known.macro(call.name)
        if symbol is not None:
            for span in _called(call.element):
                yield Occurrence(span, symbol, before=span.text[: -len(symbol.name)])
    yield from _words(document, known)
    yield from _of_robot(document, known)


Names = dict[str, list[Symbol]]
"""Name → the places that define it: one name may be given in both branches of a condition, or anew."""


class Own:
    """The symbols that one document defines; found once, whatever includes it."""

    def __init__(self, document: Document) -> None:
        self.macros: Names = {}
        self.properties: Names = {}
        self.arguments: Names = {}
        self.parameters: list[tuple[Element, str, Mapping[str, Symbol]]] = []
        """Of each macro with its name."""
        self.local: dict[Element, Names] = {}
        """Macro → the properties that end with it."""
        self.robot: list[tuple[str, Element | None, Symbol]] = []
        read = reading(document)
        for each in read.macros:
            value = each.element.attribute("name")
            self.parameters.append((each.element, each.name, dict(_parameters(each))))
            if value is not None and each.name:
                self.macros.setdefault(each.name, []).append(_symbol("macro", each.name, value))
        for found in read.properties:
            value = found.element.attribute("name")
            if value is None or not found.name:
                continue
            macro = None if found.lasts else found.macro
            own = self.properties if macro is None else self.local.setdefault(macro, {})
            own.setdefault(found.name, []).append(_symbol("property", found.name, value))
        for element, inside in read.elements:
            self._take(element, inside)

    def _take(self, element: Element, macro: Element | None) -> None:
        if element.name == "xacro:arg":
            value = element.attribute("name")
            if value is not None and value.text:
                symbol = _symbol("argument", value.text, value)
                self.arguments.setdefault(value.text, []).append(symbol)
            return
        for value, kinds, is_definition, *_ in namings(element):
            if is_definition:
                self.robot.append((kinds[0], macro, _symbol(kinds[0], value.text.strip(), value)))


class Known:
    """The symbols that a document can see, itself or in the robots that include it.

    Of others that ``document`` uses, that of the one file of the project that defines it: what makes a robot of both
    may be no file.
    """

    def __init__(self, visible: Iterable[Definitions], document: Document | None = None) -> None:
        self._document = document
        self.macros: Names = {}
        self.properties: Names = {}
        self.arguments: Names = {}
        self.taken: dict[str, Names] = {}
        """Name of a macro → its parameters."""
        self.parameters: dict[Element, Names] = {}
        """Macro → its parameters, with those of other macros of its name."""
        self.local: dict[Element, Names] = {}
        self._callers: dict[str, list[tuple[Element, str]]] = {}
        """Name of a macro → the macros that call it, with their names."""
        self.robot: dict[tuple[str, str], list[tuple[Element | None, Symbol]]] = {}
        self._patterns: dict[str, list[tuple[re.Pattern[str], int, Symbol]]] | None = None
        self._seen: set[Document] = set()
        for read in (read for each in visible for read in each.readings):
            if read.document not in self._seen:
                self._add(read.document)
                for kind, inside, symbol in read.document.view(Own).robot:
                    self.robot.setdefault((kind, symbol.name), []).append((inside, symbol))

    def _add(self, document: Document) -> None:
        """Take what belongs to xacro in a document."""
        self._seen.add(document)
        own = document.view(Own)
        pairs = (
            (self.macros, own.macros),
            (self.properties, own.properties),
            (self.arguments, own.arguments),
        )
        for known, given in pairs:
            for name, symbols in given.items():
                known.setdefault(name, []).extend(symbols)
        for macro, name, symbols_of in own.parameters:
            taken = self.parameters[macro] = self.taken.setdefault(name, {})
            for each, symbol in symbols_of.items():
                taken.setdefault(each, []).append(symbol)
        self.local.update(own.local)
        for caller in reading(document).macros:
            for call in caller.calls:
                self._callers.setdefault(call.rpartition(".")[2], []).append((caller.element, caller.name))

    def _learn(self, kind: str, name: str) -> None:
        """Take the one file of the project that defines a name which none of the others does."""
        path = None if self._document is None else definer(self._document, kind, name)
        library = None if self._document is None else library_of(self._document)
        found = None if path is None or library is None else library.document(path, Kind.XACRO)
        if found is not None and found not in self._seen:
            self._add(found)

    def macro(self, call: str) -> Symbol | None:
        """The macro that a call means, by its name after those of its namespaces."""
        name = call if call in self.macros else call.rpartition(".")[2]
        if name not in self.macros:
            self._learn("macro", name)
        return next(iter(self.macros.get(name, ())), None)

    @property
    def groups(self) -> Iterator[list[Symbol]]:
        """All places that define one name, by the first of which it is known."""
        for names in (
            self.macros,
            self.properties,
            self.arguments,
            *self.taken.values(),
            *self.local.values(),
        ):
            yield from names.values()

    def own(self, document: Document) -> Iterator[Occurrence]:
        """Where the document itself gives names to what belongs to xacro."""
        for symbols in self.groups:
            for each in symbols:
                if each.span.source is document.source:
                    yield Occurrence(each.span, symbols[0], True)

    def parameters_of(self, call: str) -> Names:
        """The parameters of the macro that a call means."""
        macro = self.macro(call) if call not in KEYWORDS else None
        return self.taken.get(macro.name, {}) if macro is not None else {}

    def word(self, name: str, macro: Element | None) -> Symbol | None:
        """The meaning of a word in an expression, inside a macro or outside."""
        around = [] if macro is None else [macro, *macro.around]
        found = next(filter(None, (self._inside(each, name) for each in around)), None)
        found = found or self.properties.get(name) or (self._of_callers(name, macro) if macro else None)
        if found is None and name not in BUILT_IN:
            self._learn("property", name)
            found = self.properties.get(name)
        return found[0] if found else None

    def _inside(self, macro: Element, name: str) -> list[Symbol] | None:
        return self.parameters.get(macro, {}).get(name) or self.local.get(macro, {}).get(name)

    def _of_callers(self, name: str, macro: Element) -> list[Symbol] | None:
        """A macro reads what those have that call it, too."""
        waiting = [macro.attributes.get("name", "").removeprefix(PREFIX)]
        for called in waiting:
            for caller, own in self._callers.get(called, ()):
                if found := self._inside(caller, name):
                    return found
                waiting += [own] if own not in waiting else []
        return None

    def part(self, kinds: Iterable[str], text: str, macro: Element | None) -> Symbol | None:
        """The definition that a text names: that of the same text, in the same macro if there are several.

        Else one that may expand to it, the longest.
        """
        for kind in kinds:
            found = self.robot.get((kind, text))
            if found:
                return next((symbol for inside, symbol in found if inside is macro), found[0][1])
        fitting = [
            (size, symbol)
            for kind in kinds
            for pattern, size, symbol in self._fitting(kind)
            if pattern.fullmatch(text)
        ]
        return max(fitting, key=lambda each: each[0])[1] if fitting and is_literal(text) else None

    def _fitting(self, kind: str) -> list[tuple[re.Pattern[str], int, Symbol]]:
        if self._patterns is None:
            self._patterns = {}
            for (each, text), found in self.robot.items():
                literal = len(replaced(text, lambda _: ""))
                if not is_literal(text) and literal > 1:
                    pattern = re.compile(".*".join(map(re.escape, _literals(text))), re.DOTALL)
                    self._patterns.setdefault(each, []).append((pattern, literal, found[0][1]))
        return self._patterns.get(kind, [])


def _literals(text: str) -> Iterator[str]:
    """The pieces of a text between its expressions."""
    at = 0
    for match in matches(text):
        yield text[at : match.start()]
        at = match.end()
    yield text[at:]


def _symbol(kind: str, name: str, value: Value) -> Symbol:
    span = value.span
    if kind == "macro" and span.text.startswith(PREFIX):
        span = span.source.span(span.start + len(PREFIX), span.end)
    return Symbol(kind, name, span)


def _parameters(macro: Macro) -> Iterator[tuple[str, Symbol]]:
    if not macro.parameters:
        return
    span = macro.element.document.spans.attribute_value(macro.element, "params")
    for parameter in parameters(span.text):  # as it is written: XML makes one space of a line's end
        name = parameter.name.lstrip("*")
        start = span.start + parameter.end - len(name)
        name = name.rstrip(",")
        if name:
            yield name, Symbol("parameter", name, span.source.span(start, start + len(name)))


def _called(element: Element) -> Iterator[Span]:
    """The name of the macro in a call, and in its end tag, with the prefix of xacro."""
    spans = element.document.spans
    if element.name == "xacro:call":
        yield spans.attribute_value(element, "macro")
    else:
        yield from filter(None, (element.span, spans.end_name(element)))


def _words(document: Document, known: Known) -> Iterator[Occurrence]:
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
        called = element.text_of("macro") or "" if element.name == f"{PREFIX}call" else element.name
        taken = known.parameters_of(called.removeprefix(PREFIX)) if element.name.startswith(PREFIX) else {}
        for name in element.attributes if taken else ():
            if name in taken:
                yield Occurrence(spans.attribute_name(element, name), taken[name][0])


def _in_text(span: Span, macro: Element | None, known: Known, *, deep: bool = True) -> Iterator[Occurrence]:
    text = span.text
    if not deep:
        text = text.partition("<")[0]
    for match in matches(text):
        is_escaped = match["command"] is None and match["code"] is None
        for argument in () if is_escaped else _ARGUMENT.finditer(match[0]):  # also within expressions
            at = span.start + match.start()
            place = span.source.span(at + argument.start("name"), at + argument.end("name"))
            symbols = known.arguments.get(place.text)
            if symbols is not None:
                yield Occurrence(place, symbols[0])
        if match["code"] is not None:
            for word in _WORD.finditer(match["code"]):
                symbol = known.word(word[0], macro)
                if symbol is not None:
                    start = span.start + match.start("code") + word.start()
                    yield Occurrence(span.source.span(start, start + len(word[0])), symbol)


def _of_robot(document: Document, known: Known) -> Iterator[Occurrence]:
    """The names of parts of the robot, which are the same where they are written the same way."""
    for element, macro in reading(document).elements:
        for value, kinds, is_definition, is_sure in namings(element):
            text = value.text.strip()
            symbol = None if kinds[0] in _IN_LINKS else known.part(kinds, text, macro)
            if symbol is not None or is_sure:
                yield Occurrence(value.span, symbol or _symbol(kinds[0], text, value), is_definition)
