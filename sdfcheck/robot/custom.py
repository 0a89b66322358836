"""Custom data: prefixed attributes and elements, of which the format says only where they may be."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.robot.part import Part

if TYPE_CHECKING:
    from sdfcheck.formats.topology import Displaced
    from sdfcheck.source.element import Element, Value


class Custom(Part):
    """A prefixed element (``flatland:gear``), or a prefixed attribute.

    Source: the custom-elements proposal of SDFormat 1.7.
    """

    __slots__ = ("own_value",)
    is_custom = True

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
    def displaced(self) -> tuple[Displaced, ...]:
        """The standard elements in it that could be beside it, where simulators look for them."""
        if self.is_attribute:
            return ()
        if self.is_urdf:
            from sdfcheck.formats.urdf.survey import survey as urdf_survey

            return urdf_survey(self.document).displaced.get(self.element, ())
        return survey(self.document).displaced.get(self.element, ())

    @property
    def replaced(self) -> tuple[str, ...]:
        """The names of required elements that are absent beside it, and that it seems to replace."""
        return () if self.is_attribute else tuple(survey(self.document).replaced.get(self.element, ()))

    @property
    def text(self) -> str:
        """Its text, or the value of the attribute."""
        return self.own_value.text if self.own_value is not None else ""
