"""All that a xacro file can see: its own definitions, calls, includes and arguments, and those of what it includes."""

from __future__ import annotations

import ast
import fnmatch
import os
import re
from collections.abc import Collection, Iterator
from functools import lru_cache
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.files.regular import names_in
from sdfcheck.formats.near_names import nearest
from sdfcheck.source.document import Document, Element
from sdfcheck.source.record import NamedTuple, Record
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import (
    FIND,
    KEYWORDS,
    OPTIONAL,
    PREFIX,
    REQUIRED,
    Parameter,
    expressions,
    is_literal,
    matches,
    parameters,
    replaced,
    substitutions,
    syntax_tree,
)
from sdfcheck.xacro.problems import ExpansionFailure, Failure, IgnoredIncludeContent, WrongXacroAttribute
from sdfcheck.xacro.static.project import is_included

# The elements of the xacro language, also where they are misspelled.


_INCLUDE = "xacro:include"
_FREE = frozenset({"gazebo", "plugin", "ros2_control", "transmission", "mujoco"})
"""The content of these belongs to others, and its names may be those of xacro's elements."""


def keyword(element: Element) -> str:
    """Which element of the language this is or was meant to be, empty if none."""
    name = element.name
    if name.startswith(PREFIX):
        own = name[len(PREFIX) :]
        if own in KEYWORDS:
            return own
        near = nearest(own, REQUIRED)
        return near if near is not None and _has_needs(element, near) else ""
    return name if lacks_prefix(element) else ""


def lacks_prefix(element: Element) -> bool:
    """Whether an element is xacro's but for the prefix: by its name, its attributes and its place."""
    name = element.name
    return name in REQUIRED and _has_needs(element, name) and not is_free(element)


def is_free(element: Element) -> bool:
    """Whether an element is inside of what is another format's than the document's."""
    names = [each.name for each in element.around]
    return any(name in _FREE or (":" in name and not name.startswith(PREFIX)) for name in names)


def is_conditional(element: Element) -> bool:
    """Whether xacro may ignore an element."""
    return any(keyword(each) in {"if", "unless"} for each in element.around)


def is_outside(element: Element) -> bool:
    """Is an element directly in the root?"""
    return element.parent is not None and element.parent.parent is None


def own_attributes(element: Element, own: str) -> dict[str, str]:
    """The attributes of an element of the language, each by the name that was meant."""
    given = element.attributes
    if own not in REQUIRED or all(name in _taken(own) for name in given):
        return given
    meant: dict[str, str] = {}
    for name, text in given.items():
        meant.setdefault(_meant(name, own, given) or name, text)
    return meant


Found = WrongXacroAttribute | IgnoredIncludeContent


def element_problems(document: Document) -> Iterator[Found]:
    """Problems of the elements of the language in a document: their attributes, and what is not read."""
    for element in document.elements[1:]:
        if is_in_include(element):
            continue
        if element.name == _INCLUDE:
            yield from (IgnoredIncludeContent(child.span, child.name) for child in element.children())
        if element.name.startswith(PREFIX) and element.name[len(PREFIX) :] in REQUIRED:
            yield from _wrong_attributes(element, element.name[len(PREFIX) :])


def is_in_include(element: Element) -> bool:
    """Whether an element is where xacro looks at nothing."""
    return any(each.name == _INCLUDE for each in element.around)


def _wrong_attributes(element: Element, own: str) -> Iterator[WrongXacroAttribute]:
    given = element.attributes
    meant = set()
    for name in given:
        if name not in _taken(own) and ":" not in name:
            near = _meant(name, own, given)
            if near is None and own == "call":
                continue  # a parameter of the macro
            meant.add(near)
            span = element.document.spans.attribute_name(element, name)
            yield WrongXacroAttribute(span, element.name, name, is_missing=False, near=near)
    for name in REQUIRED[own]:
        if name not in given and name not in meant:
            yield WrongXacroAttribute(element.span, element.name, name, is_missing=True)


def _meant(name: str, own: str, given: dict[str, str]) -> str | None:
    """The intended name of an attribute: one that is near, else the only one that is required and missing."""
    free = [each for each in _taken(own) if each not in given]
    if name in _taken(own) or ":" in name:
        return None
    missing = [each for each in REQUIRED[own] if each not in given]
    unknown = [each for each in given if each not in _taken(own)]
    is_only = len(missing) == len(unknown) == 1 and own != "call"
    return nearest(name, free) or (missing[0] if is_only else None)


def _taken(own: str) -> tuple[str, ...]:
    return (*REQUIRED[own], *OPTIONAL.get(own, ()))


def _has_needs(element: Element, own: str) -> bool:
    return all(name in element.attributes for name in REQUIRED[own])


# The names that an expression needs from outside.


@lru_cache(maxsize=4096)
def free_names(code: str) -> frozenset[str]:
    """The names that a piece of code reads and does not bind itself; none if it is not Python."""
    try:
        tree = syntax_tree(replaced(code, lambda _: "0").strip())
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return frozenset()
    read: set[str] = set()
    bound: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Name):
            (read if isinstance(node.ctx, ast.Load) else bound).add(node.id)
        elif isinstance(node, ast.arg):
            bound.add(node.arg)
    return frozenset(read - bound)


# The definitions, calls, includes and reads of one xacro file, found without evaluating anything.


_WORD = re.compile(r"[^\W\d]\w*")
_PARAMETER = re.compile(r"\*{0,2}[^\W\d][\w.:-]*")


def is_name(parameter: Parameter) -> bool:
    """Has a parameter a name that an attribute of a call can have?"""
    return _PARAMETER.fullmatch(parameter.name) is not None


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

    @property
    def is_clear(self) -> bool:
        """Is each of its parameters a name, and no default another one, so that it takes these and no others?"""
        return all(is_name(each) and ":=" not in (each.default or "") for each in self.parameters)


class Property(Record):
    """A property; ``macro`` is the macro in whose body it is defined, ``value`` None for a block."""

    element: Element
    name: str
    value: str | None
    macro: Element | None

    @property
    def lasts(self) -> bool:
        """Is it known outside of the macro, too?"""
        return self.macro is None or bool(self.element.attributes.get("scope"))


class Call(Record):
    """A use of a macro, and the macro in whose body it is."""

    element: Element
    name: str
    macro: Element | None


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
            self.calls.append(Call(element, name[len(PREFIX) :], macro))
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
            self.is_open |= not name.isidentifier()
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
            called = attributes.get("macro", "")
            self.is_open |= not called or not is_literal(called)
            if called and is_literal(called):
                self.calls.append(Call(element, called, macro))

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
        if text.count("${") > text.count("}"):
            words.update(_WORD.findall(text))  # of an expression without end
    if element.name in {"xacro:insert_block", "insert_block"}:  # without the prefix it is meant for one
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


# All that a xacro file can see: itself and what it includes, as far as that can be known.


_CONTENT = frozenset({"xacro:call", "xacro:insert_block", "xacro:element"})
_GLOB = re.compile(r"[*?\[]")
_SIMPLE = re.compile(r"[^\W\d]\w*")
_ARGUMENT = re.compile(r"arg\s+(\S+)\s*$")


class Cycle(Record):
    """An include that leads back to a file that is being included."""

    include: Include
    steps: tuple[Span, ...]
    certain: bool


class Definitions:
    """A document and the files that it includes.

    ``is_open``: some of them cannot be known or read, so that what is not found here
    may still be somewhere; ``reaches_out``: somewhere out of the project.
    """

    def __init__(self, document: Document) -> None:
        self.readings: list[Reading] = []
        self.cycles: list[Cycle] = []
        self.is_open = self.reaches_out = False
        self.missing: list[Include] = []
        """The includes of the document itself whose file is known for certain and not there."""
        self.unmatched: list[Include] = []
        """The includes of the document itself whose pattern matches no file."""
        self.conditional: set[Document] = set()
        """The documents that only includes lead to which xacro may ignore."""
        self.given: dict[str, list[Property]] = {}
        """Property → all that give it a value."""
        self.parameters: set[str] = set()
        self._done: set[str] = set()
        self._enter(document, ())
        self.macros: dict[str, list[Macro]] = {}
        for read in self.readings:
            for macro in read.macros:
                self.macros.setdefault(macro.name, []).append(macro)
        self.namespaces = {i.namespace for read in self.readings for i in read.includes if i.namespace}
        self.properties = self.given.keys() | self.namespaces
        self.words = set[str]().union(*(read.words for read in self.readings))

    def _enter(self, document: Document, way: tuple[tuple[str, Include | None], ...]) -> None:
        path = document.source.real_path
        self._done.add(path)
        read = reading(document)
        self.readings.append(read)
        for found in read.properties:
            self.given.setdefault(found.name, []).append(found)
        self.parameters.update(p.name.lstrip("*") for macro in read.macros for p in macro.parameters)
        self.is_open |= read.is_open
        self.reaches_out |= read.is_open
        if any(include is not None and include.conditional for _, include in way):
            self.conditional.add(document)
        for include in read.includes:
            targets = self._targets(include, document)
            if not targets and self._is_pattern(include, document):
                self.unmatched += [include] if not way else []
                continue
            self.is_open |= not targets
            self.reaches_out |= not targets and not self._stays(include, document)
            is_missing = not targets and not include.optional and self._known_path(include, document)
            if (
                is_missing
                and not way
                and not (include.conditional and self._asks_arguments(include.filename))
            ):
                self.missing.append(include)
            for target in targets:
                self._follow(target, document, (*way, (path, include)))

    def _follow(self, target: Path, document: Document, way: tuple[tuple[str, Include | None], ...]) -> None:
        library = library_of(document)
        real = library.disk.real(target) if library is not None else os.path.realpath(target)
        paths = [path for path, _ in way]
        if real in paths:
            if real == paths[0]:
                passed = [i for _, i in way[paths.index(real) :] if i is not None]
                certain = not any(i.conditional for i in passed)
                first = passed[0]
                self.cycles.append(Cycle(first, tuple(i.element.span for i in passed), certain))
            return
        if real in self._done:
            return
        found = library.document(target, Kind.XACRO, document) if library else None
        if found is None or found.root is None:
            self.is_open = self.reaches_out = True
        else:
            self._enter(found, way)

    def _stays(self, include: Include, document: Document) -> bool:
        """Is an include, whose file an expression decides, of a folder or package that is there?"""
        if self._known_path(include, document) is not None:
            return False
        start = next(matches(include.filename), None)
        if start is None or start.start() > 0:
            return start is not None
        find = FIND.match(start["command"] or "")
        library = library_of(document)
        return bool(find and library and library.packages(document.path).find(find[1], document.path))

    def _targets(self, include: Include, document: Document) -> list[Path]:
        """The files that an include names; none if that cannot be known."""
        path = self._known_path(include, document)
        if path is None or (library := library_of(document)) is None:
            return []
        if _GLOB.search(str(path)):
            names = names_in(path.parent) if not _GLOB.search(str(path.parent)) else []
            return [path.parent / name for name in fnmatch.filter(names, path.name)]
        path = library.packages(document.path).locate(path)
        return [path] if os.path.isfile(path) else []

    def target(self, element: Element) -> Path | None:
        """The one file that an ``xacro:include`` names; None if that cannot be known."""
        for read in self.readings:
            for include in read.includes:
                if include.element is element:
                    found = self._targets(include, read.document)
                    return found[0] if len(found) == 1 else None
        return None

    def _is_pattern(self, include: Include, document: Document) -> bool:
        """Whether an include names files by a pattern, in a folder that is known."""
        path = self._known_path(include, document)
        return path is not None and bool(_GLOB.search(path.name)) and not _GLOB.search(str(path.parent))

    def _known_path(self, include: Include, document: Document) -> Path | None:
        """Where an include leads, if that can be known."""
        return self.path_of(include.filename, document, document.path.parent)

    def path_of(self, written: str, document: Document, folder: Path) -> Path | None:
        """Where a path leads that is written in a file of a folder, if that can be known."""
        text = self._known_text(written, document)
        return folder / text if text and document.library is not None else None

    def _asks_arguments(self, text: str, of: frozenset[str] = frozenset()) -> bool:
        """Does a text have the value of an argument, which may be another one than the default?"""
        for match in matches(text):
            name = (match["code"] or "").strip()
            values = [found.value or "" for found in self.given.get(name, ()) if name not in of]
            if _ARGUMENT.match(match["command"] or "") or any(
                self._asks_arguments(value, of | {name}) for value in values
            ):
                return True
        return False

    def _known_text(self, text: str, document: Document, of: frozenset[str] = frozenset()) -> str:
        """A text whose substitutions have one possible value each; empty if one has not, or is in ``of``."""
        pieces, at = [], 0
        for match in matches(text):
            value = self._value(match, document, of) if match[0] not in of else None
            if value is None:
                return ""
            pieces += [text[at : match.start()], value]
            at = match.end()
        return "".join([*pieces, text[at:]])

    def _value(self, match: re.Match[str], document: Document, of: frozenset[str]) -> str | None:
        if match["command"] is not None:
            find = FIND.match(match["command"])
            if find and (library := library_of(document)) is not None:
                folder = library.packages(document.path).find(find[1], document.path)
                return None if folder is None else str(folder)
            argument = _ARGUMENT.match(match["command"])
            name = argument[1] if argument else ""
            values = {read.arguments[name] for read in self.readings if name in read.arguments}
        elif match["code"] is not None and _SIMPLE.fullmatch(match["code"].strip()):
            name = match["code"].strip()
            if name in self.parameters:
                return None
            values = {found.value or "" for found in self.given.get(name, ())}
        else:
            return None
        if len(values) != 1:
            return None
        return self._known_text(values.pop(), document, of | {match[0]}) or None


def visible_definitions(document: Document) -> Definitions:
    return document.view(Definitions)


_NO_ROBOT = frozenset(
    {"xacro:property", "xacro:arg", "xacro:attribute", "gazebo", "ros2_control", "transmission"}
)


def is_robot(document: Document) -> bool:
    """Whether a file is meant to be expanded on its own, rather than to be included.

    A robot has a name (a SDFormat document needs none), and elements or macro calls
    outside of macros; or else it only puts together what it includes. Beside macros, materials
    make no robot, nor do blocks about the links of another file.
    """
    root = document.root
    if root is None or root.name not in {"robot", "sdf"}:
        return False
    if root.name == "robot" and "name" not in root.attributes:
        return False
    found = _kinds_of_content(root)
    return "content" in found or (bool(found & {"include", "material"}) and "macro" not in found)


def has_content(document: Document) -> bool:
    """Are there elements or macro calls outside of macros?"""
    return document.root is not None and "content" in _kinds_of_content(document.root)


def _kinds_of_content(root: Element) -> set[str]:
    """The kinds of elements outside of macros: ``content``, ``macro``, ``include``, ``material``."""
    found = set()
    todo = list(root.children())
    while todo:
        element = todo.pop()
        name = element.name
        if name in {"xacro:if", "xacro:unless"}:
            todo += element.children()
        elif name in {"xacro:macro", "xacro:include", "material"}:
            found.add(name.rpartition(":")[2])
        elif name not in _NO_ROBOT and (
            not name.startswith(PREFIX) or name in _CONTENT or name.count(":") == 1
        ):
            found.add("content")
    return found


def knows_all(document: Document) -> bool:
    """Is all that a file uses known? Not what those define that include it, or what cannot be found."""
    return document.view(_knows_all)


def _knows_all(document: Document) -> bool:
    return is_robot(document) and not visible_definitions(document).is_open and not is_included(document)


# The arguments that a xacro file takes, and those that it lacks.

_ASKED = re.compile(r"arg\s+([^\s${}]+)\s*$")
_CALLED = re.compile(r"\barg\(\s*['\"]([^'\"]+)['\"]\s*\)")


class Taken(NamedTuple):
    """The arguments that a file declares or asks for; ``is_complete``: it takes no others."""

    names: frozenset[str]
    is_complete: bool


def taken_arguments(document: Document) -> Taken:
    """The arguments that a file takes, itself and in what it includes."""
    visible = visible_definitions(document)
    names = {name for read in visible.readings for name in read.arguments}
    for read in visible.readings:
        names.update(match[1] for command in read.commands if (match := _ASKED.match(command.text)))
        names.update(name for found in read.expressions for name in _CALLED.findall(found.code))
    return Taken(frozenset(names), not visible.is_open)


def missing_arguments(document: Document, given: Collection[str]) -> Iterator[ExpansionFailure]:
    """The first use of each argument that an expansion asks for and nobody gives a value."""
    visible = visible_definitions(document)
    known = {*given, *(name for read in visible.readings for name in read.arguments)}
    for read in visible.readings:
        if read.document in visible.conditional:
            continue
        for command in read.commands:
            match = _ASKED.match(command.text)
            if match and match[1] not in known and _is_asked(command, visible):
                known.add(match[1])
                whole = f"$({command.text})"
                span = place(command.element, command.attribute, whole)
                yield ExpansionFailure(span, Failure.ARGUMENT, match[1], whole)


def _is_asked(command: Command, visible: Definitions) -> bool:
    """Whether an expansion asks for what a command gives; for a property if somebody reads it."""
    element = command.element
    if command.certain or element.name != "xacro:property":
        return command.certain
    return (
        is_outside(element)
        and not is_conditional(element)
        and element.attributes.get("name") in visible.words
    )
