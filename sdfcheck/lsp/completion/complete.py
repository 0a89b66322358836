"""The names and values that can be typed at a place."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.formats.sdf.version import NEWEST, Version
from sdfcheck.lsp.completion.context import Context, Where, context
from sdfcheck.lsp.completion.item import Item, Sort
from sdfcheck.lsp.completion.names import name_items, wanted
from sdfcheck.lsp.completion.paths import path_items
from sdfcheck.lsp.completion.tags import attribute_items, element_items, xacro_attributes, xacro_elements
from sdfcheck.lsp.completion.values import command_items, control_items, value_items
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.static.definitions import Definitions, visible_definitions

_VERSION = re.compile(r"<sdf\b[^<>]*?\bversion\s*=\s*[\"']([^\"']*)[\"']")
_EXPRESSION = re.compile(r"\$\{[^}]*?([^\W\d]\w*)?\Z")
_SUBSTITUTION = re.compile(r"\$\((?:(arg|find)\s+)?([^\s)]*)\Z")
_FILES = frozenset({"uri", "filename", "albedo_map", "normal_map", "metalness_map", "roughness_map"})


class Completion(NamedTuple):
    """The items that are offered in place of the text from ``start`` to ``end``."""

    items: tuple[Item, ...]
    start: int
    end: int


def complete(workspace: Workspace, buffer: Buffer, offset: int) -> Completion:
    """The items at a place of an open text; none in a text that is not a description."""
    kind = buffer.kind
    where = context(buffer.source.text, offset, buffer.checkpoints)
    if kind not in {Kind.SDF, Kind.URDF, Kind.XACRO, Kind.BROKEN_XML, Kind.EMPTY} and where.around:
        return Completion((), offset, offset)
    return _Completer(workspace, buffer, where, offset).run()


class _Completer:
    def __init__(self, workspace: Workspace, buffer: Buffer, where: Context, offset: int) -> None:
        self.workspace = workspace
        self.buffer = buffer
        self.where = where
        self.offset = offset
        self.is_urdf = where.around[:1] == ("robot",) or where.tag == "robot"
        self.is_xacro = self.is_urdf and buffer.kind is Kind.XACRO
        version = _VERSION.search(buffer.source.text, 0, 4096)
        self.version = (Version.parse(version[1]) if version else None) or NEWEST

    def run(self) -> Completion:
        where = self.where
        if where.where is Where.NOWHERE:
            return Completion((), self.offset, self.offset)
        if where.where is Where.END:
            return self._of(map(_end, where.around[-1:]))
        if where.where is Where.TAG:
            return self._of(self._elements())
        if where.where is Where.ATTRIBUTE:
            return self._of(self._attributes())
        if self.is_xacro and where.where is Where.VALUE and (found := self._in_expression()) is not None:
            return found
        if where.where is Where.VALUE:
            return self._of(self._values())
        return self._in_text()

    def _of(self, items: Iterator[Item] | map[Item], start: int | None = None) -> Completion:
        unique: dict[str, Item] = {}
        for item in items:
            unique.setdefault(item.label, item)
        return Completion(tuple(unique.values()), self.where.start if start is None else start, self.offset)

    @property
    def visible(self) -> Definitions:
        """The definitions that a xacro file can see; the document is read for it."""
        document = self.workspace.document(self.buffer.path)
        assert document is not None
        return visible_definitions(document)

    def _elements(self) -> Iterator[Item]:
        around = self.where.around
        yield from control_items(around)
        yield from element_items(around, self.version, is_urdf=self.is_urdf)
        if self.is_xacro and around:
            yield from xacro_elements(self.visible)
        if around:
            yield _end(f"/{around[-1]}")

    def _attributes(self) -> Iterator[Item]:
        yield from attribute_items(self.where, self.version, is_urdf=self.is_urdf)
        if self.is_xacro and self.where.tag.startswith("xacro:"):
            yield from xacro_attributes(self.where, self.visible)
        if self.where.tag == "robot" and "xmlns:xacro" not in dict(self.where.given):
            text = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
            yield Item("xmlns:xacro", Sort.ATTRIBUTE, text, rank=6)

    def _values(self) -> Iterator[Item]:
        where = self.where
        yield from value_items(where, self.version, is_urdf=self.is_urdf)
        is_name = bool(wanted(where, is_urdf=self.is_urdf))
        is_file = (where.attribute or where.tag) in _FILES and where.tag != "plugin"
        # Reading a long text takes a while.
        document = self.workspace.document(self.buffer.path) if is_name or is_file else None
        if document is not None and is_name:
            yield from name_items(document, where, self.offset)
        if document is not None and is_file:
            yield from path_items(document, where.typed, where.tag, where.around)
        if self.is_xacro and where.where is Where.VALUE and "$" not in where.typed:
            yield from command_items()

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
        visible = self.visible
        if (found := _EXPRESSION.search(typed)) is not None:
            names = sorted(visible.properties | visible.parameters)
            word = found[1] or ""
            items = (Item(name, Sort.PROPERTY, name, rank=2) for name in names if name)
            return self._of(items, self.offset - len(word))
        if (found := _SUBSTITUTION.search(typed)) is not None and found[1]:
            if found[1] == "arg":
                names = sorted({name for read in visible.readings for name in read.arguments})
            else:
                library = self.workspace.library(self.buffer.path)
                names = library.packages(self.buffer.path).names
            items = (Item(name, Sort.NAME, name, rank=2) for name in names)
            return self._of(items, self.offset - len(found[2]))
        return None


def _end(name: str) -> Item:
    return Item(name, Sort.ELEMENT, f"{name}>", f"{name}>", "end tag", 0 if name[0] != "/" else 4)
