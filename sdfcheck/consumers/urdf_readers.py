"""What the readers of URDF do about a part that cannot be read as it stands.

It depends on the place: urdfdom drops links in part and refuses joints, MuJoCo looks at no visual
but at its material, Drake passes over controllers. Checked by taking attributes and elements
away, and by misspelling values, with urdfdom 3.0, libsdformat 12.3, Drake 1.51 and MuJoCo 4.0.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from sdfcheck.consumers.reaction import REFUSES, Consumer, Reaction, accepts, refuses, warns
from sdfcheck.source.element import Element, Value
from sdfcheck.source.sniff import Kind

_UNREAD = accepts("does not read it")
_ASIDE = frozenset(("safety_controller", "calibration"))
_NUMBER = re.compile(r"[-+]?\.?\d\S*")


def unreadable(at: Element | Value) -> Mapping[Consumer, Reaction]:
    """Reactions to a value that is malformed, or to a part that is missing; none in SDFormat."""
    element = at.element if isinstance(at, Value) else at
    if element.document.kind is Kind.SDF:
        return {}
    place = _place(element)
    if "gazebo" in place:
        return {**dict.fromkeys(Consumer, _UNREAD), Consumer.GAZEBO: refuses("crashes")}
    urdfdom = _urdfdom(place)
    found = {Consumer.URDFDOM: urdfdom, Consumer.GAZEBO: urdfdom, Consumer.DRAKE: REFUSES}
    found[Consumer.MUJOCO] = _UNREAD if is_unread_by_mujoco(at) else REFUSES
    if isinstance(at, Value) and (element.name, at.attribute, at.text) == ("joint", "type", "spherical"):
        found[Consumer.MUJOCO] = accepts("makes a ball joint of it")
    if place & _ASIDE:
        found[Consumer.DRAKE] = _UNREAD
    elif isinstance(at, Value) and _NUMBER.fullmatch(at.text.strip()):
        found[Consumer.DRAKE] = warns("reads the number at its beginning")
    return found


def lacking(element: Element, name: str) -> Mapping[Consumer, Reaction]:
    """Reactions to an attribute or child that is not there or empty."""
    if element.document.kind is Kind.SDF:
        return {}
    if (element.name, name) == ("axis", "xyz"):
        return {Consumer.URDFDOM: warns("takes no axis"), Consumer.DRAKE: warns("takes a default")}
    found = dict(unreadable(element))
    if element.name == "material" and "visual" in _place(element):
        found[Consumer.DRAKE] = accepts("needs no name there")
    if (element.name, name) == ("robot", "link"):
        found[Consumer.DRAKE] = accepts("takes a robot without links")
    if element.name == "texture" and "visual" in _place(element):
        found = {
            **dict.fromkeys(Consumer, accepts("goes by the name of the material")),
            Consumer.DRAKE: REFUSES,
        }
    if element.name in {"robot", "material"}:
        found[Consumer.MUJOCO] = _UNREAD
    return found


def undersized(at: Value) -> Mapping[Consumer, Reaction]:
    """Reactions to a shape of no size; none in SDFormat, and where Drake takes a sphere for a point."""
    if at.element.document.kind is Kind.SDF or "geometry" not in _place(at.element):
        return {}
    return {Consumer.MUJOCO: _UNREAD if is_unread_by_mujoco(at) else REFUSES}


def repeating(element: Element) -> Mapping[Consumer, Reaction]:
    """Reactions to an element that is given again, of which one is enough."""
    unread = element.document.kind is not Kind.SDF and is_unread_by_mujoco(element)
    return {Consumer.MUJOCO: _UNREAD} if unread else {}


def is_unread_by_mujoco(at: Element | Value) -> bool:
    """Whether MuJoCo passes over what stands there."""
    element = at.element if isinstance(at, Value) else at
    place = _place(element)
    if place & _ASIDE or place & {"transmission", "gazebo"}:
        return True
    if isinstance(at, Value) and (element.name, at.attribute) == ("limit", "velocity"):
        return True
    return "visual" in place and not ("material" in place and element.name != "material")


def _urdfdom(place: frozenset[str]) -> Reaction:
    if "joint" in place:
        return REFUSES
    if "material" in place:
        return warns("drops the material")
    if place & {"visual", "collision", "inertial"}:
        return warns("drops the rest of the link")
    return REFUSES


def _place(element: Element) -> frozenset[str]:
    """The names of an element and of those around it."""
    names = set()
    at: Element | None = element
    while at is not None:
        names.add(at.name)
        at = at.parent
    return frozenset(names)
