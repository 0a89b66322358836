"""Numbers, transforms and places as the page reads them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from sdfcheck.robot.motion.rotations import Array
from sdfcheck.source.document import Element

Json = dict[str, Any]


def place(element: Element) -> str:
    """``file:line`` of an element."""
    return f"{element.span.source.path.name}:{element.span.begin.line}"


def flat(transform: Array) -> list[float]:
    """A 4×4 transform column by column; what is not a number is 0, so that the page can draw it."""
    return [finite(number) for number in np.asarray(transform).T.ravel().tolist()]


def finite(number: float, default: float = 0.0) -> float:
    """The number; ``default`` for nan, infinity, and what is too large to be drawn."""
    return float(number) if math.isfinite(number) and abs(number) < 1e15 else default


def bound(number: float) -> float | None:
    """A limit; None for none."""
    return float(number) if math.isfinite(number) and abs(number) < 1e15 else None
