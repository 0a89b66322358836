"""What URDF's own shape makes wrong with a document; the rest is said as for SDFormat."""

from __future__ import annotations

from sdfcheck.source.document import Element, Value
from sdfcheck.source.record import Record
from sdfcheck.source.text import Span


class UnknownUrdfElement(Record):
    """An element that no consumer of URDF looks for at this place.

    ``uses`` are all of this name below parents of this name; ``places`` the parents below
    which it would be read. ``needed``: ``suggestion`` is required there and missing.
    """

    element: Element
    parent: Element
    suggestion: str | None
    places: tuple[str, ...]
    uses: tuple[Element, ...]
    needed: bool


class UnknownUrdfAttribute(Record):
    """An attribute that no consumer of URDF looks for; ``needed`` and ``uses`` as above.

    ``more``: so many others of the element are unknown, of which only some are reported.
    """

    value: Value
    suggestion: str | None
    uses: tuple[Value, ...]
    needed: bool
    more: int = 0


class FeatureAboveVersion(Record):
    """Something of a later version of URDF, which urdfdom ignores in this document or refuses.

    ``place`` is an element or an attribute, ``what`` its name.
    """

    place: Element | Value
    what: str
    since: str
    declared: str


class UnexpandedExpression(Record):
    """``${…}`` or ``$(…)``, which only xacro understands: ``span`` is the first of ``count``."""

    span: Span
    count: int
    values: tuple[Value, ...]
    """The attributes and texts that hold them."""
