"""The definition of one place in SDFormat or URDF; see :mod:`sdfcheck.formats.describe.place`."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from sdfcheck.formats import history
from sdfcheck.formats.describe.description import Description, Entry, UnknownPlace, missing, summary
from sdfcheck.formats.schema import AttributeDefinition, Definition, RowInVersion, Schema
from sdfcheck.formats.urdf.schema import CONTROL, URDF, control, known_parents
from sdfcheck.formats.version import Version
from sdfcheck.source.record import NamedTuple


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

    Those of ``ros2_control`` only if the steps say so, or are its own.
    """
    first, *rest = steps
    uses = [use for use in _everywhere(schema) if use.element.name == first]
    for name in rest:
        inside = {_key(use.element): use.element for use in uses if name in _children(use.element)}
        uses = [_Use(element, _children(element)[name]) for element in inside.values()]
    if CONTROL in steps or not any(map(known_parents, steps)):
        return uses
    return [use for use in uses if not use.element.place.startswith("control")]


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
    """The elements in an element; those in a block of ros2_control are in a table of its own."""
    if element.place != "robot:robot":
        return element.children
    return {**element.children, CONTROL: control()}


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
