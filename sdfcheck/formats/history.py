"""Other versions and other places: for explaining why one version does not allow a name.

Names of attributes are written with an ``@`` throughout: ``since(pose, "@degrees")``.
"""

from __future__ import annotations

from functools import cache

from sdfcheck.formats.schema import AttributeDefinition, Definition, RowInVersion
from sdfcheck.formats.sdf.schema import SDF
from sdfcheck.formats.table import Row, newest_name
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.source.record import NamedTuple

READ_IN_ALL_VERSIONS = frozenset(("model/include", "include/name", "include/pose", "include/static"))
"""Newer in the tables than in libsdformat, which reads them in files of every version: 1.4.0 does already."""


class Place(NamedTuple):
    """One place at which an element or attribute of a name is, and the versions that have it there."""

    parent: str
    """The names that lead to the parent, from the start of its definition: ``joint/axis/limit``."""
    place: str
    """``joint:joint/axis/limit/lower``."""
    versions: tuple[Version, ...]


class Deprecation(NamedTuple):
    """The note on a deprecated element or value: its replacement, and since when."""

    successor: str | None
    since: str


def in_version(definition: Definition, version: Version) -> Definition | None:
    """The definition of the same place in another version; None where that version has no such place."""
    return definition.schema.format.schema(version).at(definition.place)


def versions(parent: Definition, name: str) -> tuple[Version, ...]:
    """The versions that have a child or an ``@attribute`` of a name at this place."""
    found = []
    for version in parent.schema.format.versions:
        other = in_version(parent, version)
        if other is not None and (name[1:] in other.attributes if name[0] == "@" else name in other.children):
            found.append(version)
    return tuple(found)


def since(parent: Definition, name: str) -> Version:
    """The next version that has what the parent's own version has not; otherwise the first one that has it.

    Raises LookupError when no version has it.
    """
    known = versions(parent, name)
    later = [version for version in known if version > parent.version]
    if not known:
        raise LookupError(f"no version has {name} in {parent.place}")
    return known[0] if parent.version in known or not later else later[0]


def later(parent: Definition, name: str) -> Definition | None:
    """A child that the parent's version has not yet, as the last version that has it defines it."""
    newest = in_version(parent, parent.schema.format.newest)
    if newest is not None and name in newest.children:
        return newest.children[name]
    last = max(versions(parent, name), default=parent.version)
    holder = in_version(parent, last) if last > parent.version else None
    return holder.children[name] if holder is not None else None


def last_version(parent: Definition, name: str) -> Version | None:
    """The last version before the parent's own that had what it has no more."""
    return max((version for version in versions(parent, name) if version < parent.version), default=None)


def successor(parent: Definition, name: str) -> str | None:
    """The replacement of a child or an ``@attribute`` that is deprecated or removed."""
    return _successor(parent, f"{parent.place}/{name}").successor


def deprecation(definition: Definition) -> Deprecation:
    """The note on an element that is marked deprecated."""
    return _successor(definition, definition.place)


def _successor(definition: Definition, place: str) -> Deprecation:
    rows = ((*row, "", "", "") for row in reversed(_notes(definition, "successor")))
    known = (Deprecation(to or None, since) for noted, since, _, to, *_ in rows if noted == place)
    return next(known, Deprecation(None, ""))


def _notes(definition: RowInVersion, kind: str) -> list[tuple[str, ...]]:
    return definition.schema.format.table.notes(kind)


def renamed_value(definition: AttributeDefinition, value: str) -> str | None:
    """The name that came in for a value still accepted: ``lidar`` for the sensor type ``ray``."""
    rows = _notes(definition, "renamed")
    return next((new for place, old, new in rows if place == definition.place and old == value), None)


def carried_over(parent: Definition, name: str, version: Version) -> bool:
    """Whether consumers convert it on loading a document of that version, so that nothing is lost."""
    place = f"{parent.place}/{name}"
    rules = (Version.parse(last) for moved, last in _notes(parent, "moved") if moved == place)
    return any(last is not None and last >= version for last in rules)


def is_read(definition: Definition) -> bool:
    """Do consumers read a value? They bring a document up to the newest version first, which may have no place for it.

    Of a flag that went out only the words for true mean something.
    """
    moved = (place for place, _ in _notes(definition, "moved"))
    is_known = in_version(definition, NEWEST) is not None
    return is_known or (definition.type != "bool" and definition.place in moved)


def known_places(name: str) -> tuple[Place, ...]:
    """All places, in any version, at which an element or an ``@attribute`` of a name is."""
    return _places().get(name, ())


def known_parents(name: str, version: Version | None = None) -> tuple[str, ...]:
    """The parents, as names from the start of their definition, that allow an element of a name somewhen.

    Those that do so in ``version`` alone, if there are any.
    """
    places = known_places(name)
    living = [place for place in places if version in place.versions]
    return tuple(dict.fromkeys(place.parent for place in living or places))


@cache
def reserved_name_holders() -> frozenset[str]:
    """The elements whose ``name`` libsdformat checks for reserved words."""
    return frozenset(SDF.table.notes("reserved")[0][0].split(","))


@cache
def _places() -> dict[str, tuple[Place, ...]]:
    found: dict[str, list[Place]] = {}

    def collect(row: Row, path: str, place: str, alive: tuple[Version, ...]) -> None:
        for inner in row.rows:
            entry = Place(path, f"{place}/{inner.name}", _living(inner, alive))
            found.setdefault(inner.name, []).append(entry)
            collect(inner, f"{path}/{inner.name}", entry.place, entry.versions)

    for stem in SDF.table.stems():
        top = SDF.table.block(stem)
        name = newest_name(top)
        collect(top, name, f"{stem}:{name}", _living(top, SDF.versions))
    return {name: tuple(sorted(entries)) for name, entries in found.items()}


def _living(row: Row, versions: tuple[Version, ...]) -> tuple[Version, ...]:
    return versions if not row.life else tuple(each for each in versions if row.lives(each.minor))


def required_until(definition: Definition, attribute: str) -> Version | None:
    """The last version that requires an attribute; None if the newest one does."""
    last = None
    for version in SDF.versions:
        there = in_version(definition, version)
        known = there.attributes.get(attribute) if there else None
        if known is not None and known.required:
            last = version
    return None if last == NEWEST else last
