"""How a place of a format is described."""

from __future__ import annotations

from sdfcheck.source.record import NamedTuple

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
    from sdfcheck.formats.suggest import suggest

    near = suggest(name, known)
    return UnknownPlace(f"{holder} has no `{name}`" + (f", did you mean `{near}`?" if near else ""))
