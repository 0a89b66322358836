"""The experiments that show how a robot behaves, the same for every simulator.

Lengths in m, angles in rad, times in s, energies in J. A simulator gives a :class:`World`; the
experiments are deterministic. Imported where the engine runs, so nothing of sdfcheck but this.
"""

from __future__ import annotations

import math
import random
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

Pose = list[list[float]]
"""4×4."""
SAMPLE = 0.02
"""s: a robot that moves is looked at so often; a multiple of all time steps."""
ALIKE = 0.2
"""After this time two runs are compared: later, chains of joints differ by the least rounding."""
_STEPS = 8
"""Positions of a joint on the way through its range, beside the first."""
_DRAWN = 32
_SUNK = -5.0
"""A height from which a robot is below the ground as a whole, or nearly."""


class Contact(NamedTuple):
    """Two bodies (an empty name: the ground) that overlap by ``depth`` at a point of the world."""

    a: str
    b: str
    depth: float
    point: list[float]


class Motion(NamedTuple):
    """The purpose of a world: its root link is ``held`` or ``free``, above a ground."""

    base: str = "held"
    time_step: float = 0.001
    gravity: bool = True


class World(ABC):
    """A robot in a simulator, with joints that nothing drives."""

    @abstractmethod
    def ranges(self) -> dict[str, tuple[float, float]]:
        """The joints with one degree of freedom, and where they stop."""

    @abstractmethod
    def place(self, positions: dict[str, float], height: float | None = None) -> None:
        """Put the joints there, at rest; others at 0. ``height``: of a free root link."""

    @abstractmethod
    def contacts(self) -> list[Contact]:
        """The overlaps, also of neighbors."""

    @abstractmethod
    def advance(self, seconds: float) -> None:
        """Simulate; raises ArithmeticError where the result is not finite."""

    @abstractmethod
    def poses(self) -> dict[str, Pose]:
        """The poses of links in the world."""

    @abstractmethod
    def speeds(self) -> dict[str, float]:
        """How fast the links move."""

    @abstractmethod
    def energy(self) -> float:
        """Potential and kinetic energy."""

    @abstractmethod
    def loads(self) -> dict[str, float]:
        """Forces (N, N·m) with which the joints hold the robot against gravity where it is."""


Make = Callable[[Motion], World]


def behave(make: Make, settings: dict[str, Any]) -> dict[str, Any]:
    """The measurements that ``settings["experiments"]`` names, with ``seconds``, ``time_step`` and ``followers``."""
    found: dict[str, Any] = {}
    for name in settings["experiments"]:
        found[name] = _EXPERIMENTS[name](make, settings)
    return found


def _start(world: World, settings: dict[str, Any]) -> dict[str, float]:
    """Each joint at 0, or where it stops nearest to that; those that follow others with them."""
    start = {name: min(max(0.0, lower), upper) for name, (lower, upper) in _ordered(world)}
    return _followed(start, settings)


def _followed(positions: dict[str, float], settings: dict[str, Any]) -> dict[str, float]:
    """The positions, with those of ``followers``: name → leader, multiplier, offset."""
    return positions | {
        name: multiplier * positions[leader] + offset
        for name, (leader, multiplier, offset) in settings["followers"].items()
        if leader in positions and name in positions
    }


def _ordered(world: World) -> Iterator[tuple[str, tuple[float, float]]]:
    for name, (lower, upper) in sorted(world.ranges().items()):
        yield name, (lower, upper) if lower <= upper else (-math.inf, math.inf)


def _deepest(contacts: list[Contact]) -> dict[tuple[str, str], Contact]:
    """The deepest contact of each pair, with its names in order."""
    found: dict[tuple[str, str], Contact] = {}
    for contact in contacts:
        pair = (min(contact.a, contact.b), max(contact.a, contact.b))
        if contact.depth > 0 and (pair not in found or contact.depth > found[pair].depth):
            found[pair] = contact
    return found


def overlaps(make: Make, settings: dict[str, Any]) -> list[list[Any]]:
    """The pairs of links that overlap at the start: names, depth, point."""
    world = make(Motion(time_step=settings["time_step"], gravity=False))
    world.place(_start(world, settings))
    return [[*pair, one.depth, one.point] for pair, one in sorted(_deepest(world.contacts()).items())]


def fall(make: Make, settings: dict[str, Any]) -> dict[str, Any]:
    """The robot with its root link held, and no force in its joints."""
    done = _fall(make, settings, settings["time_step"], settings["seconds"])
    done["steps"] = [
        _fall(make, settings, settings["time_step"] * factor, ALIKE).get("early", {}) for factor in (0.5, 2.0)
    ]
    return done


def _fall(make: Make, settings: dict[str, Any], time_step: float, seconds: float) -> dict[str, Any]:
    world = make(Motion(time_step=time_step))
    world.place(_start(world, settings))
    first = last = world.energy()
    fastest: dict[str, float] = {}
    found: dict[str, Any] = {"energy": first, "highest": first, "finite": True, "fastest": fastest}
    for number in range(1, max(1, round(seconds / SAMPLE)) + 1):
        time = number * SAMPLE
        try:
            world.advance(SAMPLE)
            speeds, last = world.speeds(), world.energy()
        except ArithmeticError as error:
            return {**found, "finite": False, "reason": str(error), "time": time}
        if not all(map(math.isfinite, (last, *speeds.values()))):
            return {**found, "finite": False, "reason": "", "time": time}
        for name, speed in speeds.items():
            fastest[name] = max(speed, fastest.get(name, 0.0))
        found["highest"] = max(found["highest"], last)
        if "early" not in found and time >= ALIKE - 1e-9:
            found["early"] = world.poses()
    found["last"] = max(world.speeds().values(), default=0.0)
    return found


def sweep(make: Make, settings: dict[str, Any]) -> dict[str, list[list[Any]]]:
    """The pairs that overlap on a joint's way through its range, and those with the opposite axis of such a joint.

    Joint, names, depth, the position and the point where it is deepest, how often of how many.
    """
    met = _swept(make, settings, 1)
    meeting = {row[0] for row in met}
    return {"met": met, "mirrored": _swept(make, settings, -1, meeting)}


def _swept(make: Make, settings: dict[str, Any], way: int, asked: set[str] | None = None) -> list[list[Any]]:
    world = make(Motion(time_step=settings["time_step"], gravity=False))
    start = _start(world, settings)
    world.place(start)
    before = set(_deepest(world.contacts()))
    found: list[list[Any]] = []
    for joint, (least, most) in _ordered(world):
        lower, upper = max(least, -math.pi), min(most, math.pi)
        if joint in settings["followers"] or (asked is not None and joint not in asked):
            continue
        seen: dict[tuple[str, str], list[tuple[float, float, list[float]]]] = {}
        for step in range(_STEPS + 1):
            position = way * (lower + (upper - lower) * step / _STEPS)
            world.place(_followed({**start, joint: position}, settings))
            for pair, one in _deepest(world.contacts()).items():
                if pair not in before:
                    seen.setdefault(pair, []).append((one.depth, position, one.point))
        found += [[joint, *pair, *max(each), len(each), _STEPS + 1] for pair, each in sorted(seen.items())]
    return found


def loads(make: Make, settings: dict[str, Any]) -> dict[str, Any]:
    """The forces that hold the robot at the start, and the largest of random configurations."""
    world = make(Motion(time_step=settings["time_step"]))
    start = _start(world, settings)
    world.place(start)
    first = world.loads()
    most = {name: abs(value) for name, value in first.items()}
    drawn = random.Random(4_711)
    for _ in range(_DRAWN):
        world.place(
            {name: drawn.uniform(max(a, -math.pi), min(b, math.pi)) for name, (a, b) in _ordered(world)}
        )
        for name, value in world.loads().items():
            most[name] = max(most.get(name, 0.0), abs(value))
    return {"start": {name: abs(value) for name, value in first.items()}, "most": most}


def stand(make: Make, settings: dict[str, Any]) -> dict[str, Any]:
    """The robot on level ground: how far its root tilts and slides, and the links that touch the ground."""
    world = make(Motion("free", settings["time_step"]))
    start = _start(world, settings)
    world.place(start, _SUNK)
    depth = max((one.depth for one in world.contacts() if "" in (one.a, one.b)), default=0.0)
    if not depth:
        return {"touches": []}
    world.place(start, _SUNK + depth + 1e-4)
    root = settings["root"]
    before = world.poses().get(root)
    try:
        world.advance(settings["seconds"])
    except ArithmeticError:
        return {"touches": []}
    after = world.poses().get(root)
    touches = {a or b for a, b in _deepest(world.contacts()) if not (a and b)}
    if before is None or after is None:
        return {"touches": sorted(touches)}
    upright = sum(before[k][n] * after[k][n] for k in (2,) for n in range(3))
    slide = math.dist([row[3] for row in before[:2]], [row[3] for row in after[:2]])
    drop = before[2][3] - after[2][3]
    tilt = math.acos(min(1.0, max(-1.0, upright)))
    return {"touches": sorted(touches), "tilt": tilt, "slide": slide, "drop": drop}


_EXPERIMENTS: dict[str, Callable[[Make, dict[str, Any]], Any]] = {
    "overlaps": overlaps,
    "fall": fall,
    "sweep": sweep,
    "loads": loads,
    "stand": stand,
}
