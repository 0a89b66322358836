"""What the formats find wrong with a document: small values that rules put into words."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from sdfcheck.source.element import Element, Value
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.formats.schema import Definition
    from sdfcheck.formats.reading import Reading
    from sdfcheck.formats.version import Version


class MissingVersion(NamedTuple):
    """The root element has no ``version``, or an empty one."""

    element: Element


class UnknownVersion(NamedTuple):
    """A version that no reader knows; ``meant`` is the one that it was probably meant to be."""

    value: Value
    meant: str | None


class UnknownAttribute(NamedTuple):
    element: Element
    attribute: str
    suggestion: str | None


class UnknownElement(NamedTuple):
    """An element that no version knows anywhere."""

    element: Element
    parent: Element
    suggestion: str | None


class MisplacedElement(NamedTuple):
    """A standard element where its parent does not allow it; ``places`` are the parents that do."""

    element: Element
    parent: Element
    places: tuple[str, ...]
    suggestion: str | None


class TooNewElement(NamedTuple):
    """``uses`` are all elements of this name and place that the declared version does not have yet."""

    element: Element
    parent: Element
    since: Version
    declared: Version
    uses: tuple[Element, ...]


class TooNewAttribute(NamedTuple):
    element: Element
    attribute: str
    since: Version
    declared: Version
    uses: tuple[Element, ...]


class RemovedElement(NamedTuple):
    """Dropped before the declared version; ``until`` is the last version that had it.

    ``attribute`` is None when it is the element that was dropped.
    """

    element: Element
    parent: Element
    attribute: str | None
    until: Version
    successor: str | None


class DeprecatedElement(NamedTuple):
    """Marked deprecated; ``value`` where it is a value (a sensor type) that is."""

    element: Element
    value: Value | None
    successor: str | None
    since: str


class MissingElement(NamedTuple):
    """A required child is absent. ``default`` is what is taken instead; None: the file is refused."""

    element: Element
    child: str
    default: str | None


class ReplacedElement(NamedTuple):
    """A required child is absent and the custom element stands in for it."""

    custom: Element
    element: Element
    child: str


class MissingAttribute(NamedTuple):
    element: Element
    attribute: str
    empty: bool


class RepeatedElement(NamedTuple):
    """A child that may occur once, given again: only the first counts."""

    element: Element
    first: Element
    parent: Element


class StrayText(NamedTuple):
    """Text in an element that holds only elements."""

    span: Span
    element: Element


class BadValue(NamedTuple):
    """A value that is not read as written; ``reading`` says why. Subclasses are told apart by rules."""

    value: Value
    definition: Definition
    reading: Reading
    span: Span


class MalformedValue(BadValue):
    """Not of the type: refused."""

    __slots__ = ()


class MisreadValue(BadValue):
    """Accepted, and read as something else."""

    __slots__ = ()


class WrongComponentCount(BadValue):
    """Too few or too many numbers."""

    __slots__ = ()


class CutText(NamedTuple):
    """A value that ends at a comment: what follows, ``rest``, is not read."""

    value: Value
    rest: Span


class ReversedRange(NamedTuple):
    """Two bounds in the wrong order; ``text`` says it with their names and values."""

    lower: Value
    upper: Value
    text: str


class ValueOutOfRange(NamedTuple):
    """Outside the range that the format states; ``refused`` when libsdformat refuses it."""

    value: Value
    span: Span
    bound: str
    refused: bool


class UnknownChoice(NamedTuple):
    """A value that is none of those listed; ``refused`` when libsdformat refuses it."""

    value: Value
    choices: tuple[str, ...]
    suggestion: str | None
    refused: bool


class MissingShape(NamedTuple):
    element: Element


class SeveralShapes(NamedTuple):
    """``element`` is ignored because ``first`` is taken."""

    element: Element
    first: Element


class ConflictingRotation(NamedTuple):
    """A pose whose attributes do not go together: degrees with a quaternion."""

    value: Value
    format: Value


class MismatchedSensor(NamedTuple):
    """A sensor whose ``type`` and settings disagree.

    ``wrong`` is a settings element of another type; None when the settings that the
    type reads, ``expected``, are absent.
    """

    type: Value
    expected: str
    wrong: Element | None


class TopologyChanged(NamedTuple):
    """A standard element inside a custom one, where no reader looks for it."""

    element: Element
    custom: Element
    parent: Element
