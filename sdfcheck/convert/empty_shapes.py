"""Shapes without extent, which no consumer of SDFormat takes as they are: 1 m goes in the place of each size."""

from __future__ import annotations

from dataclasses import replace

from sdfcheck.robot.motion.mechanism import Geometry, Mechanism

_SIZED = frozenset({"box", "capsule", "cylinder", "ellipsoid", "sphere"})


def is_empty(geometry: Geometry) -> bool:
    """Is a size of it 0, or less?"""
    return geometry.kind in _SIZED and not all(size > 0 for size in geometry.size)


def without_empty_shapes(robot: Mechanism) -> Mechanism:
    """The robot without such shapes; the same object if it has none."""
    if not any(is_empty(shape) for link in robot.links.values() for shape in link.geometries):
        return robot
    links = {
        name: replace(link, geometries=type(link.geometries)(g for g in link.geometries if not is_empty(g)))
        for name, link in robot.links.items()
    }
    return replace(robot, links=links)
