"""What can be wrong with a vendor's own elements and attributes ("tags")."""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING

from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record
from sdfcheck.source.text import Span

if TYPE_CHECKING:
    from sdfcheck.formats.vendor.definitions import Effect, Vendor


class TagFault(Enum):
    """Why a value is not read as written."""

    NOT_A_NUMBER = "not a number"
    NOT_WHOLE = "not a whole number"
    NOT_FINITE = "infinity or nan"
    NOT_A_BOOLEAN = "neither true nor false"
    TRAILING = "text behind the number"
    TOO_FEW = "too few numbers"
    TOO_MANY = "too many numbers"
    EMPTY = "empty"


class TagProblem(Record):
    """About a tag of ``vendor``, called ``name``; ``effect`` is what its reader does about it."""

    vendor: Vendor
    name: str
    effect: Effect


class UnknownTag(TagProblem):
    """A prefixed name that the vendor does not have; ``target`` is an element, or an attribute."""

    target: Element | Value
    suggestion: str | None


class MisplacedTag(TagProblem):
    """A tag where the reader does not look for it.

    ``places`` are the parents where it does, in this dialect; ``other`` those of the other dialect
    if there are none; ``use`` is what this dialect has instead. ``condition`` is the place that
    it would have if a condition on its parents were met.
    """

    target: Element | Value
    places: tuple[str, ...]
    other: tuple[str, ...]
    use: str
    condition: str | None


class MalformedTag(TagProblem):
    """A value that is not of its type; ``span`` is the part to blame."""

    value: Value
    span: Span
    fault: TagFault
    expected: str


class MiscarriedTag(TagProblem):
    """A value in the wrong shape: text where an attribute is read, or the reverse.

    ``found`` and ``wanted`` are ``text``, ``@attribute`` or ``/child``.
    """

    element: Element
    value: Value
    found: str
    wanted: str


class TagOutOfRange(TagProblem):
    value: Value
    bound: str


class UnknownTagChoice(TagProblem):
    value: Value
    choices: tuple[str, ...]
    suggestion: str | None


class UnorderedTags(TagProblem):
    """A value that must be at most ``other``."""

    value: Value
    other: Value


class MissingTag(TagProblem):
    """``element`` lacks a child: the one called ``name``, or one of ``choices``.

    ``near`` is a child that may have been meant for it.
    """

    element: Element
    choices: tuple[str, ...]
    near: Element | None


class MissingTagValue(TagProblem):
    """An element without the attribute or plain child (``wanted``, such as ``@name``) that holds a value."""

    element: Element
    wanted: str
    near: str | None


class RepeatedTag(TagProblem):
    """A tag given again: only ``first`` counts."""

    element: Element
    first: Element


class RepeatedTagName(TagProblem):
    """A value that must be unique among the tags of one parent."""

    value: Value
    first: Value


class ConflictingTags(TagProblem):
    """``element`` and ``other`` exclude each other."""

    element: Element
    other: Element


class UnmetTag(TagProblem):
    """``element`` needs a sibling ``needed``; ``because`` is the element that makes it so, if one does."""

    element: Element
    needed: str
    because: Element | None


class IdleTag(TagProblem):
    """``element`` is not looked at because of ``other``."""

    element: Element
    other: Element


class ScopedTagName(TagProblem):
    """A definition with ``::`` in its name."""

    value: Value


class UnknownTagReference(TagProblem):
    """A name that nothing of the right ``kinds`` has; ``found`` is the kind of what has it instead."""

    value: Value
    kinds: tuple[str, ...]
    found: str | None
    suggestion: str | None
    scoped: bool
    """Names of parts of nested models are understood here."""


class SelfTiedTag(TagProblem):
    """Two ends of one thing name the same."""

    value: Value
    other: Value


class OutdatedTag(TagProblem):
    """A tag that is no longer read (``removed``), or that has a standard successor."""

    element: Element
    successor: str
    removed: bool


class TooNewTag(TagProblem):
    """A tag that came with release ``since``.

    ``declared`` is the release that the file says it is for; None where the tag is merely as
    new as the newest release that is known. ``uses`` are all of them.
    """

    target: Element | Value
    since: str
    declared: Value | None
    uses: int
