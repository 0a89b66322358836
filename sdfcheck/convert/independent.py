"""A second opinion on a conversion: consumers read source and result, and their robots are compared.

A side that a consumer does not read is taken from our own reading, so that a library that knows
URDF alone judges as well. Compared are the poses of links at random positions, the mass
properties of what joints carry, and the ranges of joints. Parts that a consumer itself
merges, drops or invents on one side are no difference of the conversion, and left out.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from enum import Enum
from typing import TYPE_CHECKING, Any

import numpy as np

from sdfcheck.consumers.engines import Answer, Engine, Limits, Outcome, ask
from sdfcheck.consumers.engines.staging import Stage
from sdfcheck.convert.comparison import Difference
from sdfcheck.robot.motion.mass import MassProperties
from sdfcheck.robot.motion.mechanism import Joint, Mechanism, degrees_of_freedom, link_poses, with_followers
from sdfcheck.robot.motion.poses import Array, angle_between, inverse
from sdfcheck.source.document import Spans
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.splice import replaced

if TYPE_CHECKING:
    from sdfcheck.convert.result import Comparison, Conversion
    from sdfcheck.source.document import Document

TOLERANCE = 1e-5
"""The tolerance for libraries that compute in chains, and in part with single precision (m, rad; relative)."""
CONFIGURATIONS = 16
LIMITS = Limits(60.0)


class Judge(Enum):
    """A consumer that can compare; the value is its name on the command line."""

    GAZEBO = "gazebo"
    DRAKE = "drake"
    MUJOCO = "mujoco"
    PYBULLET = "pybullet"
    PINOCCHIO = "pinocchio"
    YOURDFPY = "yourdfpy"

    @property
    def engine(self) -> Engine:
        return Engine.LIBSDFORMAT if self is Judge.GAZEBO else Engine(self.value)

    @property
    def kinds(self) -> tuple[Kind, ...]:
        """The formats that it reads."""
        both = self in {Judge.GAZEBO, Judge.DRAKE}
        return (Kind.SDF, Kind.URDF) if both else (Kind.URDF,)


class Robot(NamedTuple):
    """A robot as somebody has it: the poses of links in each configuration, bodies, and ranges of joints."""

    poses: Sequence[Mapping[str, Array]]
    bodies: Mapping[str, MassProperties]
    ranges: Mapping[str, tuple[float, float]]


class Opinion(NamedTuple):
    """In what the consumers' readings of source and result differ."""

    differences: list[Difference]
    blind: dict[Judge, str]
    """The consumers that do not read the source, even without its shapes, and why."""


def second_opinion(done: Conversion, source: Document, judges: Iterable[Judge]) -> Opinion:
    """Let consumers read source and result.

    Raises:
        WrongUsage: a consumer is not installed.
    """
    found = Opinion([], {})
    with Stage() as stage:
        for judge in judges:
            for comparison in done.comparisons:
                said = _judged(judge, comparison, source, done, stage)
                if isinstance(said, str):
                    found.blind[judge] = said
                    break
                found.differences.extend(said)
    return found


def _judged(
    judge: Judge, comparison: Comparison, source: Document, done: Conversion, stage: Stage
) -> list[Difference] | str:
    """In what a consumer's readings differ, or why it does not read the source."""
    drawn = list(_drawn(comparison.source))
    there = [_translated(one, comparison) for one in drawn]

    def read(document: Document, configurations: Sequence[Mapping[str, float]], text: str) -> Answer | None:
        if document.kind not in judge.kinds:
            return None
        settings = {"configurations": [dict(one) for one in configurations]}
        answer = ask(judge.engine, stage.question(document, "facts", settings, text), LIMITS)
        if answer.outcome is Outcome.MISSING:
            raise WrongUsage(f"--verify-with {judge.value}: not installed: {answer.error}")
        return answer

    # Nothing of it depends on shapes, whose meshes may be missing, or of a format that the consumer does not read.
    for text_of in (_text, _text_without_shapes):
        before, after = (
            read(source, drawn, text_of(source)),
            read(done.document, there, text_of(done.document)),
        )
        if _is_read(before) and _is_read(after):
            break
    if before is not None and not _is_read(before):
        return before.error
    if after is not None and not _is_read(after):
        return [Difference("reading", judge.value, f"fails: {after.error}")]
    robots = _robot(before, comparison.source, drawn), _robot(after, comparison.result, there)
    return list(_unequal(judge, comparison, *robots))


def _is_read(answer: Answer | None) -> bool:
    return answer is None or (answer.is_accepted and not answer.error)


def _text(document: Document) -> str:
    return document.source.text


def _text_without_shapes(document: Document) -> str:
    """The text of a document without the visuals and collisions of links."""
    here = Spans(document.source, document.scan)  # where people wrote it may be another text
    shapes = (
        here.whole(each)
        for each in document.elements
        if each.name in {"visual", "collision"} and each.parent is not None and each.parent.name == "link"
    )
    return replaced(document.source.text, ((span.start, span.end, "") for span in shapes))


def _drawn(robot: Mechanism) -> Iterator[dict[str, float]]:
    """Random positions of the joints with one degree of freedom; the first are those of the file.

    Joints that follow a follower stay where they are, with all in their chain: yourdfpy takes them from its leader's
    position alone.
    """
    random = np.random.default_rng(4_711)
    axes = {name: joint.axes[0] for name, joint in robot.joints.items() if joint.axes}
    leaders = {name: axis.mimic.leader for name, axis in axes.items() if axis.mimic is not None}
    held = {leaders[leader] for leader in leaders.values() if leader in leaders}
    single = [
        name for name, joint in robot.joints.items() if degrees_of_freedom(joint) == 1 and name not in held
    ]
    yield {}
    for _ in range(CONFIGURATIONS - 1):
        values = dict(zip(single, random.uniform(-1, 1, len(single)), strict=True))
        followed = with_followers(robot, {name: np.array([[value]]) for name, value in values.items()})
        yield {name: float(value[0, 0]) for name, value in followed.items()}


def _translated(configuration: Mapping[str, float], comparison: Comparison) -> dict[str, float]:
    to = comparison.correspondence
    kept = {name: value for name, value in configuration.items() if name not in to.dropped_joints}
    return {to.joint_of_axis(name, 0)[0]: value for name, value in kept.items()}


def _robot(answer: Answer | None, own: Mechanism, configurations: Sequence[Mapping[str, float]]) -> Robot:
    if answer is None:
        return _of_mechanism(own, configurations)
    if "sdf" in answer.result:
        from sdfcheck.robot.load import parse
        from sdfcheck.robot.motion.flatten import mechanism_of

        models = parse(answer.result["sdf"]).models
        printed = next((one for one in models if one.name == own.name), models[0])
        return _of_mechanism(mechanism_of(printed), configurations)
    result = answer.result
    return Robot(
        [{name: np.array(pose) for name, pose in one.items()} for one in result["poses"]],
        {name: _body(body) for name, body in result["bodies"].items() if body is not None},
        {name: (joint["lower"], joint["upper"]) for name, joint in result["joints"].items()},
    )


def _body(given: Sequence[Any]) -> MassProperties:
    return MassProperties(given[0], np.array(given[1]), np.array(given[2]))


def _of_mechanism(robot: Mechanism, configurations: Sequence[Mapping[str, float]]) -> Robot:
    poses = []
    for one in configurations:
        known = {name: np.array([[value]]) for name, value in one.items() if name in robot.joints}
        poses.append({name: pose[0] for name, pose in link_poses(robot, known).items()})
    ranges = {
        name: (joint.axes[0].lower, joint.axes[0].upper) for name, joint in robot.joints.items() if joint.axes
    }
    bodies = {name: link.body for name, link in robot.links.items() if link.body is not None}
    return Robot(poses, bodies, ranges)


def _unequal(judge: Judge, comparison: Comparison, before: Robot, after: Robot) -> Iterator[Difference]:
    yield from _moved(judge, comparison, before, after)
    to = comparison.correspondence
    for group in _groups(comparison.source):
        if to.changed_bodies.intersection(group) or _invents(group, comparison):
            continue
        own = _total(group, before, {name: (name, np.eye(4)) for name in group})
        there = {name: (to.link(name).link, to.link(name).offset) for name in group}
        other = _total(group, after, there)
        if own is not None and other is not None and (apart := _apart(own, other)) > TOLERANCE:
            text = f"differs by {apart:.3g} in {judge.value}, with all that is fixed to it"
            yield Difference("mass", group[0], text)
    for name, (lower, upper) in before.ranges.items():
        other_range = after.ranges.get(to.joint_of_axis(name, 0)[0])
        if name in to.dropped_joints or name not in comparison.source.joints or other_range is None:
            continue
        if _is_read_otherwise(judge, comparison.source.joints[name]):
            continue
        if not (_near(lower, other_range[0]) and _near(upper, other_range[1])):
            text = f"is {lower:g} to {upper:g}, and then {other_range[0]:g} to {other_range[1]:g}"
            yield Difference("range", name, f"{text} in {judge.value}")


def _moved(judge: Judge, comparison: Comparison, before: Robot, after: Robot) -> Iterator[Difference]:
    to, seen = comparison.correspondence, set[str]()
    for ours, theirs in zip(before.poses, after.poses, strict=False):
        both = [
            (pose, theirs[to.link(name).link] @ to.link(name).offset, name)
            for name, pose in ours.items()
            if name in comparison.source.links
            and name not in to.dropped_links
            and to.link(name).link in theirs
        ]
        for pose, other, name in both:
            here, there = inverse(both[0][0]) @ pose, inverse(both[0][1]) @ other
            shift = float(np.linalg.norm(here[:3, 3] - there[:3, 3]))
            turn = angle_between(here[:3, :3], there[:3, :3])
            if name not in seen and not max(shift, turn) <= TOLERANCE * max(1.0, abs(here[:3, 3]).max()) * 10:
                seen.add(name)
                text = f"is {shift:.3g} m and {turn:.3g} rad from where {judge.value} has it"
                yield Difference("link", name, text)


def _is_read_otherwise(judge: Judge, joint: Joint) -> bool:
    """Does a consumer take a range without width for none, or the limits of a continuous joint for limits?"""
    is_locked = any(axis.lower == axis.upper for axis in joint.axes)
    return joint.kind == "continuous" or (judge is Judge.MUJOCO and is_locked)


def _groups(robot: Mechanism) -> list[list[str]]:
    """The links that fixed joints tie together, the one that carries the others first."""
    head = {name: name for name in robot.links}
    for joint in robot.tree():
        if not joint.moves and joint.parent in head:
            head[joint.child] = head[joint.parent]
    groups: dict[str, list[str]] = {}
    for name, first in head.items():
        groups.setdefault(first, []).append(name)
    return [sorted(names, key=lambda name: name != first) for first, names in groups.items()]


def _invents(group: Sequence[str], comparison: Comparison) -> bool:
    """Is there a link without mass, of which consumers make what they like?"""
    links = [comparison.source.links[name] for name in group]
    return any(
        each.body is None or not each.body.mass > 0 or not each.element.has("inertial") for each in links
    )


def _total(
    group: Sequence[str], robot: Robot, names: Mapping[str, tuple[str, Array]]
) -> MassProperties | None:
    """The mass properties of a group in the frame of its first link; None where that is not there."""
    first, offset = names[group[0]]
    poses = robot.poses[0]
    if first not in poses or first not in robot.bodies:
        return None
    base = inverse(poses[first] @ offset)
    total: MassProperties | None = None
    for name in dict.fromkeys(link for link, _ in names.values()):
        if name in robot.bodies and name in poses:
            body = robot.bodies[name].seen_from(base @ poses[name])
            total = body if total is None else total.joined_with(body)
    return total


def _apart(a: MassProperties, b: MassProperties) -> float:
    """How far two bodies are from being one: relative for mass and moments, m for the center."""
    moments = max(float(np.abs(a.moments).max()), 1e-6)
    return max(
        abs(a.mass - b.mass) / max(abs(a.mass), 1e-9),
        float(np.abs(a.center - b.center).max()),
        float(np.abs(a.moments - b.moments).max()) / moments,
    )


def _near(a: float, b: float) -> bool:
    """Are two bounds equal? So large ones mean none."""
    endless = (abs(a) >= 1e9 or math.isinf(a), abs(b) >= 1e9 or math.isinf(b))
    return all(endless) or (not any(endless) and math.isclose(a, b, rel_tol=TOLERANCE, abs_tol=TOLERANCE))
