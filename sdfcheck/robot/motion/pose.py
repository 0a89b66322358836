"""Poses as values: a position and a rotation."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from sdfcheck.robot.motion.rotations import Array, inverse, to_rpy

if TYPE_CHECKING:
    from sdfcheck.robot.node import Node
    from sdfcheck.robot.part import Part
    from sdfcheck.robot.scope import Scope
    from sdfcheck.source.element import Element


class Pose:
    """Where something is: ``numpy.asarray(pose)`` is its 4×4 transform.

    The transform takes points of its frame to the frame that it is relative to.
    """

    __slots__ = ("_transform",)

    def __init__(self, transform: Array) -> None:
        self._transform = transform
        transform.setflags(write=False)

    @classmethod
    def written(cls, element: Element, name: str) -> Pose | None:
        """The pose that a child element ``pose`` or ``origin`` writes; None if there is none."""
        from sdfcheck.robot.motion.poses import origin_of, written_pose

        child = element.find(name)
        if child is None:
            return None
        return cls(origin_of(element) if name == "origin" else written_pose(child))

    @property
    def xyz(self) -> tuple[float, float, float]:
        """The position (m)."""
        x, y, z = self._transform[:3, 3].tolist()
        return x, y, z

    @property
    def rpy(self) -> tuple[float, float, float]:
        """Roll, pitch and yaw (rad) about fixed x, y and z axes, in this order."""
        return to_rpy(self._transform[:3, :3])

    @property
    def quaternion(self) -> tuple[float, float, float, float]:
        """The rotation as x, y, z, w of length 1, w not negative."""
        return _quaternion(self._transform[:3, :3])

    def inverse(self) -> Pose:
        """The pose of the other frame in this one."""
        return Pose(inverse(self._transform))

    def __matmul__(self, other: Pose) -> Pose:
        """The pose of something whose pose in this frame is ``other``."""
        return Pose(self._transform @ other._transform)

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Array:
        return np.array(self._transform, dtype=dtype, copy=True) if copy or dtype else self._transform

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Pose) and bool((self._transform == other._transform).all())

    def __hash__(self) -> int:
        return hash(self._transform.tobytes())

    def __repr__(self) -> str:
        numbers = " ".join(f"{round(number, 6) + 0.0:g}" for number in (*self.xyz, *self.rpy))
        return f"Pose({numbers!r})"


def resolved(node: Node, relative_to: str | Node | None) -> Pose:
    """The pose of a node relative to another, or to the one that a reference, written beside it, names."""
    poses, scope = node.root.poses, node.scope_around
    if scope is None:
        own = poses.in_scope(node)
        if relative_to in {None, "world"} or relative_to is node.root.outside:
            return Pose(own)
        base = node if relative_to is node else _named(node, relative_to)
        return Pose(inverse(poses.reached(cast("Scope", node), base)) if node.is_scope else own)
    if relative_to is None:
        return Pose(poses.in_scope(node).copy())
    top = scope
    while top.scope_around is not None:
        top = top.scope_around
    pose = poses.reached(top, node)
    if relative_to == "world" or relative_to in (top, node.root.outside):
        outer = np.eye(4) if top.kind == "world" else poses.in_scope(top)
        return Pose(outer @ pose if relative_to != top else pose)
    return Pose(inverse(poses.reached(top, _named(node, relative_to))) @ pose)


def _named(node: Node, reference: str | Node | None) -> Node:
    from sdfcheck.robot.motion.poses import PoseError

    if reference is not None and not isinstance(reference, str):
        return reference
    is_outermost = node.is_scope and node.scope_around is None
    scope = cast("Scope", node) if is_outermost else node.scope
    found = scope.resolve(reference or "")
    if found is None:
        raise PoseError(f"there is no frame {reference!r} in {scope.name}", node.element)
    return found


def of_part(part: Part, holder: Node | None, relative_to: str | None) -> Pose:
    """The pose of a visual, sensor or light in what it is on, or relative to what a reference names there."""
    from sdfcheck.robot.motion import poses

    if holder is None:
        return Pose(poses.written_pose(part.find("pose")))
    return Pose(poses.of_part(part, holder, relative_to))


def _quaternion(rotation: Array) -> tuple[float, float, float, float]:
    (a, b, c), (d, e, f), (g, h, i) = rotation.tolist()
    w = math.sqrt(max(0.0, 1 + a + e + i)) / 2
    x = math.copysign(math.sqrt(max(0.0, 1 + a - e - i)) / 2, h - f)
    y = math.copysign(math.sqrt(max(0.0, 1 - a + e - i)) / 2, c - g)
    z = math.copysign(math.sqrt(max(0.0, 1 - a - e + i)) / 2, d - b)
    length = math.sqrt(x * x + y * y + z * z + w * w)
    return x / length, y / length, z / length, w / length
