"""How a vendor's tags get on with their neighbours: what they need, exclude, and lose against."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.formats.vendor import problems
from sdfcheck.formats.vendor.definitions import PASSED_OVER, REFUSED, Effect, Tag, Vendor
from sdfcheck.formats.vendor.siblings import FirstChildren, first_child
from sdfcheck.formats.vendor.values import misreading, numbers, out_of_range
from sdfcheck.source.element import Element, Value

_TRUE = frozenset(("true", "1"))
_CONDITION = re.compile(r"([^(),]+)(?:\(([^)]*)\))?")


def relations(vendor: Vendor, tag: Tag, element: Element, parent: Element) -> Iterator[object]:
    """The problems that one tag has with what is around it."""
    keys = tag.keys
    for text in keys.all("excludes"):
        other = _one_of(text, parent)
        if other is not None:
            yield problems.ConflictingTags(vendor, tag.name, REFUSED, element, other)
            return
    if _is_excluded(vendor, tag, parent):
        return
    for name in keys.words("forbids"):
        if (other := element.find(name)) is not None:
            yield problems.ConflictingTags(vendor, tag.name, REFUSED, other, element)
    for text in keys.all("needs"):
        yield from _needs(vendor, tag, element, parent, text)
    other = _one_of(keys.text("idle-with"), parent)
    if other is None:
        other = next(
            (f for name in keys.words("loses-to") if (f := first_child(parent, name)) is not None), None
        )
    if other is not None:
        yield problems.IdleTag(vendor, tag.name, PASSED_OVER, element, other)
    yield from _compared(vendor, tag, element, parent)


def _is_excluded(vendor: Vendor, tag: Tag, parent: Element) -> bool:
    """Is there a sibling that excludes this one? Then that is what there is to say."""
    siblings = (vendor.tags.get(name) for name in parent.document.view(FirstChildren).of(parent))
    return any(tag.name in other.keys.all("excludes") for other in siblings if other is not None)


def _compared(vendor: Vendor, tag: Tag, element: Element, parent: Element) -> Iterator[object]:
    """Values that must differ from, or not exceed, those of other tags."""
    if limit := tag.keys.text("at-most"):
        yield from _at_most(vendor, tag, element, parent, limit)
    if name := tag.keys.text("differs"):
        other = first_child(parent, name)
        mine = _value(vendor, tag, element)
        theirs = None if other is None else _value(vendor, vendor.tags[name], other)
        if mine is not None and theirs is not None and mine.text.strip() == theirs.text.strip() != "":
            yield problems.SelfTiedTag(vendor, tag.name, REFUSED, mine, theirs)
    for name, slot in tag.attributes.items():
        if slot.unique is not None:
            yield from _unique(vendor, tag, element, parent, name, slot.unique)


def _is_skipped(tag: Tag, element: Element) -> bool:
    """Does an attribute of its own tell the reader not to look into it?"""
    switch = tag.keys.text("skipped").removeprefix("@")
    return element.attributes.get(switch, "").strip().lower() in _TRUE


def missing_children(vendor: Vendor, tag: Tag, element: Element) -> Iterator[problems.MissingTag]:
    """Children that must be there: by their own places, or one out of several."""
    if _is_skipped(tag, element):
        return
    given = {child.name for child in element.children()}
    effects = dict(text.rsplit(":", 1) for text in tag.keys.all("missing"))
    groups: list[tuple[str, ...]] = [
        (other.name,)
        for other in vendor.tags.values()
        for place in other.places
        if place.needed
        and place.path[0].name == tag.name
        and place.encloses(element)
        and place.holds(element)
    ]
    if choices := tag.keys.words("any"):
        groups.append(choices)
    for group in groups:
        if given.isdisjoint(group):
            effect = Effect.of(effects.get(group[0], "error"))
            bare = (name.partition(":")[2] for name in group)
            near = next((found for name in bare if (found := element.find(name)) is not None), None)
            yield problems.MissingTag(vendor, group[0], effect, element, group, near)


def beside(conditions: str, element: Element) -> Element | None:
    """The first sibling that meets one of ``tag(path,path)``: there, and one of the paths in the holder."""
    parent = element.parent
    return None if parent is None else _one_of(conditions, parent)


def _one_of(conditions: str, parent: Element) -> Element | None:
    for name, paths in _CONDITION.findall(conditions):
        found = _at(parent, name)
        if found is None and "/" in name:
            holder = _holder(parent)
            found = None if holder is None else _at(holder, name)
        if found is not None and (not paths or _shape(parent, paths) is not None):
            return found
    return None


def _needs(vendor: Vendor, tag: Tag, element: Element, parent: Element, text: str) -> Iterator[object]:
    match = _CONDITION.match(text)
    assert match is not None
    needed, paths = match.groups()
    because = _shape(parent, paths) if paths else None
    if (not paths or because is not None) and first_child(parent, needed) is None:
        yield problems.UnmetTag(vendor, tag.name, REFUSED, element, needed, because)


def _shape(parent: Element, paths: str) -> Element | None:
    holder = _holder(parent)
    if holder is None:
        return None
    return next((found for path in paths.split(",") if (found := _at(holder, path)) is not None), None)


def _holder(element: Element) -> Element | None:
    """The nearest standard element around."""
    at: Element | None = element
    while at is not None and at.is_custom:
        at = at.parent
    return at


def _at(element: Element, path: str) -> Element | None:
    found: Element | None = element
    for name in path.split("/"):
        found = None if found is None else first_child(found, name)
    return found


def _value(vendor: Vendor, tag: Tag, element: Element) -> Value | None:
    """The value of a tag, in whichever of its places it is."""
    for place in tag.places:
        if place.carrier == "text":
            return element.own_value
        if place.carrier[:1] == "@":
            return element.attribute(place.carrier[1:])
    return None


def _at_most(vendor: Vendor, tag: Tag, element: Element, parent: Element, limit: str) -> Iterator[object]:
    name = limit
    effect = REFUSED
    if limit.count(":") > 1:
        name, _, word = limit.rpartition(":")
        effect = Effect.of(word)
    other = first_child(parent, name)
    low = _number(vendor, tag, element)
    high = None if other is None else _number(vendor, vendor.tags[name], other)
    if low is not None and high is not None and low[0] > high[0]:
        yield problems.UnorderedTags(vendor, tag.name, effect, low[1], high[1])


def _number(vendor: Vendor, tag: Tag, element: Element) -> tuple[float, Value] | None:
    value = _value(vendor, tag, element)
    slot = next((place.slot for place in tag.places if place.slot is not None), None)
    if value is None or slot is None or not value.text.strip():
        return None
    if misreading(slot, value.text, vendor.is_lenient) or out_of_range(slot, value.text):
        return None
    return numbers(slot, value.text)[0], value


def _unique(
    vendor: Vendor, tag: Tag, element: Element, parent: Element, name: str, effect: Effect
) -> Iterator[object]:
    value = element.attribute(name)
    if value is None or not value.text:
        return
    other = parent.document.view(FirstChildren).with_value(parent, tag.name, name)[value.text]
    first = other.attribute(name)
    if other is not element and first is not None:
        yield problems.RepeatedTagName(vendor, tag.name, effect, value, first)
