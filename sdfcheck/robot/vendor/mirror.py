"""Tags that repeat a standard element in the vendor's own prefix (``<drake:visual>`` and all in it)."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.schema import Definition, schema
from sdfcheck.formats.sdf.version import NEWEST
from sdfcheck.formats.suggest import suggest
from sdfcheck.formats.vendor.definitions import IGNORED, REFUSED, Vendor
from sdfcheck.robot.vendor.tag import MirroredTag, VendorTag
from sdfcheck.source.element import Element


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
            near = suggest(bare, definition.children)
            yield MirroredTag(use.tags, child, f"{mark}{near}" if near else None, IGNORED)
        elif inner.type is None and not inner.open:
            yield from _below(use, child, inner)


def is_known_in(vendor: Vendor, name: str, parent: Element) -> bool:
    """Does a tag of the vendor keep its meaning in there?"""
    tag = vendor.tags.get(name)
    return tag is not None and any(place.encloses(parent) for place in tag.places)
