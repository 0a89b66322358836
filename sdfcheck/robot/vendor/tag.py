"""One use of a vendor's element or attribute: what it holds, what is around it, and when it came."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from sdfcheck.formats.suggest import suggest
from sdfcheck.formats.vendor.carriers import value_at, value_elsewhere
from sdfcheck.formats.vendor.definitions import REFUSED, Effect, Slot, Tag
from sdfcheck.formats.vendor.values import misreading
from sdfcheck.robot.values import lazy
from sdfcheck.robot.vendor import relations
from sdfcheck.robot.vendor.placed import PlacedTag
from sdfcheck.robot.vendor.relations import Excess, Lack, Need, Use
from sdfcheck.robot.vendor.value import VendorValue
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.robot.vendor.tags import VendorTags


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
        if self.element is not None and relations.is_skipped(self.vendor, self.element):
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
        return not conditions or relations.sibling(conditions, self.parent) is not None

    # Surroundings

    @property
    def lacks(self) -> list[Lack]:
        """The children that it must have and does not."""
        return [] if self._use is None else list(relations.lacks(self._use))

    @property
    def excluded(self) -> Element | None:
        """A sibling that it excludes."""
        return None if self._use is None else relations.excluded_by(self._use)

    @property
    def forbidden(self) -> list[Element]:
        """The children that it must not have."""
        return [] if self._compatible is None else relations.forbidden(self._compatible)

    @property
    def is_compatible(self) -> bool:
        """Is it read, without excluding a sibling or being excluded by one?"""
        return self._compatible is not None

    @property
    def needs(self) -> list[Need]:
        """The siblings that it must have and does not."""
        return [] if self._compatible is None else list(relations.needs(self._compatible))

    @property
    def idle_beside(self) -> Element | None:
        """The sibling because of which it has no effect."""
        return None if self._compatible is None else relations.idle_beside(self._compatible)

    @property
    def excess(self) -> Excess | None:
        """Its value and the one of a sibling that it must not exceed."""
        return None if self._compatible is None else relations.excess(self._compatible)

    @property
    def tied(self) -> tuple[Value, Value] | None:
        """Its value and the same one of a sibling, which must be different."""
        return None if self._compatible is None else relations.tied(self._compatible)

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
        is_in_conflict = use is None or self.excluded is not None or relations.is_excluded(use)
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
