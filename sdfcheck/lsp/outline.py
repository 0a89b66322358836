"""The outline of a text: its parts as a tree, the ranges that fold, and the files that it names."""

from __future__ import annotations

import os
import re
from bisect import bisect_right
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import Generic, TypeVar

from sdfcheck.files.uris import locate
from sdfcheck.lsp.cursor import elements
from sdfcheck.lsp.workspace import same_ends
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source, Span, unescape

_SHOWN = frozenset(
    """
    sdf world model link joint frame visual collision sensor light actor plugin include robot material
    transmission ros2_control gazebo gripper physics scene state gui xacro:macro xacro:property xacro:arg xacro:include
    """.split()
)
_URIS = frozenset(
    {"uri", "filename", "albedo_map", "normal_map", "metalness_map", "roughness_map", "heightmap"}
)


def _tags(shown: Iterable[str]) -> re.Pattern[str]:
    """Tags with these names; a name that is written as usual is apart from the other attributes."""
    names = "|".join(
        f"{first}(?:{'|'.join(name[1:] for name in some)})"
        for first, some in groupby(sorted(shown), key=itemgetter(0))
    )
    return re.compile(
        rf"<(?:({names})(?=[\s/>])(?: name=\"([\w.:/-]+)\")?([^<>\"']*(?:(?:\"[^\"<]*\"|'[^'<]*')[^<>\"']*)*)>"
        rf"|/({names})\s*>|!--[\s\S]*?-->|!\[CDATA\[[\s\S]*?\]\]>)"
    )


_TAGS = {True: _tags(_SHOWN), False: _tags(_SHOWN - {"material"})}
"""Those of all texts, and of those in which no material has a name."""
_LABELS = {
    label: re.compile(rf"(?:^|\s){label}\s*=\s*[\"']\s*([^\"']*?)\s*[\"']")
    for label in ("name", "filename", "reference")
}
_MATERIAL = re.compile(r"<material\s")
_TYPE = re.compile(r"(?:^|\s)type\s*=\s*[\"']\s*([^\"']*?)\s*[\"']")
_OTHERS = {"xacro:include": "filename", "gazebo": "reference"}
"""The attribute that holds the name, where it is another one."""
_UNITS = frozenset({"model", "link", "joint", "xacro:macro"})
"""The elements whose part of an outline is kept while an edit elsewhere leaves their text as it is."""
_LINK_END = "</link>"
_TYPED = frozenset({"joint", "sensor", "light"})
_BROUGHT = re.compile(r"<(name|uri)>\s*([^<]*?)\s*</\1>")


T = TypeVar("T")


Part = tuple[str, str, str, int, int, int, list[T]]
"""A part of a text: the name of its element, that with its type, its own name, where it starts, where its name
starts and ends, and what was made of its own parts.
"""
Maker = Callable[[Part[T], int], T]
"""Makes something of a part and where it ends."""
Mover = Callable[[T, int, int], "T | None"]
"""Makes of what was made of a part the same for an equal text: where the one and the other start; None: it cannot."""


class Outlined(NamedTuple, Generic[T]):
    """The outline of a text.

    ``units`` are its larger parts that are whole, by where they start: where they end, and what was made of each.
    """

    source: Source
    parts: list[T]
    units: dict[int, tuple[int, T]]


def outline(
    source: Source, made: Maker[T], before: Outlined[T] | None = None, moved: Mover[T] | None = None
) -> Outlined[T]:
    """The named parts of a text, as a tree; found by their tags alone, broken or not.

    Parts that the text ``before`` has, too, are taken from its outline, and links that are written as an earlier one
    from that, where they can be ``moved``.
    """
    known = {} if before is None else _unchanged(before, source)
    outliner = _Outliner(source.text, made, known, moved)
    outliner.read()
    return Outlined(source, outliner.top, outliner.units)


class _Outliner(Generic[T]):
    """Reads a text for its outline, but for the units that are known."""

    def __init__(
        self, text: str, made: Maker[T], known: Mapping[int, tuple[int, T]], moved: Mover[T] | None
    ) -> None:
        self.text = text
        self.made = made
        self.moved = moved
        self.links: dict[str, tuple[int, T]] = {}
        """The texts of links, where the first of each starts, and what was made of it."""
        self.known = known
        self.units = {**known}
        self.top: list[T] = []
        self._stack: list[Part[T]] = []
        self._stray = -1
        """Where the last end tag of nothing ends: one day it may close what is around its unit."""
        ends = (text.find("<!--", text.rfind("-->") + 1), text.find("<![CDATA[", text.rfind("]]>") + 1))
        self._sure = min((end for end in ends if end >= 0), default=len(text))
        """Where a comment begins that may end one day, and then hold what is after its beginning."""

    def read(self) -> None:
        text, stack = self.text, self._stack
        search = _TAGS[_MATERIAL.search(text) is not None].finditer
        tags = search(text)
        while (tag := next(tags, None)) is not None:
            match tag.lastindex:
                case 4 if stack and stack[-1][0] == tag[4]:
                    self._close(tag.end(), is_whole=True)
                case 4 if stack:
                    self._end(tag[4], tag.start(), tag.end())
                case 3:
                    start, at = tag.span()
                    kind, name, inside, _ = tag.groups()
                    if kind in _UNITS and (known := self._take_known(kind, start)):
                        tags = search(text, known)
                        continue
                    detail, place = kind, tag.span(2)
                    if name is None or kind in _OTHERS:
                        name, place = _labelled(kind, text, start, at - 1)
                    if kind in _TYPED and (typed := _TYPE.search(inside)) is not None:
                        detail = f"{kind} {typed[1]}".strip()
                    stack.append((kind, detail, name, start, *place, []))
                    if inside[-1:] == "/":
                        self._close(at, is_whole=True)
        while stack:
            self._close(len(text), is_whole=False)

    def _take_known(self, kind: str, start: int) -> int:
        """Take a unit that is known, or written as an earlier link; returns where it ends, 0 for another one."""
        end, found = self.known.get(start) or (0, None)
        if found is None and kind == "link" and self.moved is not None:
            end = self.text.find(_LINK_END, start) + len(_LINK_END)
            first, made = self.links.get(self.text[start:end], (0, None))
            if made is not None and self._stray < start and end <= self._sure:
                found = self.moved(made, first, start)
        if found is None:
            return 0
        self.units[start] = end, found
        (self._stack[-1][6] if self._stack else self.top).append(found)
        return end

    def _end(self, kind: str, start: int, end: int) -> None:
        """Take the end tag of an element that is not the innermost: it ends those in it, too."""
        stack = self._stack
        if not any(each[0] == kind for each in stack):
            self._stray = end
            return
        while stack[-1][0] != kind:
            self._close(start, is_whole=False)
        self._close(end, is_whole=True)

    def _close(self, end: int, *, is_whole: bool) -> None:
        """An element ends: it belongs to the one around it, or else its parts do."""
        part = self._stack.pop()
        kind, detail, name, start, _, _, parts = part
        if not name:
            if kind == "material" and not parts:
                return
            part = (kind, detail, _named(kind, self.text, start, end), *part[3:])
        found = self.made(part, end)
        if kind in _UNITS and is_whole and self._stray < start and end <= self._sure:
            self.units[start] = end, found
            if kind == "link" and self.moved is not None:
                self.links.setdefault(self.text[start:end], (start, found))
        (self._stack[-1][6] if self._stack else self.top).append(found)


def _unchanged(before: Outlined[T], source: Source) -> dict[int, tuple[int, T]]:
    """The units of an outline that are the same in another text, where they start there, on the same lines."""
    old, new = before.source.text, source.text
    if (_MATERIAL.search(old) is None) != (_MATERIAL.search(new) is None):
        return {}
    first, rest = same_ends(old, new)
    last = len(old) - rest
    found = {start: unit for start, unit in before.units.items() if unit[0] <= first}
    if len(source.line_starts) == len(before.source.line_starts):
        begins, moved = old.find("\n", last), len(new) - len(old)
        for start, (end, made) in before.units.items():
            if start > begins >= 0:
                found[start + moved] = end + moved, made
    return found


def _labelled(kind: str, text: str, start: int, end: int) -> tuple[str, tuple[int, int]]:
    """The name of an element, which is not written as usual or not at all, and its place."""
    at = start + 1 + len(kind)
    name = _LABELS[_OTHERS.get(kind, "name")].search(text, at, end)
    return (unescape(name[1]), name.span(1)) if name and name[1] else ("", (start + 1, at))


def _named(kind: str, text: str, start: int, end: int) -> str:
    """A name for what has none: an include's is what it brings, and others are named after their element."""
    found = {}
    if kind == "include":
        found = {match[1]: match[2] for match in _BROUGHT.finditer(text, start, end)}
    return found.get("name") or found.get("uri") or kind


Fold = tuple[int, int, bool]
"""A range of lines, from 0, that can be folded away, and whether it is a comment."""


def folds(document: Document) -> list[Fold]:
    """The elements and comments of several lines."""
    import numpy as np

    lines, scan = document.source.line_starts, document.scan
    firsts = np.searchsorted(lines, scan.starts, "right")
    lasts = np.searchsorted(lines, scan.closes, "right")
    is_long = lasts > firsts + 1
    folded, outermost = np.unique(firsts[is_long], return_index=True)
    ends = lasts[is_long][outermost]
    found = {
        first: (last, False) for first, last in zip((folded - 1).tolist(), (ends - 2).tolist(), strict=True)
    }
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
    if os.path.isdir(place.path):
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
