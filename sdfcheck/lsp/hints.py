"""Hints between the characters: degrees beside radians, resolved masses; and the colors of names."""

from __future__ import annotations

import math
from collections.abc import Iterator

from sdfcheck.lsp.cursor import elements
from sdfcheck.lsp.names import occurrences
from sdfcheck.robot.graph import Limit
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.errors import DescriptionError
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Span

KINDS = ("link", "joint", "frame", "model", "world", "material", "macro", "property", "parameter", "argument")
"""The kinds of names that have a color, in the order of the legend."""

_TURNING = frozenset({"revolute", "continuous", "revolute2", "universal", "ball"})
_MOST = 2000


class Hint(NamedTuple):
    """A text to show after a character."""

    offset: int
    text: str
    note: str


def hints(document: Document, within: Span) -> Iterator[Hint]:
    """The hints in a range."""
    if document.root is None or document.kind not in {Kind.SDF, Kind.URDF, Kind.XACRO}:
        return
    count = 0
    for element in elements(document).all:
        start = document.scan.starts[count] if count < len(document.scan.starts) else 0
        count += 1
        if start < within.start - _MOST or start > within.end:
            continue
        for value in _angles(element):
            yield from _degrees(value)
    if document.kind is not Kind.XACRO:
        yield from _limits(document, within)
        yield from _masses(document, within)


def _angles(element: Element) -> Iterator[Value]:
    """The values that hold roll, pitch and yaw in radians."""
    if element.name == "origin" and (value := element.attribute("rpy")) is not None:
        yield value
    if element.name == "pose" and element.content:
        given = element.attributes
        is_other = given.get("rotation_format", "") == "quat_xyzw" or given.get("degrees", "").strip() in {
            "true",
            "1",
        }
        if not is_other:
            yield element.own_value


def _degrees(value: Value) -> Iterator[Hint]:
    try:
        numbers = [float(word) for word in value.text.split()]
    except ValueError:
        return
    turn = numbers[-3:]
    if len(numbers) not in {3, 6} or not any(turn) or not all(map(math.isfinite, turn)):
        return
    text = " ".join(_angle(each) for each in turn)
    yield Hint(value.span.end, f"{text}°", "roll, pitch and yaw in degrees")


def _angle(radians: float) -> str:
    return f"{round(math.degrees(radians), 2) + 0.0:g}"


def _limits(document: Document, within: Span) -> Iterator[Hint]:
    """The limits of joints that turn."""
    for limit in root_of(document).each(Limit):
        joint = limit.joint
        if joint.element.attributes.get("type", "") not in _TURNING:
            continue
        for number in (limit.lower, limit.upper):
            if number.is_given and math.isfinite(number.number) and number.number:
                span = number.span
                if within.start <= span.start <= within.end and abs(number) < 1000:
                    yield Hint(span.end, f"{_angle(number)}°", "in degrees")


def _masses(document: Document, within: Span) -> Iterator[Hint]:
    """The mass of a link whose inertia is computed, and the total of a model of several links."""
    root = root_of(document)
    for model in root.each("Model"):
        if not within.start <= model.span.start <= within.end or len(model.links) < 2:
            continue
        try:
            body = model.mass_properties
        except DescriptionError:
            continue
        value = model.name_value
        if body is not None and body.mass and value is not None:
            yield Hint(value.span.end, f"{body.mass:.6g} kg", "the mass of all its links")
    for link in root.each("Link"):
        if (
            link.is_urdf
            or not within.start <= link.span.start <= within.end
            or not link.inertial.is_automatic
        ):
            continue
        try:
            own = link.mass_properties
        except DescriptionError:
            continue
        if own is not None and link.name_value is not None:
            yield Hint(link.name_value.span.end, f"{own.mass:.6g} kg", "computed from its collisions")


class Token(NamedTuple):
    """A name with a color; ``kind`` is the place of its kind in :data:`KINDS`."""

    span: Span
    kind: int
    is_definition: bool


def tokens(document: Document, within: Span | None = None) -> list[Token]:
    """The names of a document in order, none within another."""
    found: list[Token] = []
    end = -1
    for each in occurrences(document).all:
        span = each.span
        if each.symbol.kind not in KINDS or span.start < end or "\n" in span.text:
            continue
        if within is None or within.start <= span.start <= within.end:
            found.append(Token(span, KINDS.index(each.symbol.kind), each.is_definition))
            end = span.end
    return found
