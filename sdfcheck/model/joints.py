"""Joints of SDF models: their ends, axes, limits and leaders, and the tree that they make.

Source: libsdformat 17's Joint.cc, JointAxis.cc and parser.cc, checked against what they
report; the physics engines for what an axis and its limits are used for.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

from sdfcheck.formats.survey import survey
from sdfcheck.model.frames import guess
from sdfcheck.model.joint_problems import (
    InvertedLimits,
    MimicCycle,
    MissingAxis,
    NegativeLimit,
    NonUnitAxis,
    Problem,
    SelfJoint,
    SeveralParents,
    UnknownJointEnd,
    UnknownMimicLeader,
    UselessLimit,
    WorldAsChild,
    ZeroAxis,
)
from sdfcheck.model.scopes import NEVER_A_REFERENCE, WORLD_FRAME, Frame, Scope, scopes
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

AXES = {
    "revolute": 1,
    "continuous": 1,
    "prismatic": 1,
    "screw": 1,
    "gearbox": 2,
    "revolute2": 2,
    "universal": 2,
    "ball": 0,
    "fixed": 0,
}
"""Joint type → the number of axes that it moves about or along."""

_AXIS_NAMES = ("axis", "axis2")
_TOLERANCE = 1e-6


def problems(document: Document) -> list[Problem]:
    """Everything about the joints of an SDF document that is wrong, in no particular order."""
    surveyed = survey(document)
    joints = surveyed.index.get("joint", ())
    if not joints:
        return []
    analysis = _Analysis(document)
    for joint in joints:
        analysis.look_at(joint)
    analysis.look_at_trees()
    return analysis.found


class _Analysis:
    def __init__(self, document: Document) -> None:
        self.scopes = scopes(document)
        self.found: list[Problem] = []
        self.children: dict[Frame, list[tuple[Value, Element]]] = {}
        """Link → where joints name it (or something that moves with it) as their child."""
        self.leaders: dict[Element, list[tuple[Value, Element]]] = {}
        """Joint → where it names its leaders, and these."""

    def look_at(self, joint: Element) -> None:
        scope = self.scopes.of(joint)
        if scope is not None:
            self.look_at_ends(joint, scope)
        self.look_at_axes(joint)
        for axis in _AXIS_NAMES:
            if (element := joint.find(axis)) is not None and (mimic := element.find("mimic")) is not None:
                self.look_at_mimic(joint, axis, mimic, scope)

    # Ends

    def look_at_ends(self, joint: Element, scope: Scope) -> None:
        parent, child = (self.end(joint, role) for role in ("parent", "child"))
        if parent is None or child is None:
            return
        if child.text == WORLD_FRAME:
            self.found.append(WorldAsChild(child, joint))
            return
        if child.text == parent.text:
            self.found.append(SelfJoint(child, parent, joint))
            return
        ends = [self.resolve(joint, scope, value, role) for value, role in ((parent, "parent"), (child, "child"))]
        if any(end is None for end in ends):
            return
        carriers = [self.carrier(end) for end in ends if end is not None]
        if carriers[1] is not None and carriers[1].kind == "world":
            self.found.append(WorldAsChild(child, joint))
        elif carriers[0] is not None and carriers[0] is carriers[1]:
            self.found.append(SelfJoint(child, parent, joint, carriers[0].name))
        elif carriers[1] is not None:
            self.children.setdefault(carriers[1], []).append((child, joint))

    def end(self, joint: Element, role: str) -> Value | None:
        element = joint.find(role)
        return element.own_value if element is not None and element.content else None

    def resolve(self, joint: Element, scope: Scope, value: Value, role: str) -> Frame | None:
        """What an end names; a joint's own name, and names that reach nothing, are reported."""
        name = value.text
        if role == "parent" and name == WORLD_FRAME:
            return Frame("world", name, joint, scope)
        found = None if name == NEVER_A_REFERENCE else scope.find(name)
        if found is not None and found.element is not joint:
            return found
        if "" not in name.split("::") and not scope.may_hold(name):
            suggestion, _ = guess(scope, name)
            self.found.append(UnknownJointEnd(value, joint, role, suggestion))
        return None

    def carrier(self, frame: Frame) -> Frame | None:
        """The link (or world, or static model) that a frame moves with; None if that cannot be told."""
        seen = set()
        at: Frame | None = frame
        while at is not None and at not in seen:
            seen.add(at)
            if at.kind in {"link", "world"}:
                return at
            at = self.step(at)
        return None

    def step(self, frame: Frame) -> Frame | None:
        if frame.kind == "model":
            return self.canonical_link(frame.inner)
        if frame.kind == "joint":
            child = frame.element.find("child")
            return frame.scope.find(child.content) if child is not None else None
        attached = frame.element.attribute("attached_to") if frame.kind == "frame" else None
        if attached is not None and attached.text.strip():
            return frame.scope.find(attached.text.strip())
        return frame.scope.own

    def canonical_link(self, scope: Scope | None) -> Frame | None:
        if scope is None or not scope.complete:
            return None
        named = scope.element.attribute("canonical_link")
        if named is not None and named.text.strip():
            return scope.find(named.text.strip())
        first = next(scope.links(), None)
        if first is not None:
            return first
        return next((link for inner in scope.inner if (link := self.canonical_link(inner))), None)

    # Axes

    def look_at_axes(self, joint: Element) -> None:
        kind = joint.attributes.get("type", "").strip().lower()
        count = AXES.get(kind)
        for number, name in enumerate(_AXIS_NAMES):
            axis = joint.find(name)
            if axis is None:
                if count is not None and number < count:
                    self.found.append(MissingAxis(joint, kind, name, "0 0 1"))
                continue
            self.look_at_direction(joint, axis)
            self.look_at_limits(joint, axis, kind)

    def look_at_direction(self, joint: Element, axis: Element) -> None:
        xyz = axis.find("xyz")
        if xyz is None:
            return
        numbers = _numbers(xyz.content)
        if numbers is None or len(numbers) < 3:
            return
        length = math.hypot(*numbers[:3])
        if length < _TOLERANCE:
            self.found.append(ZeroAxis(xyz.own_value, joint))
        elif abs(length - 1) > 1e-3:
            unit = " ".join(f"{number / length:.12g}" for number in numbers[:3])
            self.found.append(NonUnitAxis(xyz.own_value, joint, length, unit))

    def look_at_limits(self, joint: Element, axis: Element, kind: str) -> None:
        limit, dynamics = axis.find("limit"), axis.find("dynamics")
        if limit is not None:
            lower, upper = limit.number("lower"), limit.number("upper")
            if lower and upper and lower.number > upper.number:
                self.found.append(InvertedLimits(lower, upper, joint))
            elif kind == "continuous":
                useless = [v for v in (lower, upper) if v is not None and abs(v.number) < 1e15]
                if useless:
                    self.found.append(UselessLimit(useless[0], tuple(useless[1:]), kind, joint))
            # libsdformat reads any negative effort or velocity as "no limit", which the format writes -1.
            for name in ("effort", "velocity"):
                value = limit.number(name)
                if value is not None and value.number < 0 and value.number != -1:
                    self.found.append(NegativeLimit(value, name, joint))
        if dynamics is not None:
            for name in ("damping", "friction"):
                value = dynamics.number(name)
                if value is not None and value.number < 0:
                    self.found.append(NegativeLimit(value, name, joint))

    # Leaders

    def look_at_mimic(self, joint: Element, axis: str, mimic: Element, scope: Scope | None) -> None:
        leader = mimic.attribute("joint")
        if leader is None or scope is None or not leader.text.strip():
            return
        name = leader.text.strip()
        wanted = mimic.attribute("axis")
        leader_axis = wanted.text.strip() if wanted is not None else "axis"
        found = scope.find(name)
        if found is None or found.kind != "joint":
            if not scope.may_hold(name):
                joints = [n for n in scope.frames if scope.frames[n].kind == "joint"]
                self.found.append(UnknownMimicLeader(leader, joint, _suggest(name, joints)))
            return
        if found.element is joint and leader_axis == axis:
            self.found.append(MimicCycle((leader,), (name,)))
            return
        if leader_axis in _AXIS_NAMES and not found.element.has(leader_axis):
            self.found.append(UnknownMimicLeader(wanted or leader, joint, None))
            return
        if found.element is not joint:
            self.leaders.setdefault(joint, []).append((leader, found.element))

    # The whole

    def look_at_trees(self) -> None:
        for link, uses in self.children.items():
            if len(uses) > 1:
                names = tuple(joint.attributes.get("name", "") for _, joint in uses)
                self.found.append(SeveralParents(uses[1][0], uses[0][0], link.name, names, refused=False))
        self.look_for_mimic_cycles()

    def look_for_mimic_cycles(self) -> None:
        done: set[Element] = set()
        for start in self.leaders:
            path: dict[Element, Value] = {}
            at = start
            while at in self.leaders and at not in path and at not in done:
                path[at], at = self.leaders[at][0]
            if at in path:
                joints = list(path)
                ring = joints[joints.index(at) :]
                names = tuple(joint.attributes.get("name", "") for joint in ring)
                self.found.append(MimicCycle(tuple(path[joint] for joint in ring), names))
            done.update(path)


def _numbers(text: str) -> tuple[float, ...] | None:
    try:
        return tuple(float(part) for part in text.split())
    except ValueError:
        return None


def _suggest(name: str, candidates: list[str]) -> str | None:
    from sdfcheck.formats.suggest import suggest

    return suggest(name, candidates)


def joints_of(document: Document) -> Iterator[Element]:
    return iter(survey(document).index.get("joint", ()))
