"""Differential drives: what the parameters of a plugin say, and where the wheels are."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, cast

from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.motion.origin import Origin, origin_in, pose_in
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model
    from sdfcheck.robot.node import Node
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.plugin import Plugin
    from sdfcheck.source.element import Element

_LEFT = ("left_joint", "leftJoint")
_RIGHT = ("right_joint", "rightJoint")
_SEPARATION = ("wheel_separation", "wheelSeparation")
_RADIUS = ("wheel_radius", "wheelRadius")
_DIAMETER = ("wheel_diameter", "wheelDiameter")
_DEEPEST = 200
"""Joints above a wheel that are followed."""


class Wheel(NamedTuple):
    """A wheel of a drive, in the frame of the model."""

    joint: Joint
    position: tuple[float, ...]
    axis: tuple[float, ...]
    """Of length 1."""
    radius: float
    """m, of its round shape; nan where there is none."""


class Drive(NamedTuple):
    """A drive with one wheel on each side."""

    left: Wheel
    right: Wheel
    left_name: Element
    """The parameter that names the joint."""
    right_name: Element
    separation: Element | None
    radius: Element | None
    """The parameter of the radius or the diameter."""

    @property
    def distance(self) -> float:
        """How far to the left of the right wheel the left one is, along its axis (m)."""
        pairs = zip(self.left.position, self.right.position, self.left.axis, strict=True)
        return sum((left - right) * along for left, right, along in pairs)

    @property
    def written_radius(self) -> float:
        """The radius that the plugin takes (m); nan if none is written."""
        number = self.radius.own_value.number if self.radius is not None else math.nan
        return number / 2 if self.radius is not None and self.radius.name in _DIAMETER else number


def drive_of(plugin: Plugin) -> Drive | None:
    """The drive that a plugin makes; None for other plugins, several wheels a side, and what is not known."""
    model = _model(plugin)
    given: dict[str, list[Element]] = {}
    for parameter in plugin.parameters:
        given.setdefault(parameter.name, []).append(parameter)
    left, right = _only(given, _LEFT), _only(given, _RIGHT)
    if model is None or left is None or right is None:
        return None
    wheels = [_wheel(model, name.content.strip()) for name in (left, right)]
    if wheels[0] is None or wheels[1] is None or wheels[0].joint is wheels[1].joint:
        return None
    radius = _only(given, (*_RADIUS, *_DIAMETER))
    return Drive(wheels[0], wheels[1], left, right, _only(given, _SEPARATION), radius)


def _only(given: dict[str, list[Element]], names: tuple[str, ...]) -> Element | None:
    found = [element for name in names for element in given.get(name, ())]
    return found[0] if len(found) == 1 else None


def _model(plugin: Plugin) -> Model | None:
    from sdfcheck.robot.model import Model

    scope = plugin.root.scope_of(plugin.element)
    return scope if isinstance(scope, Model) else None


def _wheel(model: Model, name: str) -> Wheel | None:
    joint = model.joints_by_name.get(name)
    xyz = joint.axis.xyz if joint is not None else ()
    length = math.hypot(*xyz)
    if joint is None or joint.axis_count != 1 or len(xyz) != 3 or not 0 < length < math.inf:
        return None
    if joint.axis.expressed_in:
        return None
    try:
        pose = _in_model(joint)
    except DescriptionError:
        return None
    if pose is None:
        return None
    x, y, z = (number / length for number in xyz)
    return Wheel(joint, pose.position, pose.turned((x, y, z)), wheel_radius(joint))


def _in_model(joint: Joint) -> Origin | None:
    """Where a joint is in its model; None where it hangs on nothing. Raises DescriptionError."""
    link = joint.child_link
    if link is None:
        return None
    if not joint.is_urdf:
        return _in_sdf(joint)
    found, at = origin_in(joint.element), joint.parent_link
    for _ in range(_DEEPEST):
        above = at.parent_joints[0] if at is not None and at.parent_joints else None
        if above is None:
            return found
        found, at = origin_in(above.element).followed_by(found), above.parent_link
    return None


def _in_sdf(joint: Joint) -> Origin | None:
    """The same in SDFormat, as far as it is relative to what is in the same model."""
    found, at = Origin(), cast("Node", joint)
    for _ in range(_DEEPEST):
        found = pose_in(at.pose_element).followed_by(found)
        base = at.base
        if base is None or base is joint.scope:
            return found if base is not None or not at.base_name else None
        if base.scope is not joint.scope or base.kind == "model":
            return None
        at = base
    return None


def wheel_radius(joint: Joint) -> float:
    """The radius (m) of the one round shape of the link that a joint turns; nan where it has another number of them."""
    link = joint.child_link
    shapes = (link.collisions or link.visuals) if link is not None else ()
    geometry = shapes[0].geometry if len(shapes) == 1 else None
    if geometry is None or geometry.solid is None or geometry.shape not in {"cylinder", "sphere"}:
        return math.nan
    return float(geometry.radius)
