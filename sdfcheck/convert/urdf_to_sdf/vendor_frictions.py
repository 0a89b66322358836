"""Friction that a ``<gazebo>`` block gives: in URDF Drake does not read it, in SDFormat it does."""

from __future__ import annotations

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.urdf_to_sdf.context import Context
from sdfcheck.convert.vendor.spelling import uses
from sdfcheck.convert.writer import Node
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.element import Element

_PROPERTIES = "drake:proximity_properties"
_FRICTIONS = ("drake:mu_static", "drake:mu_dynamic")
_DEFAULT = "1"
"""What Drake takes where a file says nothing."""


def keep_frictions_of_drake(context: Context, root: Element) -> None:
    """Write out what Drake takes as friction, where the result says another for Gazebo and the file is Drake's."""
    if not uses(root, "drake"):
        return
    for name, link in context.links.items():
        concerned = list(filter(_is_only_for_gazebo, link.elements("collision")))
        for collision in concerned:
            for friction in _FRICTIONS:
                collision.reach(_PROPERTIES).add(friction, _DEFAULT)
        if concerned:
            text = (
                f"the friction of link `{name}` in a <gazebo> block is not for Drake, whose 1 is written out"
            )
            at = context.plan.robot.links[name].element
            context.note(at, LossKind.CHANGED_DEFAULT, text, Severity.INFO)


def _is_only_for_gazebo(collision: Node) -> bool:
    properties, at = collision.find(_PROPERTIES), collision
    if properties is not None and any(properties.find(friction) is not None for friction in _FRICTIONS):
        return False
    for name in ("surface", "friction", "ode"):
        found = at.find(name)
        if found is None:
            return False
        at = found
    return at.find("mu") is not None or at.find("mu2") is not None
