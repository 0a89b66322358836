"""What moves badly from one generation of Gazebo to the next, or from URDF into it."""

from __future__ import annotations

from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import Record
from sdfcheck.source.text import Span


class IgnitionName(Record):
    """A name from the time when Gazebo was called Ignition.

    ``changes`` are all places to change with it (a plugin's file and class, every use of a
    prefix), and what they are to hold.
    """

    span: Span
    old: str
    new: str
    changes: tuple[tuple[Span, str], ...]


class ClassicOnlyElement(Record):
    """An element or plugin that only Gazebo Classic reads; ``count`` of its kind are in the document."""

    target: Element | Value
    what: str
    count: int


class ExtensionLostByName(Record):
    """Settings for a link in ``<gazebo>`` that do not reach a visual or collision with a name of its own."""

    settings: tuple[Element, ...]
    name: Value
    """That of the first visual or collision that they do not reach."""
    link: str
    count: int
    """How many they do not reach."""


class DisabledLumping(Record):
    """``disableFixedJointLumping`` for a fixed joint, which makes it a revolute one."""

    element: Element
    joint: Element


class ScriptMaterial(Record):
    """A material of which new Gazebo sees no colour: it names a script and nothing else.

    ``count`` are the materials of the document that name this script.
    """

    target: Element | Value
    script: str
    count: int = 1


class FrameIdSpelling(Record):
    """A sensor's frame id under a name that is not the right one in this version (or nearly not).

    ``elements`` are all of that name, in document order.
    """

    elements: tuple[Element, ...]
    instead: str
    """The name for this version; the element's own name where there is no better one."""
    version: str
