"""Differences between two robots, whatever formats they were read from.

Links are compared where their parents carry them, so that one moved joint is one
difference and not one for every link after it.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import PurePosixPath

import numpy as np

from sdfcheck.convert.comparison import Change, ChangeKind
from sdfcheck.convert.contents.comparison import SettingsDiff
from sdfcheck.convert.contents.entry import Contents
from sdfcheck.convert.rewrite.matching import (
    Names,
    Shapes,
    carriers,
    filled,
    reframed,
    same_names,
    same_pose,
    seat,
)
from sdfcheck.convert.verify import TOLERANCE, Correspondence, Counterpart, verify
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.robot.motion.mechanism import Axis, Geometry, Joint, Link, Mechanism, Mimic
from sdfcheck.robot.motion.rotations import Array, inverse, to_rpy

_ENDLESS = 1e15


def compare(
    a: Mechanism,
    b: Mechanism,
    *,
    contents: tuple[Contents, Contents] | None = None,
    across_formats: bool = False,
    tolerance: float = TOLERANCE,
) -> list[Change]:
    """The changes from ``a`` to ``b``, and from one of the ``contents`` to the other.

    ``across_formats``: what only one of the formats can say (names of shapes, frames, where
    a mesh is looked for) is not compared.
    """
    comparison = _Comparison(a, b, across_formats, tolerance)
    found = list(comparison.run())
    if contents is not None:
        settings = SettingsDiff(
            contents, comparison.names, tolerance, moved=comparison.moved, across_formats=across_formats
        )
        found += settings.run(comparison.shapes)
    if found:
        return found
    # Nothing that is known to matter has changed; make sure that the robots also move alike.
    proof = verify(
        comparison.a, comparison.b, comparison.correspondence(), configurations=4, tolerance=tolerance * 100
    )
    return [Change(ChangeKind.CHANGED, "robot", d.name, d.what, "", d.text) for d in proof.differences]


class _Comparison:
    def __init__(self, a: Mechanism, b: Mechanism, across_formats: bool, tolerance: float) -> None:
        self.across_formats = across_formats
        self.tolerance = tolerance
        self.shapes: list[tuple[str, Geometry, Geometry]] = []
        """Link (of the second) and what became of each of its shapes."""
        self.names = Names.between(a, b, tolerance)
        links = self.names.links
        self.a = filled(a, b, links)
        other = filled(b, a, {there: here for here, there in links.items()})
        self.b, self.moved = reframed(self.a, other, self.names, tolerance)
        self.carried_by = carriers(self.a), carriers(self.b)

    def correspondence(self) -> Correspondence:
        links = {name: Counterpart(other) for name, other in self.names.links.items()}
        return Correspondence(links, self.names.joints)

    def run(self) -> Iterator[Change]:
        yield from self.parts("link", self.a.links, self.b.links, self.names.links)
        yield from self.parts("joint", self.a.joints, self.b.joints, self.names.joints)
        for name, link in self.a.links.items():
            if name in self.names.links:
                yield from self.link(link, self.b.links[self.names.links[name]])
        for name, joint in self.a.joints.items():
            if name in self.names.joints:
                yield from self.joint(joint, self.b.joints[self.names.joints[name]])
        if not self.across_formats:
            yield from self.frames()

    def parts(
        self, part: str, before: Mapping[str, object], after: Mapping[str, object], same: Mapping[str, str]
    ) -> Iterator[Change]:
        for name in before:
            if name not in same:
                yield Change(ChangeKind.REMOVED, part, name)
        kept = set(same.values())
        for name in after:
            if name not in kept:
                yield Change(ChangeKind.ADDED, part, name)
        for name, other in same.items():
            if name != other:
                yield Change(ChangeKind.RENAMED, part, name, "", name, other)

    # Links

    def link(self, a: Link, b: Link) -> Iterator[Change]:
        parent, here = seat(self.a, a.name, self.carried_by[0])
        other_parent, there = seat(self.b, b.name, self.carried_by[1])
        if a.name in self.moved:
            yield self.changed("link", b.name, "frame", *pose_texts(np.eye(4), self.moved[a.name]))
        if self.names.links.get(parent, parent) != other_parent:
            parent, here, there = "", a.pose, b.pose  # the joint reports that the parent is another
        if not same_pose(here, there, self.tolerance):
            what = f"pose in `{parent}`" if parent else "pose"
            yield self.changed("link", b.name, what, *pose_texts(here, there))
        yield from self.body(b.name, a.body, b.body)
        yield from self.geometries(a, b)

    def body(self, name: str, a: MassProperties | None, b: MassProperties | None) -> Iterator[Change]:
        if a is None or b is None:
            if (a or b) is not None and (not self.across_formats or (a or b).mass):  # type: ignore[union-attr]
                texts = ("none" if body is None else f"{body.mass:g} kg" for body in (a, b))
                yield self.changed("link", name, "inertial", *texts)
            return
        if not self.equal(a.mass, b.mass):
            yield self.changed("link", name, "mass", *_pair((a.mass,), (b.mass,)))
        if not np.allclose(a.center, b.center, rtol=0, atol=self.tolerance):
            yield self.changed("link", name, "center of mass", *_pair(a.center, b.center))
        size = max(float(np.abs(a.moments).max()), float(np.abs(b.moments).max()))
        pairs = (("ixx", 0, 0), ("iyy", 1, 1), ("izz", 2, 2), ("ixy", 0, 1), ("ixz", 0, 2), ("iyz", 1, 2))
        for what, row, column in pairs:
            x, y = float(a.moments[row, column]), float(b.moments[row, column])
            if abs(x - y) > self.tolerance * size:
                yield self.changed("link", name, what, *_pair((x,), (y,)))

    def geometries(self, a: Link, b: Link) -> Iterator[Change]:
        known, new = Shapes(a.geometries, self.tolerance, self.labels), []
        for geometry in b.geometries:
            equal = known.take(geometry)
            if equal is None:
                new.append(geometry)
            else:
                self.shapes.append((b.name, equal, geometry))
        is_left = known.left()
        partners = _Partners([g for g in a.geometries if id(g) in is_left], new, self.tolerance)
        for geometry, other in partners.pairs():
            self.shapes.append((b.name, geometry, other))
            yield from self.geometry(b.name, geometry, other)
        for geometry in partners.gone.values():
            yield self.changed("link", b.name, geometry.role, _title(geometry), "none")
        for geometry in partners.new.values():
            yield self.changed("link", b.name, geometry.role, "none", _title(geometry))

    def labels(self, geometry: Geometry) -> tuple[str, str]:
        """The name and file of a shape, as far as they are compared."""
        return "" if self.across_formats else geometry.name, self.uri(geometry)

    def geometry(self, link: str, a: Geometry, b: Geometry) -> Iterator[Change]:
        label = f"{b.role} `{b.name}`" if b.name else b.role
        if not self.across_formats and a.name != b.name:
            yield self.changed("link", link, f"name of a {b.role}", a.name or "none", b.name or "none")
        if a.kind != b.kind:
            yield self.changed("link", link, f"{label} shape", _title(a), _title(b))
        elif not a.is_as_large_as(b, self.tolerance):
            yield self.changed("link", link, f"{label} size", *_pair(a.size, b.size))
        if self.uri(a) != self.uri(b):
            yield self.changed("link", link, f"{label} file", a.uri or "none", b.uri or "none")
        if not same_pose(a.pose, b.pose, self.tolerance):
            yield self.changed("link", link, f"{label} pose", *pose_texts(a.pose, b.pose))

    def uri(self, geometry: Geometry) -> str:
        return PurePosixPath(geometry.uri).name if self.across_formats else geometry.uri

    # Joints

    def joint(self, a: Joint, b: Joint) -> Iterator[Change]:
        name = b.name
        if a.kind != b.kind:
            yield self.changed("joint", name, "type", a.kind, b.kind)
        ends = [self.names.links.get(end, end) for end in (a.parent, a.child)]
        if ends == [b.child, b.parent] and b.parent != b.child:
            yield self.changed("joint", name, "parent and child", " → ".join(ends), " → ".join(ends[::-1]))
            b = _turned_round(b)
        for what, x, y in (("parent", ends[0], b.parent), ("child", ends[1], b.child)):
            if x != y:
                yield self.changed("joint", name, what, x, y)
        here, there = _in_child(self.a, a), _in_child(self.b, b)
        if self.across_formats:  # URDF has no frames of joints that are turned: the axis shows them
            here[:3, :3] = there[:3, :3] = np.eye(3)
        if not same_pose(here, there, self.tolerance) and (a.moves or not self.across_formats):
            yield self.changed("joint", name, "pose in the child", *pose_texts(here, there))
        if not self.equal(a.pitch, b.pitch):
            yield self.changed("joint", name, "pitch", *_pair((a.pitch,), (b.pitch,)))
        for number, (x_axis, y_axis) in enumerate(zip(a.axes, b.axes, strict=False)):
            label = f"axis {number + 1} " if max(len(a.axes), len(b.axes)) > 1 else ""
            turns = _in_child(self.a, a)[:3, :3], _in_child(self.b, b)[:3, :3]
            yield from self.axis(name, label, x_axis, y_axis, turns)

    def axis(self, joint: str, label: str, a: Axis, b: Axis, turns: tuple[Array, Array]) -> Iterator[Change]:
        here, there = turns[0] @ a.direction, turns[1] @ b.direction
        if not np.allclose(here, there, rtol=0, atol=max(self.tolerance, 1e-9)):
            yield self.changed("joint", joint, f"{label}direction", *_pair(here, there))
        for what in ("lower", "upper", "effort", "velocity", "damping", "friction"):
            x, y = (_bounded(getattr(axis, what)) for axis in (a, b))
            if not self.equal(x, y):
                yield self.changed("joint", joint, label + what, *_pair((x,), (y,)))
        if not self.same_mimic(a.mimic, b.mimic):
            yield self.changed("joint", joint, f"{label}mimic", _mimic(a.mimic), _mimic(b.mimic))

    def same_mimic(self, a: Mimic | None, b: Mimic | None) -> bool:
        if a is None or b is None:
            return a is b
        same = self.names.joints.get(a.leader, a.leader) == b.leader and self.equal(
            a.multiplier, b.multiplier
        )
        return same and self.equal(
            a.offset - a.multiplier * a.reference, b.offset - b.multiplier * b.reference
        )

    def frames(self) -> Iterator[Change]:
        same = same_names(self.a.frames, self.b.frames)
        yield from self.parts("frame", self.a.frames, self.b.frames, same)
        for name, its in same.items():
            (link, pose), (other, other_pose) = self.a.frames[name], self.b.frames[its]
            if self.names.links.get(link, link) != other:
                yield self.changed("frame", name, "attached to", link, other)
            elif not same_pose(pose, other_pose, self.tolerance):
                yield self.changed("frame", name, f"pose in `{other}`", *pose_texts(pose, other_pose))

    def equal(self, x: float, y: float) -> bool:
        return x == y or math.isclose(x, y, rel_tol=self.tolerance, abs_tol=min(self.tolerance, 1e-12))

    def changed(self, part: str, name: str, what: str, before: str, after: str) -> Change:
        return Change(ChangeKind.CHANGED, part, name, what, before, after)


def _turned_round(joint: Joint) -> Joint:
    """The same joint seen from its other end."""
    axes = tuple(replace(axis, direction=-axis.direction) for axis in joint.axes)
    return replace(joint, parent=joint.child, child=joint.parent, axes=axes)


def _bounded(value: float) -> float:
    """Bounds that no joint reaches count as unlimited."""
    return math.copysign(math.inf, value) if abs(value) >= _ENDLESS else value


def _in_child(robot: Mechanism, joint: Joint) -> Array:
    child = robot.links.get(joint.child)
    return inverse(child.pose) @ joint.pose if child is not None else joint.pose.copy()


class _Partners:
    """Shapes of a link that are ``gone`` and ``new``, by identity: those without counterpart stay."""

    def __init__(self, gone: list[Geometry], new: list[Geometry], tolerance: float) -> None:
        self.gone, self.new = ({id(shape): shape for shape in shapes} for shapes in (gone, new))
        self._alike = Shapes(new, tolerance)
        self._counts = [Counter(shape.role for shape in shapes) for shapes in (gone, new)]
        self._named: dict[tuple[str, str], list[Geometry]] = {}
        for shape in reversed(new):
            self._named.setdefault((shape.role, shape.name), []).append(shape)

    def pairs(self) -> Iterator[tuple[Geometry, Geometry]]:
        """Take out each shape and its counterpart."""
        for shape in list(self.gone.values()):
            other = self._alike.take(shape)
            if other is None and (other := self._partner(shape)) is not None:
                self._alike.remove(other)
            if other is not None:
                del self.gone[id(shape)], self.new[id(other)]
                for counts in self._counts:
                    counts[shape.role] -= 1
                yield shape, other

    def _partner(self, shape: Geometry) -> Geometry | None:
        """The one of its name, or the only other one of its role."""
        named = self._named.get((shape.role, shape.name), []) if shape.name else []
        while named:
            if id(other := named.pop()) in self.new:
                return other
        if all(counts[shape.role] == 1 for counts in self._counts):
            return next(other for other in self.new.values() if other.role == shape.role)
        return None


def _title(geometry: Geometry) -> str:
    name = f" `{geometry.name}`" if geometry.name else ""
    return " ".join(filter(None, (geometry.kind + name, geometry.uri)))


def _mimic(mimic: Mimic | None) -> str:
    if mimic is None:
        return "none"
    return f"{mimic.multiplier:g} × `{mimic.leader}` + {mimic.offset - mimic.multiplier * mimic.reference:g}"


def pose_texts(a: Array, b: Array) -> tuple[str, str]:
    """Two poses as x y z roll pitch yaw (m, rad)."""
    return _pair((*a[:3, 3], *to_rpy(a[:3, :3])), (*b[:3, 3], *to_rpy(b[:3, :3])))


def _pair(a: Array | tuple[float, ...], b: Array | tuple[float, ...]) -> tuple[str, str]:
    """Two lists of numbers, with as many digits as distinguish them."""
    texts = ("", "")
    for digits in (6, 10, 17):
        texts = tuple(" ".join(_digits(float(x), digits) for x in numbers) for numbers in (a, b))  # type: ignore[assignment]
        if texts[0] != texts[1]:
            break
    return texts


def _digits(number: float, digits: int) -> str:
    if math.isinf(number):
        return "none"
    return f"{0.0 if abs(number) < 1e-15 else number:.{digits}g}"
