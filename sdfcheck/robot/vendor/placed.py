"""Whether a vendor knows an element or attribute of its own, and where its consumer looks for it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.formats.vendor.definitions import IGNORED, REFUSED, Effect, Outcome, Place, Tag, Vendor
from sdfcheck.robot.values import lazy
from sdfcheck.robot.vendor.relations import meant
from sdfcheck.source.element import Element, Value
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.robot.vendor.tags import VendorTags


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
