"""Poses and directions as URDF writes them."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.writer import Node, numbers
from sdfcheck.model.rotations import Array, to_rpy

_SHORT = 12
"""A number that reads the same to 15 digits with so few characters was meant to be written so."""


def shortened(values: Array | tuple[float, ...]) -> str:
    """Numbers without the rounding in their last digits, separated by blanks."""
    return numbers(_shorter(float(value)) for value in values)


def _shorter(value: float) -> float:
    short = f"{value:.14g}"
    return float(short) if len(short) <= _SHORT else value


def add_origin(node: Node, pose: Array) -> None:
    """Write a pose; that of the parent itself is not written."""
    position, angles = shortened(pose[:3, 3]), shortened(to_rpy(pose[:3, :3]))
    attributes = {}
    if position != "0 0 0":
        attributes["xyz"] = position
    if angles != "0 0 0":
        attributes["rpy"] = angles
    if attributes:
        node.add("origin", **attributes)


def pose_text(pose: Array) -> str:
    """A pose as SDF writes it."""
    return f"{shortened(pose[:3, 3])} {shortened(to_rpy(pose[:3, :3]))}"


def is_identity(pose: Array) -> bool:
    return bool(np.abs(pose - np.eye(4)).max() < 1e-12)
