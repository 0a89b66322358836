"""Poses and directions as URDF writes them."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.writer import numbers
from sdfcheck.robot.motion.poses import written_pose
from sdfcheck.robot.motion.rotations import Array, to_rpy
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Element

_ROUNDING = 1e-14
_SHORT = 12
"""A number that reads the same to 15 digits with so few characters was meant to be written so."""


def shortened(values: Array | tuple[float, ...]) -> str:
    """Numbers without the rounding in their last digits, separated by spaces."""
    return numbers(_shorter(float(value)) for value in values)


def _shorter(value: float) -> float:
    short = f"{value:.14g}"
    return float(short) if len(short) <= _SHORT else value


def add_origin(node: Xml, pose: Array, *authors: Element | None) -> None:
    """Write a pose, in the words of an author who wrote the same; that of the parent itself is not written."""
    found = (texts for element in authors if (texts := _in_words(element, pose)) is not None)
    position, angles = next(found, None) or (shortened(pose[:3, 3]), shortened(to_rpy(pose[:3, :3])))
    attributes = {}
    if position != "0 0 0":
        attributes["xyz"] = position
    if angles != "0 0 0":
        attributes["rpy"] = angles
    if attributes:
        node.add("origin", **attributes)


def _in_words(element: Element | None, pose: Array) -> tuple[str, str] | None:
    """Position and angles as a ``pose`` element has them, if it is this pose in plain numbers."""
    if element is None or element.attributes.get("rotation_format") or element.attributes.get("degrees"):
        return None
    words = ["0" if float(word) == 0 else word for word in element.content.split()]
    if len(words) != 6 or np.abs(written_pose(element) - pose).max() > _ROUNDING:
        return None
    return " ".join(words[:3]), " ".join(words[3:])


def pose_text(pose: Array) -> str:
    """A pose as SDF writes it."""
    return f"{shortened(pose[:3, 3])} {shortened(to_rpy(pose[:3, :3]))}"


def is_identity(pose: Array) -> bool:
    return bool(np.abs(pose - np.eye(4)).max() < 1e-12)
