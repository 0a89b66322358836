"""How usual elements, attributes and words are, as counted in public files: what to suggest first."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from pathlib import Path

FILE = Path(__file__).parent / "data" / "usual.txt"

_NOTHING: Mapping[str, float] = {}


def children(dialect: str, parent: str, before: str | None = None) -> Mapping[str, float]:
    """The share of each element among those in a parent, or among those right after another one (empty: the first)."""
    return _table().get(f"{dialect} < {parent}" + ("" if before is None else f" {before}"), _NOTHING)


def attributes(dialect: str, element: str) -> Mapping[str, float]:
    """The share of each attribute of an element."""
    return _table().get(f"{dialect} @ {element}", _NOTHING)


def words(dialect: str, place: str) -> Mapping[str, float]:
    """The share of each word in an element, or in ``element@attribute``, where few words are usual."""
    return _table().get(f"{dialect} = {place}", _NOTHING)


@cache
def _table() -> dict[str, dict[str, float]]:
    found: dict[str, dict[str, float]] = {}
    for line in FILE.read_text("utf-8").splitlines():
        key, tab, rest = line.partition("\t")
        if tab:
            row = rest.split(" ")
            found[key] = {name: int(share) / 1000 for name, share in zip(row[::2], row[1::2], strict=True)}
    return found
