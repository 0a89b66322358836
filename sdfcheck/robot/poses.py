"""Where frames are: every pose resolved, whatever it is written relative to.

Source: the specification's pose frame semantics (1.7, 1.8) and libsdformat 17, which
applies them to documents of every version.
"""

from __future__ import annotations

import math

import numpy as np

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.sdf.values import floats
from sdfcheck.formats.sdf.version import Version
from sdfcheck.robot.carriers import child_of, is_merged_model, look_up, own_model
from sdfcheck.robot.includes import included
from sdfcheck.robot.rotations import Array, from_quaternion, from_rpy, inverse, transform
from sdfcheck.robot.scopes import Frame, Scope, scopes
from sdfcheck.source.element import Element

_SEVEN = Version(1, 7)


class PoseError(ValueError):
    """A pose that cannot be worked out: an unknown frame, a ring, a value that is none."""


def written_pose(pose: Element | None) -> Array:
    """The 4×4 transform that a ``pose`` element writes; no element and an empty one are zero.

    Raises PoseError if its numbers cannot be read.
    """
    if pose is None or not pose.content:
        return np.eye(4)
    numbers = floats(pose.content)
    attributes = pose.attributes
    is_quaternion = attributes.get("rotation_format", "").strip() == "quat_xyzw"
    if numbers is None or len(numbers) != (7 if is_quaternion else 6) or not all(map(math.isfinite, numbers)):
        raise PoseError(f"{pose.content!r} is not a pose")
    if is_quaternion:
        rotation = from_quaternion(*numbers[3:])
    else:
        angles = numbers[3:]
        if attributes.get("degrees", "").strip().lower() in {"true", "1"}:
            angles = tuple(math.radians(angle) for angle in angles)
        rotation = from_rpy(*angles)
    return transform(rotation, numbers[:3])


class Poses:
    """The poses of one tree of scopes, worked out when asked for and kept."""

    def __init__(self) -> None:
        self._known: dict[Frame, Array | PoseError] = {}
        self._open: set[Frame] = set()

    def in_scope(self, frame: Frame) -> Array:
        """The 4×4 pose of a frame in its scope's own frame (``__model__`` or ``world``).

        Raises PoseError where it leads nowhere.
        """
        # Chains may be long: they are resolved from their far end, so that nothing recurs deeply.
        chain: dict[Frame, None] = {}
        at: Frame | None = frame
        while at is not None and at is not at.scope.own and at not in self._known and at not in chain:
            chain[at] = None
            at = self._leads_to(at)
        for each in reversed(chain):
            self._settle(each)
        if frame is frame.scope.own:
            return np.eye(4)
        pose = self._known[frame]
        if isinstance(pose, PoseError):
            raise pose
        return pose

    def named(self, scope: Scope, reference: str) -> Array:
        """The pose, in a scope's own frame, of what a reference names there."""
        return self._of(scope, scope.find(reference), reference)

    def reached(self, scope: Scope, frame: Frame) -> Array:
        """The pose, in a scope's own frame, of a frame in it or in a nested model of it."""
        pose = self.in_scope(frame)
        at = frame.scope
        while at is not scope:
            if at.parent is None:
                raise PoseError(f"{frame.name} is not below {scope.name}")
            pose = self.in_scope(model_around(at)) @ pose
            at = at.parent
        return pose

    def of_model(self, scope: Scope) -> Array:
        """The 4×4 pose of a model in what it stands in: the model or world around it, or none."""
        if scope.parent is not None:
            return self.in_scope(model_around(scope))
        pose = written_pose(scope.element.find("pose"))
        placement = scope.element.attributes.get("placement_frame", "").strip()
        return pose @ inverse(self.named(scope, placement)) if placement else pose

    def of_part(self, part: Element, holder: Frame) -> Array:
        """The pose of a visual, collision, sensor, light or inertial in the frame of its link or joint."""
        pose = part.find("pose")
        reference = reference_of(pose)
        if not reference:
            return written_pose(pose)
        base = self._of(holder.scope, look_up(holder, reference), reference)
        return inverse(self.in_scope(holder)) @ base @ written_pose(pose)

    def _settle(self, frame: Frame) -> None:
        if frame in self._known:
            return
        if frame in self._open:
            raise PoseError(f"the pose of {frame.name} depends on itself")
        self._open.add(frame)
        try:
            self._known[frame] = self._resolve(frame)
        except PoseError as error:
            self._known[frame] = error
        finally:
            self._open.discard(frame)

    def _leads_to(self, frame: Frame) -> Frame | None:
        """What the pose of a frame is relative to; None if that is unknown or needs no resolving."""
        if is_urdf(frame):
            return urdf_base(frame)[0]
        return look_up(frame, reference) if (reference := base_of(frame)) else own_model(frame)

    def _of(self, scope: Scope, frame: Frame | None, reference: str) -> Array:
        if frame is None:
            raise PoseError(f"there is no frame {reference!r} in {scope.name}")
        return self.reached(scope, frame)

    def _resolve(self, frame: Frame) -> Array:
        if is_urdf(frame):
            return self._resolve_urdf(frame)
        scope = frame.scope
        reference = base_of(frame)
        if reference:
            base = self._of(scope, look_up(frame, reference), reference)
        else:
            model = own_model(frame)
            base = np.eye(4) if model is None else self.in_scope(model)
        result = base @ written_pose(pose_element(frame))
        placement, inside = placement_of(frame)
        if placement and inside is not None:
            result = result @ inverse(self.named(inside, placement))
        return result

    def _resolve_urdf(self, frame: Frame) -> Array:
        """Of a link: where its first joint puts it, all joints at zero; a joint is where its child is."""
        from sdfcheck.robot.urdf_robot import origin_of

        base, joint = urdf_base(frame)
        if base is None and frame.kind == "joint":
            raise PoseError(f"joint {frame.name} has no child")
        above = np.eye(4) if base is None else self.in_scope(base)
        return above if joint is None else above @ origin_of(joint)


def model_around(scope: Scope) -> Frame:
    """The frame that a nested model makes in the scope around it."""
    assert scope.parent is not None
    found = scope.parent.frames.get(scope.name)
    if found is not None and found.inner is scope:
        return found
    raise PoseError(f"{scope.name} is not in {scope.parent.name}")


def pose_element(frame: Frame) -> Element | None:
    """The pose that counts: for what an include brings the include's, if it has one."""
    own = frame.element.find("pose")
    if own is not None or frame.element.tag != "include":
        return own
    brought = included(frame.element.document, frame.element).model
    return brought.find("pose") if brought is not None and brought.tag == "model" else None


def base_of(frame: Frame) -> str:
    """The name of what a frame's pose is relative to; empty where that is the model it is part of."""
    if reference := reference_of(pose_element(frame)):
        return reference
    if frame.kind == "joint":
        return child_of(frame)
    if frame.kind == "frame" and not is_merged_model(frame):
        return frame.element.attributes.get("attached_to", "").strip()
    return ""


def placement_of(frame: Frame) -> tuple[str, Scope | None]:
    """The frame by which a model is placed instead of its own, and the scope that has it."""
    element = frame.element
    if frame.kind != "model" and not is_merged_model(frame):
        return "", None
    brought: Element | None = element
    placement = ""
    if element.tag == "include":
        brought = included(element.document, element).model
        given = element.find("placement_frame")
        placement = given.content if given is not None else ""
    if not placement and brought is not None:
        placement = brought.attributes.get("placement_frame", "").strip()
    if not placement or frame.kind == "model":
        return placement, frame.inner
    document = element.document
    return placement, scopes(document).of_included(included(document, element), None)


def is_urdf(frame: Frame) -> bool:
    """Is it a link or joint of a URDF robot?"""
    parent = frame.element.parent
    return parent is not None and parent.tag == "robot"


def urdf_base(frame: Frame) -> tuple[Frame | None, Element | None]:
    """What a URDF link or joint is placed at, and the joint whose origin leads from there to it."""
    from sdfcheck.robot.urdf_tree import tree

    robot = tree(frame.element.document)
    frames = frame.scope.frames
    if frame.kind == "joint":
        child = robot.joint_named[frame.name].child
        return (frames.get(child.text) if child is not None else None), None
    for joint in robot.parents.get(frame.name, ()):
        assert joint.parent is not None
        return frames.get(joint.parent.text), joint.element
    return own_model(frame), None


def reference_of(pose: Element | None) -> str:
    """The frame that a pose is written relative to; empty for the default."""
    if pose is None:
        return ""
    attributes = pose.attributes
    if survey(pose.document).version < _SEVEN:
        return attributes.get("frame", attributes.get("relative_to", "")).strip()
    return attributes.get("relative_to", "").strip()
