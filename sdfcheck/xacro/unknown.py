"""The parts of an expansion that depend on values, packages or files that are not known.

An expression without a value is still in the expansion, as it is written: ``$(arg name)``.
"""

from __future__ import annotations

from sdfcheck.source.document import Element
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span
from sdfcheck.xacro.language import PREFIX
from sdfcheck.xacro.origins import ExpandedDocument

_ADDRESSES = frozenset({"filename", "parameters", "texture", "uri"})
"""Attributes and elements that are addresses of files: nothing else in the robot depends on them."""
_SHAPING = frozenset({"child", "inertia", "joint", "link", "mass", "name", "parent", "reference", "type"})
"""Attributes and elements on which the links and joints depend that consumers build."""

_SHAPED = frozenset({"inertial", "joint", "link", "robot", "visual"})
"""Elements that have another meaning for the robot with another child in them, or define a material for others."""


def is_unknown(text: str) -> bool:
    """Is there an expression in a text that an expansion has left?"""
    return "${" in text or "$(" in text


def has_unknown_value(span: Span) -> bool:
    """Have the expressions at a place of an expansion no value?"""
    return is_unknown(getattr(span, "value", None) or "")


class UnknownParts:
    """``is_whole``: all links, joints and materials are there; the rest decides nothing about what is built of them."""

    def __init__(self, document: ExpandedDocument) -> None:
        self._provenance = document.provenance
        self._places: set[tuple[str, int]] = set()
        self.is_whole = True
        for element in document.elements:
            region = self._region(element)
            for each in region.walk() if region is not None else ():
                self._places.add(self._place(each.index))

    def touch(self, span: Span) -> bool:
        """Does what is at a place depend on something that is not known?"""
        number = self._provenance.last_before(span.source, span.start)
        return has_unknown_value(span) or (number >= 0 and self._place(number) in self._places)

    def _place(self, number: int) -> tuple[str, int]:
        return str(self._provenance.source(number).path), self._provenance.offset(number)

    def _region(self, element: Element) -> Element | None:
        """The element that has another meaning for what is not known of this one."""
        parent = element.parent
        if parent is None:
            return None
        is_left = element.name.startswith(PREFIX)
        unknown = {name for name, text in element.attributes.items() if is_unknown(text)}
        if is_unknown(element.content):
            unknown.add(element.name)
        if not is_left and unknown <= _ADDRESSES:
            return element if unknown else None
        is_setting = parent.name == "gazebo" and "reference" in parent.attributes
        is_part = is_left and parent.name in _SHAPED
        if is_setting or is_part or unknown & _SHAPING or element.document.kind is not Kind.URDF:
            self.is_whole = False
        return element if parent.parent is None else parent
