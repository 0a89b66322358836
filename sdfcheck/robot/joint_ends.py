"""The ends of SDF joints, and the tree that joints make of the links.

Source: libsdformat 17's Joint.cc and parser.cc, checked against what they report; Drake
for what a joint can be tied to.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.suggest import suggest_in
from sdfcheck.robot.carriers import carrier
from sdfcheck.robot.joint_problems import (
    DetachedFrame,
    JointLoop,
    Problem,
    SelfJoint,
    SeveralParents,
    UnknownJointEnd,
    WorldAsChild,
)
from sdfcheck.robot.names import FRAME_KINDS
from sdfcheck.robot.scopes import NEVER_A_REFERENCE, WORLD_FRAME, Frame, Scope, scopes
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import NamedTuple


def end_problems(document: Document, joints: Iterable[Element]) -> Iterator[Problem]:
    """What is wrong with the ends of joints, and with the tree that they make of the links."""
    analysis = _Ends(document)
    for joint in joints:
        yield from analysis.look_at(joint)
    yield from analysis.unknown_ends()
    yield from _several_parents(analysis.carried)
    yield from _loops(analysis.carried)


class _Use(NamedTuple):
    """A joint that carries a link: from which link, and where it says so."""

    parent: Frame
    child: Value
    joint: Element


class _End(NamedTuple):
    """A parent or child as written, with the other end of its joint."""

    value: Value
    other: Value
    joint: Element
    role: str


class _Lost(NamedTuple):
    """The names in a scope, how many things have none (or are misspelt), and how many that of another."""

    names: set[str]
    nameless: int
    doubled: int


class _Ends:
    def __init__(self, document: Document) -> None:
        self.document = document
        self.scopes = scopes(document)
        self.carried: dict[Frame, list[_Use]] = {}
        """Link → the joints that carry it."""
        self.astray: dict[Scope, dict[str, list[_End]]] = {}
        """Scope → the names that it does not have → the ends that give them."""

    def look_at(self, joint: Element) -> Iterator[Problem]:
        scope = self.scopes.of(joint)
        parent, child = _end(joint, "parent"), _end(joint, "child")
        if scope is None or parent is None or child is None:
            return
        if child.text == WORLD_FRAME:
            yield WorldAsChild(child, joint)
            return
        if child.text == parent.text:
            yield SelfJoint(child, parent, joint)
            return
        ends: list[Frame] = []
        for role, value, other in (("parent", parent, child), ("child", child, parent)):
            found = self.resolve(joint, scope, value, role)
            if found is not None:
                ends.append(found)
            elif "" not in value.text.split("::") and not scope.may_hold(value.text):
                end = _End(value, other, joint, role)
                self.astray.setdefault(scope, {}).setdefault(value.text, []).append(end)
        if len(ends) == 2:
            yield from self.look_at_carriers(joint, scope, (parent, child), (ends[0], ends[1]))

    def resolve(self, joint: Element, scope: Scope, value: Value, role: str) -> Frame | None:
        """What an end names; None for the joint itself and for a name that reaches nothing."""
        name = value.text
        if role == "parent" and name == WORLD_FRAME:
            return Frame("world", name, joint, scope)
        found = None if name == NEVER_A_REFERENCE else scope.find(name)
        return found if found is not None and found.element is not joint else None

    def unknown_ends(self) -> Iterator[UnknownJointEnd]:
        """The names that reach nothing, each once, unless as many links have lost their names."""
        for scope, names in self.astray.items():
            lost = _lost_names(self.document, scope)
            if len(names) <= lost.nameless:
                continue  # what has lost its name is reported there, not wherever it is missed
            unlike = set()
            if lost.doubled:
                unlike = {n for n in names if suggest_in(self.document, n, lost.names) is None}
            if len(unlike) > lost.nameless + lost.doubled:
                unlike = set()
            for name, ends in names.items():
                if name not in unlike:
                    yield from self.unknown(scope, name, ends)

    def unknown(self, scope: Scope, name: str, ends: list[_End]) -> Iterator[UnknownJointEnd]:
        from sdfcheck.robot.near_names import near_names

        # A joint that names itself is told so.
        own = [end for end in ends if end.joint.attributes.get("name", "") == name]
        foreign = [end for end in ends if end not in own]
        for first, *others in (*([end] for end in own), *([foreign] if foreign else ())):
            but = (first.joint.attributes.get("name", ""), first.other.text)
            meant, outside = near_names(self.document).guess(scope, name, but=but)
            further = tuple(end.value for end in others)
            yield UnknownJointEnd(first.value, first.joint, first.role, meant, outside, further)

    def look_at_carriers(
        self, joint: Element, scope: Scope, values: tuple[Value, Value], ends: tuple[Frame, Frame]
    ) -> Iterator[Problem]:
        """What is wrong with the links that the ends lead to."""
        parent, child = carrier(ends[0]), carrier(ends[1])
        for role, value, link in (("parent", values[0], parent), ("child", values[1], child)):
            if link is not None and link.kind == "model":
                yield DetachedFrame(value, joint, role, link.scope.element)
        if child is None or child.kind == "model":
            return
        if child.kind == "world":
            yield WorldAsChild(values[1], joint)
        elif child is parent:
            yield SelfJoint(values[1], values[0], joint, child.name)
        elif parent is not None and not _is_gearbox(joint):
            self.carried.setdefault(child, []).append(_Use(parent, values[1], joint))


def _lost_names(document: Document, scope: Scope) -> _Lost:
    parent = scope.element
    own = [child for child in parent.children() if child.name in FRAME_KINDS]
    names = [name for child in own if (name := child.attributes.get("name", ""))]
    misspelled = survey(document).misspelled
    misspelt = sum(element is parent and name in FRAME_KINDS for element, name in misspelled)
    return _Lost(set(names), len(own) - len(names) + misspelt, len(names) - len(set(names)))


def _end(joint: Element, role: str) -> Value | None:
    element = joint.find(role)
    return element.own_value if element is not None and element.content else None


def _is_gearbox(joint: Element) -> bool:
    """A gearbox couples links that other joints carry."""
    return joint.attributes.get("type", "").strip().lower() == "gearbox"


def _several_parents(carried: dict[Frame, list[_Use]]) -> Iterator[Problem]:
    for link, (first, *others) in carried.items():
        names = tuple(use.joint.attributes.get("name", "") for use in (first, *others))
        for use in others:
            yield SeveralParents(use.child, first.child, link.name, names, refused=False)


def _loops(carried: dict[Frame, list[_Use]]) -> Iterator[Problem]:
    """Joints that lead round in a ring, going up from each link by the first joint that carries it."""
    done: set[Frame] = set()
    for start in carried:
        path: dict[Frame, None] = {}
        link = start
        while link in carried and link not in done and link not in path:
            path[link] = None
            link = carried[link][0].parent
        if link in path:
            # Going up meets the last joint of the ring first.
            members = list(path)
            ring = members[members.index(link) :][::-1]
            first = min(range(len(ring)), key=lambda number: carried[ring[number]][0].child.span.start)
            ring = ring[first:] + ring[:first]
            ends = tuple(carried[member][0].child for member in ring)
            yield JointLoop(ends, tuple(member.name for member in ring), refused=False)
        done.update(path)
