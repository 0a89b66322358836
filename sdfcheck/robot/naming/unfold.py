"""Names with ``::`` in worlds up to version 1.7, which libsdformat turns back into nested models.

``A::x`` in a model becomes ``x`` in a nested model ``A``, and every reference in it
loses its ``A::``. A reference that has none to lose fails an assertion that ends the
program. Source: ``unflatten`` in libsdformat 17's Converter.cc and what it does when run.
"""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.formats.sdf.survey import Survey
from sdfcheck.source.element import Element, Value

_MOVED = frozenset({"frame", "joint", "link", "model", "gripper"})
_AXES = ("axis", "axis2")


def foreign_references(surveyed: Survey) -> dict[Element, Value | Element]:
    """The elements whose names cannot be unfolded, with what is in the way."""
    found: dict[Element, Value | Element] = {}
    for model in surveyed.index.get("model", ()):
        if _is_in_world(model):
            found.update(_in_model(model))
    return found


def _is_in_world(element: Element) -> bool:
    return next((each.name for each in element.around if each.name != "model"), "") == "world"


def _in_model(model: Element) -> Iterator[tuple[Element, Value | Element]]:
    for child in model.children():
        name = child.attributes.get("name", "")
        if child.name in _MOVED and "::" in name:
            prefix = name.partition("::")[0]
            obstacle = next(_obstacles(child, prefix), None)
            if obstacle is not None:
                yield child, obstacle


def _obstacles(element: Element, prefix: str) -> Iterator[Value | Element]:
    """The names that do not begin with the prefix, in the order in which they occur."""
    for reference in _references(element):
        if isinstance(reference, Element) or not reference.text.strip().startswith(prefix):
            yield reference


def _references(element: Element) -> Iterator[Value | Element]:
    """The references that are unfolded with an element, and axes that lack the direction they could be on."""
    if element.name == "frame":
        yield from _attribute(element, "attached_to")
    elif element.name == "link":
        for part in element.children():
            yield from _poses(part)
    elif element.name == "joint":
        for role in ("parent", "child"):
            if (end := element.find(role)) is not None and end.content:
                yield end.own_value
        for axis in (child for child in element.children() if child.name in _AXES):
            xyz = axis.find("xyz")
            yield from (axis,) if xyz is None else _attribute(xyz, "expressed_in")
        for sensor in element.children("sensor"):
            yield from _poses(sensor)


def _poses(element: Element) -> Iterator[Value]:
    """The node that the poses of a part of a link, and of its camera, are relative to."""
    for holder in (element, element.find("camera")):
        pose = holder.find("pose") if holder is not None else None
        if pose is not None:
            yield from _attribute(pose, "frame")
            yield from _attribute(pose, "relative_to")


def _attribute(element: Element, name: str) -> Iterator[Value]:
    value = element.attribute(name)
    if value is not None and value.text.strip():
        yield value
