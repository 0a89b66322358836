"""Two robots compared: as proof that they are one, and by their differences, whatever formats they were read from."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, replace
from enum import Enum
from itertools import islice
from pathlib import PurePosixPath
from types import MappingProxyType
from typing import Any

import numpy as np

from sdfcheck.convert.loss import Loss, LossKind
from sdfcheck.convert.matching import (
    Names,
    Shapes,
    carriers,
    filled,
    pose_in_parent,
    reframed,
    same_names,
    same_pose,
)
from sdfcheck.convert.settings_tree import (
    Contents,
    Divergence,
    Entry,
    divergences,
    same_number,
    same_text,
    seen_from_links,
)
from sdfcheck.robot.graph import ENDLESS
from sdfcheck.robot.motion.mass import MassProperties
from sdfcheck.robot.motion.mechanism import (
    Axis,
    Bodies,
    Geometry,
    Joint,
    Link,
    Mechanism,
    Mimic,
    Positions,
    degrees_of_freedom,
    link_poses,
    total_body,
    with_followers,
)
from sdfcheck.robot.motion.poses import Array, angles_between, inverse, to_rpy
from sdfcheck.source.document import Element
from sdfcheck.source.record import NamedTuple, Record

# The results of comparing two robots.


class ChangeKind(Enum):
    ADDED = "added"
    REMOVED = "removed"
    RENAMED = "renamed"
    CHANGED = "changed"


@dataclass(frozen=True, slots=True)
class Change:
    """One difference: of a ``part`` (model, link, joint, frame), and where it is changed, in ``what``."""

    kind: ChangeKind
    part: str
    name: str
    what: str = ""
    before: str = ""
    after: str = ""
    """Of what was renamed: the old and the new name."""


class Difference(Record):
    """One thing in which source and result are not equal."""

    what: str
    name: str
    text: str


class Verification(Record):
    """The compared quantities, and the largest differences (m, rad, relative for the mass)."""

    links: int
    configurations: int
    position: float
    angle: float
    inertia: float
    differences: tuple[Difference, ...]
    counts: Mapping[str, int] = MappingProxyType({})
    """Other compared quantities: joints, shapes, sensors, plugins and so on."""
    custom: tuple[Divergence, ...] = ()
    """Custom data that is not in the result as it was: a loss, but the same robot."""

    @property
    def is_equal(self) -> bool:
        return not self.differences

    def __str__(self) -> str:
        counts = {"link": self.links, **self.counts, "configuration": self.configurations}
        said = [f"{n} {word}{'s' * (n != 1)}" for word, n in counts.items() if n or word == "link"]
        return f"{', '.join(said)}, max pose error {max(self.position, self.angle):.1g} m"


# Proof that settings have arrived: each that the source has is in the result, or is reported as a loss.


_NO_EXCUSE = frozenset({LossKind.KEPT_AS_EXTENSION})
"""Parts that are listed must exist."""
_NOT_COMPARED = ("/pose", "material/ambient", "material/script", "material/pbr")
"""Where the formats differ: what a merged link carries moves, and URDF has one color and one texture."""

_QUOTED = re.compile("`([^`]*)`")


class Counterparts(NamedTuple):
    """A shape of a link of the source, and the shapes of the result that are as large and in the same place."""

    link: str
    shape: Geometry
    equal: Sequence[Geometry]


class SettingsProof(NamedTuple):
    """The settings of source and result, and what was reported."""

    source: Contents
    result: Contents
    losses: Sequence[Loss]
    translated: frozenset[Element] = frozenset()
    """Elements of the source that the result says in another place or in other words."""
    copies: frozenset[tuple[Element, str]] = frozenset()
    """Custom elements and attributes, by element and name, of which the ledger knows that they are in the result."""

    def unequal(
        self, links: Mapping[str, str], joints: Mapping[str, str], shapes: Iterable[Counterparts]
    ) -> Iterator[tuple[str, Divergence]]:
        """The parts of the source, and what differs; ``links`` and ``joints`` are those compared, and their names."""
        excused = _Excuses(self.losses, self.translated)

        def apart(a: Entry, b: Entry, path: str = "") -> list[Divergence]:
            found = divergences(a, b, same, path, deep=True)
            return [one for one in found if one.before != "none" and not self.arrived(one, excused, a)]

        def same(a: str, b: str) -> bool:
            known = same_text(a, b) or b in {links.get(a), joints.get(a), a.replace("::", "__")}
            return known or (("/" in a or "/" in b) and PurePosixPath(a).name == PurePosixPath(b).name)

        named = [("link", name, other) for name, other in links.items()]
        named += [("joint", name, other) for name, other in joints.items()]
        for kind, name, other in (*named, ("model", "", "")):
            for one in apart(self.source.of(kind, name), self.result.of(kind, other)):
                yield name or self.source.name, one
        for link, shape, equal in shapes:
            mine = self.source.shapes.get(shape.element)
            theirs = [
                found for other in equal if (found := self.result.shapes.get(other.element)) is not None
            ]
            if mine is not None and theirs:
                # Of several shapes in one place any may be the one.
                best = apart(mine, theirs[0], shape.role)
                for one_more in theirs[1:]:
                    if not best:
                        break
                    best = min(best, apart(mine, one_more, shape.role), key=len)
                yield from ((link, one) for one in best)

    def arrived(self, one: Divergence, excused: _Excuses, part: Entry) -> bool:
        """Is a part that differs proven to be in the result, or reported?"""
        return (one.element, one.name) in self.copies or excused.excuse(one, part)


class _Excuses:
    """The places of what was reported."""

    def __init__(self, losses: Sequence[Loss], translated: frozenset[Element]) -> None:
        self.translated = translated
        self.spans = {
            (loss.span.source.path, loss.span.start) for loss in losses if loss.kind not in _NO_EXCUSE
        }
        self.files = {path for path, _ in self.spans}
        self.brought = {
            name for loss in losses if loss.span.text == "include" for name in _QUOTED.findall(loss.message)
        }
        """The names in what is reported at includes."""

    def excuse(self, one: Divergence, part: Entry) -> bool:
        at = one.element
        if any(path in one.path for path in _NOT_COMPARED) or (
            at is not None and one.name.rpartition(":")[2] in seen_from_links(at.document)
        ):
            return True
        if one.element in self.translated and one.element is not part.element:
            return True
        while at is not None and at is not part.element:
            if self.knows(at) or self.knows_brought(at):
                return True
            at = at.parent
        return one.element is part.element and part.element is not None and self.knows(part.element)

    def knows_brought(self, element: Element) -> bool:
        """Is it in an included file, and left out? That is reported at the include, with its name."""
        if element.document.source.path in self.files:
            return False
        return element.name in self.brought or element.get("name") in self.brought

    def knows(self, element: Element) -> bool:
        """Is something reported about an element, its attributes or its text?"""
        spans = [element.span, element.own_value.span]
        spans += [
            value.name_span for name in element.attributes if (value := element.attribute(name)) is not None
        ]
        return any((span.source.path, span.start) in self.spans for span in spans)


# The changes in the settings of a robot.


_ONE_COLOR = ("material/ambient", "material/specular", "material/emissive")
"""What URDF, which has one color, leaves to the others."""


class SettingsDiff:
    """Compares the settings of two robots whose links and joints correspond."""

    def __init__(
        self,
        both: tuple[Contents, Contents],
        names: Names,
        tolerance: float,
        *,
        moved: Mapping[str, Array],
        across_formats: bool,
    ) -> None:
        """``moved``: where the frame of a link of the second is in that of its counterpart, where it is elsewhere."""
        self.moved = moved
        self.a, self.b = both
        self.links, self.joints = names.links, names.joints
        self.tolerance = tolerance
        self.across_formats = across_formats

    def run(self, shapes: Iterable[tuple[str, Geometry, Geometry]]) -> Iterator[Change]:
        """The changes; ``shapes`` are the link, and what became of which shape."""
        for name in [
            name for kind, name in self.a.parts if kind == "model" and ("model", name) in self.b.parts
        ]:
            found = divergences(self.a.of("model", name), self.b.of("model", name), self.same)
            yield from self.changes("model", name or self.b.name, found)
        for kind, names in (("link", self.links), ("joint", self.joints)):
            for name, other in names.items():
                yield from self.part(kind, name, other)
        seen: set[Entry] = set()
        for link, mine, theirs in shapes:
            first, second = self.a.shapes.get(mine.element), self.b.shapes.get(theirs.element)
            if first is None or second is None or first in seen:
                continue
            seen.add(first)
            label = f"{theirs.role} `{theirs.name}`" if theirs.name else theirs.role
            yield from self.changes("link", link, divergences(first, second, self.same, label))

    def part(self, kind: str, name: str, other: str) -> Iterator[Change]:
        theirs = self.b.of(kind, other)
        if kind == "link" and (shift := self.moved.get(name)) is not None:
            theirs = theirs.seen_from(shift)
        yield from self.changes(kind, other, divergences(self.a.of(kind, name), theirs, self.same))

    def changes(self, kind: str, name: str, found: Iterable[Divergence]) -> Iterator[Change]:
        for one in found:
            if self.across_formats and one.path.endswith(_ONE_COLOR):
                continue
            yield Change(ChangeKind.CHANGED, kind, name, one.path, one.before, one.after)

    def same(self, a: str, b: str) -> bool:
        """Do two values say the same, names of links and joints included?"""
        if same_text(a, b, self.tolerance) or self.links.get(a) == b or self.joints.get(a) == b:
            return True
        return self.across_formats and "/" in a and PurePosixPath(a).name == PurePosixPath(b).name


# Proof that two descriptions are one robot: at random joint positions the poses of all links and the mass, center of
# mass and inertia of the whole are compared, then those of each link, the links' geometry and the joints' limits.


TOLERANCE = 1e-9
CONFIGURATIONS = 64
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
    unlimited: float = ENDLESS
    """Bounds from here on mean none."""
    dropped_links: frozenset[str] = frozenset()
    dropped_joints: frozenset[str] = frozenset()
    dropped_shapes: Set[Element] = frozenset()
    """The visuals and collisions of the source that the result cannot hold, or writes as others."""
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
    comparison = _Proof(source, result, correspondence or Correspondence(), tolerance)
    return comparison.run(configurations, settings)


_EQUAL = 8
"""So many shapes of the result are taken into account that equal one of the source."""


def _kind(joint: Joint) -> str:
    """The kind of a joint; one that turns between limits that nobody reaches is continuous."""
    is_endless = bool(joint.axes) and joint.axes[0].lower <= -ENDLESS and joint.axes[0].upper >= ENDLESS
    return "continuous" if joint.kind == "revolute" and is_endless else joint.kind


_ENDS: Mapping[str, Callable[[float, float], float]] = {"lower": min, "upper": max}


def _bounds_apart(
    a: Axis, b: Axis, tolerance: float, unlimited: float = ENDLESS
) -> Iterator[tuple[str, float, float]]:
    """The limits and dynamics in which two axes differ; bounds from ``unlimited`` on mean none.

    The ends of a range may have been exchanged.
    """
    for what in ("lower", "upper", "effort", "velocity", "damping", "friction"):
        end = _ENDS.get(what)
        given = (getattr(axis, what) if end is None else end(axis.lower, axis.upper) for axis in (a, b))
        x, y = (math.copysign(math.inf, value) if abs(value) >= unlimited else value for value in given)
        if not same_number(x, y, tolerance):
            yield what, x, y


class _Proof:
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
        for what, a, b in _bounds_apart(mine, theirs, self.tolerance, self.to.unlimited):
            self.differ(what, joint.name, f"was {a:g} and is {b:g}")

    def compare_geometries(self) -> None:
        known: dict[str, Shapes] = {}
        for name in self.compared:
            counterpart = self.to.link(name)
            wanted = [
                g for g in self.source.links[name].geometries if g.element not in self.to.dropped_shapes
            ]
            if not wanted:
                continue
            if counterpart.link not in known:
                known[counterpart.link] = Shapes(
                    self.result.links[counterpart.link].geometries, self.tolerance
                )
            there = known[counterpart.link].copy()
            for geometry in wanted:
                moved = replace(geometry, pose=counterpart.offset @ geometry.pose)
                if there.take(moved) is None:
                    self.differ(geometry.role, name, f"{geometry.kind} has no equal in the result")
                else:
                    # Of those in one place, another may have been taken for one before.
                    equal = list(islice(known[counterpart.link].like(moved), _EQUAL))
                    self.shapes.append(Counterparts(name, geometry, equal))

    def differ(self, what: str, name: str, text: str) -> None:
        self.found.setdefault((what, name), Difference(what, name, text))


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


# Differences between two robots. Links are compared where their parents carry them, so that one moved joint is one
# difference and not one for every link after it.


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
    comparison = _Changes(a, b, across_formats, tolerance)
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


class _Changes:
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
        parent, here = pose_in_parent(self.a, a.name, self.carried_by[0])
        other_parent, there = pose_in_parent(self.b, b.name, self.carried_by[1])
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
        if not self.across_formats and not _are_called_alike(link, a, b):
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
        if _kind(a) != _kind(b):
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
        for what, x, y in _bounds_apart(a, b, self.tolerance):
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
        return same_number(x, y, self.tolerance)

    def changed(self, part: str, name: str, what: str, before: str, after: str) -> Change:
        return Change(ChangeKind.CHANGED, part, name, what, before, after)


def _turned_round(joint: Joint) -> Joint:
    """The same joint seen from its other end."""
    axes = tuple(replace(axis, direction=-axis.direction) for axis in joint.axes)
    return replace(joint, parent=joint.child, child=joint.parent, axes=axes)


def _in_child(robot: Mechanism, joint: Joint) -> Array:
    child = robot.links.get(joint.child)
    return inverse(child.pose) @ joint.pose if child is not None else joint.pose.copy()


def _are_called_alike(link: str, a: Geometry, b: Geometry) -> bool:
    """Whether two shapes have one name; one without a name gets that of its link from libsdformat."""
    given = f"{link}_{b.role}"
    return a.name == b.name or ("" in (a.name, b.name) and (a.name or b.name).startswith(given))


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
