"""Boxes around shapes."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from sdfcheck.robot.motion.poses import of_part
from sdfcheck.robot.motion.rotations import Array

if TYPE_CHECKING:
    from sdfcheck.robot.parts.shape import Geometry, Shape


def of_shapes(shapes: Iterable[Shape]) -> Array | None:
    """The lowest and highest x, y, z (m) of shapes in their link's frame, shape (2, 3); None without any.

    Of shapes that are round the box around their own axes counts. Raises PoseError.
    """
    corners = [found for shape in shapes if (found := _corners(shape)) is not None]
    if not corners:
        return None
    points = np.concatenate(corners)
    return np.array([points.min(axis=0), points.max(axis=0)])


def _corners(shape: Shape) -> Array | None:
    """The eight corners of the box around one shape, in its link's frame."""
    half = _half_size(shape.geometry)
    if half is None:
        return None
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    pose = of_part(shape, shape.link, None)
    return np.asarray(signs * half @ pose[:3, :3].T + pose[:3, 3])


def _half_size(geometry: Geometry) -> tuple[float, ...] | None:
    """Half the size along each axis of the shape; None for meshes, planes and what cannot be read."""
    radius, half = float(geometry.radius), float(geometry.length) / 2
    if geometry.solid is None:
        return None
    return {
        "box": tuple(size / 2 for size in geometry.size),
        "sphere": (radius, radius, radius),
        "ellipsoid": tuple(geometry.radii),
        "cylinder": (radius, radius, half),
        "cone": (radius, radius, half),
        "capsule": (radius, radius, half + radius),
    }.get(geometry.shape)
