"""Friction of collisions: in SDFormat Drake reads the one for Gazebo, in URDF only its own."""

from __future__ import annotations

from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.writer import Node
from sdfcheck.source.element import Element

_PROPERTIES = "drake:proximity_properties"
_FRICTIONS = {"mu": "drake:mu_static", "mu2": "drake:mu_dynamic"}
_DEFAULT = "1"


def carry_friction(context: Context, collision: Node, element: Element) -> None:
    """Write the friction of a collision for Drake, where the description is written for it."""
    at: Element | None = element
    for name in ("surface", "friction", "ode"):
        at = at.find(name) if at is not None else None
    own = collision.find(_PROPERTIES)
    if not context.natives or at is None or (own is not None and any(map(own.find, _FRICTIONS.values()))):
        return
    values = {name: part.content for name in _FRICTIONS if (part := at.find(name)) is not None}
    if values:
        properties = collision.reach(_PROPERTIES)
        for name, tag in _FRICTIONS.items():
            properties.add(tag, value=values.get(name, _DEFAULT))
