"""A model as physics sees it, as numbers: links and joints of the model and of all models in it by name.

Lengths in m, angles in rad, masses in kg, moments in kg·m². Transforms are 4×4 arrays
(:mod:`sdfcheck.robot.motion.poses`). The zero configuration is the one in which the file
places its links.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from sdfcheck.robot.motion.mass import MassProperties
from sdfcheck.robot.motion.poses import Array
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
