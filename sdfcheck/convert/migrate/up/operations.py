"""The changes that libsdformat makes when it reads an older file, from data/migration.txt."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from sdfcheck.source.record import NamedTuple

_FILE = Path(__file__).parents[2] / "data" / "migration.txt"


class Operation(NamedTuple):
    """One line: at a place, from here to there; ``@x`` is the attribute ``x`` of the element before it."""

    minor: int
    name: str
    at: str
    source: str
    target: str
    value: str


@cache
def operations(minor: int) -> tuple[Operation, ...]:
    """Those that lead to 1.``minor``, in the order of effect."""
    lines = (line for line in _FILE.read_text("utf-8").splitlines() if not line.startswith("#"))
    rows = ((line + "\t" * 5).split("\t")[:6] for line in lines)
    return tuple(Operation(int(first), *rest) for first, *rest in rows if int(first) == minor)
