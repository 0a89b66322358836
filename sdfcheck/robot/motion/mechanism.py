"""A model as physics sees it, as numbers: links and joints of the model and of all models in it by name.

Lengths in m, angles in rad, masses in kg, moments in kg·m². Transforms are 4×4 arrays
(:mod:`sdfcheck.robot.motion.poses`). The zero configuration is the one in which the file
places its links.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from sdfcheck.bodies.solid import Skin, together
from sdfcheck.robot.motion.mass import MassProperties
from sdfcheck.robot.motion.origin import Origin, Triple
from sdfcheck.robot.motion.poses import Array, about_axis, inverse, transform, z_towards
from sdfcheck.source.document import Element
from sdfcheck.source.record import NamedTuple


@dataclass(frozen=True, slots=True)
class Geometry:
    """A shape of a link: ``role`` is visual or collision, ``size`` its numbers, ``uri`` a mesh's file."""

    role: str
    kind: str
    size: tuple[float, ...]
    pose: Array
    """4×4, in the link's frame."""
    element: Element
    name: str = ""
    uri: str = ""

    def is_as_large_as(self, other: Geometry, tolerance: float) -> bool:
        """Are the sizes of two shapes of one kind equal? What is not a number is equal to itself."""
        return len(self.size) == len(other.size) and all(
            math.isclose(mine, theirs, rel_tol=1e-9, abs_tol=tolerance)
            or (math.isnan(mine) and math.isnan(theirs))
            for mine, theirs in zip(self.size, other.size, strict=True)
        )


@dataclass(slots=True)
class Link:
    """A rigid body and the frame that the file gives it."""

    name: str
    pose: Array
    """4×4, in the model's frame, at the zero configuration."""
    element: Element
    body: MassProperties | None = None
    """None where the file gives no mass properties."""
    geometries: list[Geometry] = field(default_factory=list)


class Mimic(NamedTuple):
    """position = multiplier · (position of the leader - reference) + offset."""

    leader: str
    multiplier: float = 1.0
    offset: float = 0.0
    reference: float = 0.0


@dataclass(frozen=True, slots=True)
class Axis:
    """A direction that a joint turns about or moves along, of unit length, in the joint's frame."""

    direction: Array
    lower: float = -math.inf
    upper: float = math.inf
    effort: float = math.inf
    velocity: float = math.inf
    damping: float = 0.0
    friction: float = 0.0
    mimic: Mimic | None = None


@dataclass(slots=True)
class Joint:
    """A joint between two links (``parent`` may be ``world``)."""

    name: str
    kind: str
    """fixed, revolute, continuous, prismatic, ball, universal, screw, gearbox, revolute2, planar or floating."""
    parent: str
    child: str
    pose: Array
    """4×4, in the model's frame, at the zero configuration."""
    element: Element
    axes: tuple[Axis, ...] = ()
    pitch: float = 0.0
    """Of a screw: m of travel per radian."""

    @property
    def moves(self) -> bool:
        return self.kind != "fixed"


@dataclass(slots=True)
class Mechanism:
    """One model: links and joints by name, in document order, and named frames."""

    name: str
    links: dict[str, Link]
    joints: dict[str, Joint]
    frames: dict[str, tuple[str, Array]] = field(default_factory=dict)
    """Frame → the link that it moves with and its 4×4 pose in that link's frame."""

    def roots(self) -> list[str]:
        """Links that no joint carries, except from the world."""
        carried = {joint.child for joint in self.joints.values() if joint.parent != "world"}
        return [name for name in self.links if name not in carried]

    def tree(self) -> list[Joint]:
        """The joints that carry links, parents first; a joint that closes a loop is left out."""
        carriers: dict[str, Joint] = {}
        for joint in self.joints.values():
            if joint.parent != joint.child and joint.child in self.links:
                carriers.setdefault(joint.child, joint)
        carried: dict[str, list[tuple[int, Joint]]] = {}
        for number, joint in enumerate(carriers.values()):
            carried.setdefault(joint.parent, []).append((number, joint))
        ordered: list[Joint] = []
        placed = ["world", *(name for name in self.links if name not in carriers)]
        while placed:
            ready = sorted(
                (each for name in placed for each in carried.pop(name, ())), key=lambda each: each[0]
            )
            ordered += (joint for _, joint in ready)
            placed = [joint.child for _, joint in ready]
        return ordered

    def spanning(self) -> list[Joint]:
        """The tree and the joints that tie trees together: no loops, but a link may have several parents."""
        chosen = self.tree()
        group = {name: name for name in (*self.links, "world")}

        def top(name: str) -> str:
            while group[name] != name:
                group[name] = name = group[group[name]]
            return name

        for joint in chosen:
            group[top(joint.child)] = top(joint.parent)
        taken = {joint.name for joint in chosen}
        for joint in self.joints.values():
            known = joint.parent in group and joint.child in group
            if joint.name not in taken and known and top(joint.parent) != top(joint.child):
                group[top(joint.child)] = top(joint.parent)
                chosen.append(joint)
        return chosen

    def loops(self) -> list[Joint]:
        """The joints that close loops."""
        tree = {joint.name for joint in self.spanning()}
        return [joint for joint in self.joints.values() if joint.name not in tree]


# Forward kinematics and total mass of a robot at any joint positions.
#
# Many configurations are worked out at once: arrays of poses have the shape (n, 4, 4), or (1, 4, 4) for what
# is the same in all of them.


Positions = Mapping[str, Array]
"""Joint → its positions (rad or m), shape (n, k): one for each axis; three for a ball joint (a rotation vector)."""


_POSITIONS = {
    "fixed": 0, "ball": 3, "universal": 2, "revolute2": 2, "planar": 3, "floating": 6, "curvilinear": 0
}  # fmt: skip
"""Kind of joint → how many positions it takes, where that is not one. A path is not followed."""


def degrees_of_freedom(joint: Joint) -> int:
    """How many positions a joint takes."""
    return _POSITIONS.get(joint.kind, 1)


class Bodies(NamedTuple):
    """Mass properties of a robot in n configurations; the moments are about the centers."""

    mass: float
    centers: Array
    """Shape (n, 3)."""
    moments: Array
    """Shape (n, 3, 3)."""

    def seen_from(self, frames: Array) -> Bodies:
        """The same in outer frames, in which these have the poses ``frames``."""
        turns = frames[:, :3, :3]
        centers = (turns @ self.centers[..., None])[..., 0] + frames[:, :3, 3]
        return Bodies(self.mass, centers, turns @ self.moments @ turns.swapaxes(-1, -2))


def motions(joint: Joint, positions: Array | None) -> Array:
    """The displacements of a joint's child in the joint's frame, shape (n, 4, 4)."""
    kind, axes = joint.kind, joint.axes
    if kind == "fixed" or positions is None or not positions.shape[1]:
        return np.eye(4)[None]
    first = positions[:, 0]
    if kind == "ball":
        return transform(_by_vector(positions), (0, 0, 0))
    if kind == "prismatic":
        return _shifted(first[:, None] * _direction(axes))
    if kind in {"universal", "revolute2"}:
        turned = about_axis(_direction(axes), first) @ about_axis(_direction(axes, 1), positions[:, 1])
        return transform(turned, (0, 0, 0))
    if kind == "screw":
        travel = first[:, None] * _direction(axes) * joint.pitch
        return transform(about_axis(_direction(axes), first), travel)
    if kind == "planar":
        across = _perpendicular(_direction(axes))
        along = first[:, None] * across[0] + positions[:, 1, None] * across[1]
        return transform(about_axis(_direction(axes), positions[:, 2]), along)
    if kind == "floating":
        return transform(_by_vector(positions[:, 3:]), positions[:, :3])
    return transform(about_axis(_direction(axes), first), (0, 0, 0))


def _by_vector(vectors: Array) -> Array:
    """Turns about vectors (n, 3), as far as they are long (rad)."""
    angles = np.linalg.norm(vectors, axis=1)
    return about_axis(vectors / np.where(angles > 0, angles, 1)[:, None], angles)


def _shifted(shifts: Array) -> Array:
    return transform(np.broadcast_to(np.eye(3), (len(shifts), 3, 3)), shifts)


def link_poses(robot: Mechanism, positions: Positions) -> dict[str, Array]:
    """The poses of every link in the model's frame; joints that close loops are ignored.

    ``positions`` leaves out joints at zero; followers are worked out from their leaders.
    A connected group is placed from the world, or else from its first link that no joint carries.
    """
    values = with_followers(robot, positions)
    beside: dict[str, list[Joint]] = {}
    for joint in robot.spanning():
        for end in (joint.parent, joint.child):
            beside.setdefault(end, []).append(joint)
    poses: dict[str, Array] = {}
    for start in ("world", *robot.roots(), *robot.links):
        if start in poses:
            continue
        poses[start] = _zero(robot, start)[None]
        waiting = [start]
        while waiting:
            here = waiting.pop()
            for joint in beside.get(here, ()):
                there = joint.child if here == joint.parent else joint.parent
                if there not in poses:
                    poses[there] = poses[here] @ _steps(robot, joint, values, here)
                    waiting.append(there)
    return {name: poses[name] for name in robot.links}


def _zero(robot: Mechanism, name: str) -> Array:
    link = robot.links.get(name)
    return np.eye(4) if link is None else link.pose


def _steps(robot: Mechanism, joint: Joint, values: Positions, start: str) -> Array:
    """The poses of one end of a joint in the other, ``start``."""
    before = inverse(_zero(robot, joint.parent)) @ joint.pose
    after = inverse(joint.pose) @ _zero(robot, joint.child)
    across = before @ motions(joint, values.get(joint.name)) @ after
    return across if start == joint.parent else inverse(across)


def with_followers(robot: Mechanism, positions: Positions) -> dict[str, Array]:
    """The positions, with those of mimicking joints worked out, chains too; what leads into a ring keeps its own."""
    result, own = dict(positions), set[str]()
    nowhere = np.zeros((1, 1))

    def mimic_of(name: str) -> Mimic | None:
        joint = robot.joints[name]
        mimic = joint.axes[0].mimic if joint.axes and name not in own else None
        return mimic if mimic is not None and mimic.leader in robot.joints else None

    for name in robot.joints:
        chain: dict[str, Mimic] = {}
        at = name
        while at not in chain and (mimic := mimic_of(at)) is not None:
            chain[at], at = mimic, mimic.leader
        own |= chain.keys()  # from here on they have a position
        if at in chain:
            continue
        position = result.get(at, nowhere)[:, :1]
        for follower, mimic in reversed(chain.items()):
            position = mimic.multiplier * (position - mimic.reference) + mimic.offset
            result[follower] = position
    return result


def total_body(robot: Mechanism, poses: Mapping[str, Array]) -> Bodies | None:
    """All links joined at the given poses, in the model's frame; None if no link has mass properties."""
    bodies = [(link.body, poses[name]) for name, link in robot.links.items() if link.body is not None]
    if not bodies:
        return None
    placed = np.stack(np.broadcast_arrays(*(pose for _, pose in bodies)))
    turns = placed[..., :3, :3]
    masses = np.array([body.mass for body, _ in bodies])
    centers = (turns @ np.stack([body.center for body, _ in bodies])[:, None, :, None])[..., 0]
    centers = centers + placed[..., :3, 3]
    moments = turns @ np.stack([body.moments for body, _ in bodies])[:, None] @ turns.swapaxes(-1, -2)
    mass = float(masses.sum())
    center = np.einsum("l,lni->ni", masses, centers) / mass if mass else centers[0]
    offsets = centers - center
    squares = np.einsum("lni,lni->ln", offsets, offsets)[..., None, None] * np.eye(3)
    shifts = squares - offsets[..., :, None] * offsets[..., None, :]
    return Bodies(mass, center, (moments + masses[:, None, None, None] * shifts).sum(axis=0))


def _direction(axes: tuple[Axis, ...], number: int = 0) -> Array:
    return axes[number].direction if len(axes) > number else np.array([0.0, 0.0, 1.0])


def _perpendicular(normal: Array) -> tuple[Array, Array]:
    """Two unit vectors that span the plane across a normal: x and y, turned with z the shortest way to it."""
    turned = z_towards(normal)
    return turned[:, 0], turned[:, 1]


# Surfaces of parts in the robot's frame, and how they touch.


_STEPS = 9
"""Positions of a joint in its range."""
_LEAST = 0.15
"""Of the surface: parts of neighbors that are in one another by less are the rule."""
_FINENESS = ((60, 120), (250, 400))
"""So many points of a part are asked, and so many of its parent say what is inside of it: first few, then more."""


def placed(skins: Iterable[tuple[Skin | None, Origin]]) -> Skin | None:
    """Skins at their poses as one; None without any, or where one is not known."""
    known = list(skins)
    if any(skin is None for skin, _ in known):
        return None
    return together(skin.moved(_matrix(pose)) for skin, pose in known if skin is not None)


def joined(skins: Iterable[Skin | None]) -> Skin | None:
    """The same of those that are at their places."""
    return placed((skin, Origin()) for skin in skins)


def distance(skins: Sequence[Skin], others: Sequence[Skin], least: float) -> float:
    """How far two groups are apart (m); 0 if not farther than ``least``. Best with neighbors first."""
    if not skins or not others or skins[0].is_near(others[0], least):
        return 0.0
    lows, highs = (np.array([other.bounds[side] for other in others]) for side in (0, 1))
    rows = []
    for skin in skins:
        low, high = skin.bounds
        rows.append(np.linalg.norm(np.maximum(0, np.maximum(lows - high, low - highs)), axis=1))
        if any(skin.is_near(others[int(at)], least) for at in np.flatnonzero(rows[-1] <= least)):
            return 0.0
    bounds = np.concatenate(rows)
    found = math.inf
    for at in np.argsort(bounds):
        if bounds[at] >= found:
            break
        skin, other = skins[int(at) // len(others)], others[int(at) % len(others)]
        found = min(found, max(float(bounds[at]), skin.distance_to(other)))
    return found


def reach(
    part: Skin, parent: Skin, kind: str, place: Triple, direction: Triple, limits: tuple[float, float]
) -> tuple[float, float] | None:
    """The largest shares of a part that its joint moves into its parent within its limits, and would the other way.

    None where that is little.
    """
    lower, upper = limits
    axis, at = np.array(direction), np.array(place)
    if kind == "revolute":
        lower, upper = max(lower, -math.pi), min(upper, math.pi)
    positions = np.linspace(lower, upper, _STEPS)

    def most(part: Skin, parent: Skin, way: int, least: float) -> float:
        for each in positions:
            moved = part.moved(_displacement(kind, axis, at, way * each))
            least = max(least, moved.share_in(parent, least))
        return least

    within = opposite = 0.0
    for asked, inside in _FINENESS:
        few = part.some(asked), parent.some(inside)
        within = most(*few, 1, _LEAST / 2)
        opposite = most(*few, -1, 0.0) if within > _LEAST / 2 else within
        if within - opposite < _LEAST / 2:
            return None
    return within, opposite


def _matrix(origin: Origin) -> Array:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = origin.rotation, origin.position
    return pose


def _displacement(kind: str, axis: Array, at: Array, position: float) -> Array:
    """The motion of a joint's part in the robot's frame, shape (4, 4)."""
    pose = np.eye(4)
    if kind == "prismatic":
        pose[:3, 3] = position * axis
    else:
        pose[:3, :3] = about_axis(axis, position)
        pose[:3, 3] = at - pose[:3, :3] @ at
    return pose
