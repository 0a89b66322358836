"""Problems that the walks find in a document: small values that rules put into words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.source.document import Element, Value
from sdfcheck.source.record import Record
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.formats.reading import Reading
    from sdfcheck.formats.schema import RowInVersion
    from sdfcheck.formats.version import Version


class UnknownAttribute(Record):
    """An attribute that no version knows there.

    ``more``: so many others of the element are unknown, of which only some are reported. ``child``: the child that
    it should be, as the ``others`` should.
    """

    element: Element
    attribute: str
    suggestion: str | None
    more: int = 0
    child: str | None = None
    others: tuple[str, ...] = ()


class UnknownElement(Record):
    """An element that no version knows anywhere; ``refused`` where libsdformat refuses the file for it."""

    element: Element
    parent: Element
    suggestion: str | None
    refused: bool = False


class MisplacedElement(Record):
    """A standard element where its parent does not allow it.

    ``places`` are the parents that do, the likeliest first and those only if there are
    any. ``ignored`` is False for what consumers find wherever it is, ``is_default`` True for a
    value that holds without it. ``others`` are siblings that go where it goes.
    """

    element: Element
    parent: Element
    places: tuple[str, ...]
    suggestion: str | None
    ignored: bool = True
    is_default: bool = False
    others: tuple[Element, ...] = ()


class TooNewElement(Record):
    """An element that the declared version does not have yet.

    ``uses`` are all elements of this name and place, ``declaration`` is the version that the
    file declares.
    """

    element: Element
    since: Version
    declaration: Value
    uses: tuple[Element, ...]


class TooNewAttribute(Record):
    """An attribute that the declared version does not have yet; as :class:`TooNewElement`."""

    element: Element
    attribute: str
    since: Version
    declaration: Value
    uses: tuple[Element, ...]


class RemovedElement(Record):
    """Dropped before the declared version; ``until`` is the last version that had it.

    ``attribute`` is None when it is the element that was dropped. ``others`` use it as well.
    """

    element: Element
    parent: Element
    attribute: str | None
    until: Version
    successor: str | None
    others: tuple[Element, ...] = ()


class DeprecatedElement(Record):
    """Marked deprecated; ``value`` where it is a value (a sensor type) that is.

    ``announced``: only said to go some day, and read by everybody still.
    ``settings`` is the element that has the old name of the value.
    """

    element: Element
    value: Value | None
    successor: str | None
    since: str
    announced: bool = False
    settings: Element | None = None


class MissingElement(Record):
    """A required child is absent; ``refused`` when libsdformat does not take the file so.

    ``default`` is the value that is taken instead, None where there is none to speak of. ``text`` is
    all that the element holds, ``others`` are more children that it lacks then, and ``fits`` says whether the
    text is a value for the child. ``attributes``: it is written as the first of these, and others as the rest.
    ``cause``: what the child is called instead.
    """

    element: Element
    child: str
    default: str | None
    refused: bool = False
    text: Span | None = None
    others: tuple[str, ...] = ()
    fits: bool = False
    attributes: tuple[str, ...] = ()
    cause: Span | None = None


class MissingAttribute(Record):
    """A required attribute is absent, or ``empty``.

    ``until`` is the last version that requires it, where the newest one does not; then
    only consumers of that time refuse the file. ``elements``: it is written as an element, and so are all these.
    ``others`` are elements of its name without it, in parents of one name. ``cause``: what it is called instead.
    """

    element: Element
    attribute: str
    empty: bool
    until: Version | None = None
    elements: tuple[Element, ...] = ()
    others: tuple[Element, ...] = ()
    cause: Span | None = None


class EmptyName(Record):
    """A name of nothing but spaces; ``until`` as in :class:`MissingAttribute`.

    Names of shapes in URDF are counted: ``shapes``.
    """

    value: Value
    until: Version | None = None
    shapes: int = 0


class RepeatedElement(Record):
    """A child that may occur once, given again: only the first counts.

    ``refused``: libsdformat does not take the file. That is so for a second model, light
    or actor at the root, where ``element`` and ``first`` may be of different names.
    ``others`` are given still later.
    """

    element: Element
    first: Element
    parent: Element
    refused: bool = False
    others: tuple[Element, ...] = ()


class StrayText(Record):
    """Text in an element that holds only elements; ``text`` is its first line."""

    span: Span
    text: str
    element: Element


class BadValue(Record):
    """A value that is not read as written; ``reading`` says why. Rules distinguish the subclasses."""

    value: Value
    definition: RowInVersion
    reading: Reading
    span: Span


class MalformedValue(BadValue):
    """Not of the type, which is refused; or empty, where (unless refused) the default is taken.

    ``attribute``: the only attribute of an empty element, where it has none.
    """

    attribute: str | None = None


class MisreadValue(BadValue):
    """Accepted, and read as something else."""


class WrongComponentCount(BadValue):
    """Too few or too many numbers."""


class CutText(Record):
    """A value that ends at a comment: what follows, ``rest``, is not read."""

    value: Value
    rest: Span


class ReversedRange(Record):
    """Two bounds in the wrong order; ``text`` says it with their names and values."""

    lower: Value
    upper: Value
    text: str


class ValueOutOfRange(Record):
    """Outside the range that the format states; ``refused`` when libsdformat refuses it.

    ``instead`` is what libsdformat takes in its place, where it does.
    """

    value: Value
    span: Span
    bound: str
    refused: bool
    instead: str | None = None


class UnknownChoice(Record):
    """A value that is not in the list; ``refused`` when libsdformat refuses it."""

    value: Value
    choices: tuple[str, ...]
    suggestion: str | None
    refused: bool


class SeveralShapes(Record):
    """``element`` is ignored because ``first`` is taken."""

    element: Element
    first: Element


class ConflictingRotation(Record):
    """A pose whose attributes do not go together: degrees with a quaternion."""

    value: Value
    format: Value


# Problems of URDF alone.


class UnknownUrdfElement(Record):
    """An element that no consumer of URDF looks for at this place.

    ``uses`` are all of this name below parents of this name; ``places`` the parents below
    which it would be read. ``needed``: ``suggestion`` is required there and missing. ``attributes``: these should be
    attributes of the parent. ``is_color``: they are all the colors that SDFormat gives materials.
    """

    element: Element
    parent: Element
    suggestion: str | None
    places: tuple[str, ...]
    uses: tuple[Element, ...]
    needed: bool
    attributes: tuple[Element, ...] = ()
    is_color: bool = False


class UnknownUrdfAttribute(Record):
    """An attribute that no consumer of URDF looks for; ``needed`` and ``uses`` as there.

    ``others`` are unknown attributes of the same elements, ``more``: so many others of the element
    are unknown, of which only some are reported.
    """

    value: Value
    suggestion: str | None
    uses: tuple[Value, ...]
    needed: bool
    more: int = 0
    others: tuple[Value, ...] = ()


class FeatureAboveVersion(Record):
    """Something of a later version of URDF, which urdfdom ignores in this document or refuses.

    ``place`` is an element or an attribute, ``what`` its name, ``count`` how often it is used there.
    """

    place: Element | Value
    what: str
    since: str
    declared: str
    count: int


class UnexpandedExpression(Record):
    """``${…}`` or ``$(…)``, which only xacro understands: ``span`` is the first of ``count``."""

    span: Span
    count: int
    values: tuple[Value, ...]
    """The attributes and texts that hold them."""
