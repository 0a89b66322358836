"""What Drake does not support, or takes in its own way, in documents that are right by their format."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record

if TYPE_CHECKING:
    from sdfcheck.formats.vendor.definitions import Effect


class UnsupportedJoint(Record):
    """A joint of a type that Drake does not have; ``instead`` is how to write what is meant.

    ``where`` says what about the joint's surroundings makes it so (a world, a static model).
    """

    type: Value
    effect: Effect
    instead: str | None = None
    where: str | None = None


class UnsupportedMesh(Record):
    """A mesh file of a format that Drake does not read in this role; ``formats`` are those that it does."""

    value: Value
    role: str
    formats: tuple[str, ...]
    effect: Effect


class UnactuatedJoint(Record):
    """A joint that Drake makes no actuator for; ``target`` is the reason, ``idle`` is not read for it."""

    target: Element | Value
    joint: str
    reason: str
    effect: Effect
    idle: Element | None = None
    others: int = 0


class MasslessLeaf(Record):
    """A link that ends a moving branch, with nothing fixed to it or below it that has mass.

    ``joint`` is the joint that moves it; None for a free link.
    """

    link: Element
    joint: Element | None
    links: int


class IgnoredByDrake(Record):
    """An element or attribute that Drake passes over; ``uses`` counts those of this kind."""

    target: Element | Value
    parent: str
    warned: bool
    uses: int


class SpecialValue(Record):
    """A value that means something else to Drake than by the format."""

    value: Value
    meaning: str


class FrictionOrder(Record):
    """The dynamic friction ``dynamic`` is above the static one; None where it is the default, 1."""

    static: Value
    dynamic: Value | None


class CrashesDrake(Record):
    """Something that ends the whole process, or an assertion in it."""

    target: Element | Value
    what: str
    effect: Effect
