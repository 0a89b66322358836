"""One robot seen through the frames of another.

A converter may move the frame of a link within the link, or that of a model within the
model, and everything in it stays where it is. Compared number by number nothing would be
equal; compared through the other's frames, only the frame has moved.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np

from sdfcheck.convert.rewrite.renaming import Names, Shapes, carriers, same_pose, seat
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.robot.motion.mechanism import Geometry, Joint, Link, Mechanism
from sdfcheck.robot.motion.rotations import Array, inverse


def reframed(
    a: Mechanism, b: Mechanism, names: Names, tolerance: float
) -> tuple[Mechanism, Mapping[str, Array]]:
    """``b`` with the link frames of ``a``, where a link differs in less if only its frame has moved.

    Also the 4×4 poses of the frames that have moved in those that they had, by the names of ``a``.
    """
    search = _Search(a, b, names, tolerance)
    for name in _parents_first(a):
        if name in names.links:
            search.settle(name)
    moved = {name: shift for name, shift in search.shifts.items() if not same_pose(shift, np.eye(4), 1e-12)}
    back = {names.links[name]: shift for name, shift in moved.items()}
    links = {name: _shifted(link, back[name]) if name in back else link for name, link in b.links.items()}
    frames = {
        name: (link, back[link] @ pose if link in back else pose) for name, (link, pose) in b.frames.items()
    }
    return Mechanism(b.name, links, b.joints, frames), moved


def shifted_model(robot: Mechanism, shift: Array) -> Mechanism:
    """The robot in a frame in which its own model frame has the 4×4 pose ``shift``."""
    links = {name: replace(link, pose=shift @ link.pose) for name, link in robot.links.items()}
    joints = {name: replace(joint, pose=shift @ joint.pose) for name, joint in robot.joints.items()}
    return Mechanism(robot.name, links, joints, robot.frames)


class _Search:
    """Finds for each link the pose of its frame in ``b`` in the one that it has in ``a``."""

    def __init__(self, a: Mechanism, b: Mechanism, names: Names, tolerance: float) -> None:
        self.a = a
        self.b = b
        self.names = names
        self.tolerance = tolerance
        self.shifts: dict[str, Array] = {}
        self.carriers = tuple({joint.child: joint for joint in robot.tree()} for robot in (a, b))
        self.carried_by = carriers(a), carriers(b)
        self.pairs: dict[str, list[tuple[Joint, Joint]]] = {}
        for one, other in names.joints.items():
            mine, theirs = a.joints[one], b.joints[other]
            for end in {mine.parent, mine.child}:
                self.pairs.setdefault(end, []).append((mine, theirs))

    def settle(self, name: str) -> None:
        best = np.eye(4)
        fewest = self.mismatches(name, best)
        for shift in self.candidates(name) if fewest else ():
            count = self.mismatches(name, shift)
            if count < fewest:
                best, fewest = shift, count
        self.shifts[name] = best

    def candidates(self, name: str) -> Iterator[Array]:
        """Where the frame would be if a joint had stayed in place in the link."""
        link, other = self.a.links[name], self.b.links[self.names.links[name]]
        mine, theirs = self.carriers[0].get(name), self.carriers[1].get(other.name)
        if mine is not None and theirs is not None:
            yield inverse(link.pose) @ mine.pose @ inverse(theirs.pose) @ other.pose
        for mine, theirs in self.pairs.get(name, ()):
            if other.name in {theirs.parent, theirs.child}:
                yield inverse(link.pose) @ mine.pose @ inverse(theirs.pose) @ other.pose

    def mismatches(self, name: str, shift: Array) -> int:
        """In how much the link differs if its frame has moved so."""
        link, other = self.a.links[name], self.b.links[self.names.links[name]]
        theirs = _shifted(other, shift)
        count = int(not _same_body(link.body, theirs.body, self.tolerance))
        count += _unmatched(link.geometries, theirs.geometries, self.tolerance)
        parent, here = seat(self.a, name, self.carried_by[0])
        other_parent = self.carried_by[1].get(other.name, "")
        if parent and self.names.links.get(parent) == other_parent and parent in self.shifts:
            above = self.b.links[other_parent].pose @ inverse(self.shifts[parent])
            count += not same_pose(here, inverse(above) @ theirs.pose, self.tolerance)
        for mine, its in self.pairs.get(name, ()):
            if mine.child == name and its.child == other.name:
                there = inverse(theirs.pose) @ its.pose
                count += not same_pose(inverse(link.pose) @ mine.pose, there, self.tolerance)
        return count


def _parents_first(robot: Mechanism) -> list[str]:
    carried = [joint.child for joint in robot.tree()]
    return [*(name for name in robot.links if name not in set(carried)), *carried]


def _shifted(link: Link, shift: Array) -> Link:
    """The link with its frame moved, so that its old one has this pose in the new one."""
    body = None if link.body is None else link.body.seen_from(shift)
    shapes = [replace(shape, pose=shift @ shape.pose) for shape in link.geometries]
    return replace(link, pose=link.pose @ inverse(shift), body=body, geometries=shapes)


def _same_body(a: MassProperties | None, b: MassProperties | None, tolerance: float) -> bool:
    if a is None or b is None:
        return a is b
    size = max(float(np.abs(a.moments).max()), 1e-12)
    return bool(
        np.allclose(a.center, b.center, rtol=0, atol=tolerance)
        and np.allclose(a.moments, b.moments, rtol=0, atol=tolerance * size)
    )


def _unmatched(mine: list[Geometry], theirs: list[Geometry], tolerance: float) -> int:
    left = Shapes(theirs, tolerance)
    return sum(left.take(shape) is None for shape in mine)
