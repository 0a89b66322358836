"""What URDF allows at one place; see :mod:`sdfcheck.formats.describe.place`."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.describe.description import Description, Entry, UnknownPlace, missing, summary
from sdfcheck.formats.urdf.table import (
    VERSIONS,
    UrdfAttribute,
    UrdfElement,
    control,
    extension,
    known_parents,
    urdf,
)
from sdfcheck.source.record import NamedTuple


class _Use(NamedTuple):
    path: tuple[str, ...]
    element: UrdfElement


def describe_urdf(steps: tuple[str, ...]) -> tuple[Description, ...]:
    """All places whose names end with ``steps``; alike ones are reported once.

    Raises: UnknownPlace: the format has no such place.
    """
    if not steps:
        raise UnknownPlace("there is no element without a name")
    *outer, last = steps
    if last[0] == "@":
        holders = [use for use in _everywhere() if _ends(use, outer)]
        owners = [
            (use, use.element.attributes[last[1:]]) for use in holders if last[1:] in use.element.attributes
        ]
        found = [_attribute(use, attribute) for use, attribute in owners]
    else:
        found = [_element(use) for use in _everywhere() if _ends(use, list(steps))]
    if not found:
        raise _complaint(steps)
    return _merged(found)


def describe_definition(path: tuple[str, ...], element: UrdfElement) -> Description:
    """An element to which names lead, that of ``robot`` first."""
    return _element(_Use(path, element))


def describe_attribute(path: tuple[str, ...], element: UrdfElement, name: str) -> Description:
    """An attribute of an element; raises KeyError for one that it has not."""
    return _attribute(_Use(path, element), element.attributes[name])


def _everywhere() -> Iterator[_Use]:
    waiting = [_Use(("robot",), urdf()), _Use(("robot", "gazebo"), extension())]
    while waiting:
        use = waiting.pop()
        # The settings of an extension that libsdformat reads are in a table of its own.
        if use.element is not extension():
            yield use
        inner = (
            {**use.element.children, "ros2_control": control()}
            if use.element is urdf()
            else use.element.children
        )
        waiting += [_Use((*use.path, name), child) for name, child in inner.items()]


def _ends(use: _Use, steps: list[str]) -> bool:
    """Does a place end with these names? Those of ``ros2_control`` only if they say so, or are its own."""
    if steps and list(use.path[-len(steps) :]) != steps:
        return False
    if use.path[1:2] != ("ros2_control",) or "ros2_control" in steps or not steps:
        return True
    return not any(known_parents(step) for step in steps)


def _element(use: _Use) -> Description:
    element = use.element
    value = element.value
    children = tuple(map(_entry_of_child, element.children.values()))
    if use.path == ("robot", "gazebo"):
        children = tuple(map(_entry_of_child, extension().children.values()))
    described = Description(
        name=_name(use),
        format="URDF",
        what="element",
        since=_since(element),
        open=element.open,
        parents=_parents(use),
        attributes=tuple(map(_entry_of_attribute, element.attributes.values())),
        children=children,
        notes=_consumers(element.consumers),
        summary=summary("urdf", use.path),
    )
    return described if value is None else _with_value(described, value)


def _attribute(use: _Use, attribute: UrdfAttribute) -> Description:
    described = Description(
        name=f"{_name(use)}/@{attribute.name}",
        format="URDF",
        what="attribute",
        since=_since(attribute),
        parents=(Entry(use.element.name, "1" if attribute.required else "0"),),
        notes=_consumers(attribute.consumers),
        summary=summary("urdf", (*use.path, f"@{attribute.name}")),
    )
    return _with_value(described, attribute)


def _with_value(described: Description, value: UrdfAttribute) -> Description:
    instead = value.range.instead if value.range else None
    substitute = (f"libsdformat takes {instead} for a value out of range",) if instead else ()
    return described._replace(
        type=value.type,
        default=value.default,
        unit=_unit(value),
        range=str(value.range or ""),
        choices=value.choices,
        notes=(*_consumers(value.consumers), *substitute),
    )


def _entry_of_child(child: UrdfElement) -> Entry:
    return _entry(child.name, _often(child), child.value, child)


def _entry_of_attribute(attribute: UrdfAttribute) -> Entry:
    return _entry(f"@{attribute.name}", "1" if attribute.required else "0", attribute, attribute)


def _entry(name: str, often: str, value: UrdfAttribute | None, thing: UrdfElement | UrdfAttribute) -> Entry:
    given = (value.type, value.default, _unit(value)) if value else ("", "", "")
    return Entry(name, often, *given, _since(thing), note="".join(_consumers(thing.consumers)))


def _often(element: UrdfElement) -> str:
    if element.required:
        return "1" if element.single else "+"
    return "0" if element.single else "*"


def _unit(value: UrdfAttribute) -> str:
    return (
        value.units[0]
        if len(value.units) == 1
        else " (turning), ".join(value.units) + " (sliding)" * bool(value.units)
    )


def _since(thing: UrdfElement | UrdfAttribute) -> str:
    return thing.release or (str(thing.since) if thing.since > VERSIONS[0] else "")


def _consumers(names: tuple[str, ...]) -> tuple[str, ...]:
    return (f"read by {', '.join(names)} only",) if names else ()


def _name(use: _Use) -> str:
    return "/".join(use.path[1:]) or "robot"


def _parents(use: _Use) -> tuple[Entry, ...]:
    above = use.path[:-1]
    return (Entry("/".join(above[1:]) or "robot", _often(use.element)),) if above else ()


def _merged(found: list[Description]) -> tuple[Description, ...]:
    """Places that differ in their parents only are one, under the shortest name."""
    groups: dict[Description, list[Description]] = {}
    for one in found:
        bare = one._replace(name=one.name.rpartition("/")[2], parents=())
        groups.setdefault(bare, []).append(one)
    merged = []
    for bare, alike in groups.items():
        parents = tuple(sorted({parent for one in alike for parent in one.parents}))
        name = alike[0].name if len(alike) == 1 else bare.name
        if len(alike) > 1 and bare.what == "attribute":
            name = f"{parents[0].name}/{bare.name}" if len(parents) == 1 else bare.name
        merged.append(bare._replace(name=name, parents=parents))
    return tuple(sorted(merged))


def _complaint(steps: tuple[str, ...]) -> UnknownPlace:
    for end in range(1, len(steps)):
        if not any(_ends(use, list(steps[:end])) for use in _everywhere()):
            return _complaint(steps[:end])
    *outer, last = steps
    held = [use.element for use in _everywhere() if _ends(use, outer)]
    if last[0] == "@":
        known = {f"@{name}" for element in held for name in element.attributes}
    else:
        known = {name for element in held for name in element.children}
    return missing(last, f"`{'/'.join(outer)}`" if outer else "URDF", sorted(known))
