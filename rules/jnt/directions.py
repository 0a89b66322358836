"""Directions of axes: valid ones, and those of no length."""

from sdfcheck import Axis

NO_LENGTH = 1e-6
"""libsdformat refuses a shorter axis."""
WITH_AXIS = frozenset(("continuous", "planar", "prismatic", "revolute"))
"""The types of joint that have an axis in URDF."""


def is_used(axis: Axis) -> bool:
    """Does anybody read the direction? The first axis of a joint counts, in URDF that of types that have one."""
    joint = axis.joint
    if axis is not joint.axis and axis is not joint.axis2:
        return False
    return not axis.is_urdf or joint.type in WITH_AXIS


def has_no_length(axis: Axis) -> bool:
    """Does it point nowhere?"""
    return axis.length <= 0 if axis.is_urdf else axis.length < NO_LENGTH
