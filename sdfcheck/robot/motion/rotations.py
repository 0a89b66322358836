"""Rotations and transforms as plain numpy arrays.

A transform is a 4×4 array that takes points of the inner frame to the outer one.
Angles are in radians; roll, pitch and yaw are turns about fixed x, y and z axes, in
that order, as SDFormat and URDF have them.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from sdfcheck.robot.motion.origin import of_quaternion, of_rpy

Array = npt.NDArray[np.float64]

_POLE = 1e-9
"""Below this cosine of the pitch, roll and yaw turn about one axis and only their sum is determined."""


def from_rpy(roll: float, pitch: float, yaw: float) -> Array:
    """The 3×3 rotation of roll, pitch, yaw (rad)."""
    return np.array(of_rpy(roll, pitch, yaw))


def to_rpy(rotation: Array) -> tuple[float, float, float]:
    """Roll, pitch, yaw (rad) of a 3×3 rotation; exact up to the poles, where the yaw is 0."""
    across = math.hypot(rotation[0, 0], rotation[1, 0])
    pitch = math.atan2(-rotation[2, 0], across)
    if across < _POLE:
        return math.atan2(-rotation[1, 2], rotation[1, 1]), pitch, 0.0
    roll = math.atan2(rotation[2, 1], rotation[2, 2])
    return roll, pitch, math.atan2(rotation[1, 0], rotation[0, 0])


def from_quaternion(x: float, y: float, z: float, w: float) -> Array:
    """The 3×3 rotation of a quaternion, normalized first; of the zero quaternion, no rotation."""
    return np.array(of_quaternion(x, y, z, w))


def about_axis(axis: Sequence[float] | Array, angle: float | Array) -> Array:
    """The 3×3 rotation by an angle (rad) about an axis of unit length; of many, shapes (…, 3) and (…)."""
    x, y, z = np.moveaxis(np.asarray(axis, dtype=float), -1, 0)
    cross = np.zeros((*x.shape, 3, 3))
    cross[..., 2, 1], cross[..., 0, 2], cross[..., 1, 0] = x, y, z
    cross -= cross.swapaxes(-1, -2)
    angles = np.asarray(angle)[..., None, None]
    return np.asarray(np.eye(3) + np.sin(angles) * cross + 2 * np.sin(angles / 2) ** 2 * (cross @ cross))


def z_towards(direction: Array) -> Array:
    """The 3×3 rotation that turns z the shortest way into a direction of unit length."""
    across = np.cross((0.0, 0.0, 1.0), direction)
    length = float(np.linalg.norm(across))
    axis = across / length if length > 1e-12 else np.array((1.0, 0.0, 0.0))
    return about_axis(axis, math.atan2(length, float(direction[2])))


def transform(rotation: Array, position: Sequence[float] | Array) -> Array:
    """The 4×4 transform of a rotation and a position (m); of many, shapes (…, 3, 3) and (…, 3)."""
    result = np.zeros((*np.shape(rotation)[:-2], 4, 4))
    result[..., :3, :3] = rotation
    result[..., :3, 3] = position
    result[..., 3, 3] = 1
    return result


def inverse(of: Array) -> Array:
    """The inverse of a 4×4 transform, or of many, shape (…, 4, 4)."""
    back = of[..., :3, :3].swapaxes(-1, -2)
    result = np.zeros(of.shape)
    result[..., :3, :3] = back
    result[..., :3, 3] = -(back @ of[..., :3, 3:])[..., 0]
    result[..., 3, 3] = 1
    return result


def angle_between(a: Array, b: Array) -> float:
    """The angle (rad) between two 3×3 rotations, precise also where it is tiny."""
    return float(angles_between(a, b))


def angles_between(a: Array, b: Array) -> Array:
    """The angles (rad) between rotations, shape (…, 3, 3)."""
    chords = np.linalg.norm(a - b, axis=(-2, -1)) / (2 * math.sqrt(2))
    return np.asarray(2 * np.arcsin(np.minimum(1.0, chords)))
