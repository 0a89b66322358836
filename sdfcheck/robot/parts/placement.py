"""Placements: ``pose`` in SDFormat, ``origin`` in URDF."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.formats.sdf.version import Version
from sdfcheck.robot.part import Part
from sdfcheck.robot.values import Vector

if TYPE_CHECKING:
    from sdfcheck.source.element import Element, Value

_SEVEN = Version(1, 7)


class Placement(Part):
    """A ``pose`` of SDFormat or an ``origin`` of URDF, as it is written."""

    __slots__ = ()
    kind = "pose"

    @property
    def numbers(self) -> Vector:
        """Of a pose: position (m) and rotation, in one row; empty where it cannot be read."""
        return Vector.of(None if self.is_urdf else self.element.own_value, self.element, (0.0,) * 6)

    @property
    def xyz(self) -> Vector:
        """The position (m)."""
        if self.is_urdf:
            return Vector.of(self.attribute("xyz"), self.element, (0.0, 0.0, 0.0))
        return self._part(slice(0, 3))

    @property
    def rotation(self) -> Vector:
        """Roll, pitch, yaw (rad or degrees), or the quaternion x, y, z, w."""
        if not self.is_urdf:
            return self._part(slice(3, None))
        quaternion = self.attribute("quat_xyzw")
        return Vector.of(quaternion or self.attribute("rpy"), self.element, (0.0, 0.0, 0.0))

    @property
    def is_quaternion(self) -> bool:
        if self.is_urdf:
            return self.attribute("quat_xyzw") is not None
        return (self._text("rotation_format") or "").strip() == "quat_xyzw"

    @property
    def reference(self) -> str:
        """The frame that it is relative to, as written; empty for the default."""
        return "" if self.is_urdf else reference_of(self.element)

    def _part(self, part: slice) -> Vector:
        numbers = self.numbers
        found = Vector(tuple(numbers)[part])
        found.value, found.element = numbers.value, numbers.element
        return found


def reference_of(pose: Element | None) -> str:
    """The frame that a pose is written relative to; empty for the default."""
    value = reference_value(pose)
    return "" if value is None else value.text.strip()


def reference_value(pose: Element | None) -> Value | None:
    """The reference of a pose with its place: until 1.6 it was called ``frame``."""
    if pose is None or pose.name != "pose":
        return None
    old = pose.attribute("frame")
    if old is not None:
        from sdfcheck.formats.sdf.survey import survey

        if survey(pose.document).version < _SEVEN:
            return old
    return pose.attribute("relative_to")
