"""Where an element that is in the wrong place was meant to be."""

from __future__ import annotations

from sdfcheck.formats.sdf.schema import Definition
from sdfcheck.source.element import Element

_BELOW = 1
"""The rank of what is in the parent."""


def likely_parents(places: tuple[str, ...], parent: Element, definition: Definition) -> tuple[str, ...]:
    """Those of ``places`` (names from the start of a definition) that are the likeliest from ``parent``.

    First comes what encloses the parent (an element set one level too deep), the nearest
    first, then what can be reached from there (one level too high); all of them if there is neither.
    The children of the parent are likely in any case.
    """
    chain = _chain(parent)
    ranked: dict[int, list[tuple[int, str]]] = {}
    for place in places:
        rank, distance = _rank(place.split("/"), chain, definition)
        ranked.setdefault(rank, []).append((distance, place))
    best = sorted(ranked[min(ranked)])
    children = sorted(ranked.get(_BELOW, ())) if min(ranked) < _BELOW else []
    return tuple(place for _, place in (*children, *best))


def _chain(element: Element) -> list[str]:
    """The names of an element and of what encloses it, from the inside out."""
    names = [element.name]
    while (parent := element.parent) is not None:
        names.append(parent.name)
        element = parent
    return names


def _rank(steps: list[str], chain: list[str], definition: Definition) -> tuple[int, int]:
    inwards = steps[::-1]
    for distance in range(len(chain)):
        if chain[distance : distance + len(inwards)] == inwards:
            return 0, distance
    if steps[0] in definition.children:
        return _BELOW, 0
    if steps[0] in chain[:-1]:
        return 2, chain.index(steps[0])
    return 3, 0
