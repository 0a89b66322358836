"""What a format allows at one place, for people and programs that ask: ``joint/axis``, ``pose/@degrees``.

A question is a path of names, as short as is clear; its prefix says which format is meant
(``urdf:joint/limit``, ``drake:proximity_properties``), none or ``sdf:`` SDFormat.
"""

from __future__ import annotations

from sdfcheck.formats.sdf.version import NEWEST, Version
from sdfcheck.source.record import NamedTuple

HOW_OFTEN = {
    "1": "exactly one",
    "0": "at most one",
    "+": "one or more",
    "*": "any number",
    "-1": "at most one",
    "": "",
}
"""What multiplicities mean."""


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
    """What is allowed at one place. Empty texts: nothing to say."""

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
    """What is inside is not the format's business."""
    parents: tuple[Entry, ...] = ()
    attributes: tuple[Entry, ...] = ()
    children: tuple[Entry, ...] = ()
    notes: tuple[str, ...] = ()


def describe(question: str, version: Version = NEWEST) -> tuple[Description, ...]:
    """All places that a question fits, sorted; ``version`` is that of SDFormat.

    Raises:
        UnknownPlace: there is none.
    """
    dialect, steps = _taken_apart(question)
    if dialect == "urdf":
        from sdfcheck.formats.describe.urdf import describe_urdf

        return describe_urdf(steps)
    if dialect:
        from sdfcheck.formats.describe.vendor import describe_vendor

        return describe_vendor(dialect, steps)
    from sdfcheck.formats.describe.sdf import describe_sdf

    try:
        return describe_sdf(steps, version)
    except UnknownPlace as error:
        if question.startswith("sdf:") or not _is_urdf(steps):
            raise
        raise UnknownPlace(f"{error}; URDF has it: `urdf:{'/'.join(steps)}`") from None


def missing(name: str, holder: str, known: list[str]) -> UnknownPlace:
    """The complaint about a name that its holder does not know."""
    from sdfcheck.formats.suggest import suggest

    near = suggest(name, known)
    return UnknownPlace(f"{holder} has no `{name}`" + (f", did you mean `{near}`?" if near else ""))


def _taken_apart(question: str) -> tuple[str, tuple[str, ...]]:
    """The prefix that says which format is meant, and the names."""
    text = question.strip().strip("/")
    steps = tuple(filter(None, text.removeprefix("sdf:").split("/")))
    if not steps:
        raise UnknownPlace("there is no element without a name")
    if text.startswith("urdf:"):
        return "urdf", tuple(filter(None, text.removeprefix("urdf:").split("/")))
    custom = next((step for step in steps if ":" in step), None)
    return (custom.removeprefix("@").partition(":")[0] if custom else ""), steps


def _is_urdf(steps: tuple[str, ...]) -> bool:
    from sdfcheck.formats.describe.urdf import describe_urdf

    try:
        return bool(describe_urdf(steps))
    except UnknownPlace:
        return False
