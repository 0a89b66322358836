"""What SDFormat allows at one place; see :mod:`sdfcheck.formats.describe.place`."""

from __future__ import annotations

from sdfcheck.formats.describe.description import Description, Entry, missing, summary
from sdfcheck.formats.sdf import history
from sdfcheck.formats.sdf.choices import Choices
from sdfcheck.formats.sdf.schema import AttributeDefinition, Definition, schema
from sdfcheck.formats.sdf.version import NEWEST, VERSIONS, Version
from sdfcheck.source.record import NamedTuple

_NEWEST_FIRST = VERSIONS[::-1]


class _Use(NamedTuple):
    """An element below one parent (None for the root)."""

    parent: Definition | None
    element: Definition


def describe_sdf(steps: tuple[str, ...], version: Version) -> tuple[Description, ...]:
    """All places whose names end with ``steps``; of another version where this one has none.

    Raises:
        UnknownPlace: no version has one.
    """
    for known in (version, *_NEWEST_FIRST):
        found = _found(steps, known)
        if found:
            asked = "/".join(steps)
            return tuple(sorted(found, key=lambda one: (one.name != asked, one.name)))
    raise _complaint(steps, version)


def describe_definition(parent: Definition | None, element: Definition) -> Description:
    """An element below one parent."""
    return _element([_Use(parent, element)])


def describe_attribute(owner: Definition, name: str) -> Description:
    """An attribute of an element; raises KeyError for one that it has not."""
    return _attribute(owner, owner.attributes[name])


def _found(steps: tuple[str, ...], version: Version) -> list[Description]:
    *outer, last = steps
    if last[0] == "@":
        holders = _uses(tuple(outer), version) if outer else _everywhere(version)
        owners = {use.element.place: use.element for use in holders if last[1:] in use.element.attributes}
        return [_attribute(owner, owner.attributes[last[1:]]) for owner in owners.values()]
    grouped: dict[str, list[_Use]] = {}
    for use in _uses(steps, version):
        grouped.setdefault(use.element.place, []).append(use)
    return [_element(uses) for uses in grouped.values()]


def _uses(steps: tuple[str, ...], version: Version) -> list[_Use]:
    """Where elements are whose own name and those of whose parents are ``steps``."""
    first, *rest = steps
    uses = [use for use in _everywhere(version) if use.element.name == first]
    for name in rest:
        inside = {use.element.place: use.element for use in uses if name in use.element.children}
        uses = [_Use(element, element.children[name]) for element in inside.values()]
    return uses


def _everywhere(version: Version) -> list[_Use]:
    """Every element below every parent of a version; a parent of one definition is one parent."""
    root = schema(version).root
    found = [_Use(None, root)]
    seen, waiting = {root.place}, [root]
    while waiting:
        parent = waiting.pop()
        for child in parent.children.values():
            found.append(_Use(parent, child))
            if child.place not in seen:
                seen.add(child.place)
                waiting.append(child)
    return found


def _element(uses: list[_Use]) -> Description:
    element, parent = uses[0].element, uses[0].parent
    versions = sorted({version for use in uses for version in _versions(use)})
    deprecation = history.deprecation(element.place)
    successor = deprecation.successor or (history.successor(parent, element.name) if parent else None)
    attributes = (_entry_of_attribute(element, attribute) for attribute in element.attributes.values())
    return Description(
        name=element.path,
        format=f"SDFormat {element.version}",
        what="element",
        type=element.type or "",
        default=_default(element.default),
        unit=history.unit(element) or "",
        range=str(element.range or ""),
        choices=_choices(element.choices),
        since=str(versions[0]),
        until="" if NEWEST in versions else str(versions[-1]),
        deprecated=element.deprecated or element.multiplicity == "-1",
        successor=successor or "",
        open=element.open,
        parents=tuple(
            Entry(use.parent.path, use.element.multiplicity) for use in sorted(uses, key=_path) if use.parent
        ),
        attributes=tuple(attributes),
        children=tuple(_entry_of_child(element, child) for child in element.children.values()),
        notes=_notes(element),
        summary=summary("sdf", (*([parent.name] if parent else ()), *element.path.split("/"))),
    )


def _notes(element: Definition) -> tuple[str, ...]:
    notes = []
    if element.multiplicity in {"1", "+"} and _default(element.default):
        notes.append("consumers take the default where it is missing")
    if element.range is not None and element.range.instead:
        notes.append(f"consumers take {element.range.instead} for a value out of range")
    return tuple(notes)


def _path(use: _Use) -> str:
    return use.parent.path if use.parent else ""


def _versions(use: _Use) -> tuple[Version, ...]:
    if use.parent is None:
        return tuple(reversed(_NEWEST_FIRST))
    return history.versions(use.parent, use.element.name)


def _attribute(owner: Definition, attribute: AttributeDefinition) -> Description:
    versions = history.versions(owner, f"@{attribute.name}")
    renamed = ((value, history.renamed_value(attribute, value)) for value in _choices(attribute.choices))
    return Description(
        name=f"{owner.path}/@{attribute.name}",
        format=f"SDFormat {owner.version}",
        what="attribute",
        type=attribute.type,
        default=_default(attribute.default),
        range=str(attribute.range or ""),
        choices=_choices(attribute.choices),
        since=str(versions[0]),
        until="" if NEWEST in versions else str(versions[-1]),
        successor=history.successor(owner, f"@{attribute.name}") or "",
        parents=(Entry(owner.path, "1" if attribute.required else "0"),),
        notes=tuple(f"`{old}` is now called `{new}`" for old, new in renamed if new),
        summary=summary("sdf", (*owner.path.split("/"), f"@{attribute.name}")),
    )


def _entry_of_child(parent: Definition, child: Definition) -> Entry:
    return Entry(
        child.name,
        child.multiplicity,
        child.type or "",
        _default(child.default),
        history.unit(child) or "",
        _since(parent, child.name),
        child.deprecated or child.multiplicity == "-1",
    )


def _entry_of_attribute(owner: Definition, attribute: AttributeDefinition) -> Entry:
    name = f"@{attribute.name}"
    often = "1" if attribute.required else "0"
    since = _since(owner, name)
    return Entry(name, often, attribute.type, _default(attribute.default), "", since)


def _since(parent: Definition, name: str) -> str:
    """When it came in, where that was later than what holds it."""
    first = history.versions(parent, name)[0]
    held = next(v for v in reversed(_NEWEST_FIRST) if history.in_version(parent, v) is not None)
    return str(first) if first > held else ""


def _default(text: str | None) -> str:
    return "" if text is None or text == "__default__" else text


def _choices(choices: Choices | None) -> tuple[str, ...]:
    return choices.listed if choices else ()


def _complaint(steps: tuple[str, ...], version: Version) -> Exception:
    for end in range(1, len(steps)):
        if not _found(steps[:end], version):
            return _complaint(steps[:end], version)
    *outer, last = steps
    held = _uses(tuple(outer), version) if outer else _everywhere(version)
    if last[0] == "@":
        known = {f"@{name}" for use in held for name in use.element.attributes}
    elif outer:
        known = {name for use in held for name in use.element.children}
    else:
        known = {use.element.name for use in held}
    holder = f"`{'/'.join(outer)}`" if outer else f"SDFormat {version}"
    return missing(last, holder, sorted(known))
