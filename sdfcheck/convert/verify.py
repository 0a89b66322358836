"""Proof that two descriptions are one robot.

Both are read by their own parsers into :class:`~sdfcheck.robot.motion.mechanism.Robot`; at random
joint positions the poses of all links and the mass, center of mass and inertia of the
whole are compared, then those of each link, the links' geometry and the joints' limits.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import islice
from types import MappingProxyType
from typing import Any

import numpy as np

from sdfcheck.convert.comparison import Difference, Verification
from sdfcheck.convert.contents.comparison import Counterparts, SettingsProof
from sdfcheck.convert.contents.entry import Divergence
from sdfcheck.convert.nearby import Nearby
from sdfcheck.robot.motion.kinematics import (
    Bodies,
    Positions,
    degrees_of_freedom,
    link_poses,
    total_body,
    with_followers,
)
from sdfcheck.robot.motion.mass_properties import MassProperties
from sdfcheck.robot.motion.mechanism import Axis, Geometry, Joint, Mechanism
from sdfcheck.robot.motion.rotations import Array, angles_between, inverse
from sdfcheck.source.record import Record

TOLERANCE = 1e-9
CONFIGURATIONS = 64
_ENDLESS = 1e15
"""Bounds from here on mean none, for formats that want a number."""
_IN_PLACE = np.eye(4)
_IN_PLACE.flags.writeable = False
_NONE: Mapping[str, Any] = MappingProxyType({})


class Counterpart(Record):
    """Where a link of the source is in the result: the link, and the 4×4 pose of the source's frame in it."""

    link: str
    offset: Array = _IN_PLACE


class Correspondence(Record):
    """The links and joints of the source in the result; those not named keep their name, or are ``dropped``."""

    links: Mapping[str, Counterpart] = _NONE
    joints: Mapping[str, str] = _NONE
    parts: Mapping[str, tuple[str, ...]] = _NONE
    """Source joints that became several: the joint for each axis."""
    unlimited: float = _ENDLESS
    """Bounds from here on mean none."""
    dropped_links: frozenset[str] = frozenset()
    dropped_joints: frozenset[str] = frozenset()
    dropped_geometries: frozenset[str] = frozenset()
    """Kinds of shape that the result cannot hold."""
    changed_bodies: frozenset[str] = frozenset()
    """Source links whose mass properties were given to them, or left out; if there are any, totals
    are not compared."""

    def link(self, name: str) -> Counterpart:
        return self.links.get(name) or Counterpart(name)

    def joint(self, name: str) -> str:
        return self.joints.get(name, name)

    def joint_of_axis(self, name: str, number: int) -> tuple[str, int]:
        """The joint of the result that an axis of the source is, and the number of the axis there."""
        parts = self.parts.get(name)
        return (parts[number], 0) if parts else (self.joint(name), number)


def verify(
    source: Mechanism,
    result: Mechanism,
    correspondence: Correspondence | None = None,
    *,
    settings: SettingsProof | None = None,
    configurations: int = CONFIGURATIONS,
    tolerance: float = TOLERANCE,
) -> Verification:
    """Compare two robots and their settings; the positions are random, and the same at every call."""
    comparison = _Comparison(source, result, correspondence or Correspondence(), tolerance)
    return comparison.run(configurations, settings)


_EQUAL = 8
"""So many shapes of the result are taken into account that equal one of the source."""


class _Comparison:
    def __init__(
        self, source: Mechanism, result: Mechanism, correspondence: Correspondence, tolerance: float
    ) -> None:
        self.source = source
        self.result = result
        self.to = correspondence
        self.tolerance = tolerance
        self.found: dict[tuple[str, str], Difference] = {}
        self.position = self.angle = self.inertia = 0.0
        self.compared = [name for name in source.links if name not in correspondence.dropped_links]
        self.shapes: list[Counterparts] = []
        self.custom: list[Divergence] = []

    def run(self, configurations: int, settings: SettingsProof | None) -> Verification:
        missing = [name for name in self.compared if self.to.link(name).link not in self.result.links]
        for name in missing:
            self.differ("link", name, "is missing")
        self.compared = [name for name in self.compared if name not in missing]
        if not any(map(degrees_of_freedom, self.source.joints.values())):
            configurations = 1  # nothing moves
        if self.compared:
            self.compare_at(self.draw(configurations))
            self.compare_bodies()
        self.compare_joints()
        self.compare_geometries()
        if settings is not None:
            self.compare_settings(settings)
        return Verification(
            len(self.compared),
            configurations,
            self.position,
            self.angle,
            self.inertia,
            tuple(self.found.values()),
            self.counts(settings),
            tuple(self.custom),
        )

    def counts(self, settings: SettingsProof | None) -> dict[str, int]:
        """The parts that were compared in addition to links."""
        joints = sum(name not in self.to.dropped_joints for name in self.source.joints)
        others = settings.source.count() if settings is not None else {}
        return {"joint": joints, "shape": len(self.shapes), **dict(sorted(others.items()))}

    def compare_settings(self, settings: SettingsProof) -> None:
        links = {name: self.to.link(name).link for name in self.compared}
        joints = {
            name: self.to.joint(name) for name in self.source.joints if name not in self.to.dropped_joints
        }
        for name, one in settings.unequal(links, joints, self.shapes):
            if one.is_custom and one.element is not None:
                self.custom.append(one)
            else:
                self.differ(one.path, name, f"was {one.before} and is {one.after}")

    def draw(self, configurations: int) -> Positions:
        """Random configurations; the first is the one in which the file places the links."""
        drawn: dict[str, Array] = {}
        for joint in self.source.joints.values():
            wanted = degrees_of_freedom(joint)
            if wanted and joint.name not in self.to.dropped_joints:
                drawn[joint.name] = _scattered(configurations, wanted, len(drawn))
                drawn[joint.name][0] = 0
        return drawn

    def translate(self, positions: Positions) -> Positions:
        """The same configurations in the result's joints."""
        there: dict[str, Array] = {}
        for name, values in positions.items():
            parts = self.to.parts.get(name)
            if parts:
                there.update((part, values[:, n : n + 1]) for n, part in enumerate(parts))
            else:
                there[self.to.joint(name)] = values
        return there

    def compare_at(self, positions: Positions) -> None:
        ours = link_poses(self.source, positions)
        theirs = link_poses(self.result, self.translate(with_followers(self.source, positions)))
        seen = [self.to.link(name) for name in self.compared]
        here = _stacked([ours[name] for name in self.compared])
        there = _stacked([theirs[one.link] for one in seen]) @ np.stack([one.offset for one in seen])[:, None]
        our_root, their_root = inverse(here[0]), inverse(there[0])
        here, there = our_root @ here, their_root @ there
        positions_apart = np.linalg.norm(here[..., :3, 3] - there[..., :3, 3], axis=-1)
        angles_apart = angles_between(here[..., :3, :3], there[..., :3, :3])
        self.position, self.angle = float(positions_apart.max()), float(angles_apart.max())
        allowed = self.tolerance * np.maximum(1.0, np.linalg.norm(here[..., :3, 3], axis=-1))
        # Written so that a value that is not a number is off as well.
        off = ~((positions_apart <= allowed) & (angles_apart <= self.tolerance))
        for number in np.flatnonzero(off.any(axis=1)):
            apart = f"{positions_apart[number].max():.3g} m and {angles_apart[number].max():.3g} rad"
            self.differ("link", self.compared[number], f"is {apart} off")
        if not self.to.changed_bodies:
            self.compare_totals(
                total_body(self.source, ours), total_body(self.result, theirs), our_root, their_root
            )

    def compare_totals(
        self, first: Bodies | None, second: Bodies | None, our_root: Array, their_root: Array
    ) -> None:
        if first is not None and second is not None:
            self.compare_mass(self.source.name, first.seen_from(our_root), second.seen_from(their_root))
        elif first is not second and (first or second).mass > 0:  # type: ignore[union-attr]
            self.differ("mass", self.source.name, "is given on one side only")

    def compare_bodies(self) -> None:
        """Each link of the result must weigh what the source's links weigh that went into it."""
        became: dict[str, MassProperties] = {}
        changed = {self.to.link(name).link for name in self.to.changed_bodies}
        for name in self.compared:
            body, counterpart = self.source.links[name].body, self.to.link(name)
            if body is not None:
                seen, there = body.seen_from(counterpart.offset), became.get(counterpart.link)
                became[counterpart.link] = seen if there is None else there.joined_with(seen)
        for name in dict.fromkeys(self.to.link(one).link for one in self.compared):
            mine, theirs = became.get(name), self.result.links[name].body
            if name in changed:
                continue
            if mine is not None and theirs is not None:
                self.compare_mass(name, _single(mine), _single(theirs))
            elif mine is not theirs and (mine or theirs).mass > 0:  # type: ignore[union-attr]
                self.differ("mass", name, "is given on one side only")

    def compare_mass(self, name: str, a: Bodies, b: Bodies) -> None:
        moments = max(float(np.abs(a.moments).max()), 1e-9)
        errors = {
            "mass": abs(a.mass - b.mass) / max(abs(a.mass), 1e-9),
            "center of mass": float(np.abs(a.centers - b.centers).max()) if a.mass else 0.0,
            "inertia": float(np.abs(a.moments - b.moments).max()) / moments,
        }
        for what, error in errors.items():
            self.inertia = max(self.inertia, error)
            if not error <= self.tolerance:
                self.differ(what, name, f"differs by {error:.3g}")

    def compare_joints(self) -> None:
        for name, joint in self.source.joints.items():
            if name in self.to.dropped_joints or not joint.moves:
                continue
            for number, mine in enumerate(joint.axes or (None,)):
                there, which = self.to.joint_of_axis(name, number)
                other = self.result.joints.get(there)
                if other is None:
                    self.differ("joint", name, "is missing")
                elif mine is not None and which < len(other.axes):
                    self.compare_axes(joint, mine, other.axes[which])

    def compare_axes(self, joint: Joint, mine: Axis, theirs: Axis) -> None:
        # Wrong couplings of joints show in the poses.
        if mine.mimic is not None and theirs.mimic is None:
            self.differ("joint", joint.name, f"does not follow `{mine.mimic.leader}`")
        for what in ("lower", "upper", "effort", "velocity", "damping", "friction"):
            a, b = self.bounded(getattr(mine, what)), self.bounded(getattr(theirs, what))
            if a != b and not math.isclose(a, b, rel_tol=1e-12, abs_tol=1e-12):
                self.differ(what, joint.name, f"was {a:g} and is {b:g}")

    def bounded(self, value: float) -> float:
        return math.copysign(math.inf, value) if abs(value) >= self.to.unlimited else value

    def compare_geometries(self) -> None:
        known: dict[str, Nearby[Geometry]] = {}
        for name in self.compared:
            counterpart = self.to.link(name)
            wanted = [
                g for g in self.source.links[name].geometries if g.kind not in self.to.dropped_geometries
            ]
            if not wanted:
                continue
            if counterpart.link not in known:
                shapes = self.result.links[counterpart.link].geometries
                known[counterpart.link] = Nearby((_numbers(shape, shape.pose), shape) for shape in shapes)
            there = known[counterpart.link].copy()
            for geometry in wanted:
                numbers = _numbers(geometry, counterpart.offset @ geometry.pose)
                near = there.near(numbers, max(self.tolerance, 1e-9))
                equal = list(islice((g for g in near if self.same(geometry, g, counterpart.offset)), _EQUAL))
                if not equal:
                    self.differ(geometry.role, name, f"{geometry.kind} has no equal in the result")
                else:
                    there.remove(_numbers(equal[0], equal[0].pose), equal[0])
                    self.shapes.append(Counterparts(name, geometry, equal))

    def same(self, mine: Geometry, theirs: Geometry, offset: Array) -> bool:
        if (mine.role, mine.kind) != (theirs.role, theirs.kind) or not mine.is_as_large_as(theirs, 1e-12):
            return False
        return bool((np.abs(offset @ mine.pose - theirs.pose) <= max(self.tolerance, 1e-9)).all())

    def differ(self, what: str, name: str, text: str) -> None:
        self.found.setdefault((what, name), Difference(what, name, text))


def _numbers(shape: Geometry, pose: Array) -> list[float]:
    """The numbers by which shapes are compared."""
    return [*pose[:3].ravel().tolist(), *shape.size]


def _scattered(rows: int, columns: int, seed: int) -> Array:
    """Numbers from -1 to 1 that look random (SplitMix64): ``numpy.random`` takes long to load."""
    numbers = np.arange(1, rows * columns + 1, dtype=np.uint64) + np.uint64(seed << 32)
    numbers *= np.uint64(0x9E3779B97F4A7C15)
    numbers = (numbers ^ (numbers >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    numbers = (numbers ^ (numbers >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    numbers ^= numbers >> np.uint64(31)
    return np.asarray(numbers / 2.0**63 - 1).reshape(rows, columns)


def _stacked(poses: list[Array]) -> Array:
    """Poses of several links in n configurations, shape (links, n, 4, 4)."""
    return np.stack(np.broadcast_arrays(*poses))


def _single(body: MassProperties) -> Bodies:
    return Bodies(body.mass, body.center[None], body.moments[None])
