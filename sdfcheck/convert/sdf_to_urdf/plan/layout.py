"""Where the links of the URDF are: each at the joint that carries it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from sdfcheck.convert.sdf_to_urdf.plan.arrange import WORLD, Arrangement
from sdfcheck.convert.sdf_to_urdf.plan.naming import Naming
from sdfcheck.robot.motion.mechanism import Mechanism
from sdfcheck.robot.motion.rotations import Array, angle_between, inverse

SAME = 1e-12
"""Frames that are nearer than this (m, rad) are one."""


@dataclass(frozen=True, slots=True)
class Layout:
    """The frames of the URDF's links, as 4×4 poses in the model's frame, by the names of the source.

    ``joint_links`` are massless links before links which keep their frame, with
    the frames of those: the joint carries them.
    """

    frames: Mapping[str, Array]
    joint_links: Mapping[str, tuple[str, Array]]

    def within(self, link: str, pose: Array) -> Array:
        """A pose of the model's frame in the frame of a link."""
        return tidy(inverse(self.frames[link]) @ pose)


def lay_out(robot: Mechanism, made: Arrangement, world: Array, *, keep: bool, naming: Naming) -> Layout:
    """Frames for all links; ``world`` is the pose of the world in the model's frame."""
    frames: dict[str, Array] = {WORLD: world}
    joint_links: dict[str, tuple[str, Array]] = {}
    carriers = made.carriers
    for name, link in robot.links.items():
        edge = carriers.get(name)
        if edge is None or is_same(edge.joint.pose, link.pose):
            frames[name] = link.pose
        elif keep:
            frames[name] = link.pose
            joint_links[name] = (naming.unique(f"{name}__joint"), edge.joint.pose)
        else:
            frames[name] = edge.joint.pose
    return Layout(frames, joint_links)


def is_same(a: Array, b: Array) -> bool:
    near = float(np.linalg.norm(a[:3, 3] - b[:3, 3])) < SAME
    return near and angle_between(a[:3, :3], b[:3, :3]) < SAME


def tidy(pose: Array) -> Array:
    """The pose without the dust of rounding around zero and one."""
    result: Array = pose.copy()
    result[np.abs(result) < 1e-15] = 0.0
    turn = result[:3, :3]
    turn[np.abs(turn - 1) < 1e-15] = 1.0
    turn[np.abs(turn + 1) < 1e-15] = -1.0
    return result
