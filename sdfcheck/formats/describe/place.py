"""The definition of one place in a format, for people and programs: ``joint/axis``, ``pose/@degrees``.

A question is a path of names, as short as is clear; its prefix says which format is meant
(``urdf:joint/limit``, ``drake:proximity_properties``), none or ``sdf:`` SDFormat.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from sdfcheck.formats.describe.description import Description, UnknownPlace
from sdfcheck.formats.vendor import BUILT_IN
from sdfcheck.formats.version import NEWEST, Version


def describe(
    question: str, version: Version = NEWEST, tables: Mapping[str, Path] = BUILT_IN
) -> tuple[Description, ...]:
    """All places that a question fits, sorted; ``version`` is that of SDFormat, ``tables`` are those of vendors.

    Raises: UnknownPlace: the format has no such place.
    """
    from sdfcheck.formats.describe.definition import describe_places
    from sdfcheck.formats.sdf.schema import schema
    from sdfcheck.formats.urdf.schema import CONTROL, URDF

    dialect, steps = _taken_apart(question)
    robots = URDF.schema(URDF.newest)
    if dialect == "urdf":
        return describe_places(robots, steps)
    if dialect:
        from sdfcheck.formats.describe.vendor import describe_vendor

        return describe_vendor(dialect, steps, tables)
    try:
        return describe_places(schema(version), steps)
    except UnknownPlace as error:
        if question.startswith("sdf:"):
            raise
        try:
            found = describe_places(robots, steps)
        except UnknownPlace:
            raise error from None
        if steps[0] == CONTROL:  # elements of URDF alone
            return found
        raise UnknownPlace(f"{error}; URDF has it: `urdf:{'/'.join(steps)}`") from None


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
