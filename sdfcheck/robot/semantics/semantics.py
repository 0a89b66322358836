"""SRDF: groups, states, end effectors and collisions of a robot that another file describes.

Source: srdfdom (ros2, noetic) and MoveIt's robot model.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from sdfcheck.formats.near_names import nearest
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.srdf import named_by, srdf
from sdfcheck.robot.values import lazy
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import is_expression

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Model
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.link import Link
    from sdfcheck.source.document import Element, Value
    from sdfcheck.source.text import Span


VIRTUAL_TYPES = ("fixed", "floating", "planar")
ROOT_JOINT = "root_joint"
"""What Pinocchio calls the joint of a floating robot, which no URDF has."""

_MOST_LINKS_OF_GROUPS = 10_000_000
"""So many steps are worth it to know the links of all groups: PR2's take 5,000."""
_COUNTS = {"revolute": 1, "continuous": 1, "prismatic": 1, "planar": 3, "floating": 7}


class NamedPart(NamedTuple):
    """A name of a link or joint of the robot, or of a group, with its place."""

    kind: str
    value: Value


class StateValue(NamedTuple):
    """The value of a joint in a state of a group."""

    state: Element
    joint: Element
    value: Value


class Semantics:
    """The content of an SRDF file; ``robots`` are those that it may be about, empty where none is found.

    ``strangers`` are robots of its name that have nothing of what it names, ``namesake`` one of another name that has
    all of it.
    """

    def __init__(self, document: Document) -> None:
        root = document.root
        assert root is not None, "a document without elements says nothing"
        self.document = document
        self.element: Element = root
        self.robots: tuple[Model, ...] = ()
        self.strangers: tuple[Model, ...] = ()
        self.namesake: Model | None = None
        self.has_kinematics = False
        """Has its package the solvers of MoveIt's groups? Others read SRDF too, Pinocchio only poses of joints."""

    @property
    def span(self) -> Span:
        """The place of its root's name."""
        return self.element.span

    @property
    def name(self) -> str:
        """The name of the robot."""
        return self.element.attributes.get("name", "").strip()

    @lazy
    def parts(self) -> tuple[tuple[Element, Definition], ...]:
        """The elements that srdfdom reads, each with what is allowed in it."""
        return tuple(srdf().known(self.element))

    @lazy
    def groups(self) -> dict[str, Element]:
        """Name → its group, of several the first."""
        found: dict[str, Element] = {}
        for group in self.element.children("group"):
            if name := group.attributes.get("name", "").strip():
                found.setdefault(name, group)
        return found

    @lazy
    def links_of(self) -> dict[str, frozenset[str]]:
        """Name of a group → its links as MoveIt collects them: children of its joints; empty if unsure or too many."""
        robot = self.robots[0] if len(self.robots) == 1 and not any(self.unknown) else None
        if robot is None or any(self.unknown_groups):
            return {}
        above = {joint.child_name: joint.parent_name for joint in robot.joints}
        parts = sum(len(group.nodes) for group in self.groups.values())
        if (len(self.groups) + parts) * (parts + len(above)) > _MOST_LINKS_OF_GROUPS:
            return {}
        own = {name: frozenset(_own_links(group, robot, above)) for name, group in self.groups.items()}
        return {name: frozenset().union(*(own[each] for each in self._groups_in(name))) for name in own}

    def _groups_in(self, group: str) -> Iterator[str]:
        """A group and those that it consists of, each once."""
        waiting, seen = [group], {group}
        while waiting:
            name = waiting.pop()
            yield name
            inner = (each.attributes.get("name", "").strip() for each in self.groups[name].children("group"))
            new = {each for each in inner if each in self.groups} - seen
            waiting += new
            seen |= new

    @lazy
    def groups_of(self) -> dict[str, set[str]]:
        """Link → the groups that have it, where that is certain."""
        found: dict[str, set[str]] = {}
        for name, links in self.links_of.items():
            for link in links:
                found.setdefault(link, set()).add(name)
        return found

    @property
    def detached_end_effectors(self) -> Iterator[tuple[Value, str]]:
        """The end effectors for which MoveIt finds no group that carries them: what would have to change, and why."""
        for each in self.element.children("end_effector"):
            own, parent, link = (
                each.attributes.get(name, "").strip() for name in ("group", "parent_group", "parent_link")
            )
            carriers = self.groups_of.get(link, set()) - {own}
            value = each.attribute("parent_link")
            named = each.attribute("parent_group")
            if value is None or own not in self.links_of or any(map(is_expression, (own, parent, link))):
                continue
            if named is not None and parent == own:
                yield named, f"group `{own}` cannot carry itself"
            elif parent and parent not in carriers:
                yield value, f"group `{parent}` does not have link `{link}`"
            elif not carriers and self.has_kinematics:
                yield value, f"no other group has link `{link}`"

    @property
    def idle_states(self) -> Iterator[tuple[Value, str]]:
        """The first joint of each state that its group does not move, and why."""
        seen = set()
        for state, element, _ in self.state_values:
            group, value = state.attributes.get("group", "").strip(), element.attribute("name")
            name = "" if value is None else value.text.strip()
            joint = self.robots[0].joints_by_name.get(name) if group in self.links_of else None
            if joint is None or value is None or state in seen:
                continue
            if joint.child_name not in self.links_of[group]:
                seen.add(state)
                yield value, f"not in group `{group}`"
            elif joint.type == "fixed":
                seen.add(state)
                yield value, "fixed"

    @property
    def unknown_virtual_types(self) -> Iterator[Value]:
        """The types of virtual joints that srdfdom does not know."""
        for joint in self.element.children("virtual_joint"):
            value = joint.attribute("type")
            text = "fixed" if value is None else value.text.strip().lower()
            if value is not None and text not in VIRTUAL_TYPES and not is_expression(text):
                yield value

    @property
    def lacking(self) -> Iterator[tuple[Element, str]]:
        """The elements without an attribute that they need."""
        for part, definition in self.parts:
            for name in definition.required_attributes:
                if part.attribute(name) is None:
                    yield part, name

    @lazy
    def references(self) -> tuple[NamedPart, ...]:
        """The names of links and joints of the robot, and of groups."""
        return tuple(
            NamedPart(kind, value)
            for part, definition in self.parts
            for attribute in definition.attributes.values()
            if (kind := named_by(attribute)) and (value := part.attribute(attribute.name)) is not None
        )

    @lazy
    def named(self) -> tuple[NamedPart, ...]:
        """The names of links and joints of the robot."""
        return tuple(
            part
            for part in self.references
            if part.kind != "group" and part.value.text.strip() and not is_expression(part.value.text)
        )

    @lazy
    def virtual_joints(self) -> dict[str, str]:
        """The joints that it adds itself: name → type."""
        return {
            each.attributes.get("name", "").strip(): each.attributes.get("type", "").strip().lower()
            for each in self.element.children("virtual_joint")
        }

    @property
    def misplaced_virtual_joints(self) -> Iterator[tuple[Value, Link]]:
        """The children of virtual joints that are not the root of the robot, and the root."""
        for joint in self.element.children("virtual_joint") if self.robots else ():
            value = joint.attribute("child_link")
            roots = [robot.tree.roots[0] for robot in self.robots if len(robot.tree.roots) == 1]
            name = "" if value is None else value.text.strip()
            is_root = len(roots) < len(self.robots) or any(root.name == name for root in roots)
            if (
                value is not None
                and not is_root
                and any(name in names(robot, "link") for robot in self.robots)
            ):
                yield value, roots[0]

    @property
    def unknown(self) -> Iterator[NamedPart]:
        """The names that no robot has which the file may be about."""
        for part in self.named if self.robots else ():
            name = part.value.text.strip()
            if not self.is_added(part) and not any(name in names(robot, part.kind) for robot in self.robots):
                yield part

    def is_added(self, part: NamedPart) -> bool:
        """Is it a joint that no URDF has, but which this file or Pinocchio adds?"""
        name = part.value.text.strip()
        return part.kind == "joint" and (name == ROOT_JOINT or name in self.virtual_joints)

    def guess(self, part: NamedPart) -> str | None:
        """The name that was probably meant."""
        known = {name for robot in self.robots for name in names(robot, part.kind)}
        return nearest(part.value.text.strip(), known, self.document)

    @property
    def unknown_groups(self) -> Iterator[Value]:
        """The names of groups that it does not define."""
        for kind, value in self.references:
            if kind == "group" and value.text.strip() not in self.groups and not is_expression(value.text):
                yield value

    @property
    def doubled(self) -> Iterator[tuple[Value, Value]]:
        """The names of groups, and of states of a group, that are given before, with the first."""
        seen: dict[tuple[str, str, str], Value] = {}
        for part in self.element.children():
            value = part.attribute("name")
            if part.name in {"group", "group_state", "end_effector"} and value is not None:
                group = part.attributes.get("group", "") if part.name == "group_state" else ""
                first = seen.setdefault((part.name, group, value.text.strip()), value)
                if first is not value:
                    yield value, first

    @property
    def state_values(self) -> Iterator[StateValue]:
        """The values of joints in states."""
        for state in self.element.children("group_state"):
            for joint in state.children("joint"):
                value = joint.attribute("value")
                if value is not None and not is_expression(value.text):
                    yield StateValue(state, joint, value)

    def joint_of(self, state: StateValue) -> Joint | None:
        """The joint of the robot that a value is for; None where that is not certain."""
        name = state.joint.attributes.get("name", "").strip()
        found = [robot.joints_by_name[name] for robot in self.robots if name in robot.joints_by_name]
        return found[0] if len(self.robots) == 1 and found else None

    def miscounted(self, state: StateValue) -> str | None:
        """Why a value is not the numbers that its joint needs; None where it is, or that is unknown."""
        words = state.value.text.split()
        if not words or not all(map(_is_number, words)):
            return "a number"
        joint = self.joint_of(state)
        name = state.joint.attributes.get("name", "").strip()
        kind = joint.type if joint is not None else self.virtual_joints.get(name, "")
        count = _COUNTS.get(kind, len(words))
        return None if count == len(words) else f"{count} number{'s' * (count > 1)}"

    def outside(self, state: StateValue) -> Joint | None:
        """The joint whose limits a value is outside of."""
        joint = self.joint_of(state)
        if joint is None or joint.axis_count != 1 or joint.type not in {"revolute", "prismatic"}:
            return None
        low, high = joint.axis.limit.range
        number = state.value.number
        slack = 1e-6 * max(abs(low), abs(high), 1)
        return joint if number < low - slack or number > high + slack else None


def _own_links(group: Element, robot: Model, above: Mapping[str, str]) -> Iterator[str]:
    """The links that a group has without its groups: those below its joints, and between the ends of its chains."""
    for part in group.children():
        name = part.attributes.get("name", "").strip()
        if part.name == "link":
            yield name
        elif part.name == "joint" and name in robot.joints_by_name:
            yield robot.joints_by_name[name].child_name
        elif part.name == "joint":
            yield from (link.name for link in robot.tree.roots)
        elif part.name == "chain":
            tip, base = (part.attributes.get(end, "").strip() for end in ("tip_link", "base_link"))
            yield from set(_way_up(tip, above)).symmetric_difference(_way_up(base, above))


def _way_up(link: str, above: Mapping[str, str]) -> Iterator[str]:
    """A link and those above it, up to the root."""
    seen = set()
    while link and link not in seen:
        seen.add(link)
        yield link
        link = above.get(link, "")


def names(robot: Model, kind: str) -> frozenset[str]:
    """The names of the links or joints of a robot."""
    if kind == "joint":
        return frozenset(robot.joints_by_name)
    return frozenset(link.name for link in robot.links)


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return "_" not in text


# The semantics in a document; nothing in other documents than SRDF.


def semantics_in(document: Document) -> tuple[Semantics, ...]:
    """The parts of an SRDF document that are about a robot."""
    if document.kind is not Kind.SRDF or document.root is None:
        return ()

    return (document.view(Semantics),)
