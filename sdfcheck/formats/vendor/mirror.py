"""Tags that repeat a standard element in the vendor's own prefix (``<drake:visual>`` and all in it)."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.schema import Definition, schema
from sdfcheck.formats.sdf.version import NEWEST
from sdfcheck.formats.suggest import suggest
from sdfcheck.formats.vendor import problems
from sdfcheck.formats.vendor.definitions import PASSED_OVER, REFUSED, Tag, Vendor
from sdfcheck.source.element import Element


def mirror_problems(vendor: Vendor, tag: Tag, element: Element, standard: str) -> Iterator[object]:
    """Everything below must have the prefix, and be what the standard element may hold."""
    definition = schema(NEWEST).at(f"{standard}:{standard}")
    if definition is not None:
        yield from _below(vendor, tag, element, definition, top=True)


def _below(vendor: Vendor, tag: Tag, element: Element, definition: Definition, top: bool) -> Iterator[object]:
    mark = f"{vendor.prefix}:"
    for child in element.children():
        name = child.name
        bare = name.removeprefix(mark)
        if name == bare:
            meant = f"{mark}{name}"
            yield problems.UnknownTag(vendor, name, REFUSED, child, meant)
            continue
        if top and stands_here(vendor, name, element):
            continue
        inner = definition.children.get(bare)
        if inner is None:
            near = suggest(bare, definition.children)
            yield problems.UnknownTag(vendor, name, PASSED_OVER, child, f"{mark}{near}" if near else None)
        elif inner.type is None and not inner.open:
            yield from _below(vendor, tag, child, inner, top=False)


def stands_here(vendor: Vendor, name: str, parent: Element) -> bool:
    """Tags of the vendor that keep their meaning in there."""
    tag = vendor.tags.get(name)
    return tag is not None and any(place.encloses(parent) for place in tag.places)
