"""Where frames are: every pose resolved, whatever it is written relative to.

Source: the specification's pose frame semantics (1.7, 1.8) and libsdformat 17, which
applies them to documents of every version.
"""

from __future__ import annotations

import math

import numpy as np

from sdfcheck.formats.survey import survey
from sdfcheck.formats.values import floats
from sdfcheck.formats.version import Version
from sdfcheck.model.rotations import Array, from_quaternion, from_rpy, inverse, transform
from sdfcheck.model.scopes import Frame, Scope
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
    if numbers is None or len(numbers) != (7 if is_quaternion else 6):
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
        self._known: dict[Frame, Array] = {}
        self._open: set[Frame] = set()

    def in_scope(self, frame: Frame) -> Array:
        """The 4×4 pose of a frame in its scope's own frame (``__model__`` or ``world``).

        Raises PoseError where it leads nowhere.
        """
        if frame is frame.scope.own:
            return np.eye(4)
        if frame not in self._known:
            if frame in self._open:
                raise PoseError(f"the pose of {frame.name} depends on itself")
            self._open.add(frame)
            try:
                self._known[frame] = self._resolve(frame)
            finally:
                self._open.discard(frame)
        return self._known[frame]

    def named(self, scope: Scope, reference: str) -> Array:
        """The pose, in a scope's own frame, of what a reference names there."""
        found = scope.find(reference)
        if found is None:
            raise PoseError(f"there is no frame {reference!r} in {scope.name}")
        return self.reached(scope, found)

    def reached(self, scope: Scope, frame: Frame) -> Array:
        """The pose, in a scope's own frame, of a frame in it or in a nested model of it."""
        pose = self.in_scope(frame)
        at = frame.scope
        while at is not scope:
            if at.parent is None:
                raise PoseError(f"{frame.name} is not below {scope.name}")
            model = next(f for f in at.parent.frames.values() if f.inner is at)
            pose = self.in_scope(model) @ pose
            at = at.parent
        return pose

    def of_part(self, part: Element, holder: Frame) -> Array:
        """The pose of a visual, collision, sensor, light or inertial in the frame of its link or joint."""
        pose = part.find("pose")
        reference = reference_of(pose)
        if not reference:
            return written_pose(pose)
        base = self.named(holder.scope, reference)
        return inverse(self.in_scope(holder)) @ base @ written_pose(pose)

    def _resolve(self, frame: Frame) -> Array:
        scope = frame.scope
        pose = self._pose_element(frame)
        reference = reference_of(pose)
        base = self.named(scope, reference) if reference else self._default_base(frame)
        result = base @ written_pose(pose)
        if frame.inner is not None and (placement := self._placement(frame)):
            result = result @ inverse(self.named(frame.inner, placement))
        return result

    def _pose_element(self, frame: Frame) -> Element | None:
        """The pose that counts: for an included model the include's, if it has one."""
        own = frame.element.find("pose")
        if own is None and frame.inner is not None and frame.inner.placed is not None:
            return frame.inner.element.find("pose")
        return own

    def _placement(self, frame: Frame) -> str:
        assert frame.inner is not None
        placed = frame.inner.placed
        if placed is not None and (child := placed.find("placement_frame")) is not None:
            return child.content
        return frame.inner.element.attributes.get("placement_frame", "").strip()

    def _default_base(self, frame: Frame) -> Array:
        if frame.kind == "joint" and (child := frame.element.find("child")) is not None:
            return self.named(frame.scope, child.content)
        if frame.kind == "frame" and (reference := frame.element.attributes.get("attached_to", "").strip()):
            return self.named(frame.scope, reference)
        return np.eye(4)


def reference_of(pose: Element | None) -> str:
    """The frame that a pose is written relative to; empty for the default."""
    if pose is None:
        return ""
    attributes = pose.attributes
    if survey(pose.document).version < _SEVEN:
        return attributes.get("frame", attributes.get("relative_to", "")).strip()
    return attributes.get("relative_to", "").strip()
