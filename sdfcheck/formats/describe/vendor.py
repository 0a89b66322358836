"""The entry of a vendor's table for a prefixed name; see :mod:`sdfcheck.formats.describe.place`."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from sdfcheck.formats.describe.description import Description, Entry, UnknownPlace, missing, summary
from sdfcheck.formats.near_names import suggest
from sdfcheck.formats.vendor import BUILT_IN
from sdfcheck.formats.vendor.definitions import DIALECTS, Effect, Place, Slot, Tag, Vendor
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.source.record import NamedTuple

_FORMATS = {"sdf": "SDFormat", "urdf": "URDF"}


class _Table(NamedTuple):
    dialect: str
    vendor: Vendor


def describe_vendor(
    prefix: str, steps: tuple[str, ...], tables: Mapping[str, Path] = BUILT_IN
) -> tuple[Description, ...]:
    """A prefixed name in each dialect, by ``tables`` by prefix; plain names before it narrow the places.

    Raises:
        UnknownPlace: the prefix has no table, or the table no such name.
    """
    if prefix not in tables:
        near = suggest(prefix, ["sdf", "urdf", *tables])
        advice = f", did you mean `{near}:`?" if near else ""
        raise UnknownPlace(f"nothing is known of the prefix `{prefix}`{advice}")
    known = [_Table(dialect, vendor(tables[prefix], dialect)) for dialect in DIALECTS]
    *_, last = steps
    if ":" not in last:
        return _slots(steps, known)
    name = last.removeprefix("@")
    if not any(name in table.vendor.tags for table in known):
        raise missing(name, known[0].vendor.name, sorted(known[0].vendor.tags))
    found = [_tag(table, table.vendor.tags[name], steps[:-1]) for table in known]
    kept = tuple(description for description in found if description is not None)
    if not kept:
        raise UnknownPlace(f"{known[0].vendor.name} does not read `{name}` in `{'/'.join(steps[:-1])}`")
    return kept


def _slots(steps: tuple[str, ...], tables: list[_Table]) -> tuple[Description, ...]:
    """An attribute (``@name``) or plain child of a tag."""
    number = max(n for n, step in enumerate(steps) if ":" in step)
    name, inner = steps[number], "/".join(steps[number + 1 :])
    found, known = [], set[str]()
    for table in tables:
        tag = table.vendor.tags.get(name)
        if tag is None:
            raise missing(name, table.vendor.name, sorted(table.vendor.tags))
        slots = {f"@{key}": slot for key, slot in tag.attributes.items()} | tag.parts
        known |= slots.keys()
        if inner in slots:
            holder = (Entry(name, "1" if slots[inner].required else "0"),)
            what = "attribute" if inner[0] == "@" else "element"
            bare = _empty(table, f"{name}/{inner}", what, tag)._replace(parents=holder)
            found.append(_with_value(bare, slots[inner]))
    if not found:
        raise missing(inner, f"`{name}`", sorted(known))
    return tuple(found)


def _empty(table: _Table, name: str, what: str, tag: Tag) -> Description:
    title = f"{table.vendor.name} ({_FORMATS[table.dialect]})"
    since = f"{table.vendor.name} {tag.since}" if tag.since else ""
    about = summary(table.vendor.prefix, (tag.name,)) if name == tag.name else ""
    return Description(name=name, format=title, what=what, since=since, summary=about)


def _tag(table: _Table, tag: Tag, outer: tuple[str, ...]) -> Description | None:
    places = [place for place in tag.places if _is_in(place, outer)]
    if not places and outer:
        return None
    is_attribute = any(place.carrier == "attribute" for place in places)
    described = _empty(table, tag.name, "attribute" if is_attribute else "element", tag)
    slot = next((place.slot for place in places if place.slot is not None), None)
    carried = {place.carrier for place in places} - {"", "text", "attribute"}
    attributes = [_entry(f"@{name}", own) for name, own in tag.attributes.items()]
    if slot is not None and carried:
        attributes += [_entry(name, slot) for name in sorted(carried)]
    elif slot is not None:
        described = _with_value(described, slot)
    gone = tag.keys.text("gone")
    old = tag.keys.text("deprecated") if tag.keys.text("deprecated-in") in {"", table.dialect} else ""
    return described._replace(
        deprecated=bool(gone or old),
        successor=gone or old,
        parents=tuple(Entry(place.text, _often(place), since=place.since) for place in places),
        attributes=tuple(attributes),
        children=_children(table, tag),
        notes=_notes(table, tag),
    )


def _is_in(place: Place, outer: tuple[str, ...]) -> bool:
    names = tuple(step.name for step in reversed(place.path))
    return not outer or names[-len(outer) :] == outer


def _children(table: _Table, tag: Tag) -> tuple[Entry, ...]:
    own = [_entry(name, slot) for name, slot in tag.parts.items()]
    for other in table.vendor.tags.values():
        for place in other.places:
            if place.path[0].name == tag.name:
                slot = place.slot
                entry = Entry(other.name, _often(place), since=other.since)
                if slot is not None:
                    entry = entry._replace(type=slot.type, default=slot.default, unit=_unit(slot))
                own.append(entry)
    return tuple(own)


def _notes(table: _Table, tag: Tag) -> tuple[str, ...]:
    notes = []
    if not tag.places and not tag.keys.text("gone"):
        outcome = _in_words(tag.absent.effect) if tag.absent else "is ignored"
        instead = f"; use {tag.absent.use}" if tag.absent and tag.absent.use else ""
        notes.append(f"in {_FORMATS[table.dialect]} it {outcome}{instead}")
    for needed in tag.keys.all("needs"):
        name, _, where = needed.partition("(")
        condition = f" (in {where.rstrip(')').replace(',', ', ')})" if where else ""
        notes.append(f"needs {name}{condition}")
    notes += [f"not together with {', '.join(tag.keys.words('excludes'))}"] * bool(tag.keys.text("excludes"))
    notes += [f"needs one of {', '.join(tag.keys.words('any'))}"] * bool(tag.keys.text("any"))
    notes += [f"at most {tag.keys.text('at-most')}"] * bool(tag.keys.text("at-most"))
    return tuple(notes)


def _in_words(effect: Effect) -> str:
    return "stops the consumer" if effect.refused else "is ignored"


def _often(place: Place) -> str:
    if place.single:
        return "1" if place.needed else "0"
    return "+" if place.needed else "*"


def _entry(name: str, slot: Slot) -> Entry:
    return Entry(name, "1" if slot.required else "0", slot.type, slot.default, _unit(slot))


def _unit(slot: Slot) -> str:
    return slot.unit.replace("|", " (turning), ") + " (sliding)" * ("|" in slot.unit)


def _with_value(described: Description, slot: Slot) -> Description:
    return described._replace(
        type=slot.type,
        default=slot.default,
        unit=_unit(slot),
        range="anything but 0" if slot.nonzero else str(slot.range or ""),
        choices=slot.choices,
    )
