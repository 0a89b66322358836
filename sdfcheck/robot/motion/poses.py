"""Poses: where nodes are, whatever the pose is written relative to.

Source: the specification's pose frame semantics (1.7, 1.8) and libsdformat 17, which
applies them to documents of every version.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any, cast

import numpy as np

from sdfcheck.robot.motion.origin import origin_in, pose_in
from sdfcheck.robot.motion.rotations import Array, inverse, to_rpy, transform
from sdfcheck.robot.values import reference_of
from sdfcheck.source.errors import DescriptionError

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Model, Node, Part, Scope
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.source.document import Element


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
    if holder is None:
        return Pose(written_pose(part.find("pose")))
    return Pose(_pose_of_part(part, holder, relative_to))


def _quaternion(rotation: Array) -> tuple[float, float, float, float]:
    (a, b, c), (d, e, f), (g, h, i) = rotation.tolist()
    w = math.sqrt(max(0.0, 1 + a + e + i)) / 2
    x = math.copysign(math.sqrt(max(0.0, 1 + a - e - i)) / 2, h - f)
    y = math.copysign(math.sqrt(max(0.0, 1 - a + e - i)) / 2, c - g)
    z = math.copysign(math.sqrt(max(0.0, 1 - a - e + i)) / 2, d - b)
    length = math.sqrt(x * x + y * y + z * z + w * w)
    return x / length, y / length, z / length, w / length


class PoseError(DescriptionError):
    """A pose that cannot be worked out: an unknown frame, a ring, a value that is not a pose."""


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
        self._known: dict[Node, Array | DescriptionError] = {}
        self._open: set[Node] = set()

    def in_scope(self, node: Node) -> Array:
        """The 4×4 pose of a node in the frame of the model or world that it is in.

        Raises PoseError where it leads nowhere.
        """
        # Chains may be long: they are resolved from their far end, so that nothing recurs deeply.
        chain: dict[Node, None] = {}
        at: Node | None = node
        while at is not None and at not in self._known and at not in chain:
            chain[at] = None
            at = self._leads_to(at)
        for each in reversed(chain):
            self._settle(each)
        pose = self._known[node]
        if isinstance(pose, DescriptionError):
            raise pose
        return pose

    def named(self, scope: Scope, reference: str) -> Array:
        """The pose, in a scope's own frame, of what a reference names there."""
        return self._of(scope, scope.resolve(reference), reference)

    def reached(self, scope: Scope, node: Node) -> Array:
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

    def of_part(self, part: Element, holder: Node) -> Array:
        """The pose of a visual, collision, sensor, light or inertial in the frame of its link or joint."""
        if holder.is_urdf and part.name != "sensor":
            return origin_of(part)
        pose = part.find("pose")
        reference = reference_of(pose)
        if not reference:
            return written_pose(pose)
        base = self._of(holder.scope, holder.look_up(reference), reference)
        return inverse(self.in_scope(holder)) @ base @ written_pose(pose)

    def _settle(self, node: Node) -> None:
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

    def _leads_to(self, node: Node) -> Node | None:
        """The node that the pose of a node is relative to; None if that is its scope, or unknown."""
        base = urdf_base(node)[0] if is_in_urdf(node) else node.base
        return None if base is node.scope else base

    def _of(self, scope: Scope, node: Node | None, reference: str) -> Array:
        if node is None:
            raise PoseError(f"there is no frame {reference!r} in {scope.name}", scope.element)
        return self.reached(scope, node)

    def _resolve(self, node: Node) -> Array:
        if is_in_urdf(node):
            return self._resolve_urdf(node)
        base = np.eye(4)
        if node.scope_around is not None:
            base = self._of(node.scope, node.base, node.base_name)
        result = base @ written_pose(node.pose_element)
        inside = node.unmerged
        if inside.kind == "model" and (frame := cast("Model", inside).placement_frame):
            result = result @ inverse(self.named(cast("Model", inside), frame))
        return result

    def _resolve_urdf(self, node: Node) -> Array:
        """Of a link: where its first joint puts it, all joints at zero; a joint is where its child is."""
        base, joint = urdf_base(node)
        if base is None and node.kind == "joint":
            raise PoseError(f"joint {node.name} has no child", node.element)
        above = np.eye(4) if base is None or base is node.scope else self.in_scope(base)
        return above if joint is None else above @ origin_of(joint.element)


def is_in_urdf(node: Node) -> bool:
    """Is it a link or joint of a URDF robot?"""
    return node.is_urdf and node.kind in {"link", "joint"}


def urdf_base(node: Node) -> tuple[Node | None, Joint | None]:
    """The node that a URDF link or joint is placed at, and the joint whose origin leads from there to it."""
    if node.kind == "joint":
        return cast("Joint", node).child, None
    for joint in node.parent_joints:  # type: ignore[attr-defined]
        return joint.parent, joint
    return node.merged or node.scope, None


def _pose_of_part(part: Part, holder: Node, relative_to: str | None) -> Array:
    """The pose of a part in the frame of its holder, or relative to what a reference in it names."""
    poses = holder.root.poses
    pose = poses.of_part(part.element, holder) if part.is_given else np.eye(4)
    if relative_to is None:
        return pose
    scope = holder.scope
    base = np.eye(4) if relative_to == scope.own_name else poses.named(scope, relative_to)
    return inverse(base) @ poses.reached(scope, holder) @ pose
