"""Joints that only one simulator knows: ``drake:joint``."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from sdfcheck.robot.model import Model
from sdfcheck.robot.motion import mechanism
from sdfcheck.robot.motion.origin import urdf_number
from sdfcheck.robot.parts.joint import Joint

_IN_SDF = frozenset({"curvilinear", "planar"})
_IN_URDF = _IN_SDF | {"ball", "screw", "universal"}


def joints_of_vendors(model: Model) -> Iterator[Joint]:
    """Those directly in a model.

    One that a URDF file also has for libsdformat, in a ``<gazebo>`` block, is left out.
    """
    kept = {joint.name for block in model.gazebo_blocks for joint in block.joints}
    for element in model.children("drake:joint"):
        joint = model.part(element)
        if not isinstance(joint, Joint):
            continue
        if joint.type in (_IN_URDF if joint.is_urdf else _IN_SDF) and joint.name not in kept:
            yield joint


def mimic_of_vendors(joint: Joint) -> tuple[str, float, float] | None:
    """Leader, multiplier and offset of Drake's own way to say that a joint of SDFormat follows another."""
    mimic = joint.find("drake:mimic")
    if mimic is None:
        return None
    numbers = (mimic.attribute(name) for name in ("multiplier", "offset"))
    multiplier, offset = (math.nan if value is None else value.number for value in numbers)
    if math.isnan(multiplier) or math.isnan(offset):
        return None
    return mimic.attributes.get("joint", "").strip(), multiplier, offset


def as_vendors_have_it(made: mechanism.Joint, joint: Joint) -> mechanism.Joint:
    """The joint of a URDF file with the axes and the pitch that Drake gives it.

    A universal joint turns about x, then y, whatever its axis says.
    """
    axis = made.axes[0]
    if made.kind == "universal":
        made.axes = tuple(replace(axis, direction=np.eye(3)[number]) for number in (0, 1))
    elif made.kind in {"ball", "curvilinear"}:
        made.axes = ()
    elif made.kind == "screw":
        pitch = joint.find("drake:screw_thread_pitch")
        made.pitch = 0.0 if pitch is None else urdf_number(pitch, "value", 0.0) / (2 * math.pi)
    return made
