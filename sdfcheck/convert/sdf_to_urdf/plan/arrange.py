"""Which joints make the tree that URDF demands, and which way round they go."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from sdfcheck.robot.motion.mechanism import Joint, Mechanism

WORLD = "world"


@dataclass(frozen=True, slots=True)
class Edge:
    """A joint of the tree, from its parent there to its child there."""

    joint: Joint
    parent: str
    child: str

    @property
    def is_reversed(self) -> bool:
        """Is the joint's parent the child in the tree?"""
        return self.parent != self.joint.parent


@dataclass(slots=True)
class Arrangement:
    """A forest: its edges in document order, the tops of its trees, the joints left over."""

    edges: list[Edge]
    tops: list[str]
    """The links that no edge carries; the first is the one that holds the canonical link."""
    loops: list[Joint] = field(default_factory=list)
    has_world: bool = False

    @property
    def carriers(self) -> dict[str, Edge]:
        return {edge.child: edge for edge in self.edges}


def arrange(robot: Mechanism, canonical: str) -> Arrangement:
    """The forest in which every tree begins at the world, at the top above the canonical link, or where no
    joint carries a link."""
    chosen = robot.spanning()
    beside: dict[str, list[Joint]] = {}
    for joint in chosen:
        for end in (joint.parent, joint.child):
            beside.setdefault(end, []).append(joint)
    edges: dict[str, Edge] = {}
    tops: list[str] = []
    placed: set[str] = set()
    for start in (WORLD, _top(robot, canonical), *robot.roots(), *robot.links):
        if start in placed or (start not in robot.links and start not in beside):
            continue
        tops.append(start)
        for edge in _outwards(start, beside, placed):
            edges[edge.joint.name] = edge
    has_world = WORLD in tops
    if has_world:
        tops.remove(WORLD)
    kept = [edges[name] for name in robot.joints if name in edges]
    return Arrangement(kept, tops, robot.loops(), has_world)


def _outwards(start: str, beside: dict[str, list[Joint]], placed: set[str]) -> Iterator[Edge]:
    """The edges of one tree; nearest to its top first."""
    placed.add(start)
    waiting = [start]
    for here in waiting:
        for joint in beside.get(here, ()):
            there = joint.child if here == joint.parent else joint.parent
            if there not in placed:
                placed.add(there)
                waiting.append(there)
                yield Edge(joint, here, there)


def _top(robot: Mechanism, link: str) -> str:
    """The link at the top of the tree that a link is in."""
    carriers = {joint.child: joint for joint in robot.tree()}
    while link in carriers and carriers[link].parent != WORLD:
        link = carriers[link].parent
    return link
