"""Which link, joint and shape of one robot is which of another, and one robot seen through the frames of the other."""

from __future__ import annotations

import math
from bisect import bisect_left
from collections import Counter
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import cycle, islice
from operator import mul
from typing import Generic, TypeVar

import numpy as np

from sdfcheck.robot.motion.mass import MassProperties, default_mass
from sdfcheck.robot.motion.mechanism import Geometry, Joint, Link, Mechanism
from sdfcheck.robot.motion.poses import Array, inverse
from sdfcheck.source.sniff import Kind

# Things with numbers, such as poses and sizes, found by numbers that are nearly the same.


T = TypeVar("T")

_WEIGHTS = tuple(1 + math.sin(number) / 2 for number in range(1, 17))
"""Irregular, so that different numbers seldom have the same sum."""


class Nearby(Generic[T]):
    """Things in the order of a sum of their numbers, in which those that are nearly the same are side by side."""

    def __init__(self, things: Iterable[tuple[Sequence[float], T]]) -> None:
        pairs = sorted(((_sum(numbers), thing) for numbers, thing in things), key=lambda pair: pair[0])
        self._sums = [each for each, _ in pairs]
        self._things = [thing for _, thing in pairs]

    def copy(self) -> Nearby[T]:
        made: Nearby[T] = Nearby(())
        made._sums, made._things = self._sums.copy(), self._things.copy()
        return made

    def near(self, numbers: Sequence[float], tolerance: float) -> Iterator[T]:
        """All whose numbers are within ``tolerance``, or a part of 1e-9, of these, one by one; and seldom others."""
        wanted = _sum(numbers)
        margin = sum(tolerance + 1e-8 * abs(number) for number in _finite(numbers)) * max(_WEIGHTS)
        at = bisect_left(self._sums, wanted - margin)
        while at < len(self._sums) and self._sums[at] <= wanted + margin:
            yield self._things[at]
            at += 1

    def __iter__(self) -> Iterator[T]:
        return iter(self._things)

    def remove(self, numbers: Sequence[float], thing: T) -> None:
        """Take out a thing with its numbers, which must be there."""
        at = bisect_left(self._sums, _sum(numbers))
        while self._things[at] is not thing:
            at += 1
        del self._things[at], self._sums[at]


def _sum(numbers: Sequence[float]) -> float:
    return float(sum(map(mul, _finite(numbers), cycle(_WEIGHTS))))


def _finite(numbers: Iterable[float]) -> list[float]:
    return [number if math.isfinite(number) else 0.0 for number in numbers]


# Which link and joint of one robot is which of another: by name, or by being alike.


@dataclass(frozen=True, slots=True)
class Names:
    """Names in the first robot → names in the second, of all links and joints that are in both."""

    links: dict[str, str]
    joints: dict[str, str]

    @classmethod
    def between(cls, a: Mechanism, b: Mechanism, tolerance: float) -> Names:
        """Pair what has one name; of the rest, pair what is alike if nothing else is."""
        links = same_names(a.links, b.links)

        _pair_links(a, b, links, tolerance)
        joints = same_names(a.joints, b.joints)
        there: dict[tuple[str, str], list[str]] = {}
        for other, joint in b.joints.items():
            there.setdefault(_ends(joint, {}), []).append(other)
        taken = set(joints.values())
        joints.update(
            _unique_pairs(
                [name for name in a.joints if name not in joints],
                lambda name: (x for x in there.get(_ends(a.joints[name], links), ()) if x not in taken),
            )
        )
        return cls(
            {name: links[name] for name in a.links if name in links},
            {name: joints[name] for name in a.joints if name in joints},
        )


def same_names(a: Iterable[str], b: Container[str]) -> dict[str, str]:
    """The parts of one name, or of the name that they get where scopes are flattened."""
    same = {name: name for name in a if name in b}
    taken = set(same)
    for name in a:
        flat = name.replace("::", "__")
        if name not in same and flat in b and flat not in taken:
            same[name] = flat
            taken.add(flat)
    return same


def carriers(robot: Mechanism) -> dict[str, str]:
    """Link → the link that carries it, by the first joint that says so."""
    found: dict[str, str] = {}
    for joint in robot.joints.values():
        if joint.parent != joint.child and joint.parent in robot.links:
            found.setdefault(joint.child, joint.parent)
    return found


def pose_in_parent(robot: Mechanism, name: str, carried_by: Mapping[str, str]) -> tuple[str, Array]:
    """The link that carries a link, empty for none, and the 4×4 pose in it or in the model."""
    pose, parent = robot.links[name].pose, carried_by.get(name, "")
    return parent, inverse(robot.links[parent].pose) @ pose if parent else pose


def meant_body(link: Link, other: Link) -> MassProperties | None:
    """The mass properties of a link; what an SDF model leaves out is 1 kg, where the other link has any."""
    silent = link.body is None and other.body is not None and link.element.document.kind is Kind.SDF
    return default_mass() if silent else link.body


def filled(robot: Mechanism, other: Mechanism, names: Mapping[str, str]) -> Mechanism:
    """The robot with the mass properties that are meant, where those of the other robot are written."""
    links = {
        name: replace(link, body=meant_body(link, other.links[names[name]])) if name in names else link
        for name, link in robot.links.items()
    }
    return replace(robot, links=links)


def same_pose(a: Array, b: Array, tolerance: float) -> bool:
    scale = max(1.0, float(np.abs(a[:3, 3]).max()))
    return bool(np.allclose(a, b, rtol=0, atol=tolerance * scale))


def same_geometry(a: Geometry, b: Geometry, tolerance: float) -> bool:
    """Are they one shape at one place? Names and files do not matter."""
    is_alike = (a.role, a.kind) == (b.role, b.kind) and a.is_as_large_as(b, tolerance)
    return is_alike and same_pose(a.pose, b.pose, tolerance)


class Shapes:
    """Shapes of a link, in which one that is like another is found without a look at all.

    ``key``: what else must be equal for two to be alike, such as names.
    """

    def __init__(
        self, shapes: Iterable[Geometry], tolerance: float, key: Callable[[Geometry], object] = lambda _: None
    ) -> None:
        self._tolerance, self._key = tolerance, key
        kinds: dict[object, list[tuple[list[float], Geometry]]] = {}
        for shape in shapes:
            kinds.setdefault(self._kind(shape), []).append((_numbers(shape), shape))
        self._kinds = {kind: Nearby(pairs) for kind, pairs in kinds.items()}

    def copy(self) -> Shapes:
        made = Shapes((), self._tolerance, self._key)
        made._kinds = {kind: shapes.copy() for kind, shapes in self._kinds.items()}
        return made

    def like(self, wanted: Geometry) -> Iterator[Geometry]:
        """Those that are like a shape."""
        margin = self._tolerance * max(1.0, float(np.abs(wanted.pose[:3, 3]).max()))
        near = self._kinds.get(self._kind(wanted), _NO_SHAPES).near(_numbers(wanted), 2 * margin)
        return (shape for shape in near if same_geometry(shape, wanted, self._tolerance))

    def take(self, wanted: Geometry) -> Geometry | None:
        """Take out one that is like a shape; None if there is none."""
        found = next(self.like(wanted), None)
        if found is not None:
            self.remove(found)
        return found

    def remove(self, shape: Geometry) -> None:
        self._kinds[self._kind(shape)].remove(_numbers(shape), shape)

    def left(self) -> set[int]:
        """The identities of those that were not taken."""
        return {id(shape) for kind in self._kinds.values() for shape in kind}

    def _kind(self, shape: Geometry) -> object:
        return shape.role, shape.kind, len(shape.size), self._key(shape)


_NO_SHAPES: Nearby[Geometry] = Nearby(())


def _numbers(shape: Geometry) -> list[float]:
    return [*shape.size, *shape.pose[:3].ravel().tolist()]


def _pair_links(a: Mechanism, b: Mechanism, links: dict[str, str], tolerance: float) -> None:
    """Add the links that have another name and are alike, from parents to children, to those that are known."""
    seats = [
        {name: pose_in_parent(robot, name, up) for name in robot.links}
        for robot in (a, b)
        for up in [carriers(robot)]
    ]
    taken = set(links.values())
    below: tuple[dict[str, list[str]], ...] = ({}, {})
    for number, known in enumerate((links, taken)):
        for name, (parent, _) in seats[number].items():
            if name not in known:
                below[number].setdefault(parent, []).append(name)

    def alike(name: str, other: str) -> bool:
        if not same_pose(seats[0][name][1], seats[1][other][1], tolerance):
            return False
        return _same_link(a.links[name], b.links[other], tolerance)

    # A renamed link is known by its parent, which may have been renamed as well.
    waiting = [("", ""), *links.items()]
    while waiting:
        mine, theirs = waiting.pop()
        gone = [name for name in below[0].get(mine, ()) if name not in links]
        new = [name for name in below[1].get(theirs, ()) if name not in taken] if gone else []
        places = Nearby((seats[1][other][1][:3].ravel().tolist(), other) for other in new)

        def candidates(name: str, places: Nearby[str] = places) -> Iterator[str]:
            pose = seats[0][name][1]
            margin = tolerance * max(1.0, float(np.abs(pose[:3, 3]).max()))
            return (x for x in places.near(pose[:3].ravel().tolist(), 2 * margin) if alike(name, x))

        if found := _unique_pairs(gone, candidates):
            links.update(found)
            taken.update(found.values())
            waiting += [(mine, theirs), *found.items()]


def _unique_pairs(gone: list[str], candidates: Callable[[str], Iterable[str]]) -> dict[str, str]:
    """Those that have one candidate, which is nobody else's; more than a few candidates are not counted."""
    few = {name: list(islice(candidates(name), 3)) for name in gone}
    chosen = Counter(other for others in few.values() for other in others)
    return {name: others[0] for name, others in few.items() if len(others) == 1 and chosen[others[0]] == 1}


def _same_link(link: Link, other: Link, tolerance: float) -> bool:
    if len(link.geometries) != len(other.geometries) or not _same_body(
        meant_body(link, other), meant_body(other, link)
    ):
        return False
    pairs = zip(link.geometries, other.geometries, strict=True)
    return all(same_geometry(mine, theirs, tolerance) for mine, theirs in pairs)


def _same_body(a: MassProperties | None, b: MassProperties | None) -> bool:
    if a is None or b is None:
        return a is b
    same_mass = bool(np.isclose(a.mass, b.mass, rtol=1e-9, atol=0))
    return same_mass and np.allclose(a.center, b.center) and np.allclose(a.moments, b.moments, rtol=1e-6)


def _ends(joint: Joint, links: dict[str, str]) -> tuple[str, str]:
    return links.get(joint.parent, joint.parent), links.get(joint.child, joint.child)


# One robot seen through the frames of another.
#
# A converter may move the frame of a link within the link, or that of a model within the
# model, and everything in it stays where it is. Compared number by number nothing would be
# equal; compared through the other's frames, only the frame has moved.


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
        count = int(not _same_pose_body(link.body, theirs.body, self.tolerance))
        count += _unmatched(link.geometries, theirs.geometries, self.tolerance)
        parent, here = pose_in_parent(self.a, name, self.carried_by[0])
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
    carried = dict.fromkeys(joint.child for joint in robot.tree())
    return [*(name for name in robot.links if name not in carried), *carried]


def _shifted(link: Link, shift: Array) -> Link:
    """The link with its frame moved, so that its old one has this pose in the new one."""
    body = None if link.body is None else link.body.seen_from(shift)
    shapes = [replace(shape, pose=shift @ shape.pose) for shape in link.geometries]
    return replace(link, pose=link.pose @ inverse(shift), body=body, geometries=shapes)


def _same_pose_body(a: MassProperties | None, b: MassProperties | None, tolerance: float) -> bool:
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
