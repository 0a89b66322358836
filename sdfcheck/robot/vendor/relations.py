"""How a vendor's tags get on with their neighbors: what they need, exclude, and lose against."""

from __future__ import annotations

import re
from collections.abc import Iterator

from sdfcheck.formats.near_names import nearest, suggest
from sdfcheck.formats.vendor.definitions import REFUSED, Effect, Tag, Vendor
from sdfcheck.formats.vendor.values import misreading, numbers, out_of_range
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.record import NamedTuple

# Children by name, looked up once for each element: a group may have any number of members.


class FirstChildren:
    """The first child of each name, of the elements of a document."""

    __slots__ = ("_by_name", "_by_value")

    def __init__(self, document: Document) -> None:
        self._by_name: dict[Element, dict[str, Element]] = {}
        self._by_value: dict[tuple[Element, str, str], dict[str, Element]] = {}

    def of(self, parent: Element) -> dict[str, Element]:
        """The first children of an element by their names as written."""
        known = self._by_name.get(parent)
        if known is None:
            known = self._by_name[parent] = {}
            for child in parent.children():
                known.setdefault(child.name, child)
        return known

    def with_value(self, parent: Element, name: str, attribute: str) -> dict[str, Element]:
        """The first children of a name by the value of an attribute."""
        key = (parent, name, attribute)
        known = self._by_value.get(key)
        if known is None:
            known = self._by_value[key] = {}
            for child in parent.children(name):
                value = child.attribute(attribute)
                if value is not None:
                    known.setdefault(value.text, child)
        return known


def first_child(parent: Element, name: str) -> Element | None:
    """The first child of a name; the same as ``parent.find(name)``, where it is asked of every child."""
    return parent.document.view(FirstChildren).of(parent).get(name)


_TRUE = frozenset(("true", "1"))
_CONDITION = re.compile(r"([^(),]+)(?:\(([^)]*)\))?")


class Use(NamedTuple):
    """A tag as an element of a document."""

    vendor: Vendor
    tag: Tag
    element: Element
    parent: Element


class Lack(NamedTuple):
    """A child that must be there and is not: one of ``choices``."""

    choices: tuple[str, ...]
    effect: Effect
    near: Element | None
    """A child without prefix that may have been meant for it."""
    misspelled: str | None
    """The name of a child that the vendor does not know, and that is near to a choice."""


class Need(NamedTuple):
    """A sibling that must be there and is not; ``because`` is the element that makes it so, if one does."""

    name: str
    because: Element | None


class Excess(NamedTuple):
    """A value above the one of another tag that it must not exceed."""

    low: Value
    high: Value
    effect: Effect


def excluded_by(use: Use) -> Element | None:
    """The sibling that a tag excludes."""
    return next(
        (found for text in use.tag.keys.all("excludes") if (found := sibling(text, use.parent)) is not None),
        None,
    )


def is_excluded(use: Use) -> bool:
    """Is there a sibling that excludes this tag?"""
    names = use.parent.document.view(FirstChildren).of(use.parent)
    siblings = (use.vendor.tags.get(name) for name in names)
    return any(use.tag.name in other.keys.all("excludes") for other in siblings if other is not None)


def forbidden(use: Use) -> list[Element]:
    """The children that a tag must not have."""
    found = map(use.element.find, use.tag.keys.words("forbids"))
    return [child for child in found if child is not None]


def idle_beside(use: Use) -> Element | None:
    """The sibling because of which a tag has no effect."""
    tag, parent = use.tag, use.parent
    other = sibling(tag.keys.text("idle-with"), parent)
    if other is not None:
        return other
    return next(
        (f for name in tag.keys.words("loses-to") if (f := first_child(parent, name)) is not None), None
    )


def needs(use: Use) -> Iterator[Need]:
    """The siblings that a tag needs and does not have."""
    parent = use.parent
    for text in use.tag.keys.all("needs"):
        match = _CONDITION.match(text)
        assert match is not None
        needed, paths = match.groups()
        because = _shape(parent, paths) if paths else None
        if (not paths or because is not None) and first_child(parent, needed) is None:
            yield Need(needed, because)


def tied(use: Use) -> tuple[Value, Value] | None:
    """The value of a tag and the same one of another, which must be different."""
    name = use.tag.keys.text("differs")
    other = first_child(use.parent, name) if name else None
    mine = _value(use.tag, use.element) if other is not None else None
    theirs = None if other is None else _value(use.vendor.tags[name], other)
    if mine is None or theirs is None or not mine.text.strip() == theirs.text.strip() != "":
        return None
    return mine, theirs


def excess(use: Use) -> Excess | None:
    """The value of a tag that is above the one that it must not exceed."""
    name, effect = use.tag.keys.text("at-most"), REFUSED
    if name.count(":") > 1:
        name, _, word = name.rpartition(":")
        effect = Effect.of(word)
    other = first_child(use.parent, name) if name else None
    low = _number(use.vendor, use.tag, use.element) if other is not None else None
    high = None if other is None else _number(use.vendor, use.vendor.tags[name], other)
    if low is None or high is None or not low[0] > high[0]:
        return None
    return Excess(low[1], high[1], effect)


def is_skipped(vendor: Vendor, element: Element) -> bool:
    """Does an attribute of a tag, or of one around it, make the consumer skip its content?"""
    at: Element | None = element
    while at is not None and (tag := vendor.tags.get(at.name)) is not None:
        switch = tag.keys.text("skipped").removeprefix("@")
        text = at.text_of(switch, "") if switch else ""
        is_exact = bool(switch) and tag.attributes[switch].type == "truth"
        if text == "true" or (not is_exact and text.strip().lower() in _TRUE):
            return True
        at = at.parent
    return False


def lacks(use: Use) -> Iterator[Lack]:
    """Children that must be there: by their own places, or one out of several."""
    vendor, tag, element = use.vendor, use.tag, use.element
    if is_skipped(vendor, element):
        return
    given = [child.name for child in element.children()]
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
    groups = [group for group in groups if set(group).isdisjoint(given)]
    strange = [name for name in given if name.startswith(f"{vendor.prefix}:") and name not in vendor.tags]
    # Where one is missing, a name that is only somewhat like it is meant for it.
    wanted = [name for group in groups for name in group]
    meanings = {suggest(name, wanted): name for name in strange} if groups else {}
    for group in groups:
        effect = Effect.of(effects.get(group[0], "error"))
        bare = (name.partition(":")[2] for name in group)
        near = next((found for name in bare if (found := element.find(name)) is not None), None)
        misspelled = next((meanings[choice] for choice in group if choice in meanings), None)
        yield Lack(group, effect, near, misspelled)


def meant(vendor: Vendor, name: str) -> str | None:
    """The tag that a misspelled name was probably to be."""
    mark = f"{vendor.prefix}:"
    found = nearest(name.removeprefix(mark), (tag.removeprefix(mark) for tag in vendor.tags))
    return f"{mark}{found}" if found else None


def sibling(conditions: str, parent: Element) -> Element | None:
    """The first child that meets one of ``tag(path,path)``: there, and one of the paths in the holder."""
    for name, paths in _CONDITION.findall(conditions):
        found = _at(parent, name)
        if found is None and "/" in name:
            holder = _holder(parent)
            found = None if holder is None else _at(holder, name)
        if found is not None and (not paths or _shape(parent, paths) is not None):
            return found
    return None


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


def _value(tag: Tag, element: Element) -> Value | None:
    """The value of a tag, in whichever of its places it is."""
    for place in tag.places:
        if place.carrier == "text":
            return element.own_value
        if place.carrier[:1] == "@":
            return element.attribute(place.carrier[1:])
    return None


def _number(vendor: Vendor, tag: Tag, element: Element) -> tuple[float, Value] | None:
    value = _value(tag, element)
    slot = next((place.slot for place in tag.places if place.slot is not None), None)
    if value is None or slot is None or not value.text.strip():
        return None
    if misreading(slot, value.text, vendor.is_lenient) or out_of_range(slot, value.text):
        return None
    return numbers(slot, value.text)[0], value
