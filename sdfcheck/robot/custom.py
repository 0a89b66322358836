"""Custom data: prefixed attributes and elements, of which the format says only where they may be."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.robot.part import Part

if TYPE_CHECKING:
    from sdfcheck.source.element import Element, Value


class Custom(Part):
    """A prefixed element (``flatland:gear``), or a prefixed attribute.

    Source: the custom-elements proposal of SDFormat 1.7.
    """

    __slots__ = ("own_value",)

    def __init__(self, holder: Part, element: Element | None, attribute: Value | None = None) -> None:
        super().__init__(holder, element)
        self.own_value: Value | None = attribute
        """Its text with its place."""
        if attribute is None and element is not None:
            self.own_value = element.own_value

    @property
    def is_attribute(self) -> bool:
        return self.own_value is not None and self.own_value.attribute is not None

    @property
    def tag(self) -> str:
        """Its name as written, prefix included."""
        value = self.own_value
        return value.attribute if value is not None and value.attribute else self.element.name

    @property
    def prefix(self) -> str:
        return self.tag.partition(":")[0]

    @property
    def displaced(self) -> tuple[Element, ...]:
        """The standard elements in it that belong beside it, where simulators look for them."""
        return () if self.is_attribute else survey(self.document).displaced.get(self.element, ())

    @property
    def replaced(self) -> tuple[str, ...]:
        """The names of required elements that are absent beside it, and in place of which it seems to be given."""
        return () if self.is_attribute else tuple(survey(self.document).replaced.get(self.element, ()))

    @property
    def text(self) -> str:
        """Its text, or the value of the attribute."""
        return self.own_value.text if self.own_value is not None else ""


def customs(part: Part) -> dict[str, Custom]:
    """The custom attributes and elements of a part by name, the first of each."""
    found: dict[str, Custom] = {}
    if not part.is_given:
        return found
    for name in part.element.attributes:
        if ":" in name and not name.startswith(("xmlns:", "xml:")):
            found[name] = Custom(part, part.element, part.element.attribute(name))
    for child in part.children():
        if child.is_custom:
            made = part.part(child)
            if isinstance(made, Custom):
                found.setdefault(child.name, made)
    return found
