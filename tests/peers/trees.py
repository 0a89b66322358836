"""Two trees of SDFormat side by side: what is in one and not, or with another value, in the other."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import zip_longest
from typing import NamedTuple

from lxml import etree

_NEAR = 1e-9
Pair = tuple[etree._Element | None, etree._Element | None]


class Difference(NamedTuple):
    """``path`` is of names of elements; the texts are None on the side that lacks it."""

    path: str
    theirs: str | None
    ours: str | None


def differences(theirs: etree._Element, ours: etree._Element, path: str = "") -> Iterator[Difference]:
    """Compare two elements of one name: attributes, texts and children.

    Numbers are compared as such. The order of children of one name counts, that of others does not.
    """
    path = f"{path}/{theirs.tag}"
    for name in sorted({*theirs.attrib, *ours.attrib}):
        before, after = theirs.get(name), ours.get(name)
        if before is None or after is None or not is_same_text(before, after):
            yield Difference(f"{path}/@{name}", before, after)
    if not is_same_text(theirs.text or "", ours.text or ""):
        yield Difference(path, (theirs.text or "").strip(), (ours.text or "").strip())
    pairs = list(_pairs(theirs, ours))
    kept = [after for before, after in pairs if before is not None and after is not None]
    for tag in {child.tag for child in kept}:
        row = [ours.index(child) for child in kept if child.tag == tag]
        if row != sorted(row):
            yield Difference(f"{path}/{tag}", "in another order", "in another order")
    for their, our in pairs:
        if their is not None and our is not None:
            yield from differences(their, our, path)
        elif their is not None:
            yield Difference(f"{path}/{their.tag}", _said(their), None)
        elif our is not None:
            yield Difference(f"{path}/{our.tag}", None, _said(our))


def _said(element: etree._Element) -> str:
    return element.get("name") or (element.text or "").strip()


def _pairs(theirs: etree._Element, ours: etree._Element) -> Iterator[Pair]:
    """Children that belong together: by tag and ``name`` where that is unique, otherwise by order."""
    for tag in dict.fromkeys(str(child.tag) for child in (*theirs, *ours)):
        before = [child for child in theirs if child.tag == tag]
        after = [child for child in ours if child.tag == tag]
        names = [child.get("name") for child in before]
        named = {child.get("name"): child for child in after}
        if len(set(names)) < len(before) or len(named) < len(after):
            yield from zip_longest(before, after)
        else:
            yield from ((child, named.get(child.get("name"))) for child in before)
            yield from ((None, child) for name, child in named.items() if name not in names)


def is_same_text(before: str, after: str) -> bool:
    """Are two texts the same words and, nearly, the same numbers?"""
    if before == after:
        return True
    mine, others = before.split(), after.split()
    return len(mine) == len(others) and all(map(_is_same_word, mine, others))


def _is_same_word(before: str, after: str) -> bool:
    if before == after or {before.lower(), after.lower()} in ({"true", "1"}, {"false", "0"}):
        return True
    try:
        return math.isclose(float(before), float(after), rel_tol=_NEAR, abs_tol=_NEAR)
    except ValueError:
        return False
