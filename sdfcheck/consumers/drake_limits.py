"""What Drake ignores of SDFormat and URDF, from data/drake-limits.txt."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from sdfcheck.source.record import NamedTuple

_FILE = Path(__file__).with_name("data") / "drake-limits.txt"


class Ignored(NamedTuple):
    """An element ``name`` (or attribute ``@name``) in a parent; with ``unless``, only where the value is another."""

    parents: tuple[str, ...]
    """Names from the inside out."""
    name: str
    unless: str
    warned: bool
    """Does Drake say so?"""


@cache
def ignored_by_drake(dialect: str) -> tuple[Ignored, ...]:
    """Everything that Drake ignores in ``sdf`` or ``urdf``."""
    found = []
    for line in _FILE.read_text("utf-8").splitlines():
        if line.startswith("#"):
            continue
        own, parent, *lists = line.split("\t")
        if own != dialect:
            continue
        for warned, names in zip((True, False), lists, strict=False):
            for item in names.removeprefix("-").split(",") if names != "-" else ():
                name, _, unless = item.partition("!")
                found.append(Ignored(tuple(parent.split("/")[::-1]), name, unless, warned))
    return tuple(found)
