"""The colors that a text writes, for the editor's color picker."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from sdfcheck.formats.describe import spot
from sdfcheck.lsp.cursor import elements
from sdfcheck.lsp.hover import names_around, version_of
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import Span

_TYPE = "color"
_CHANNELS = (3, 4)


class Color(NamedTuple):
    """A color in a text: red, green, blue and alpha from 0 to 1."""

    span: Span
    channels: tuple[float, float, float, float]


def colors(document: Document) -> Iterator[Color]:
    """The values that the format takes for colors and that can be shown as one."""
    if document.root is None:
        return
    is_color: dict[tuple[str, ...], bool] = {}
    for element in elements(document).all:
        for attribute, value in _values(element):
            channels = _channels(value.text)
            if channels is None:
                continue
            way = (*names_around(element), attribute)
            if way not in is_color:
                is_color[way] = _is_color(document, way[:-1], attribute)
            if is_color[way]:
                yield Color(value.span, channels)


def _values(element: Element) -> Iterator[tuple[str, Value]]:
    if not element.nodes and element.content:
        yield "", element.own_value
    for name in element.attributes:
        if (value := element.attribute(name)) is not None:
            yield name, value


def _channels(text: str) -> tuple[float, float, float, float] | None:
    words = text.split()
    if len(words) not in _CHANNELS:
        return None
    try:
        numbers = [float(word) for word in words]
    except ValueError:
        return None
    if not all(0 <= number <= 1 for number in numbers):  # also false for nan
        return None
    red, green, blue, alpha = (*numbers, 1.0)[:4]
    return red, green, blue, alpha


def _is_color(document: Document, names: Sequence[str], attribute: str) -> bool:
    place = spot(names, version_of(document)) or spot(names)
    described = None if place is None else place.describe(attribute)
    return described is not None and described.type == _TYPE


def written(before: str, channels: Sequence[float]) -> str:
    """The text for another color; three numbers stay three unless it is transparent."""
    count = 3 if len(before.split()) == 3 and math.isclose(channels[3], 1) else 4
    return " ".join(f"{round(channel, 3) + 0.0:g}" for channel in channels[:count])
