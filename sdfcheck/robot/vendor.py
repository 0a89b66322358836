"""Elements of vendors: their tags and values, what these refer to, and what they lack."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from itertools import chain
from pathlib import Path

from sdfcheck.formats.findings import part
from sdfcheck.formats.near_names import nearest, suggest
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.vendor.definitions import (
    IGNORED,
    REFUSED,
    Effect,
    Outcome,
    Place,
    Slot,
    Tag,
    Vendor,
    value_at,
    value_elsewhere,
)
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.formats.vendor.values import Misreading, expected_of, misreading, numbers, out_of_range
from sdfcheck.formats.version import NEWEST
from sdfcheck.robot.graph import Scope
from sdfcheck.robot.naming.name import MODEL_FRAME
from sdfcheck.robot.root import root_of
from sdfcheck.robot.values import lazy
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span, pattern

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
_CONDITION = pattern(r"([^(),]+)(?:\(([^)]*)\))?")


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


# A value of a vendor's tag, and how the vendor's consumer takes it.


_TEXTS = frozenset(("string", "file"))


class VendorValue:
    """A value of a vendor's tag; ``slot`` says what it is to be."""

    def __init__(self, tag: VendorTag, slot: Slot, value: Value) -> None:
        self.tag = tag
        self.prefix = tag.prefix
        self.slot = slot
        self.value = value
        self.text = value.text
        self.document = tag.document

    def __repr__(self) -> str:
        return f"VendorValue({self.title}: {self.text!r})"

    @property
    def span(self) -> Span:
        """Its place."""
        return self.value.span

    @property
    def title(self) -> str:
        """Its name in a sentence: its attribute or plain child, where that is not the tag itself."""
        own = self.value.attribute or self.value.element.name
        return f"`{self.tag.name}`" if own in {self.tag.name, "value"} else f"`{own}` of `{self.tag.name}`"

    @property
    def expected(self) -> str:
        """Its type in plain words."""
        return expected_of(self.slot)

    @lazy
    def misreading(self) -> Misreading | None:
        """Why it is not read as it is written; None where it is."""
        if self.slot.type in _TEXTS:
            return None
        return misreading(self.slot, self.text, self.tag.vendor.is_lenient, self.tag.is_judged)

    @property
    def misread_span(self) -> Span:
        """The part that is not read as it is written."""
        bad = self.misreading
        return part(self.value, bad.start, bad.end) if bad is not None and self.text.strip() else self.span

    @property
    def is_unknown_choice(self) -> bool:
        """Is it a word that is not one of the choices?"""
        if not self.slot.choices or self.misreading is not None:
            return False
        return self.text.strip() not in self.slot.choices

    @property
    def is_well_formed(self) -> bool:
        """Is it read as it is written?"""
        return self.misreading is None and not self.is_unknown_choice

    @property
    def is_definition(self) -> bool:
        """Is it the name of something that is defined here, and that can have no scoped name?"""
        return self.slot.plain is not None and self.is_well_formed

    @property
    def bound(self) -> str | None:
        """The bound that it breaks, in words."""
        if not self.is_well_formed or not self.tag.is_judged:
            return None
        return out_of_range(self.slot, self.text)

    @lazy
    def unresolved(self) -> Unresolved | None:
        """The fault of a name that is not defined; None where it refers to something."""
        if not self.slot.references or not self.text.strip() or not self.is_well_formed:
            return None
        if is_skipped(self.tag.vendor, self.value.element):
            return None
        return self.tag.tags.references.unresolved(self)

    @property
    def first(self) -> Value | None:
        """The same name of another tag before it, where names must differ."""
        is_unique = self.slot.unique is not None and self.value.attribute is not None and self.text
        if not is_unique or not self.tag.is_compatible:
            return None
        assert self.value.attribute is not None
        named = self.document.view(FirstChildren).with_value(
            self.tag.parent, self.tag.name, self.value.attribute
        )
        first = named[self.text]
        return None if first is self.value.element else first.attribute(self.value.attribute)


# Whether a vendor knows an element or attribute of its own, and where its consumer looks for it.


class PlacedTag:
    """One use of a vendor's element or attribute, as far as its name and place go.

    ``definition`` is what the vendor's table says about the name; None for a name that it does not have.
    """

    def __init__(
        self, tags: VendorTags, target: Element | Value, name: str, definition: Tag | None, parent: Element
    ) -> None:
        self.tags = tags
        self.vendor: Vendor = tags.vendor
        self.prefix = tags.vendor.prefix
        self.document = tags.document
        self.name = name
        self.definition = definition
        self.parent = parent
        """The element that it is in, or an attribute of."""
        self.target = target
        self.first: Element | None = None
        """The one of the same name before it, where one counts."""

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.name!r})"

    @property
    def span(self) -> Span:
        """The place of its name."""
        return self.target.name_span if isinstance(self.target, Value) else self.target.span

    @property
    def title(self) -> str:
        """Its name in a sentence."""
        return f"`{self.name}`" if isinstance(self.target, Value) else self.target.title

    @property
    def element(self) -> Element | None:
        """The element that it is; None for an attribute."""
        return None if isinstance(self.target, Value) else self.target

    @property
    def is_attribute(self) -> bool:
        return isinstance(self.target, Value)

    # Whether it is read

    @lazy
    def place(self) -> Place | None:
        """The place of the table that it is in; None where the vendor's consumer does not look for it."""
        return next((place for place in self._fitting if place.holds(self.parent)), None)

    @property
    def unmet(self) -> Place | None:
        """The place that it would have if a condition on the elements around it held."""
        return next(iter(self._fitting), None) if self.place is None else None

    @property
    def is_undecided(self) -> bool:
        """Has the element around it a wrong choice, which decides what it may hold?"""
        around = self.vendor.tags.get(self.parent.name) if self._fitting else None
        slots = around.attributes.items() if around is not None else ()
        given = self.parent.attributes
        return any(slot.choices and given.get(name) not in slot.choices for name, slot in slots)

    @property
    def is_gone(self) -> bool:
        """Was it read once, and is no longer?"""
        return self.definition is not None and bool(self.definition.keys.text("gone"))

    @property
    def is_read(self) -> bool:
        """Does the vendor's consumer look at it?"""
        return self.place is not None and self.first is None and not self.is_gone

    @property
    def successor(self) -> str:
        """The replacement of a tag that is removed, or that is older than a standard element; else empty."""
        if self.definition is None:
            return ""
        keys = self.definition.keys
        is_deprecated = self.is_read and self.document.kind.value in keys.words("deprecated-in")
        return keys.text("gone") or (keys.text("deprecated") if is_deprecated else "")

    @property
    def meant(self) -> str | None:
        """The tag that an unknown name was probably to be."""
        return meant(self.vendor, self.name)

    @property
    def effect(self) -> Effect:
        """The reaction of the vendor's consumer to a tag that is not read as it is written."""
        if self.definition is None:
            return self._effect_of_unknown()
        if self.is_gone:
            return self.definition.keys.effect("wrong") or REFUSED
        if self.place is None:
            return self._effect_of_misplaced(self.definition)
        return IGNORED if self.first is not None else Effect(Outcome.ACCEPTED)

    @property
    def places(self) -> tuple[str, ...]:
        """Where the vendor's consumer looks for it in this format."""
        return _shown(self.definition)

    @property
    def other_places(self) -> tuple[str, ...]:
        """Where it does in the other format."""
        return _shown(self.tags.other.tags.get(self.name))

    @property
    def substitute(self) -> str:
        """The counterpart in this format of a tag that only the other one has."""
        absent = self.definition.absent if self.definition is not None else None
        return absent.use if absent is not None else ""

    @property
    def mirrors(self) -> str:
        """The standard element that it repeats in the vendor's prefix; empty for most."""
        return self.definition.keys.text("mirror") if self.definition is not None else ""

    @lazy
    def _fitting(self) -> tuple[Place, ...]:
        """The places in which the names of the parents fit."""
        places = self.definition.places if self.definition is not None else ()
        return tuple(
            p for p in places if (p.carrier == "attribute") is self.is_attribute and p.encloses(self.parent)
        )

    def _effect_of_unknown(self) -> Effect:
        """That of a tag that is missing where this one was probably meant for it, else that of any in this place."""
        around = self.tags.by_element.get(self.parent)
        lacks = around.lacks if around is not None else ()
        decisive = (lack.effect for lack in lacks if lack.misspelled == self.name)
        return next(decisive, self.vendor.effect_in(None if self.is_attribute else self.parent))

    def _effect_of_misplaced(self, definition: Tag) -> Effect:
        usual = self.vendor.effect_in(None if self.is_attribute else self.parent)
        if self.unmet is not None:
            return self.unmet.otherwise or usual
        absent = definition.absent
        if absent is not None and (not absent.within or self.parent.name in absent.within):
            return absent.effect
        return usual


def _shown(tag: Tag | None) -> tuple[str, ...]:
    """The places of a tag for people."""
    places = tag.places if tag is not None else ()
    return tuple(f"{p.text}/@" if p.carrier == "attribute" else p.text for p in places)


# One use of a vendor's element or attribute: what it holds, what is around it, and when it came.


class MissingValue(NamedTuple):
    """A value that is not there; ``carrier`` is ``@attribute`` or ``/child``."""

    carrier: str
    effect: Effect
    near: str | None
    """The name of what may have been meant for it."""


class VendorTag(PlacedTag):
    """One use of a vendor's element or attribute."""

    def __init__(
        self, tags: VendorTags, target: Element | Value, name: str, definition: Tag | None, parent: Element
    ) -> None:
        super().__init__(tags, target, name, definition, parent)
        self.alike: list[VendorTag] = []
        """All tags of this name in the file, as far as they bring something of a later release of their own."""

    # Its values

    @lazy
    def values(self) -> tuple[VendorValue, ...]:
        """The values that it carries, without those with expressions of xacro."""
        found = [VendorValue(self, slot, value) for _, slot, value in self._slots() if value is not None]
        return tuple(value for value in found if "${" not in value.text and "$(" not in value.text)

    @property
    def missing_values(self) -> tuple[MissingValue, ...]:
        """The values that must be in attributes or plain children, and are nowhere."""
        if self.element is not None and is_skipped(self.vendor, self.element):
            return ()
        found = [
            (carrier, REFUSED)
            for carrier, slot, value in self._slots()
            if value is None and slot.required and slot is not self._own_slot
        ]
        if self.is_empty and self.carrier != "text" and self.stray is None:
            found.append((self.carrier, self.effect_of_empty))
        return tuple(MissingValue(carrier, effect, self._near(carrier)) for carrier, effect in found)

    @property
    def carrier(self) -> str:
        """Where its own value is: ``text``, ``@attribute``, ``/child``; empty if it has none."""
        return self.place.carrier if self.is_read and self.place is not None else ""

    @property
    def is_empty(self) -> bool:
        """Is its own value missing from where it is read?"""
        if self._own_slot is None or self.element is None:
            return False
        value = value_at(self.element, self.carrier)
        return value is None or (not value.text and self.carrier == "text")

    @property
    def lacks_text(self) -> bool:
        """Is its value the text that is missing?"""
        slot = self._own_slot
        return slot is not None and slot.type != "flag" and self.carrier == "text" and self.is_empty

    @property
    def stray(self) -> tuple[str, Value] | None:
        """Its value where it is not read from: the carrier and the value."""
        return (
            value_elsewhere(self.element, self.carrier)
            if self.is_empty and self.element is not None
            else None
        )

    @property
    def effect_of_empty(self) -> Effect:
        """The reaction of the vendor's consumer where the value is missing."""
        slot = self._own_slot
        if slot is None or slot.lacking is not None or self.carrier != "text":
            return (slot.lacking if slot is not None else None) or REFUSED
        empty = misreading(slot, "", self.vendor.is_lenient, self.is_judged)
        return REFUSED if empty is None else empty.effect

    @property
    def is_judged(self) -> bool:
        """Do the ranges of its values hold here?"""
        conditions = self.definition.keys.text("range-with") if self.definition is not None else ""
        return not conditions or sibling(conditions, self.parent) is not None

    # Surroundings

    @property
    def lacks(self) -> list[Lack]:
        """The children that it must have and does not."""
        return [] if self._use is None else list(lacks(self._use))

    @property
    def excluded(self) -> Element | None:
        """A sibling that it excludes."""
        return None if self._use is None else excluded_by(self._use)

    @property
    def forbidden(self) -> list[Element]:
        """The children that it must not have."""
        return [] if self._compatible is None else forbidden(self._compatible)

    @property
    def is_compatible(self) -> bool:
        """Is it read, without excluding a sibling or being excluded by one?"""
        return self._compatible is not None

    @property
    def needs(self) -> list[Need]:
        """The siblings that it must have and does not."""
        return [] if self._compatible is None else list(needs(self._compatible))

    @property
    def idle_beside(self) -> Element | None:
        """The sibling because of which it has no effect."""
        return None if self._compatible is None else idle_beside(self._compatible)

    @property
    def excess(self) -> Excess | None:
        """Its value and the one of a sibling that it must not exceed."""
        return None if self._compatible is None else excess(self._compatible)

    @property
    def tied(self) -> tuple[Value, Value] | None:
        """Its value and the same one of a sibling, which must be different."""
        return None if self._compatible is None else tied(self._compatible)

    # When it came

    @property
    def since(self) -> str:
        """The release of the vendor's consumer that brought it; empty where nobody knows."""
        place = self.place if self.is_read else None
        return "" if place is None or self.definition is None else place.since or self.definition.since

    @property
    def declared(self) -> Value | None:
        """The release that the file says it is for."""
        root = self.document.root
        return root.attribute(self.vendor.version) if root is not None and self.vendor.version else None

    @property
    def is_too_new(self) -> bool:
        """Is it of a later release than the file says, or where it says none, of the newest that is known?"""
        limit = _release(self.declared.text if self.declared is not None else "")
        newest, release = _release(self.vendor.release), _release(self.since)
        return release > limit if limit else self.declared is None and bool(newest) and release >= newest

    # For itself

    @property
    def _own_slot(self) -> Slot | None:
        return self.place.slot if self.is_read and self.place is not None else None

    def _slots(self) -> Iterator[tuple[str, Slot, Value | None]]:
        """All that may hold a value: the carrier, what it is to hold, and the value if it is there."""
        definition, slot = self.definition, self._own_slot
        if not self.is_read or definition is None:
            return
        if self.element is None:
            assert isinstance(self.target, Value)
            if slot is not None:
                yield "attribute", slot, self.target
            return
        if slot is not None:
            yield self.carrier, slot, None if self.is_empty else value_at(self.element, self.carrier)
        for slots, sigil in ((definition.attributes, "@"), (definition.parts, "/")):
            for name, other in slots.items():
                yield f"{sigil}{name}", other, value_at(self.element, f"{sigil}{name}")

    def _near(self, carrier: str) -> str | None:
        """The attribute, or the child with a prefix, that was probably meant."""
        assert isinstance(self.target, Element)
        if carrier[0] == "@":
            return suggest(carrier[1:], self.target.attributes)
        name = f"{self.prefix}:{carrier[1:]}"
        return name if self.target.has(name) else None

    @lazy
    def _use(self) -> Use | None:
        """It as an element that is read."""
        if self.element is None or self.definition is None or not self.is_read:
            return None
        return Use(self.vendor, self.definition, self.element, self.parent)

    @lazy
    def _compatible(self) -> Use | None:
        """The same, where no sibling excludes it, which would be reported then."""
        use = self._use
        is_in_conflict = use is None or self.excluded is not None or is_excluded(use)
        return None if is_in_conflict else use


class MirroredTag(VendorTag):
    """An element that is wrong in one that repeats a standard element in the vendor's prefix."""

    def __init__(self, tags: VendorTags, target: Element, meant: str | None, effect: Effect) -> None:
        parent = target.parent
        assert parent is not None, "it is in another element"
        super().__init__(tags, target, target.name, None, parent)
        self._meant = meant
        self._effect = effect

    @property
    def meant(self) -> str | None:
        return self._meant

    @property
    def effect(self) -> Effect:
        return self._effect


def _release(text: str) -> tuple[int, ...]:
    parts = text.strip().split(".")
    return tuple(map(int, parts)) if all(part.isdecimal() for part in parts) else ()


# The parts that the names in vendors' tags refer to: in SDF by scope, in URDF among the robot's parts.


_URDF_KINDS = frozenset({"frame", "joint", "link"})
_UNKNOWABLE = "?"


def owner_of(element: Element) -> Element | None:
    """The model or robot that the names in an element belong to."""
    return next((each for each in element.around if each.name in {"model", "robot"}), None)


class Unresolved(NamedTuple):
    """A name that nothing of the right kind has."""

    kinds: tuple[str, ...]
    """The kinds that would do."""
    found: str | None
    """The kind of what has the name instead."""
    near: str | None
    """The name that was probably meant."""


class _Found(NamedTuple):
    """The part of a name (None: nothing; ``?``: that cannot be determined), and the names that would do."""

    kind: str | None
    candidates: Iterable[str]


class References:
    """Resolves the names in the tags of one vendor in a document."""

    def __init__(self, document: Document, vendor: Vendor) -> None:
        self.document = document
        self.vendor = vendor
        self.is_sdf = document.kind is Kind.SDF
        self._parts: dict[tuple[Element, tuple[str, ...]], dict[str, str]] = {}
        self._right: dict[tuple[Element, tuple[str, ...], bool], list[str]] = {}
        self._tags: dict[tuple[Element, str], dict[str, None]] = {}

    def unresolved(self, value: VendorValue) -> Unresolved | None:
        """The fault of a name that is not defined; None for one that may refer to something."""
        slot, name = value.slot, value.text.strip()
        owner = owner_of(value.value.element)
        if owner is None:
            return None
        found = self.look_up(owner, slot, name)
        if found.kind in slot.references or found.kind == _UNKNOWABLE:
            return None
        return Unresolved(slot.references, found.kind, nearest(name, found.candidates, self.document))

    def look_up(self, owner: Element, slot: Slot, name: str) -> _Found:
        own = [kind for kind in slot.references if ":" in kind]
        found = _Found(None, [])
        if len(own) < len(slot.references):
            found = self.in_sdf(owner, slot, name) if self.is_sdf else self.in_urdf(owner, slot, name)
        for kind in own:
            if found.kind not in slot.references:
                tags = self.among_tags(owner, kind, slot, name)
                found = _Found(tags.kind or found.kind, chain(found.candidates, tags.candidates))
        return found

    def in_sdf(self, owner: Element, slot: Slot, name: str) -> _Found:
        scope = self.scope(owner)
        if scope is None or (name == MODEL_FRAME and "frame" in slot.references):
            return _Found(_UNKNOWABLE, [])
        right = self.right_in(owner, scope, slot)
        if "::" in name and not slot.scoped:
            return _Found(None, right)
        if scope.resolve(name) is None and scope.may_hold(name):
            return _Found(_UNKNOWABLE, [])
        return _Found(_kind(scope, name), right)

    def right_in(self, owner: Element, scope: Scope, slot: Slot) -> list[str]:
        """The names in a model that would do, in its order."""
        key = (owner, slot.references, slot.scoped)
        if key not in self._right:
            self._right[key] = [
                candidate
                for candidate in scope.names()
                if (slot.scoped or "::" not in candidate) and _kind(scope, candidate) in slot.references
            ]
        return self._right[key]

    def scope(self, owner: Element) -> Scope | None:
        part = root_of(self.document).part_of(owner)
        return part if isinstance(part, Scope) else None

    def in_urdf(self, owner: Element, slot: Slot, name: str) -> _Found:
        kinds = self.parts_of(owner, slot.references)
        key = (owner, slot.references, False)
        if key not in self._right:
            self._right[key] = [own for own, kind in kinds.items() if kind in slot.references]
        return _Found(None if name == "world" else kinds.get(name), self._right[key])

    def parts_of(self, owner: Element, wanted: tuple[str, ...]) -> dict[str, str]:
        """The kinds of a robot's parts by their names; of several of a name one that is wanted."""
        key = (owner, wanted)
        if key not in self._parts:
            kinds = self._parts[key] = {}
            for child in owner.children():
                kind = child.name.removeprefix(f"{self.vendor.prefix}:")
                own = child.attributes.get("name", "")
                if kind in _URDF_KINDS and own and kinds.get(own) not in wanted:
                    kinds[own] = kind
        return self._parts[key]

    def among_tags(self, owner: Element, kind: str, slot: Slot, name: str) -> _Found:
        """Tags of a kind in the same model or, where scoped names are understood, in nested ones."""
        path, delimiter, last = name.rpartition("::")
        if not delimiter:
            names = self.named(owner, kind)
            return _Found(kind if name in names else None, names)
        scope = self.scope(owner) if self.is_sdf and slot.scoped else None
        if scope is None:
            return _Found(None, self.named(owner, kind))
        model = scope.resolve(path)
        if not isinstance(model, Scope) or not model.is_complete:
            return _Found(_UNKNOWABLE if scope.may_hold(name) else None, [])
        names = self.named(model.element, kind)
        return _Found(kind if last in names else None, (f"{path}::{own}" for own in names))

    def named(self, owner: Element, kind: str) -> dict[str, None]:
        """The names of an element's children of one kind, in their order."""
        key = (owner, kind)
        if key not in self._tags:
            tags = (child for child in owner.children(kind) if not is_skipped(self.vendor, child))
            names = (child.text_of("name", "") for child in tags)
            self._tags[key] = dict.fromkeys(filter(None, names))
        return self._tags[key]


def _kind(scope: Scope, name: str) -> str | None:
    frame = None if name == "world" else scope.resolve(name)
    return None if frame is None else frame.kind


# The tags of vendors in a document, in its order.


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
    if document.kind not in {Kind.SDF, Kind.URDF} or document.source.contains("<xacro:"):
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
