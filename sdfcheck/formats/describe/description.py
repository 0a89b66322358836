"""How a place of a format is described, and the purpose of elements and attributes."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from pathlib import Path

from sdfcheck.source.record import NamedTuple

# The purpose of elements and attributes, from data/descriptions.txt; read when it is asked for.


_FILE = Path(__file__).parents[1] / "data" / "descriptions.txt"


def summary(dialect: str, names: Sequence[str]) -> str:
    """The purpose of the place at the end of a path of names, in one or two sentences; empty if unknown.

    ``dialect`` is ``sdf``, ``urdf``, ``drake`` or ``ros2_control``; the last name is an
    attribute's if it begins with ``@``.
    """
    known = _texts().get(dialect, {})
    last = names[-1]
    for number in range(max(0, len(names) - 3), len(names) - 1):
        text = known.get(f"{'/'.join(names[number:])}")
        if text is not None:
            return text
    return known.get(last, "")


@cache
def _texts() -> dict[str, dict[str, str]]:
    found: dict[str, dict[str, str]] = {}
    block: dict[str, str] = {}
    for line in _FILE.read_text("utf-8").splitlines():
        if line.startswith("["):
            block = found.setdefault(line.strip("[]"), {})
        elif line and not line.startswith("#"):
            places, _, text = line.partition("\t")
            block.update((place.strip(), text) for place in places.split(","))
    return found


# How a place of a format is described.


HOW_OFTEN = {
    "1": "exactly one",
    "0": "at most one",
    "+": "one or more",
    "*": "any number",
    "-1": "at most one",
    "": "",
}
"""Multiplicities in words."""


class UnknownPlace(LookupError):
    """The format has nothing of that name; the text says what is nearest."""


class Entry(NamedTuple):
    """One line of a list: an attribute or child of what is described, or a parent of it."""

    name: str
    multiplicity: str = ""
    type: str = ""
    default: str = ""
    unit: str = ""
    since: str = ""
    deprecated: bool = False
    note: str = ""


class Description(NamedTuple):
    """The definition of one place. Empty texts: nothing to say."""

    name: str
    """The names that lead there: ``joint/axis``, ``pose/@degrees``."""
    format: str
    """``SDFormat 1.12``, ``URDF``, ``Drake (SDFormat)``."""
    what: str
    """``element`` or ``attribute``."""
    type: str = ""
    default: str = ""
    unit: str = ""
    range: str = ""
    choices: tuple[str, ...] = ()
    since: str = ""
    until: str = ""
    """The last version that has it; empty while the newest one has."""
    deprecated: bool = False
    successor: str = ""
    open: bool = False
    """The content is free."""
    parents: tuple[Entry, ...] = ()
    attributes: tuple[Entry, ...] = ()
    children: tuple[Entry, ...] = ()
    notes: tuple[str, ...] = ()
    summary: str = ""
    """Its purpose, in one or two sentences."""


def missing(name: str, holder: str, known: list[str]) -> UnknownPlace:
    """The complaint about a name that its holder does not know."""
    from sdfcheck.formats.near_names import suggest

    near = suggest(name, known)
    return UnknownPlace(f"{holder} has no `{name}`" + (f", did you mean `{near}`?" if near else ""))
