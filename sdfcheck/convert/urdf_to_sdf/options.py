"""The choices of a caller."""

from __future__ import annotations

from enum import Enum

from sdfcheck.consumers.reaction import Consumer
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.source.record import Record


class FixedJoints(Enum):
    """The treatment of fixed joints: they stay, or their links become one."""

    KEEP = "keep"
    MERGE = "merge"


class Massless(Enum):
    """The treatment of a link without mass, which SDFormat does not have.

    MERGE: it becomes part of what it is fixed to, else SMALL. SMALL: it gets a negligible
    mass. AUTO: its collisions' inertia is left to the simulator (1.11), else SMALL.
    REFUSE: nothing is converted.
    """

    MERGE = "merge"
    SMALL = "small"
    AUTO = "auto"
    REFUSE = "refuse"


class PackageUris(Enum):
    """How ``package://`` is written: as it is, or the way Gazebo looks for models."""

    KEEP = "keep"
    MODEL = "model"


class Options(Record):
    version: Version = NEWEST
    fixed_joints: FixedJoints = FixedJoints.KEEP
    massless: Massless = Massless.MERGE
    package_uris: PackageUris = PackageUris.MODEL
    like: Consumer | None = None
    """The consumer that decides what is merged, what is dropped and what shapes are called; else the above do."""

    @property
    def has_frames(self) -> bool:
        """Whether poses can be relative to others, and frames be named (1.7)."""
        return self.version >= Version(1, 7)

    @property
    def has_mimic(self) -> bool:
        return self.version >= Version(1, 11)

    @property
    def has_axes_of_models(self) -> bool:
        """Whether an axis is written in the frame of the model (up to 1.4)."""
        return self.version < Version(1, 5)
