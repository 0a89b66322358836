"""How tags carry their values: as text, in an attribute, in a plain child."""

from __future__ import annotations

from sdfcheck.source.element import Element, Value

_USUAL = ("value", "name", "link", "xyz", "axis")


def value_at(element: Element, carrier: str) -> Value | None:
    """The value in the shape ``text``, ``@attribute`` or ``/child``; None if it is not there."""
    if carrier == "text":
        return element.own_value
    if carrier[0] == "@":
        return element.attribute(carrier[1:])
    child = element.find(carrier[1:])
    return None if child is None else child.own_value


def value_elsewhere(element: Element, wanted: str) -> tuple[str, Value] | None:
    """A value that is in another shape than the one that is read."""
    if wanted != "text" and element.content:
        return "text", element.own_value
    for name in _USUAL:
        if wanted != f"@{name}" and (value := element.attribute(name)) is not None:
            return f"@{name}", value
    return None
