"""Lights."""

from __future__ import annotations

from typing import TYPE_CHECKING

from sdfcheck.robot.part import Part
from sdfcheck.robot.values import Vector, number

if TYPE_CHECKING:
    from sdfcheck.robot.motion.pose import Pose


class Light(Part):
    """A light of a world or link, or one that is a whole file."""

    __slots__ = ()
    kind = "light"

    @property
    def type(self) -> str:
        """``point``, ``spot`` or ``directional``."""
        return (self._text("type") or "point").strip()

    @property
    def direction(self) -> Vector:
        """Where it shines to."""
        return self._vector("direction", (0.0, 0.0, -1.0))

    @property
    def diffuse(self) -> Vector:
        """Red, green, blue, alpha."""
        return self._vector("diffuse", (1.0, 1.0, 1.0, 1.0))

    @property
    def specular(self) -> Vector:
        """Red, green, blue, alpha."""
        return self._vector("specular", (0.1, 0.1, 0.1, 1.0))

    intensity = number("intensity", 1.0, "A factor.")

    def pose(self, relative_to: str | None = None) -> Pose:
        """Its pose in what it is in, or relative to what a reference names there; raises PoseError."""
        from sdfcheck.robot.motion.pose import of_part
        from sdfcheck.robot.node import Node

        return of_part(self, self.within(Node), relative_to)
