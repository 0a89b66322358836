"""The tags of vendors in a document, in its order."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from sdfcheck.formats.near_names import nearest
from sdfcheck.formats.sdf.schema import Definition, schema
from sdfcheck.formats.sdf.version import NEWEST
from sdfcheck.formats.vendor.definitions import IGNORED, REFUSED, Vendor
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.robot.values import lazy
from sdfcheck.robot.vendor.references import References
from sdfcheck.robot.vendor.tag import MirroredTag, VendorTag
from sdfcheck.robot.vendor.value import VendorValue
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.sniff import Kind

_CLOSED = frozenset(("plugin", "gazebo"))
"""The content of these is for their own parsers."""


class VendorTags:
    """The elements and attributes of one vendor in a document."""

    def __init__(self, document: Document, vendor: Vendor, other: Vendor) -> None:
        self.document = document
        self.vendor = vendor
        self.other = other
        """The same vendor's table for the other format."""
        self.by_element: dict[Element, VendorTag] = {}
        """The tags that are elements and read."""
        self._mark = f"{vendor.prefix}:"
        self.all = list(self._walk(document.root)) if document.root is not None else []
        self._find_newcomers()

    @lazy
    def references(self) -> References:
        """The parts that names in values refer to."""
        return References(self.document, self.vendor)

    def _walk(self, root: Element) -> Iterator[VendorTag]:
        # As an attribute, a tag has a space before it.
        has_attributes = re.search(rf"\s{re.escape(self._mark)}", self.document.source.text) is not None
        waiting = [root]
        while waiting:
            element = waiting.pop()
            if has_attributes:
                yield from self._attributes(element)
            seen: dict[str, Element] = {}
            below: list[Element] = []
            for child in element.children():
                name = child.name
                if ":" not in name:
                    if name not in _CLOSED and (has_attributes or child.nodes):
                        below.append(child)
                elif name.startswith(self._mark):
                    use = self._element(child, element, seen)
                    yield use
                    if not use.is_read:
                        continue
                    if standard := use.mirrors:
                        yield from mirrored(use, standard)
                        yield from self._kept(child)
                    else:
                        below.append(child)
            waiting += reversed(below)

    def _element(self, element: Element, parent: Element, seen: dict[str, Element]) -> VendorTag:
        name = element.name
        use = VendorTag(self, element, name, self.vendor.tags.get(name), parent)
        if use.place is not None and not use.is_gone:
            if use.place.single:
                use.first = seen.get(name)
            seen.setdefault(name, element)
        if use.is_read:
            self.by_element[element] = use
        return use

    def _kept(self, element: Element) -> Iterator[VendorTag]:
        """The tags that keep their meaning where all else repeats a standard element."""
        seen: dict[str, Element] = {}
        for child in element.children():
            if is_known_in(self.vendor, child.name, element):
                yield self._element(child, element, seen)

    def _attributes(self, element: Element) -> Iterator[VendorTag]:
        for name, text in element.attributes.items():
            if name.startswith(self._mark):
                value = Value(element, name, text)
                yield VendorTag(self, value, name, self.vendor.tags.get(name), element)

    def _find_newcomers(self) -> None:
        """Gather the tags by name and release, without what came along with the element around it."""
        found: dict[tuple[str, str], list[VendorTag]] = {}
        for use in self.all:
            around = self.vendor.tags.get(use.parent.name)
            if use.since and (around is None or around.since != use.since):
                use.alike = found.setdefault((use.name, use.since), [])
                use.alike.append(use)


class _Known:
    """The tags of a document by the tables that they were looked up in."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._found: dict[Path, VendorTags] = {}

    def of(self, table: Path) -> VendorTags:
        found = self._found.get(table)
        if found is None:
            dialects = ("sdf", "urdf") if self._document.kind is Kind.SDF else ("urdf", "sdf")
            own, other = (vendor(table, dialect) for dialect in dialects)
            found = self._found[table] = VendorTags(self._document, own, other)
        return found


def tags(document: Document, tables: Iterable[Path]) -> Iterator[VendorTag]:
    """The tags of some vendors in an SDF or URDF document."""
    if document.kind not in {Kind.SDF, Kind.URDF} or "<xacro:" in document.source.text:
        return
    for table in tables:
        yield from document.view(_Known).of(table).all


def values(document: Document, tables: Iterable[Path]) -> Iterator[VendorValue]:
    """The values of those tags."""
    for tag in tags(document, tables):
        yield from tag.values


def mirrored(use: VendorTag, standard: str) -> Iterator[MirroredTag]:
    """The problems below: everything must have the prefix, and be allowed in the standard element."""
    definition = schema(NEWEST).at(f"{standard}:{standard}")
    if definition is not None and use.element is not None:
        yield from _below(use, use.element, definition)


def _below(use: VendorTag, element: Element, definition: Definition) -> Iterator[MirroredTag]:
    mark = f"{use.prefix}:"
    for child in element.children():
        name = child.name
        bare = name.removeprefix(mark)
        if name == bare:
            yield MirroredTag(use.tags, child, f"{mark}{name}", REFUSED)
            continue
        if element is use.element and is_known_in(use.vendor, name, element):
            continue
        inner = definition.children.get(bare)
        if inner is None:
            near = nearest(bare, definition.children)
            yield MirroredTag(use.tags, child, f"{mark}{near}" if near else None, IGNORED)
        elif inner.type is None and not inner.open:
            yield from _below(use, child, inner)


def is_known_in(vendor: Vendor, name: str, parent: Element) -> bool:
    """Does a tag of the vendor keep its meaning in there?"""
    tag = vendor.tags.get(name)
    return tag is not None and any(place.encloses(parent) for place in tag.places)
