"""SRDF: what srdfdom and MoveIt read of it, and what its attributes name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cache

from sdfcheck.formats.schema import AttributeDefinition, Definition, Format
from sdfcheck.formats.table import Table
from sdfcheck.formats.urdf.schema import acceptance, is_needed
from sdfcheck.formats.version import Version

SRDF = Format(Table("srdf"), "robot", (Version(1, 0),), acceptance, is_needed)


def srdf() -> Definition:
    """The element ``robot``, with everything in it."""
    return SRDF.schema(SRDF.newest).root


def at(around: Sequence[str]) -> Definition | None:
    """The place to which the names of elements lead; in a macro of xacro, the first one that there may be."""
    start = max((number for number, name in enumerate(around) if name.startswith("xacro:")), default=0)
    path = "/".join(around[start + 1 :])
    return next(filter(None, (holder.at(path) for holder in (srdf(), *srdf().children.values()))), None)


def named_by(attribute: AttributeDefinition) -> str:
    """The kind of thing that a value names: ``link`` or ``joint`` of the robot, ``group`` of the file, or empty."""
    return attribute.row.extra("names")


@cache
def naming(element: Definition) -> tuple[tuple[str, str], ...]:
    """The attributes of an element that name something, each with the kind of that."""
    named = ((attribute.name, named_by(attribute)) for attribute in element.attributes.values())
    return tuple((name, kind) for name, kind in named if kind)


@cache
def references() -> Mapping[tuple[str, str], str]:
    """Element and attribute → what it names."""
    found: dict[tuple[str, str], str] = {}
    waiting = [srdf()]
    for element in waiting:
        waiting += element.children.values()
        found.update(((element.name, name), kind) for name, kind in naming(element))
    return found
