"""Values with the defaults that the formats give them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.schema import AttributeDefinition, Definition, schema
from sdfcheck.formats.sdf.survey import survey
from sdfcheck.robot.access.lookup import NotFound
from sdfcheck.robot.values import Flag, Number, Text, Vector, is_true

if TYPE_CHECKING:
    from sdfcheck.robot.part import Part
    from sdfcheck.source.element import Element, Value

_NUMBERS = frozenset(("double", "float", "int", "unsigned int"))
_VECTORS = frozenset(("vector3", "vector2d", "vector2i", "color", "pose", "quaternion", "angle", "time"))


def setting(part: Part, name: str) -> Number | Vector | Flag | Text:
    """A value of a part, or its default; raises NotFound where the format has none of that name."""
    if part.is_urdf:
        value = part.value(name)
        if value is None:
            raise NotFound(f"{part.title} has no `{name}`")
        return _typed(value, part.element, "double" if value.number == value.number else "string", "")
    definition: Definition | AttributeDefinition | None = _definition(part.element)
    if not part.is_given and isinstance(definition, Definition):
        definition = definition.children.get(part.kind)
    element: Element | None = part.element if part.is_given else None
    *path, last = name.split("/")
    for step in path:
        definition = definition.children.get(step) if isinstance(definition, Definition) else None
        element = None if element is None else element.find(step)
    place = definition
    if isinstance(place, Definition):
        definition = place.attributes.get(last) or place.children.get(last)
    if definition is None or definition is place or definition.type is None:
        raise NotFound(f"the format has no value `{name}` in {part.title}")
    value = None
    if element is not None:
        child = None if isinstance(definition, AttributeDefinition) else element.find(last)
        value = element.attribute(last) if child is None else child.own_value
    return _typed(
        value, part.element if element is None else element, definition.type, definition.default or ""
    )


def _definition(element: Element) -> Definition | None:
    """The definition of an element in the document's version."""
    names: list[str] = []
    at: Element = element
    while (parent := at.parent) is not None and parent.name != "gazebo":
        names.insert(0, at.name)
        at = parent
    definition: Definition | None = schema(survey(element.document).version).root
    if at.name != "sdf":  # in a <gazebo> block of URDF
        names.insert(0, at.name)
        definition = schema(survey(element.document).version).at(f"{names[0]}:{names[0]}")
        names = names[1:]
    for name in names:
        definition = definition.children.get(name) if definition is not None else None
    return definition


def _typed(value: Value | None, element: Element, kind: str, default: str) -> Number | Vector | Flag | Text:
    if kind in _NUMBERS:
        return Number.of(value, element, _number(default))
    if kind in _VECTORS:
        return Vector.of(value, element, map(_number, default.split()))
    if kind == "bool":
        return Flag.of(value, element, is_true(default))
    return Text.of(value, element, default)


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return math.nan
