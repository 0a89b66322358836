"""The description of names and places: what an element is, where it may be, since when, and what it holds."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path

from sdfcheck.formats import history
from sdfcheck.formats.near_names import suggest
from sdfcheck.formats.schema import AttributeDefinition, Definition, RowInVersion, Schema
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.urdf.schema import URDF, known_parents, of_controllers, urdf
from sdfcheck.formats.vendor import BUILT_IN
from sdfcheck.formats.vendor.definitions import DIALECTS, Effect, Place, Slot, Tag, Vendor
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.source.record import NamedTuple

# How a place of a format is described, and the purpose of elements and attributes.

# The purpose of elements and attributes, from data/descriptions.txt; read when it is asked for.


_FILE = Path(__file__).parent / "data" / "descriptions.txt"


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
    """``SDFormat 1.12``, ``URDF``, ``Drake, SDFormat``."""
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
    near = suggest(name, known)
    return UnknownPlace(f"{holder} has no `{name}`" + (f", did you mean `{near}`?" if near else ""))


# The definition of one place in SDFormat or URDF.


class _Use(NamedTuple):
    """An element below one parent (None for the root)."""

    parent: Definition | None
    element: Definition


def describe_places(schema: Schema, steps: tuple[str, ...]) -> tuple[Description, ...]:
    """All places whose names end with ``steps``; of another version where this one has none.

    Raises:
        UnknownPlace: no version has one.
    """
    if not steps:
        raise UnknownPlace("there is no element without a name")
    for version in (schema.version, *reversed(schema.format.versions)):
        found = _found(schema.format.schema(version), steps)
        if found:
            asked = "/".join(steps)
            return tuple(sorted(found, key=lambda one: (one.name != asked, one.name)))
    raise _complaint(schema, steps)


def describe_definition(parent: Definition | None, element: Definition) -> Description:
    """An element below one parent."""
    return _element([_Use(parent, element)])


def describe_attribute(owner: Definition, name: str) -> Description:
    """An attribute of an element; raises KeyError for one that it has not."""
    return _attribute(owner, owner.attributes[name])


def _found(schema: Schema, steps: tuple[str, ...]) -> list[Description]:
    *outer, last = steps
    if last[0] == "@":
        holders = _uses(schema, tuple(outer)) if outer else _everywhere(schema)
        owners = {_key(use.element): use.element for use in holders if last[1:] in use.element.attributes}
        return [_attribute(owner, owner.attributes[last[1:]]) for owner in owners.values()]
    grouped: dict[tuple[object, ...], list[_Use]] = {}
    for use in _uses(schema, steps):
        remarks = (use.element.consumers, use.element.release, _summary(use))
        grouped.setdefault((*_key(use.element), *remarks), []).append(use)
    return [_element(uses) for uses in grouped.values()]


def _uses(schema: Schema, steps: tuple[str, ...]) -> list[_Use]:
    """Where elements are whose own name and those of whose parents are ``steps``.

    Those of controllers only if the steps say so, or are their own.
    """
    first, *rest = steps
    uses = [use for use in _everywhere(schema) if use.element.name == first]
    for name in rest:
        inside = {_key(use.element): use.element for use in uses if name in _children(use.element)}
        uses = [_Use(element, _children(element)[name]) for element in inside.values()]
    if of_controllers().keys() & set(steps) or not any(map(known_parents, steps)):
        return uses
    return [use for use in uses if not use.element.place.startswith(("control", "drive"))]


def _key(element: Definition) -> tuple[str, str]:
    """A definition under one name."""
    return element.place, element.name


def _everywhere(schema: Schema) -> list[_Use]:
    """Every element below every parent of a version; a parent of one definition is one parent."""
    found = [_Use(None, schema.root)]
    seen, waiting = {_key(schema.root)}, [schema.root]
    while waiting:
        parent = waiting.pop()
        for child in _children(parent).values():
            found.append(_Use(parent, child))
            if _key(child) not in seen:
                seen.add(_key(child))
                waiting.append(child)
    return found


def _children(element: Definition) -> Mapping[str, Definition]:
    """The elements in an element; those of controllers are in tables of their own."""
    if element.place != "robot:robot":
        return element.children
    return {**element.children, **of_controllers()}


def _element(uses: list[_Use]) -> Description:
    element, parent = uses[0].element, uses[0].parent
    deprecation = history.deprecation(element)
    successor = deprecation.successor or (history.successor(parent, element.name) if parent else None)
    attributes = (_entry(element, each, f"@{each.name}") for each in element.attributes.values())
    children = (_entry(element, each, each.name) for each in _children(element).values())
    versions = sorted({version for use in uses for version in _versions(use)})
    return _described(element, "element", versions)._replace(
        name=_name(element),
        deprecated=element.deprecated or element.multiplicity == "-1",
        successor=successor or "",
        open=element.open,
        parents=tuple(
            Entry(_name(use.parent), use.element.multiplicity)
            for use in sorted(uses, key=_path)
            if use.parent
        ),
        attributes=tuple(attributes),
        children=tuple(children),
        notes=tuple(_notes(element)),
        summary=_summary(uses[0]),
    )


def _attribute(owner: Definition, attribute: AttributeDefinition) -> Description:
    name = f"@{attribute.name}"
    return _described(attribute, "attribute", history.versions(owner, name))._replace(
        name=f"{_name(owner)}/{name}",
        successor=history.successor(owner, name) or "",
        parents=(Entry(_name(owner), attribute.multiplicity),),
        notes=tuple(_notes(attribute)),
        summary=summary(_dialect(owner), (*owner.path.split("/"), name)),
    )


def _described(place: RowInVersion, what: str, versions: list[Version] | tuple[Version, ...]) -> Description:
    """The facts about an element or attribute that both have."""
    known = place.schema.format.versions
    since = versions[0] if versions else place.version
    return Description(
        name=place.name,
        format="URDF" if place.schema.format is URDF else f"SDFormat {place.version}",
        what=what,
        type=place.type or "",
        default=place.given_default,
        unit=_unit(place),
        range=str(place.range or ""),
        choices=place.listed,
        since=place.release or ("" if known is URDF.versions and since == known[0] else str(since)),
        until="" if not versions or known[-1] in versions else str(versions[-1]),
    )


def _entry(holder: Definition, inner: Definition | AttributeDefinition, name: str) -> Entry:
    return Entry(
        name,
        inner.multiplicity,
        inner.type or "",
        inner.given_default,
        _unit(inner),
        inner.release or _since(holder, name),
        isinstance(inner, Definition) and (inner.deprecated or inner.multiplicity == "-1"),
        "".join(_readers(inner)),
    )


def _since(parent: Definition, name: str) -> str:
    """When it came in, where that was later than what holds it."""
    known = history.versions(parent, name)
    held = next(v for v in parent.schema.format.versions if history.in_version(parent, v) is not None)
    return str(known[0]) if known and known[0] > held else ""


def _notes(place: Definition | AttributeDefinition) -> Iterator[str]:
    yield from _readers(place)
    if isinstance(place, Definition):
        if place.multiplicity in {"1", "+"} and place.given_default:
            yield "consumers take the default where it is missing"
    else:
        renamed = ((value, history.renamed_value(place, value)) for value in place.listed)
        yield from (f"`{old}` is now called `{new}`" for old, new in renamed if new)
    if place.range is not None and place.range.instead:
        yield f"libsdformat takes {place.range.instead} for a value out of range"


def _readers(place: RowInVersion) -> Iterator[str]:
    if place.consumers:
        yield f"read by {', '.join(place.consumers)} only"


def _unit(place: RowInVersion) -> str:
    angular, *linear = place.units or ("",)
    return f"{angular} (turning), {linear[0]} (sliding)" if linear else angular


def _versions(use: _Use) -> tuple[Version, ...]:
    if use.parent is None:
        return use.element.schema.format.versions
    return history.versions(use.parent, use.element.name)


def _dialect(element: Definition) -> str:
    return "urdf" if element.schema.format is URDF else "sdf"


def _summary(use: _Use) -> str:
    above = () if use.parent is None else (use.parent.name,)
    return summary(_dialect(use.element), (*above, *use.element.path.split("/")))


def _name(element: Definition) -> str:
    """The names that lead to an element from the start of its definition, or from the root."""
    return element.path.removeprefix(f"{element.schema.root.name}/")


def _path(use: _Use) -> str:
    return use.parent.path if use.parent else ""


def _complaint(schema: Schema, steps: tuple[str, ...]) -> UnknownPlace:
    for end in range(1, len(steps)):
        if not _found(schema, steps[:end]):
            return _complaint(schema, steps[:end])
    *outer, last = steps
    held = _uses(schema, tuple(outer)) if outer else _everywhere(schema)
    if last[0] == "@":
        known = {f"@{name}" for use in held for name in use.element.attributes}
    elif outer:
        known = {name for use in held for name in _children(use.element)}
    else:
        known = {use.element.name for use in held}
    title = "URDF" if schema.format is URDF else f"SDFormat {schema.version}"
    return missing(last, f"`{'/'.join(outer)}`" if outer else title, sorted(known))


# The entry of a vendor's table for a prefixed name.

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
    title = f"{table.vendor.name}, {_FORMATS[table.dialect]}"
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
    attributes = [_entry_of_tag(f"@{name}", own) for name, own in tag.attributes.items()]
    if slot is not None and carried:
        attributes += [_entry_of_tag(name, slot) for name in sorted(carried)]
    elif slot is not None:
        described = _with_value(described, slot)
    gone = tag.keys.text("gone")
    old = tag.keys.text("deprecated") if tag.keys.text("deprecated-in") in {"", table.dialect} else ""
    return described._replace(
        deprecated=bool(gone or old),
        successor=gone or old,
        parents=tuple(Entry(place.text, _often(place), since=place.since) for place in places),
        attributes=tuple(attributes),
        children=_tags_below(table, tag),
        notes=_remarks(table, tag),
    )


def _is_in(place: Place, outer: tuple[str, ...]) -> bool:
    names = tuple(step.name for step in reversed(place.path))
    return not outer or names[-len(outer) :] == outer


def _tags_below(table: _Table, tag: Tag) -> tuple[Entry, ...]:
    own = [_entry_of_tag(name, slot) for name, slot in tag.parts.items()]
    for other in table.vendor.tags.values():
        for place in other.places:
            if place.path[0].name == tag.name:
                slot = place.slot
                entry = Entry(other.name, _often(place), since=other.since)
                if slot is not None:
                    entry = entry._replace(type=slot.type, default=slot.default, unit=_unit_of_value(slot))
                own.append(entry)
    return tuple(own)


def _remarks(table: _Table, tag: Tag) -> tuple[str, ...]:
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


def _entry_of_tag(name: str, slot: Slot) -> Entry:
    return Entry(name, "1" if slot.required else "0", slot.type, slot.default, _unit_of_value(slot))


def _unit_of_value(slot: Slot) -> str:
    return slot.unit.replace("|", " (turning), ") + " (sliding)" * ("|" in slot.unit)


def _with_value(described: Description, slot: Slot) -> Description:
    return described._replace(
        type=slot.type,
        default=slot.default,
        unit=_unit_of_value(slot),
        range="anything but 0" if slot.nonzero else str(slot.range or ""),
        choices=slot.choices,
    )


# The definition of a place that is known by the names of the elements around it.

_TRANSPARENT = frozenset({"xacro:if", "xacro:unless"})
_EXTENDED = ("model/link", "model/joint", "model", "model/link/collision", "model/link/visual")
"""Where what a ``<gazebo>`` block holds belongs in SDFormat."""
_IN_MACROS = {
    "sdf": (
        "model",
        "model/link",
        "model/joint",
        "world",
        "model/link/visual",
        "model/link/visual/geometry",
        "model/link/inertial",
    ),
    "robot": ("", "link", "joint", "link/visual", "link/inertial", "link/visual/geometry"),
}
"""Where the content of a macro may belong, by the name of the root."""


class Spot(NamedTuple):
    """A place of a format: an element, and its parent."""

    definition: Definition
    parent: Definition | None = None

    @property
    def is_block(self) -> bool:
        """Is it a ``<gazebo>`` block of URDF, which holds SDFormat, too?"""
        return self.definition.place == "gazebo:gazebo"

    @property
    def is_open(self) -> bool:
        """Is anything allowed inside?"""
        return self.definition.open and not self.is_block

    def describe(self, attribute: str = "") -> Description | None:
        """The definition of the element, or of an attribute of it; None for one that is unknown."""
        if not attribute:
            return describe_definition(self.parent, self.definition)
        known = attribute in self.definition.attributes
        return describe_attribute(self.definition, attribute) if known else None


def spot(names: Sequence[str], version: Version = NEWEST) -> Spot | None:
    """The place to which the names of elements lead, from the root's on; None where no format has one.

    The content of a macro of xacro belongs where the macro is, or in a model, link or joint.
    """
    first, *inner = [name for name in names if name not in _TRANSPARENT] or [""]
    if first not in _IN_MACROS:
        return None
    root = Spot(schema(version).root if first == "sdf" else urdf())
    last = max((number for number, name in enumerate(inner) if name.startswith("xacro:")), default=-1)
    if last < 0:
        return _inside(root, inner, version)
    around = "/".join(name for name in inner[:last] if not name.startswith("xacro:"))
    for place in (around, *_IN_MACROS[first]):
        holder = _inside(root, filter(None, place.split("/")), version)
        found = None if holder is None else _inside(holder, inner[last + 1 :], version)
        if found is not None and (found is not holder or place == around):
            return found
    return None


def _inside(start: Spot, names: Iterable[str], version: Version) -> Spot | None:
    at, waiting = start, list(names)
    while waiting:
        definition = at.definition
        known = _children(definition).get(waiting[0])
        if at.is_block and (known is None or len(waiting) > 1):
            return _in_block(waiting, version)
        if at.is_open or known is None:
            return None
        at = Spot(known, definition)
        del waiting[0]
    return at


def _in_block(names: list[str], version: Version) -> Spot | None:
    """Elements of SDFormat in a ``<gazebo>`` block."""
    for place in _EXTENDED:
        holder = schema(version).root.at(place)
        found = None if holder is None else _inside(Spot(holder), names, version)
        if found is not None:
            return found
    return None


def describe_custom(
    name: str, outer: Sequence[str], tables: Mapping[str, Path], *, is_urdf: bool
) -> Description | None:
    """The entry of a vendor's table for a prefixed element or attribute (``@name``, ``element/@name``)."""
    own = tuple(name.split("/"))
    prefix = own[0].removeprefix("@").partition(":")[0]
    wanted = "URDF" if is_urdf else "SDFormat"
    for steps in ((*outer[-1:], *own), own):
        try:
            found = describe_vendor(prefix, steps, tables)
        except UnknownPlace:
            continue
        return next((one for one in found if one.format.endswith(wanted)), found[0])
    return None


# The definition of one place in a format, for people and programs: ``joint/axis``, ``pose/@degrees``.
#
# A question is a path of names, as short as is clear; its prefix says which format is meant
# (``urdf:joint/limit``, ``drake:proximity_properties``), none or ``sdf:`` SDFormat.


def describe(
    question: str, version: Version = NEWEST, tables: Mapping[str, Path] = BUILT_IN
) -> tuple[Description, ...]:
    """All places that a question fits, sorted; ``version`` is that of SDFormat, ``tables`` are those of vendors.

    Raises: UnknownPlace: the format has no such place.
    """
    dialect, steps = _taken_apart(question)
    robots = URDF.schema(URDF.newest)
    if dialect == "urdf":
        return describe_places(robots, steps)
    if dialect:
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
        if steps[0] in of_controllers():  # elements of URDF alone
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
