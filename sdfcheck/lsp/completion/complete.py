"""The names and values that can be typed at a place."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence

from sdfcheck.formats import near_names as usual
from sdfcheck.formats.vendor.definitions import Vendor
from sdfcheck.formats.vendor.table import vendors
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.lsp.completion.context import Context, Where, context
from sdfcheck.lsp.completion.item import Item, Sort
from sdfcheck.lsp.completion.likely import Usage, plain, words_in
from sdfcheck.lsp.completion.names import name_items, wanted
from sdfcheck.lsp.completion.paths import path_items
from sdfcheck.lsp.completion.tags import (
    Macros,
    Project,
    attribute_items,
    block_items,
    element_items,
    macros_in,
    parameter_items,
    seen_attributes,
    seen_items,
    semantic_attributes,
    semantic_elements,
    xacro_attributes,
    xacro_elements,
)
from sdfcheck.lsp.completion.values import command_items, semantic_values, value_items
from sdfcheck.lsp.names.expanded import roots_of
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.language import KEYWORDS
from sdfcheck.xacro.static.definitions import Definitions, visible_definitions
from sdfcheck.xacro.static.launches import launched_names

_VERSION = re.compile(r"<sdf\b[^<>]*?\bversion\s*=\s*[\"']([^\"']*)[\"']")
_EXPRESSION = re.compile(r"\$\{[^}]*?([^\W\d]\w*)?\Z")
_SUBSTITUTION = re.compile(r"\$\((?:(arg|find)\s+)?([^\s)]*)\Z")
_ASKED = re.compile(r"\$\(arg\s+([^\s()$]+)\)")
_MACRO = re.compile(r"<xacro:macro\b[^<>]*?\sname\s*=\s*[\"']([^\"'<>]+)[\"']|</xacro:macro")
_FILES = frozenset({"uri", "filename", "albedo_map", "normal_map", "metalness_map", "roughness_map"})
_KINDS = frozenset({Kind.SDF, Kind.URDF, Kind.XACRO, Kind.SRDF, Kind.BROKEN_XML, Kind.EMPTY})
_KEYWORDS = {
    "xacro:if": 0.15,
    "xacro:property": 0.13,
    "xacro:unless": 0.11,
    "xacro:insert_block": 0.1,
    "xacro:include": 0.1,
}
"""The elements that can be written next to calls anywhere, and how likely that is."""
MANY = 8
"""Of so many words one often follows the one before it."""
_BEFORE_END = 5
"""So many elements are suggested before the end of the one around."""


class Completion(NamedTuple):
    """The items that are offered in place of the text from ``start`` to ``end``, the likeliest first."""

    items: tuple[Item, ...]
    start: int
    end: int


def complete(workspace: Workspace, buffer: Buffer, offset: int) -> Completion:
    """The items at a place of an open text; none in a text that is not a description."""
    where = context(buffer.source.text, offset, buffer.checkpoints)
    if buffer.kind not in _KINDS and where.around:
        return Completion((), offset, offset)
    return _Completer(workspace, buffer, where, offset).run()


class _Completer:
    def __init__(self, workspace: Workspace, buffer: Buffer, where: Context, offset: int) -> None:
        self.workspace = workspace
        self.buffer = buffer
        self.where = where._replace(around=plain(where.around))
        self.written = where.around
        self.offset = offset
        is_robot = where.around[:1] == ("robot",) or where.tag == "robot"
        is_robot = is_robot or (buffer.kind is Kind.XACRO and where.around[:1] not in {(), ("sdf",)})
        self.is_srdf = buffer.kind is Kind.SRDF and is_robot
        self.is_urdf = is_robot and not self.is_srdf
        self.is_xacro = buffer.kind is Kind.XACRO or "xmlns:xacro" in buffer.source.text[:4096]
        self.dialect = "srdf" if self.is_srdf else "urdf" if self.is_urdf else "sdf"
        version = _VERSION.search(buffer.source.text, 0, 4096)
        self.version = (Version.parse(version[1]) if version else None) or NEWEST
        self.parameters: list[Item] = []
        """Those of the plugin around the place."""
        self._usage: Usage | None = None

    @property
    def vendors(self) -> Sequence[Vendor]:
        """The tables of vendors' own elements."""
        return vendors(self.workspace.library(self.buffer.path), "urdf" if self.is_urdf else "sdf")

    @property
    def usage(self) -> Usage:
        """The habits of the text around the place."""
        if self._usage is None:
            is_choice = self.written[-1:] != self.where.around[-1:]
            self._usage = Usage(self.buffer.source.text, self.where, self.offset, is_choice=is_choice)
        return self._usage

    def run(self) -> Completion:
        where = self.where
        if where.where is Where.NOWHERE:
            return Completion((), self.offset, self.offset)
        if where.where is Where.END:
            return self._of(map(_end, self.written[-1:]))
        if where.where is Where.TAG:
            return self._of(self._elements())
        if where.where is Where.ATTRIBUTE:
            return self._of(self._attributes())
        if self.is_xacro and (found := self._in_expression()) is not None:
            return found
        if where.where is Where.VALUE:
            return self._of(self._values())
        return self._in_text()

    def _of(self, items: Iterable[Item], start: int | None = None) -> Completion:
        unique: dict[str, Item] = {}
        for item in items:
            unique.setdefault(item.label, item)
        typed = self.where.typed if start is None else self.buffer.source.text[start : self.offset]
        order = sorted(unique.values(), key=lambda item: not item.label.startswith(typed))
        return Completion(tuple(order), self.where.start if start is None else start, self.offset)

    @property
    def visible(self) -> list[Definitions]:
        """The definitions that a xacro file can see, itself and in the robots that include it."""
        document = self._document
        return [visible_definitions(each) for each in (document, *roots_of(document))]

    @property
    def _document(self) -> Document:
        document = self.workspace.document(self.buffer.path)
        assert document is not None
        return document

    @property
    def project(self) -> Project:
        """The words of the xacro files of the project."""
        return self.workspace.library(self.buffer.path).of_project(self.buffer.path, Project)

    @property
    def macros(self) -> Macros:
        """The macros that a file can see, or could if packages were found."""
        return {**self.project.included(self.buffer.source.text), **macros_in(self.visible)}

    def _elements(self) -> list[Item]:
        around = self.where.around
        found: list[Item] = []
        if self.is_srdf:
            found += semantic_elements(around)
        else:
            found += element_items(around, self.version, self.vendors)
        self.parameters = [*parameter_items(self.buffer.source.text, around, self.offset)]
        found += self.parameters
        is_known = bool(found)
        if self.is_xacro and around:
            macros = self.macros
            if around[-1].startswith("xacro:") and around[-1].removeprefix("xacro:") not in KEYWORDS:
                found = [*block_items(around[-1], {**self.project.macros, **macros})]
            found += xacro_elements(macros)
        found += seen_items(self.usage.seen_elements(), "in this file")
        if not is_known or around[-1:] == ("plugin",):
            found += seen_items(usual.children(self.dialect, around[-1] if around else ""), "")
        return self._with_end(self._sorted_elements(found))

    def _sorted_elements(self, items: Iterable[Item]) -> list[Item]:
        unique: dict[str, Item] = {}
        for item in items:
            unique.setdefault(item.label, item)
        repeatable = {item.label for item in unique.values() if item.is_repeatable}
        scores = self.usage.elements(unique, self.dialect, repeatable, self.where.typed)
        if self.is_xacro:
            macros = [item.label for item in unique.values() if item.sort is Sort.MACRO]
            scores = {**scores, **dict(self._calls(macros, scores))}
            scores |= {f"xacro:{name}": -1.0 for name in self._open_macros()}
        present = {*self.usage.before, *self.usage.after}
        needed = {item.label for item in unique.values() if item.rank == 1 and item.label not in present}
        read = {item.label for item in self.parameters} - present
        more = ((name, score + (name in needed) + (name in read)) for name, score in scores.items())
        return _ordered(unique.values(), dict(more))

    def _open_macros(self) -> list[str]:
        """The macros that the place is in, which do not call themselves."""
        found: list[str] = []
        for name in _MACRO.findall(self.buffer.source.text, 0, self.offset):
            if name:
                found.append(name)
            elif found:
                found.pop()
        return found

    def _calls(self, macros: Sequence[str], scores: Mapping[str, float]) -> Iterator[tuple[str, float]]:
        """How likely calls are: rather of macros that nobody calls yet, and that are called like their neighbors."""
        called = {
            f"xacro:{call.name}" for each in self.visible for read in each.readings for call in read.calls
        }
        new = [name for name in macros if name not in called]
        # Elsewhere than in robots and macros, elements of the format are likelier, as long as nothing is typed.
        share = 1.0 if self.where.typed or self.where.around[-1:] in {("robot",), ("xacro:macro",)} else 0.1
        near = words_in(" ".join([*self.usage.before[-1:], *self.usage.after[:1]]))
        for name in macros:
            own = words_in(name)
            alike = len(own & near) / max(1, len(own | near))
            yield name, scores[name] + share * (0.4 * (name in new) / max(1, len(new)) + 0.1 * alike)
        for name, often in _KEYWORDS.items():
            if name in scores:
                yield name, scores[name] + share * often

    def _with_end(self, items: list[Item]) -> list[Item]:
        if self.written:
            items.insert(min(_BEFORE_END, len(items)), _end(f"/{self.written[-1]}"))
        return items

    def _attributes(self) -> list[Item]:
        tag = self.where.tag
        found: list[Item] = []
        if self.is_srdf:
            found += semantic_attributes(self.where)
        elif not tag.startswith("xacro:"):
            found += attribute_items(self.where, self.version, self.vendors)
        if self.is_xacro and tag.startswith("xacro:"):
            found += xacro_attributes(self.where, {**self.project.macros, **self.macros})
        if tag == "robot" and "xmlns:xacro" not in dict(self.where.given):
            text = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
            found.append(Item("xmlns:xacro", Sort.ATTRIBUTE, text, rank=6))
        found += seen_attributes(self.usage.seen_attributes(tag), self.where)
        needed = {item.label for item in found if item.rank == 1}
        scores = self.usage.attribute_scores(tag, {item.label for item in found}, self.dialect)
        return _ordered(found, {name: score + 2 * (name in needed) for name, score in scores.items()})

    def _values(self) -> list[Item]:
        where = self.where
        place = f"{where.tag}@{where.attribute}" if where.attribute else where.tag
        given = semantic_values(where) if self.is_srdf else value_items(where, self.version, self.vendors)
        choices = list(given)
        choices += self._usual_words(place, {item.label for item in choices})
        scores = self.usage.word_scores(place, {item.label for item in choices}, self.dialect)
        labels = [item.label for item in choices]
        last = self.usage.neighbors(place, self.offset)[0][:1] if len(labels) > MANY else []
        if last and last[0] in labels[:-1]:  # words that are written one after the other
            scores[labels[labels.index(last[0]) + 1]] += 1
        near = words_in(" ".join(value for _, value in where.given))
        scores = {
            name: score + bool(words_in(name) and words_in(name) <= near) for name, score in scores.items()
        }
        found = _ordered(choices, scores)
        kinds = wanted(where, self.dialect, self.vendors)
        is_file = (where.attribute or where.tag) in _FILES and where.tag != "plugin"
        # Reading a long text takes a while.
        document = self.workspace.document(self.buffer.path) if kinds or is_file else None
        if document is not None and kinds:
            found += name_items(self.workspace, document, where, self.offset, self.usage, kinds)
        if self.is_xacro and where.tag == "xacro:insert_block" and where.attribute == "name":
            found += self._blocks()
        if document is not None and is_file:
            found += path_items(document, where.typed, where.tag, where.around)
        if self.is_xacro and where.where is Where.VALUE and "$" not in where.typed:
            found += command_items()
        return found

    def _blocks(self) -> Iterator[Item]:
        """The properties that hold elements."""
        for visible in self.visible:
            for name, values in visible.given.items():
                if any(each.value is None and each.element.nodes for each in values):
                    yield Item(name, Sort.NAME, name, detail="property", rank=2)

    def _usual_words(self, place: str, known: set[str]) -> Iterator[Item]:
        """Words for a place whose words are not in the format, or that the text has there."""
        if place.endswith(("_interface@name", "hardwareInterface", "@reason")):
            yield from (
                Item(word, Sort.CHOICE, word) for word in dict.fromkeys(self.usage.seen_values(place))
            )
        if known and known <= {"true", "false"}:
            if self.usage.has_digits:
                yield from (Item(word, Sort.CHOICE, word) for word in ("1", "0"))
        elif not known:
            yield from (Item(word, Sort.CHOICE, word) for word in usual.words(self.dialect, place))

    def _in_text(self) -> Completion:
        """Values for an element that holds text, elements for one that holds elements."""
        found = self._of(self._values())
        if found.items or (self.where.typed and not self.where.typed[0].isalpha()):
            return found
        elements = (
            each._replace(text=f"<{each.text}", snippet=each.snippet and f"<{each.snippet}")
            for each in self._elements()
        )
        return self._of(elements)

    def _in_expression(self) -> Completion | None:
        """The names that an expression of xacro can use."""
        typed = self.where.typed
        if "$" not in typed:
            return None
        if (found := _EXPRESSION.search(typed)) is not None:
            visible = self.visible
            names = {name for each in visible for name in each.properties | each.parameters if name}
            word = found[1] or ""
            items = self._words_of_expressions(names, r"\$\{[^}]*\}", r"[^\W\d]\w*")
            return self._of(items, self.offset - len(word))
        if (found := _SUBSTITUTION.search(typed)) is not None and found[1]:
            if found[1] == "arg":
                names = {name for each in self.visible for read in each.readings for name in read.arguments}
                names |= set(_ASKED.findall(self.buffer.source.text)) | self.project.arguments
                names |= launched_names(self._document)
            else:
                library = self.workspace.library(self.buffer.path)
                names = set(library.packages(self.buffer.path).names)
            items = self._words_of_expressions(names, r"\$\([^)]*\)", r"[^\s()$]+")
            return self._of(items, self.offset - len(found[2]))
        return None

    def _words_of_expressions(self, names: set[str], expression: str, word: str) -> list[Item]:
        """Names for an expression: those that expressions nearby use, and that are called like the place."""
        text, start = self.buffer.source.text, max(0, self.offset - 4000)
        scores = dict.fromkeys(names, 0.0)
        attribute = self.where.attribute
        near = {attribute} | words_in(
            f"{attribute} {self.where.tag} {dict(self.where.given).get('name', '')}"
        )
        uses = Counter(
            found for match in re.findall(expression, text) for found in set(re.findall(word, match))
        )
        flags = self._flags() if self.where.tag in {"xacro:if", "xacro:unless"} else set()
        for match in re.finditer(expression, text[start : self.offset + 4000]):
            distance = abs(start + match.start() - self.offset)
            for found in re.findall(word, match[0]):
                if found in scores:
                    scores[found] += 20 / (20 + distance)
                    near |= words_in(found) if distance < 300 else set()
        for name in names:
            own = words_in(name) or {name}
            scores[name] += 2 * len(own & near) / max(1, len(own)) + (name == attribute)
            scores[name] += (uses[name] == 0) + 1.5 * name.endswith(f"_{attribute}") + 0.5 * (name in flags)
        return _ordered((Item(name, Sort.PROPERTY, name) for name in sorted(names)), scores)

    def _flags(self) -> set[str]:
        """The arguments that are true or false by default."""
        read = (each for visible in self.visible for each in visible.readings)
        known = ((name, default) for each in read for name, default in each.arguments.items())
        return {name for name, default in known if default.strip().lower() in {"true", "false", "0", "1"}}


def _ordered(items: Iterable[Item], scores: Mapping[str, float]) -> list[Item]:
    """Items, the likeliest first, then by rank."""
    return sorted(items, key=lambda item: (-round(scores.get(item.label, 0.0), 3), item.rank))


def _end(name: str) -> Item:
    return Item(name, Sort.ELEMENT, f"{name}>", f"{name}>", "end tag", 0 if name[0] != "/" else 4)
