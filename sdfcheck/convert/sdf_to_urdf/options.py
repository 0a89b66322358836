"""What a user can choose about the URDF that an SDF model becomes."""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum


class Unsupported(Enum):
    """What to do with a joint or forest that URDF cannot express."""

    FLOATING = "floating"
    FIXED = "fixed"
    ERROR = "error"


class Loops(Enum):
    """What to do with joints that close loops."""

    ERROR = "error"
    CUT = "cut"


class Planes(Enum):
    """What to do with planes."""

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
    """What a ball joint becomes."""
    forest: Unsupported = Unsupported.FLOATING
    """How free links are tied to the one root that URDF demands."""
    loops: Loops = Loops.ERROR
    """Whether a joint that closes a loop may be left to libsdformat."""
    planes: Planes = Planes.DROP
    """Whether a flat box may stand for a plane."""
    unlimited: float = 1e16
    """What is written for a limit that is infinite."""
    package_uris: bool = False
    """Uris ``model://x`` are written ``package://x``, which consumers of URDF resolve."""
