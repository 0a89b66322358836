"""A description that is to be changed: its text, the elements that the formats define, and edits."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from pathlib import Path

from sdfcheck.source.document import Document, Element, Value, read
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.scan import ElementPlace
from sdfcheck.source.sniff import Kind, sniff
from sdfcheck.source.splice import Replacement

OPAQUE = {"gazebo", "plugin", "ros2_control", "transmission"}
"""The content of these is not checked against the tables of the formats."""
KINDS = {Kind.SDF, Kind.URDF, Kind.XACRO}
_WORD = re.compile(r"\S+")
_NUMBER = re.compile(r"[+-]?\d+(\.\d*)?([eE][+-]?\d+)?|[+-]?\.\d+")


class Change(NamedTuple):
    """Edits in order of place, and the offset of what a person would correct."""

    edits: tuple[Replacement, ...]
    at: int


class Page:
    """One file, read once."""

    def __init__(self, path: Path, data: bytes) -> None:
        self.path = path
        self.document: Document = read(data, path, sniff(data, path))
        self.text = self.document.source.text

    @property
    def is_usable(self) -> bool:
        """Whether it is a description without fault of text, which can be edited by offset."""
        document = self.document
        return document.kind in KINDS and document.root is not None and not document.problems

    @property
    def is_robot(self) -> bool:
        """Whether names in it can be looked up without an expansion."""
        return self.document.kind is not Kind.XACRO

    @cached_property
    def all(self) -> list[Element]:
        return self.document.elements

    @cached_property
    def known(self) -> list[Element]:
        """The elements of the format: no prefix, and in nothing that is opaque or has a prefix of its own."""
        return [each for each in self.all if not each.is_custom and not any(map(_is_opaque, around(each)))]

    def named(self, *names: str) -> Iterator[Element]:
        return (each for each in self.known if each.name in names)

    def line(self, offset: int) -> int:
        return self.document.source.position(offset).line

    def place(self, element: Element) -> ElementPlace:
        return self.document.spans.place(element)


def write(value: Value, text: str) -> Change:
    """The change of a value."""
    return Change(((value.span.start, value.span.end, text),), value.span.start)


def literal(value: Value | None) -> str:
    """The text of a value that xacro does not compute; empty where there is none."""
    return "" if value is None or "$" in value.text or "&" in value.span.text else value.text.strip()


def words(value: Value) -> list[tuple[int, int, str]]:
    """The words of a value with their places."""
    start, text = value.span.start, value.span.text
    return [(start + each.start(), start + each.end(), each[0]) for each in _WORD.finditer(text)]


def is_number(text: str) -> bool:
    return _NUMBER.fullmatch(text) is not None


def around(element: Element) -> Iterator[Element]:
    while (parent := element.parent) is not None:
        yield parent
        element = parent


def _is_opaque(element: Element) -> bool:
    return element.name in OPAQUE or (element.is_custom and not element.name.startswith("xacro:"))
