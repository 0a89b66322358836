"""Mass, center of mass and inertia of a body."""

from __future__ import annotations

import numpy as np

from sdfcheck.robot.motion.rotations import Array
from sdfcheck.source.record import NamedTuple


class MassProperties(NamedTuple):
    """Mass (kg), center of mass (m) and inertia tensor (kg·m²) about it, in the axes of one frame."""

    mass: float
    center: Array
    """Shape (3,)."""
    moments: Array
    """About the center of mass, shape (3, 3)."""

    def seen_from(self, frame: Array) -> MassProperties:
        """The same body in an outer frame, in which this one's frame has the 4×4 pose ``frame``."""
        turn = frame[:3, :3]
        return MassProperties(self.mass, turn @ self.center + frame[:3, 3], turn @ self.moments @ turn.T)

    def joined_with(self, other: MassProperties) -> MassProperties:
        """Two bodies of one frame, rigidly joined."""
        mass = self.mass + other.mass
        if mass == 0:
            return MassProperties(0.0, self.center, self.moments + other.moments)
        center = (self.mass * self.center + other.mass * other.center) / mass
        moments = np.zeros((3, 3))
        for body in (self, other):
            offset = body.center - center
            shift = float(offset @ offset) * np.eye(3) - np.outer(offset, offset)
            moments += body.moments + body.mass * shift
        return MassProperties(mass, center, moments)


SMALL = MassProperties(1e-3, np.zeros(3), np.eye(3) * 1e-6)
"""A body too small to have an effect, for links that move and have no mass, which consumers refuse or drop."""
