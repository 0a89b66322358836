"""The choices of a user about the URDF that an SDF model becomes."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Unsupported(Enum):
    """The treatment of a joint or forest that URDF cannot express."""

    FLOATING = "floating"
    FIXED = "fixed"
    ERROR = "error"


class Loops(Enum):
    """The treatment of joints that close loops."""

    ERROR = "error"
    CUT = "cut"


class Planes(Enum):
    """The treatment of planes."""

    DROP = "drop"
    BOX = "box"


@dataclass(frozen=True, slots=True)
class Options:
    """Choices; the defaults lose the least."""

    model: str = ""
    """The model to convert, where the file has several."""
    keep_link_frames: bool = False
    """Links keep their frames; a link that is not at its joint gets a massless one in front."""
    frames: bool = False
    """Frames become massless links."""
    ball: Unsupported = Unsupported.FLOATING
    """The replacement of a ball joint."""
    forest: Unsupported = Unsupported.FLOATING
    """How free links are tied to the one root that URDF demands."""
    loops: Loops = Loops.ERROR
    """Whether a joint that closes a loop may be left to libsdformat."""
    planes: Planes = Planes.DROP
    """Whether a flat box may replace a plane."""
    unlimited: float = 1e16
    """The number that is written for an infinite limit."""
    package_uris: bool = False
    """Uris ``model://x`` are written ``package://x``, which consumers of URDF resolve."""
