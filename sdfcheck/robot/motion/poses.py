"""Poses: where nodes are, whatever the pose is written relative to.

Source: the specification's pose frame semantics (1.7, 1.8) and libsdformat 17, which
applies them to documents of every version.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Protocol, cast

import numpy as np
import numpy.typing as npt

from sdfcheck.robot.motion.origin import Origin, PoseError, of_rpy, origin_in, pose_in
from sdfcheck.robot.values import reference_of
from sdfcheck.source.document import Element
from sdfcheck.source.errors import DescriptionError

# Rotations and transforms as plain numpy arrays.
#
# A transform is a 4×4 array that takes points of the inner frame to the outer one. Angles are in radians;
# roll, pitch and yaw are turns about fixed x, y and z axes, in that order, as SDFormat and URDF have them.


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


# Nodes, as far as their poses depend on them.


class Placed(Protocol):
    """A link, joint, frame, model or world; what is said of each is said of nodes in :mod:`sdfcheck.robot.part`."""

    element: Element
    is_urdf: bool

    @property
    def kind(self) -> str: ...
    @property
    def name(self) -> str: ...
    @property
    def is_scope(self) -> bool: ...
    @property
    def scope(self) -> Scoped: ...
    @property
    def scope_around(self) -> Scoped | None: ...
    @property
    def base(self) -> Placed | None: ...
    @property
    def base_name(self) -> str: ...
    @property
    def urdf_base(self) -> tuple[Placed | None, Element | None]: ...
    @property
    def pose_element(self) -> Element | None: ...
    @property
    def placement_frame(self) -> str: ...
    @property
    def unmerged(self) -> Placed: ...
    def look_up(self, reference: str) -> Placed | None: ...


class Scoped(Placed, Protocol):
    """A model or world."""

    @property
    def own_name(self) -> str: ...
    def resolve(self, reference: str) -> Placed | None: ...


# Poses as values: a position and a rotation.


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


def _quaternion(rotation: Array) -> tuple[float, float, float, float]:
    (a, b, c), (d, e, f), (g, h, i) = rotation.tolist()
    w = math.sqrt(max(0.0, 1 + a + e + i)) / 2
    x = math.copysign(math.sqrt(max(0.0, 1 + a - e - i)) / 2, h - f)
    y = math.copysign(math.sqrt(max(0.0, 1 - a + e - i)) / 2, c - g)
    z = math.copysign(math.sqrt(max(0.0, 1 - a - e + i)) / 2, d - b)
    length = math.sqrt(x * x + y * y + z * z + w * w)
    return x / length, y / length, z / length, w / length


def written_pose(pose: Element | None) -> Array:
    """The 4×4 transform that a ``pose`` element writes; no element and an empty one are zero.

    Raises PoseError if its numbers cannot be read.
    """
    try:
        origin = pose_in(pose)
    except DescriptionError as error:
        raise PoseError(str(error), error.element) from None
    return transform(np.array(origin.rotation), origin.position)


def origin_of(element: Element) -> Array:
    """The 4×4 transform of an element's ``origin`` in URDF; the identity without one.

    Raises DescriptionError where a number is not one.
    """
    origin = origin_in(element)
    return transform(np.array(origin.rotation), origin.position)


class Poses:
    """The poses of the nodes of one description, worked out when asked for and kept."""

    def __init__(self) -> None:
        self._known: dict[Placed, Array | DescriptionError] = {}
        self._open: set[Placed] = set()

    def of_node(self, node: Placed, relative_to: str | Placed | None) -> Pose:
        """The pose of a node relative to another, or to the one that a reference, written beside it, names.

        ``"world"`` is the outermost model or world.
        """
        scope = node.scope_around
        if scope is None:
            own = self.in_scope(node)
            if relative_to is None or relative_to == "world" or not node.is_scope:
                return Pose(own)
            outermost = cast("Scoped", node)
            return Pose(inverse(self.reached(outermost, _named(outermost, relative_to, node))))
        if relative_to is None:
            return Pose(self.in_scope(node).copy())
        top = scope
        while top.scope_around is not None:
            top = top.scope_around
        pose = self.reached(top, node)
        if relative_to == "world" and top.kind != "world":
            return Pose(self.in_scope(top) @ pose)
        if relative_to in ("world", top):
            return Pose(pose)
        return Pose(inverse(self.reached(top, _named(node.scope, relative_to, node))) @ pose)

    def of_part_in(self, part: Element | None, holder: Placed | None, relative_to: str | None) -> Pose:
        """The pose of a part, if it is written, in what it is on, or relative to what a reference names there."""
        if holder is None:
            return Pose(written_pose(None if part is None else part.find("pose")))
        pose = np.eye(4) if part is None else self.of_part(part, holder)
        if relative_to is None:
            return Pose(pose)
        scope = holder.scope
        base = np.eye(4) if relative_to == scope.own_name else self.named(scope, relative_to)
        return Pose(inverse(base) @ self.reached(scope, holder) @ pose)

    def in_scope(self, node: Placed) -> Array:
        """The 4×4 pose of a node in the frame of the model or world that it is in.

        Raises PoseError where it leads nowhere.
        """
        # Chains may be long: they are resolved from their far end, so that nothing recurs deeply.
        chain: dict[Placed, None] = {}
        at: Placed | None = node
        while at is not None and at not in self._known and at not in chain:
            chain[at] = None
            at = self._leads_to(at)
        for each in reversed(chain):
            self._settle(each)
        pose = self._known[node]
        if isinstance(pose, DescriptionError):
            raise pose
        return pose

    def named(self, scope: Scoped, reference: str) -> Array:
        """The pose, in a scope's own frame, of what a reference names there."""
        return self._of(scope, scope.resolve(reference), reference)

    def reached(self, scope: Scoped, node: Placed) -> Array:
        """The pose, in a scope's own frame, of the scope itself, a node in it, or one in a nested model of it."""
        if node is scope:
            return np.eye(4)
        pose = self.in_scope(node)
        at = node.scope
        while at is not scope:
            if at.scope_around is None:
                raise PoseError(f"{node.name} is not below {scope.name}", node.element)
            pose = self.in_scope(at) @ pose
            at = at.scope
        return pose

    def of_part(self, part: Element, holder: Placed) -> Array:
        """The pose of a visual, collision, sensor, light or inertial in the frame of its link or joint."""
        if holder.is_urdf and part.name != "sensor":
            return origin_of(part)
        pose = part.find("pose")
        reference = reference_of(pose)
        if not reference:
            return written_pose(pose)
        base = self._of(holder.scope, holder.look_up(reference), reference)
        return inverse(self.in_scope(holder)) @ base @ written_pose(pose)

    def _settle(self, node: Placed) -> None:
        if node in self._known:
            return
        if node in self._open:
            raise PoseError(f"the pose of {node.name} depends on itself", node.element)
        self._open.add(node)
        try:
            self._known[node] = self._resolve(node)
        except DescriptionError as error:
            self._known[node] = error
        finally:
            self._open.discard(node)

    def _leads_to(self, node: Placed) -> Placed | None:
        """The node that the pose of a node is relative to; None if that is its scope, or unknown."""
        base = node.urdf_base[0] if is_in_urdf(node) else node.base
        return None if base is node.scope else base

    def _of(self, scope: Scoped, node: Placed | None, reference: str) -> Array:
        if node is None:
            raise PoseError(f"there is no frame {reference!r} in {scope.name}", scope.element)
        return self.reached(scope, node)

    def _resolve(self, node: Placed) -> Array:
        if is_in_urdf(node):
            return self._resolve_urdf(node)
        base = np.eye(4)
        if node.scope_around is not None:
            base = self._of(node.scope, node.base, node.base_name)
        result = base @ written_pose(node.pose_element)
        inside = node.unmerged
        if inside.placement_frame:
            result = result @ inverse(self.named(cast("Scoped", inside), inside.placement_frame))
        return result

    def _resolve_urdf(self, node: Placed) -> Array:
        """Of a link: where its first joint puts it, all joints at zero; a joint is where its child is."""
        base, joint = node.urdf_base
        if base is None and node.kind == "joint":
            raise PoseError(f"joint {node.name} has no child", node.element)
        above = np.eye(4) if base is None or base is node.scope else self.in_scope(base)
        return above if joint is None else above @ origin_of(joint)


def is_in_urdf(node: Placed) -> bool:
    """Is it a link or joint of a URDF robot?"""
    return node.is_urdf and node.kind in {"link", "joint"}


def _named(scope: Scoped, reference: str | Placed, node: Placed) -> Placed:
    if not isinstance(reference, str):
        return reference
    found = scope.resolve(reference)
    if found is None:
        raise PoseError(f"there is no frame {reference!r} in {scope.name}", node.element)
    return found


def origin_from(transform: Array) -> Origin:
    """A 4×4 transform in plain numbers."""
    (a, b, c, x), (d, e, f, y), (g, h, i, z), _ = transform.tolist()
    return Origin(((a, b, c), (d, e, f), (g, h, i)), (x, y, z))
