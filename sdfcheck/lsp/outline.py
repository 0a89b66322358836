"""The outline of a text: its parts as a tree, the ranges that fold, and the files that it names."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from pathlib import Path

from sdfcheck.files.uris import locate
from sdfcheck.lsp.cursor import elements
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

_SHOWN = frozenset(
    """
    sdf world model link joint frame visual collision sensor light actor plugin include robot material
    transmission ros2_control gazebo gripper physics scene state gui xacro:macro xacro:property xacro:arg xacro:include
    """.split()
)
_URIS = frozenset(
    {"uri", "filename", "albedo_map", "normal_map", "metalness_map", "roughness_map", "heightmap"}
)


class Entry(NamedTuple):
    """A part of a text; ``kind`` is the name of its element."""

    kind: str
    name: str
    detail: str
    whole: Span
    place: Span
    children: tuple[Entry, ...]


def outline(document: Document) -> tuple[Entry, ...]:
    """The named parts of a document, as a tree."""
    root = document.root
    return () if root is None else tuple(_entries(root))


def _entries(element: Element) -> Iterator[Entry]:
    # Documents are not deep where parts have names, and those that are were refused as too deep.
    children = tuple(entry for child in element.children() for entry in _entries(child))
    name = element.name
    if name not in _SHOWN or (name == "material" and not element.attributes.get("name")):
        yield from children
        return
    value = element.attribute("name")
    label, place = name, element.span
    if value is not None and value.text.strip():
        label, place = value.text.strip(), value.span
    elif name in {"include", "xacro:include", "gazebo"}:
        own = _brought(element)
        label = own.text.strip() if own is not None and own.text.strip() else name
    spans = element.document.spans
    yield Entry(name, label, _detail(element), spans.whole(element), place, children)


def _brought(element: Element) -> Value | None:
    if element.name == "xacro:include":
        return element.attribute("filename")
    if element.name == "gazebo":
        return element.attribute("reference")
    return element.value("name") or element.value("uri")


def _detail(element: Element) -> str:
    kind = element.attributes.get("type", "")
    return f"{element.name} {kind}".strip() if element.name in {"joint", "sensor", "light"} else element.name


class Fold(NamedTuple):
    """A range of lines, from 0, that can be folded away."""

    first: int
    last: int
    is_comment: bool


def folds(document: Document) -> list[Fold]:
    """The elements and comments of several lines."""
    lines = document.source.line_starts
    scan = document.scan
    found: dict[int, Fold] = {}
    for start, close in zip(scan.starts, scan.closes, strict=True):
        first, last = bisect_right(lines, start) - 1, bisect_right(lines, close) - 2
        if last > first:
            found.setdefault(first, Fold(first, last, False))
    for start, end in scan.comments:
        first, last = bisect_right(lines, start) - 1, bisect_right(lines, end) - 1
        if last > first:
            found.setdefault(first, Fold(first, last, True))
    return [found[line] for line in sorted(found)]


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
