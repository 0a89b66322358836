"""The outline of a text: its parts as a tree, the ranges that fold, and the files that it names."""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator
from itertools import groupby, repeat
from operator import itemgetter
from pathlib import Path

from sdfcheck.files.uris import locate
from sdfcheck.lsp.cursor import elements
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.references import unescape
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span

_SHOWN = frozenset(
    """
    sdf world model link joint frame visual collision sensor light actor plugin include robot material
    transmission ros2_control gazebo gripper physics scene state gui xacro:macro xacro:property xacro:arg xacro:include
    """.split()
)
_URIS = frozenset(
    {"uri", "filename", "albedo_map", "normal_map", "metalness_map", "roughness_map", "heightmap"}
)


_NAMES = "|".join(
    f"{first}(?:{'|'.join(name[1:] for name in names)})"
    for first, names in groupby(sorted(_SHOWN), key=itemgetter(0))
)
_TAGS = re.compile(
    rf"<(?:({_NAMES})(?=[\s/>])([^<>\"']*(?:(?:\"[^\"<]*\"|'[^'<]*')[^<>\"']*)*)>"
    rf"|/({_NAMES})\s*>|!--[\s\S]*?-->|!\[CDATA\[[\s\S]*?\]\]>)"
)
_LABELS = {
    label: re.compile(rf"(?:^|\s){label}\s*=\s*[\"']\s*([^\"']*?)\s*[\"']")
    for label in ("name", "filename", "reference", "type")
}
_OTHERS = {"xacro:include": "filename", "gazebo": "reference"}
"""The attribute that holds the name, where it is another one."""
_TYPED = frozenset({"joint", "sensor", "light"})
_NAMED = frozenset(('name="', "name='"))
_BROUGHT = re.compile(r"<(name|uri)>\s*([^<]*?)\s*</\1>")


class Entry:
    """A part of a text; ``kind`` is the name of its element. Its name is at ``place``."""

    __slots__ = ("children", "detail", "end", "kind", "name", "place", "start")

    def __init__(self, kind: str, name: str, detail: str, start: int, place: tuple[int, int]) -> None:
        self.kind = kind
        self.name = name
        self.detail = detail
        self.start = self.end = start
        self.place = place
        self.children: list[Entry] = []


def outline(source: Source) -> list[Entry]:
    """The named parts of a text, as a tree; found by their tags alone, broken or not."""
    text = source.text
    top: list[Entry] = []
    stack: list[Entry] = []
    for tag in _TAGS.finditer(text):
        name, inside, closed = tag.groups()
        if name is not None:
            entry = _entry(name, inside, tag.start())
            if inside[-1:] == "/":
                _close(entry, tag.end(), stack, top)
            else:
                stack.append(entry)
        elif closed is not None and stack and stack[-1].kind == closed:
            _close(stack.pop(), tag.end(), stack, top)
        elif closed is not None and any(each.kind == closed for each in stack):
            while stack[-1].kind != closed:
                _close(stack.pop(), tag.start(), stack, top)
            _close(stack.pop(), tag.end(), stack, top)
    while stack:
        _close(stack.pop(), len(text), stack, top)
    for entry in top:
        _name_includes(entry, text)
    return top


def _entry(kind: str, inside: str, start: int) -> Entry:
    at = start + 1 + len(kind)
    label = _OTHERS.get(kind, "name")
    name, first = "", 0
    if label == "name" and inside[1:7] in _NAMED and (end := inside.find(inside[6], 7)) > 0:  # as usual
        quoted = inside[7:end]
        name = quoted.strip()
        first = 7 + quoted.find(name)
    elif inside and (match := _LABELS[label].search(inside)) is not None:
        name, first = match[1], match.start(1)
    place = (at + first, at + first + len(name)) if name else (start + 1, at)
    detail = kind
    if kind in _TYPED and (typed := _LABELS["type"].search(inside)) is not None:
        detail = f"{kind} {typed[1]}".strip()
    return Entry(kind, unescape(name) if "&" in name else name, detail, start, place)


def _close(entry: Entry, end: int, stack: list[Entry], top: list[Entry]) -> None:
    """An element ends: it belongs to the one around it, or else its parts do."""
    entry.end = end
    if entry.kind == "material" and not entry.name and not entry.children:
        return
    (stack[-1].children if stack else top).append(entry)


def _name_includes(entry: Entry, text: str) -> None:
    """Name includes after what they bring, and what has no name after its element."""
    waiting = [entry]
    while waiting:
        one = waiting.pop()
        waiting += one.children
        if not one.name and one.kind == "include":
            found = {match[1]: match[2] for match in _BROUGHT.finditer(text, one.start, one.end)}
            one.name = found.get("name") or found.get("uri") or ""
        one.name = one.name or one.kind


Fold = tuple[int, int, bool]
"""A range of lines, from 0, that can be folded away, and whether it is a comment."""


def folds(document: Document) -> list[Fold]:
    """The elements and comments of several lines."""
    lines, scan = [*document.source.line_starts, len(document.source.text) + 1], document.scan
    found: dict[int, tuple[int, bool]] = {}
    firsts = map(bisect_right, repeat(lines), scan.starts)
    for first, close in zip(firsts, scan.closes, strict=True):
        if (
            lines[first] <= close
            and first - 1 not in found
            and (last := bisect_right(lines, close, first)) > first + 1
        ):
            found[first - 1] = last - 2, False
    for start, end in scan.comments:
        first, last = bisect_right(lines, start) - 1, bisect_right(lines, end) - 1
        if last > first and first not in found:
            found[first] = last, True
    return [(first, last, is_comment) for first, (last, is_comment) in sorted(found.items())]


class Link(NamedTuple):
    """A place that names a file."""

    span: Span
    target: Path


def links(document: Document) -> Iterator[Link]:
    """The files that a document names and that are there."""
    for element in elements(document).all:
        for value in _uri_values(element):
            target = target_of(document, value)
            if target is not None:
                yield Link(value.span, target)


def _uri_values(element: Element) -> Iterator[Value]:
    name = element.name
    if name in _URIS and element.content:
        yield element.own_value
    value = element.attribute("filename")
    if value is not None and value.text.strip() and name != "plugin":
        yield value


def target_of(document: Document, value: Value) -> Path | None:
    """The file that a value names; after the folder of a model the model itself."""
    text = value.text.strip()
    if document.library is None or not text:
        return None
    if document.kind is Kind.XACRO and "$" in text:
        return _expanded(document, value)
    place = locate(document, text)
    if place.path is None or place.is_remote:
        return None
    if place.path.is_dir():
        if (
            value.element.name != "uri"
            or value.element.parent is None
            or value.element.parent.name != "include"
        ):
            return None
        from sdfcheck.robot.includes.included import included

        found = included(document, value.element.parent)
        return found.file
    return Path(place.path)


def _expanded(document: Document, value: Value) -> Path | None:
    """The file of an include whose name has parts that xacro knows."""
    from sdfcheck.xacro.static.definitions import visible_definitions

    if value.element.name != "xacro:include":
        return None
    return visible_definitions(document).target(value.element)
