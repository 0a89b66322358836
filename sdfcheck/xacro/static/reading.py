"""The definitions, calls, includes and reads of one xacro file, found without evaluating anything."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.record import Record
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import KEYWORDS, PREFIX, expressions, is_literal, substitutions
from sdfcheck.xacro.parameters import Parameter, parameters
from sdfcheck.xacro.static.elements import keyword, own_attributes

_WORD = re.compile(r"[^\W\d]\w*")


class Macro(Record):
    """A macro: its element, its parameters, the words that its body reads, and the macros that it calls."""

    element: Element
    name: str
    parameters: tuple[Parameter, ...]
    words: frozenset[str]
    calls: tuple[str, ...]
    has_includes: bool
    written: tuple[Parameter, ...]
    """Its parameters as xacro takes them, with commas and doubled ones."""


class Property(Record):
    """A property; ``macro`` is the macro in whose body it is defined, ``value`` None for a block."""

    element: Element
    name: str
    value: str | None
    macro: Element | None


class Call(Record):
    """A use of a macro."""

    element: Element
    name: str


class Expression(Record):
    """A ``${…}``: its code, where it is (``attribute`` None: in the text), and in which macro's body."""

    element: Element
    attribute: str | None
    code: str
    macro: Element | None


class Include(Record):
    """An include; ``conditional`` inside ``xacro:if`` or a macro, ``optional`` where the file may be missing."""

    element: Element
    filename: str
    namespace: str
    conditional: bool
    optional: bool


class Command(Record):
    """A ``$(…)``, and whether it is evaluated for certain."""

    element: Element
    attribute: str | None
    text: str
    certain: bool


class Reading:
    """The facts of one file; made by :func:`reading` once for each document."""

    def __init__(self, document: Document) -> None:
        self.document = document
        self.macros: list[Macro] = []
        self.properties: list[Property] = []
        self.calls: list[Call] = []
        self.expressions: list[Expression] = []
        self.includes: list[Include] = []
        self.commands: list[Command] = []
        self.elements: list[tuple[Element, Element | None]] = []
        """All elements, each with the macro in whose body it is."""
        self.arguments: dict[str, str] = {}
        self.argument_elements: dict[str, Element] = {}
        self.words: set[str] = set()
        """Every word in an expression, and every name that is inserted or forwarded."""
        self.is_open = False
        """Whether names are made by expressions, so that not all of them can be known."""
        if document.root is not None:
            self._walk(document.root, None, False)

    def _walk(self, element: Element, macro: Element | None, conditional: bool) -> None:
        name = element.name
        self.elements.append((element, macro))
        own = keyword(element)
        if name.startswith(PREFIX) and name[len(PREFIX) :] not in KEYWORDS:
            self.calls.append(Call(element, name[len(PREFIX) :]))
        if own == "macro":
            self._take_macro(element)
            macro, conditional = element, True
        elif own:
            self._take_keyword(own, element, macro, conditional)
            conditional |= own in {"if", "unless"}
        self._take_values(element, macro, conditional)
        if own == "include":
            return  # xacro ignores what is inside
        for child in element.children():
            self._walk(child, macro, conditional)

    def _take_macro(self, element: Element) -> None:
        attributes = own_attributes(element, "macro")
        name = attributes.get("name", "").removeprefix(PREFIX)
        written = tuple(parameters(attributes.get("params", "")))
        found = tuple({each.name: each for each in map(_without_comma, reversed(written))}.values())[::-1]
        words = _words_in_text(element)
        calls: list[str] = []
        has_includes = False
        for node in element.below:
            if node.name == "xacro:macro":
                continue
            words |= _words_of(node)
            has_includes |= keyword(node) == "include"
            if node.name.startswith(PREFIX) and node.name[len(PREFIX) :] not in KEYWORDS - {"call"}:
                calls.append(node.name[len(PREFIX) :])
        for parameter in found:
            default = parameter.default or ""
            words.update(word for _, code in expressions(default) for word in _WORD.findall(code))
        self.words.update(p.name for p in found if p.forwards)
        self.macros.append(Macro(element, name, found, frozenset(words), tuple(calls), has_includes, written))

    def _take_keyword(self, own: str, element: Element, macro: Element | None, conditional: bool) -> None:
        attributes = own_attributes(element, own)
        name = attributes.get("name", "")
        if own == "property":
            self.is_open |= not is_literal(name)
            self.properties.append(
                Property(element, name, attributes.get("value", attributes.get("default")), macro)
            )
        elif own == "arg":
            self.arguments.setdefault(name, attributes.get("default", ""))
            self.argument_elements.setdefault(name, element)
        elif own == "include":
            optional = attributes.get("optional", "") not in {"", "false", "False", "0"}
            namespace = attributes.get("ns", "")
            self.is_open |= not is_literal(namespace)
            filename = attributes.get("filename", "")
            self.includes.append(Include(element, filename, namespace, conditional or optional, optional))
        elif own == "call":
            self.is_open |= not is_literal(attributes.get("macro", ""))
            if is_literal(attributes.get("macro", "")):
                self.calls.append(Call(element, attributes.get("macro", "")))

    def _take_values(self, element: Element, macro: Element | None, conditional: bool) -> None:
        self.words |= _words_of(element)
        certain = not conditional and element.name != "xacro:property"
        for attribute, text in texts(element):
            for _, code in expressions(text):
                self.expressions.append(Expression(element, attribute, code, macro))
            for _, command in substitutions(text):
                self.commands.append(Command(element, attribute, command, certain))


def reading(document: Document) -> Reading:
    """The facts of a document, read once."""
    return document.view(Reading)


def texts(element: Element, signs: str = "$") -> Iterator[tuple[str | None, str]]:
    """The attribute values and the text that xacro evaluates, as far as they have one of the signs."""
    for attribute, value in element.attributes.items():
        if any(sign in value for sign in signs):
            yield attribute, value
    for text in (element.text, *(child.tail for child in element.nodes)):
        if text and any(sign in text for sign in signs):
            yield None, str(text)


def own_words(element: Element) -> set[str]:
    """The words that an element reads itself, the defaults of a macro's parameters included."""
    words = _words_of(element)
    if keyword(element) == "macro":
        words.update(_WORD.findall(element.attributes.get("params", "")))
    return words


def _without_comma(parameter: Parameter) -> Parameter:
    """A parameter as it was meant where somebody separated it from the next by a comma."""
    if not parameter.name.endswith(",") and not (parameter.default or "").endswith(","):
        return parameter
    name = parameter.name.rstrip(",")
    end = parameter.end - len(parameter.name) + len(name)
    return parameter._replace(name=name, end=end, default=(parameter.default or "").rstrip(",") or None)


def _words_of(element: Element) -> set[str]:
    """The words in an element's expressions, and the block that it inserts."""
    words = {
        word for _, text in texts(element) for _, code in expressions(text) for word in _WORD.findall(code)
    }
    for _, text in texts(element):
        words.update(word for _, command in substitutions(text) for word in _WORD.findall(command))
    if element.name == "xacro:insert_block":
        words.add(element.attributes.get("name", ""))
    return words


def _words_in_text(element: Element) -> set[str]:
    """The words in the expressions of an element's own text."""
    found = [text for attribute, text in texts(element) if attribute is None]
    return {word for text in found for _, code in expressions(text) for word in _WORD.findall(code)}


def place(element: Element, attribute: str | None, code: str, word: str = "") -> Span:
    """The place of a word in an expression; the expression, the value or the tag if it is not found."""
    spans = element.document.spans
    if attribute is not None:
        whole = spans.attribute_value(element, attribute)
    else:
        at = spans.place(element)
        whole = spans.span(element, at.end, at.close)
    start = whole.source.text.find(code, whole.start, whole.end)
    if start < 0:
        return whole if attribute is not None else element.span
    if word:
        pattern = re.compile(rf"'[^']*'|\"[^\"]*\"|(?<![\w.])({re.escape(word)})(?!\w)")
        matches = pattern.finditer(whole.source.text, start, start + len(code))
        match = next((match for match in matches if match[1]), None)
        if match:
            return whole.source.span(match.start(), match.end())
    return whole.source.span(start, start + len(code))
