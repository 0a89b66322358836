"""The definition of one place in a format, for people and programs: ``joint/axis``, ``pose/@degrees``.

A question is a path of names, as short as is clear; its prefix says which format is meant
(``urdf:joint/limit``, ``drake:proximity_properties``), none or ``sdf:`` SDFormat.
"""

from __future__ import annotations

from sdfcheck.formats.describe.description import Description, UnknownPlace
from sdfcheck.formats.sdf.version import NEWEST, Version

CONTROL = "ros2_control"
"""Elements of URDF alone, which are never looked up with a prefix."""


def describe(question: str, version: Version = NEWEST) -> tuple[Description, ...]:
    """All places that a question fits, sorted; ``version`` is that of SDFormat.

    Raises: UnknownPlace: the format has no such place.
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
        if steps[0] == CONTROL:
            from sdfcheck.formats.describe.urdf import describe_urdf

            return describe_urdf(steps)
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


def _is_urdf(steps: tuple[str, ...]) -> bool:
    from sdfcheck.formats.describe.urdf import describe_urdf

    try:
        return bool(describe_urdf(steps))
    except UnknownPlace:
        return False
