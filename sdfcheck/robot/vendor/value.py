"""A value of a vendor's tag, and how the vendor's consumer takes it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.text_pieces import part
from sdfcheck.formats.vendor.definitions import Slot
from sdfcheck.formats.vendor.values import Misreading, expected_of, misreading, out_of_range
from sdfcheck.robot.values import lazy
from sdfcheck.robot.vendor.relations import is_skipped
from sdfcheck.robot.vendor.siblings import FirstChildren
from sdfcheck.source.element import Value
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.robot.vendor.references import Unresolved
    from sdfcheck.robot.vendor.tag import VendorTag

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
