"""SRDF: groups, states, end effectors and collisions of a robot that another file describes."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from itertools import chain, combinations, islice
from math import dist, inf
from operator import itemgetter
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.library import Library, library_of
from sdfcheck.files.packages import Packages, is_of_ros_2
from sdfcheck.files.regular import read_regular
from sdfcheck.formats.near_names import nearest, suggest_in
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.srdf import naming, references, srdf
from sdfcheck.robot.naming.occurrences import Occurrence, Symbol, steps
from sdfcheck.robot.root import root_of
from sdfcheck.robot.values import lazy
from sdfcheck.source.document import Document, Element, read
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import HEAD, Kind, sniff
from sdfcheck.source.text import Source, is_expression, pattern
from sdfcheck.xacro.language import may_become

if TYPE_CHECKING:
    from sdfcheck.robot.controllers import Mistyped, MoveItFiles
    from sdfcheck.robot.graph import Joint, Link, Model
    from sdfcheck.robot.motion.origin import Origin
    from sdfcheck.source.document import Element, Value
    from sdfcheck.source.text import Span


VIRTUAL_TYPES = ("fixed", "floating", "planar")
ROOT_JOINT = "root_joint"
"""What Pinocchio calls the joint of a floating robot, which no URDF has."""

_MOST_LINKS_OF_GROUPS = 10_000_000
"""So many steps are worth it to know the links of all groups: PR2's take 5,000."""
_COUNTS = {"revolute": 1, "continuous": 1, "prismatic": 1, "planar": 3, "floating": 7}


_CLOSE = 1e-3
"""So far apart (rad or m), a joint and its place are the same."""
_IN = 0.1
"""Of the surface of a link: so much may be inside of another one where the points are few."""
_TOUCH = 0.002
"""m: fingers that are closed touch, and numbers are rounded."""
_MOST_STATES, _MOST_MOVED, _MOST_JOINTS, _MOST_COMPARED = 20, 60, 500, 50
"""States, links, joints, and pairs of surfaces, that are looked at for collisions."""
_MOST_BETWEEN = 3
"""Joints between two parts of a gripper."""
_MOST_SENT = 50
"""So many controllers of MoveIt are compared with the groups."""
_NAMED = r"<{}\s[^<>]*?\bname\s*=\s*[\"']([^\"']*)[\"']"
"""A link or joint in a branch of xacro that the arguments do not take."""


_PROPERTIES = {
    "angular_distance_weight": ("planar", "floating"),
    "min_translational_distance": ("planar",),
    "motion_model": ("planar",),
}
"""What MoveIt reads of a joint beside URDF → the types of joints that have it."""
_MOTION_MODELS = ("holonomic", "diff_drive")


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
        self.chained: Mapping[str, bool] = {}
        """The groups whose solver is that of KDL, which solves chains, and whether it looks at positions alone."""
        self.beside: Mapping[str, Path] = {}
        """The files of MoveIt's parameters in its package of ROS 2, by name, if it is the only SRDF file there."""

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
        robot = self.robots[0] if len(self.robots) == 1 and not any(self._unfound) else None
        if any(each.name == "group" for each in self.faulty):
            robot = None
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
            new = self._direct_groups(name) - seen
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
    def branched_chains(self) -> Iterator[tuple[Value, str, str]]:
        """The groups whose solver is for chains and whose joints branch: their name, and two such joints."""
        above = {joint.child_name: joint for robot in self.robots for joint in robot.joints}
        for name, group in self.groups.items():
            value, links = group.attribute("name"), self.links_of.get(name, frozenset())
            if name not in self.chained or value is None:
                continue
            first: dict[str, str] = {}
            for link in sorted(link for link in links if link in above):
                joint = above[link]
                before = _before(joint, links, above)
                other = first.setdefault(before, joint.name)
                if other != joint.name:
                    yield value, other, joint.name
                    break

    @property
    def short_chains(self) -> Iterator[tuple[Value, int]]:
        """The groups that are solved as arms for places and directions, and have too few joints for both, or none."""
        branched = {value.text.strip() for value, _, _ in self.branched_chains}
        for name, is_for_places in self.chained.items():
            value = self.groups[name].attribute("name") if name in self.groups else None
            if value is None or is_for_places or name in branched or name not in self.links_of:
                continue
            joints = [each for each in self.robots[0].joints if each.child_name in self.links_of[name]]
            moved = [each for each in joints if _is_driven(each)]
            if self.links_of[name] and all(each.type in _UNSOLVED for each in joints):
                yield value, 0
            elif _SHORTEST <= len(moved) < _WHOLE and all(each.type in _PLAIN for each in moved):
                yield value, len(moved)

    @lazy
    def parameters(self) -> MoveItFiles:
        """The content of the files of MoveIt's parameters beside it."""
        from sdfcheck.robot.controllers import LARGEST, MoveItFiles, moveit_files

        texts = {}
        for name, path in self.beside.items():
            try:
                text = read_regular(path, LARGEST).decode("utf-8-sig")
            except (OSError, UnicodeDecodeError):
                continue
            texts[name] = Source(path, text, is_foreign=True)
        return moveit_files(texts) if texts else MoveItFiles()

    @property
    def mistyped(self) -> tuple[Mistyped, ...]:
        """The limits of joints in a file beside it that are of another type than MoveIt declares."""
        return self.parameters.mistyped

    @property
    def _parameterized(self) -> Model | None:
        """The robot whose joints those files name, where that is certain."""
        return self.robots[0] if len(self.robots) == 1 and self.beside and not any(self._unfound) else None

    @property
    def unlimited_joints(self) -> Iterator[tuple[Value, Sequence[str], Span]]:
        """The groups with joints whose acceleration nothing limits: their name, these joints, and the file's place."""
        robot, limits = self._parameterized, self.parameters.limits
        if self.parameters.release == "humble":
            return
        known = {each.name for each in limits if each.content}
        if robot is None or not any(each.name in robot.joints_by_name for each in limits):
            return
        for name, links in self.links_of.items():
            value = self.groups[name].attribute("name")
            moved = (each for each in robot.joints if each.child_name in links and _is_driven(each))
            left = [each.name for each in moved if each.name not in known and not _has_acceleration(each)]
            if value is not None and left:
                yield (
                    value,
                    left,
                    next((each.span for each in limits if each.name == left[0]), limits[0].span),
                )

    @property
    def unmatched_parameters(self) -> Iterator[tuple[str, Span]]:
        """Words about each name in the files of MoveIt's parameters that is not there, and its place."""
        robot, files = self._parameterized, self.parameters
        yield from self._strange_limits
        solved = {each.name for each in files.solvers}
        left = [
            name for name in self.groups if name not in solved and self.groups[name].find("chain") is not None
        ]
        for each in files.solvers:
            if left and each.name not in self.groups and not is_expression(each.name):
                yield f"has a solver for group `{each.name}`, and group `{left[0]}` has none", each.span
        for sent in files.sent:
            unknown = (each for each in sent.joints if robot and each.content not in robot.joints_by_name)
            other = files.started_instead(sent)
            if robot is not None and (lost := next(unknown, None)) is not None:
                yield f"sends joint `{lost.content}`, which {robot.title} does not have", lost.span
            elif other:
                words = f"the controller of these joints in `ros2_controllers.yaml` is `{other}`"
                yield f"sends trajectories to `{sent.own_name}`, and {words}", sent.name.span
        yield from ((each.words, each.span) for each in files.misspelled)
        yield from self._strange_to_servo
        yield from self._left_joints
        yield from self._wider_limits

    @property
    def _strange_limits(self) -> Iterator[tuple[str, Span]]:
        """Words about limits of joints that are not there: of all, or of those with nearly the name of another one."""
        robot = self._parameterized
        limits = [each for each in self.parameters.limits if not is_expression(each.name)]
        if robot is None or not limits:
            return
        unknown = [each for each in limits if each.name not in robot.joints_by_name]
        words = f"which {robot.title} does not have"
        if len(unknown) == len(limits):
            more = f" (and {len(limits) - 1} more)" * (len(limits) > 1)
            yield f"limits joint `{limits[0].name}`, {words}{more}", limits[0].span
            return
        known = {each.name for each in limits}
        left = [name for name in robot.joints_by_name if name not in known]
        for each in unknown:
            if (near := nearest(each.name, left, self.document)) is not None:
                yield f"limits joint `{each.name}`, {words}; there is `{near}`", each.span

    @property
    def _wider_limits(self) -> Iterator[tuple[str, Span]]:
        """Words about the first bound in a file that is beyond that of the joint, and how many more there are."""
        robot = self._parameterized
        found = []
        for name, bound in self.parameters.allowed if robot is not None else ():
            joint = robot.joints_by_name.get(name) if robot is not None else None
            limit = joint.axis.limit if joint is not None and joint.axis_count == 1 else None
            if joint is None or limit is None or not limit.is_given:
                continue
            own = {"max_velocity": limit.velocity, "min_position": limit.lower}.get(bound.name, limit.upper)
            is_kept = own.number > 0 if bound.name == "max_velocity" else limit.range[0] > -inf
            excess = (own.number - bound.number) * (1 if bound.name == "min_position" else -1)
            if is_kept and excess > _SLACK * max(1.0, abs(own.number)):
                found.append(
                    (f"has `{bound.name}` {bound.content} for {joint.title}, which has {own.text}", bound)
                )
        for words, bound in found[:1]:
            yield f"{words} in the robot{f' (and {len(found) - 1} more)' if found[1:] else ''}", bound.span

    @property
    def _strange_to_servo(self) -> Iterator[tuple[str, Span]]:
        """Words about the group or link that MoveIt's servo is to move and that is not there: the first."""
        robot = self._parameterized
        if robot is None:
            return
        for each in self.parameters.servo:
            is_group = each.name == "move_group_name"
            known = self.groups if is_group else names(robot, "link")
            if each.content not in known:
                what = "group" if is_group else "link"
                yield f"names {what} `{each.content}` in `{each.name}`, which is not there", each.span
                return

    @property
    def _left_joints(self) -> Iterator[tuple[str, Span]]:
        """Words about joints of groups that no controller of MoveIt has, while one has their others."""
        robot, files = self._parameterized, self.parameters
        if robot is None:
            return
        passive = {each.attributes.get("name", "").strip() for each in self.element.children("passive_joint")}
        above = {joint.child_name: joint.name for joint in robot.joints if _is_driven(joint)}
        moved = {
            name: {above[link] for link in links if link in above} for name, links in self.links_of.items()
        }
        for sent in files.sent[:_MOST_SENT]:
            if not sent.is_of_trajectories or any(
                each.content not in robot.joints_by_name for each in sent.joints
            ):
                continue
            own = {each.content for each in sent.joints} | passive
            for name, joints in moved.items():
                left = sorted(joints - files.handled - passive)
                if left and 2 * len(own & joints) > len(joints):
                    words = f"sends no joint `{left[0]}` to a controller, which group `{name}` moves with the others"
                    yield f"{words} of `{sent.own_name}`", sent.joints[0].span
                    break

    @property
    def adjacent_pairs(self) -> Iterator[Element]:
        """The pairs of links that it calls neighbors, whose collisions it switches off."""
        for each in self.element.children("disable_collisions"):
            if each.attributes.get("reason", "").strip().lower() == "adjacent":
                yield each

    @lazy
    def _paired(self) -> Model | None:
        """The robot whose neighbors it calls so, where all links, and all pairs, are read that it names."""
        is_misread = any(each.name.startswith("disable") for each in self.faulty)
        is_known = len(self.robots) == 1 and any(self.adjacent_pairs) and not any(self._unfound)
        return self.robots[0] if is_known and not is_misread else None

    @property
    def bare_robot(self) -> Model | None:
        """Its robot, if there is something to see of it and nothing that collides."""
        robot = self.robots[0] if len(self.robots) == 1 and not any(self._unfound) else None
        if robot is None or not any(link.has("visual") for link in robot.links):
            return None
        solid = (
            each.has("collision") or each.misnamed("collision") or each.switches_off("collision")
            for each in robot.links
        )
        return None if any(solid) else robot

    @property
    def unlisted_neighbors(self) -> Iterator[tuple[Link, Link]]:
        """Neighbors whose collisions may touch and stay on, where those of other neighbors are off.

        MoveIt checks pairs of which a group moves a link.
        """
        robot = self._paired
        if robot is None:
            return
        known: dict[str, Link | None] = {}
        for link in robot.links:
            above = _solid_above(link, known) if link.collisions else None
            if above is not None and self._is_checked(above, link) and not above.distance_to(link):
                yield above, link

    @lazy
    def unlisted_overlaps(self) -> tuple[tuple[Link, Link], ...]:
        """Links near one another that are in each other with all joints at 0, and whose collisions stay on.

        The collisions of both with other links are off. Neighbors are left out, and what is farther along an arm or on
        another one, for that may start elsewhere.
        """
        robot = self._paired
        if robot is None or len(robot.joints) > _MOST_JOINTS:
            return ()
        listed, above = frozenset[str]().union(*self._pairs_off), _moving_above(robot)
        solid = [link for link in robot.links if link.collisions and link.name in listed and link in above]
        neighbors = {frozenset(pair) for pair in self.unlisted_neighbors}
        near = (
            (one, other)
            for one, other in combinations(solid[:_MOST_MOVED], 2)
            if _are_beside(above[one], above[other])
            and frozenset((one, other)) not in neighbors
            and all(_rests_at_zero(robot.joints_by_name[name]) for name in above[one] ^ above[other])
            and self._is_checked(one, other)
            and not one.distance_to(other)
        )
        return tuple((one, other) for one, other in islice(near, _MOST_COMPARED) if one.is_in(other, _IN))

    @property
    def colliding_states(self) -> Iterator[tuple[Value, Link, Link]]:
        """The names of states in which two links are in each other whose collisions stay on, and these.

        The joints between them are all those of the state, or follow them.
        """
        for value, one, other, poses in islice(self._near_in_states, _MOST_COMPARED):
            if one.is_in(other, _IN, poses):
                yield value, one, other

    @property
    def _near_in_states(self) -> Iterator[tuple[Value, Link, Link, Mapping[Link, Origin]]]:
        """The names of states, two links whose collisions stay on and that may touch there, and where these are."""
        robot = self._paired
        solid = [link for link in robot.links if link.collisions] if robot is not None else []
        if robot is None or len(solid) > _MOST_MOVED or len(robot.joints) > _MOST_JOINTS:
            return
        found = {frozenset(pair) for pair in chain(self.unlisted_neighbors, self.unlisted_overlaps)}
        above = _moving_above(robot)
        pairs = [
            (one, other, above[one] ^ above[other])
            for one, other in combinations([link for link in solid if link in above], 2)
            if frozenset((one, other)) not in found and self._is_checked(one, other)
        ]
        for state in islice(self.element.children("group_state"), _MOST_STATES) if pairs else ():
            value, places = state.attribute("name"), self._places_in(state, robot)
            within = [(one, other) for one, other, between in pairs if between and between <= places.keys()]
            poses = robot.poses_with(places) if value is not None and within else {}
            for one, other in within:
                near = _near(one, other, poses)
                if value is not None and near:
                    yield value, one, other, near

    def _places_in(self, state: Element, robot: Model) -> dict[str, float]:
        """Joint → where it is in a state, those that follow others among them."""
        places = {
            each.attributes.get("name", "").strip(): value.number
            for each in state.children("joint")
            if (value := each.attribute("value")) is not None and _is_number(value.text)
        }
        for joint in robot.joints:
            mimic = joint.axis.mimic if joint.axis_count == 1 else None
            if mimic is not None and mimic.leader_name in places:
                places[joint.name] = mimic.multiplier.number * places[mimic.leader_name] + mimic.offset.number
        return places

    @lazy
    def _pairs_off(self) -> set[frozenset[str]]:
        return {
            frozenset(each.attributes.get(end, "").strip() for end in ("link1", "link2"))
            for each in self.element.children("disable_collisions")
        }

    @lazy
    def _links_off(self) -> set[str]:
        return {
            each.attributes.get("link", "") for each in self.element.children("disable_default_collisions")
        }

    def _is_checked(self, one: Link, other: Link) -> bool:
        """Does MoveIt look for collisions between two links?"""
        names = {one.name, other.name}
        is_off = frozenset(names) in self._pairs_off or bool(names & self._links_off)
        return not is_off and bool(self.groups_of.keys() & names)

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
    def partial_states(self) -> Iterator[tuple[Value, Sequence[str]]]:
        """The names of states that say nothing of some joints that their group moves, and these."""
        driven: dict[str, list[str]] = {}
        for state in self.element.children("group_state"):
            value, group = state.attribute("name"), state.attributes.get("group", "").strip()
            given = {joint.attributes.get("name", "").strip() for joint in state.children("joint")}
            if value is None or group not in self.links_of or state in self.faulty:
                continue
            if given <= {ROOT_JOINT} or any(map(is_expression, given)):
                continue
            if group not in driven:
                moved = (each for each in self.robots[0].joints if each.child_name in self.links_of[group])
                driven[group] = [joint.name for joint in moved if _is_driven(joint)]
            if left := [name for name in driven[group] if name not in given]:
                yield value, left

    @property
    def unfollowed(self) -> Iterator[tuple[StateValue, str, float]]:
        """The values of joints that follow others, with the leader, and where its value in the state takes them."""
        given = {
            (v.state, v.joint.attributes.get("name", "").strip()): v.value.number for v in self.state_values
        }
        for state in self.state_values:
            joint = self.joint_of(state)
            mimic = joint.axis.mimic if joint is not None and joint.axis_count == 1 else None
            leader = given.get((state.state, mimic.leader_name)) if mimic is not None else None
            if mimic is not None and leader is not None:
                place = mimic.multiplier.number * leader + mimic.offset.number
                if abs(place - state.value.number) > _CLOSE:
                    yield state, mimic.leader_name, place

    @property
    def unknown_virtual_types(self) -> Iterator[Value]:
        """The types of virtual joints that srdfdom does not know."""
        for joint in self.element.children("virtual_joint"):
            value = joint.attribute("type")
            text = "fixed" if value is None else value.text.strip().lower()
            if value is not None and text not in VIRTUAL_TYPES and not is_expression(text):
                yield value

    @property
    def refused_properties(self) -> Iterator[tuple[Value, Collection[str]]]:
        """What MoveIt does not take of the properties of joints, and what it could be instead."""
        for each in self.element.children("joint_property"):
            joint, name, value = map(each.attribute, ("joint_name", "property_name", "value"))
            if (
                joint is None
                or name is None
                or value is None
                or any(map(is_expression, each.attributes.values()))
            ):
                continue
            types = _PROPERTIES.get(name.text.strip(), ())
            is_model = name.text.strip() == "motion_model"
            if not types:
                yield name, _PROPERTIES
            elif (kind := self._type_of(joint.text.strip())) and kind not in types:
                yield joint, types
            elif value.text not in _MOTION_MODELS if is_model else not _is_number(value.text):
                yield value, _MOTION_MODELS if is_model else ("a number",)

    def _type_of(self, joint: str) -> str:
        """The type of a joint, of the robot or its own; empty where that is not certain."""
        types = {robot.joints_by_name[joint].type for robot in self.robots if joint in robot.joints_by_name}
        return self.virtual_joints.get(joint, "") or (types.pop() if len(types) == 1 else "")

    @property
    def unbuilt_groups(self) -> Iterator[tuple[Value, str]]:
        """The groups that MoveIt leaves out although each of their parts is known, and why; of a circle the first."""
        is_nested = any(group.has("group") for group in self.groups.values())
        in_circle = self._group_in_circle if is_nested else None
        for name, group in self.groups.items():
            value = group.attribute("name")
            if value is not None and all(_has_no_joint(part) for part in group.children()):
                yield value, "has no joints"
            elif value is not None and name == in_circle:
                yield value, "is a part of itself"

    @property
    def _group_in_circle(self) -> str | None:
        """The first group of a circle in which each one is a part of the next."""
        from graphlib import CycleError, TopologicalSorter

        parts = {name: self._direct_groups(name) for name in self.groups}
        try:
            TopologicalSorter(parts).prepare()
        except CycleError as error:
            circle = set(error.args[1])
            return next(name for name in parts if name in circle)
        return None

    def _direct_groups(self, group: str) -> frozenset[str]:
        """The groups that a group names as its parts."""
        inner = (each.attributes.get("name", "").strip() for each in self.groups[group].children("group"))
        return frozenset(each for each in inner if each in self.groups)

    @property
    def lacking(self) -> Iterator[tuple[Element, str]]:
        """The elements without an attribute that they need, or with an empty one where MoveIt asks for a text."""
        for part, definition in self.parts:
            for name in definition.required_attributes:
                value = part.attribute(name)
                if (part, name) in self.misspelled_attributes:
                    continue
                if value is None or (name == "parent_frame" and not value.text):
                    yield part, name

    @lazy
    def misspelled(self) -> tuple[tuple[Element, str], ...]:
        """The elements that srdfdom does not read, each with the name of one that it would read there."""
        return tuple(
            (each, near)
            for holder, definition in self.parts
            for each in holder.children()
            if each.name not in definition.children and ":" not in each.name
            if (near := suggest_in(self.document, each.name, definition.children))
        )

    @lazy
    def misspelled_attributes(self) -> Mapping[tuple[Element, str], tuple[Value, bool]]:
        """Element and attribute that srdfdom would read → the one in its place, and whether the element needs it."""
        found: dict[tuple[Element, str], tuple[Value, bool]] = {}
        for part, definition in self.parts:
            unknown = [
                each for each in part.attributes if each not in definition.attributes and ":" not in each
            ]
            left = [each for each in definition.attributes if unknown and each not in part.attributes]
            for name in unknown:
                near, value = suggest_in(self.document, name, left), part.attribute(name)
                if near is not None and value is not None:
                    found[part, near] = value, near in definition.required_attributes
        return found

    @lazy
    def faulty(self) -> frozenset[Element]:
        """The elements that srdfdom does not read as they are meant, and those around them."""
        found = chain(self.misspelled, self.misspelled_attributes, self.lacking)
        return frozenset(each for element, _ in found for each in (element, *element.around)) - {self.element}

    @lazy
    def references(self) -> tuple[NamedPart, ...]:
        """The names of links and joints of the robot, and of groups."""
        return tuple(
            NamedPart(kind, value)
            for part, definition in self.parts
            for name, kind in naming(definition)
            if (value := part.attribute(name)) is not None
            and (value.text.strip() or definition.attributes[name].required)
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
        """The names that no robot has which the file may be about, whatever its arguments are."""
        for part in self._unfound:
            pattern, name = _NAMED.format(part.kind), part.value.text.strip()
            if not any(robot.document.may_name(pattern, name) for robot in self.robots):
                yield part

    @property
    def _unfound(self) -> Iterator[NamedPart]:
        """The names that none of the robots has as it is expanded."""
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
        """The names of groups that it does not define; those of groups that lost their name are not known."""
        if any(each.name == "group" and "name" not in each.attributes for each in self.faulty):
            return
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


def _solid_above(link: Link, known: dict[str, Link | None]) -> Link | None:
    """The nearest link above another one that has collisions; ``known``: those above links without any."""
    passed, above = [], _parent(link)
    while above is not None and not above.collisions and above.name not in known:
        passed.append(above.name)
        known[above.name] = None  # where joints form a circle, nothing is above
        above = _parent(above)
    found = known[above.name] if above is not None and not above.collisions else above
    known.update(dict.fromkeys(passed, found))
    return found if found is not link else None


def _moving_above(robot: Model) -> dict[Link, frozenset[str]]:
    """Link → the names of the joints above it that are not fixed."""
    tree = robot.tree
    found: dict[Link, frozenset[str]] = {}
    waiting = [(root, frozenset[str]()) for root in tree.roots]
    while waiting:
        link, names = waiting.pop()
        found[link] = names
        for joint in tree.children.get(link, ()):
            child = joint.child_link
            if child is not None and tree.parents[child][0] is joint:
                waiting.append((child, names if joint.is_fixed else names | {joint.name}))
    return found


def _near(one: Link, other: Link, poses: Mapping[Link, Origin]) -> Mapping[Link, Origin]:
    """The poses of two links, a little farther apart; none where the balls around their shapes do not meet."""
    balls = []
    for link in (one, other):
        if link not in poses or (box := link.extent) is None:
            return {}
        x, y, z = box.center
        balls.append((poses[link].applied_to((x, y, z)), box.diagonal / 2))
    (here, near), (there, far) = balls
    apart = dist(here, there)
    if not 0 < apart < near + far:
        return {}
    pose = poses[other]
    x, y, z = (at + _TOUCH * (b - a) / apart for at, a, b in zip(pose.position, here, there, strict=True))
    return {one: poses[one], other: pose._replace(position=(x, y, z))}


def _are_beside(one: frozenset[str], other: frozenset[str]) -> bool:
    """Is there one joint between two links at most, of those above them, or a few, and none is above the other?"""
    between = len(one ^ other)
    return between <= 1 or (between <= _MOST_BETWEEN and not (one <= other or other <= one))


def _rests_at_zero(joint: Joint) -> bool:
    """Is a joint at 0 where MoveIt starts?"""
    mimic = joint.axis.mimic if joint.axis_count == 1 else None
    if joint.axis_count != 1 or (mimic is not None and mimic.offset.number != 0):
        return False
    low, high = joint.axis.limit.range
    return low <= 0 <= high


def _has_acceleration(joint: Joint) -> bool:
    """Does URDF limit its acceleration, as its newer versions can?"""
    return any(limit.attribute("acceleration") is not None for limit in joint.element.children("limit"))


_SLACK = 0.01
"""Of a bound, or rad, m, rad/s or m/s: rounded figures are no findings."""
_SHORTEST, _WHOLE = 3, 6
"""Joints of an arm, and those that it takes to reach a place in any direction."""
_UNSOLVED = frozenset(("fixed", "floating", "planar"))
_PLAIN = frozenset(("continuous", "prismatic", "revolute"))


def _is_driven(joint: Joint) -> bool:
    """Does it move, and follow no other joint?"""
    return joint.type != "fixed" and not (joint.axis_count == 1 and joint.axis.mimic is not None)


def _parent(link: Link) -> Link | None:
    return link.parent_joints[0].parent_link if link.parent_joints else None


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


def _has_no_joint(part: Element) -> bool:
    """Is a part of a group a chain from a link to itself?"""
    ends = [part.attributes.get(end, "").strip() for end in ("base_link", "tip_link")]
    return part.name == "chain" and bool(ends[0]) and ends[0] == ends[1] and not is_expression(ends[0])


def _before(joint: Joint, links: Collection[str], above: Mapping[str, Joint]) -> str:
    """The link of a group whose joint is before one, but for joints that are fixed; empty if there is none."""
    link, steps_left = joint.parent_name, len(above)
    while link not in links and link in above and above[link].type == "fixed" and steps_left:
        link, steps_left = above[link].parent_name, steps_left - 1
    return link if link in links and link in above else ""


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


# The names in SRDF: its own, and those of the links and joints of the robot that it is about.


def own_kind(element: Element) -> str:
    """The kind of thing to which an element of SRDF gives its name; empty where it names what is elsewhere.

    A virtual joint is a joint. States of two groups may have one name, so that their kinds differ.
    """
    if element.name == "group_state":
        return f"state of {element.attributes.get('group', '').strip() or 'no group'}"
    is_group = element.name == "group" and (element.parent is None or element.parent.name != "group")
    return _KINDS.get(element.name, "") if is_group or element.name != "group" else ""


_KINDS = {"group": "group", "virtual_joint": "joint", "end_effector": "end effector"}


def semantic_names(semantics: Semantics, wanted: Collection[str] | None = None) -> Iterator[Occurrence]:
    """Every place that names something, also in elements of others; the parts of the robot have no definition.

    ``wanted``: only the places with one of these names.
    """
    known: dict[tuple[str, str], Symbol] = {}
    for element in semantics.element.children():
        value, kind = element.attribute("name"), own_kind(element)
        if kind and value is not None and value.text.strip():
            span, name = steps(value)[0][0], value.text.strip()
            yield Occurrence(span, known.setdefault((kind, name), Symbol(kind, name, span)), True)
    named = references()
    for element in semantics.document.elements:
        for attribute, text in element.attributes.items():
            kind = named.get((element.name, attribute), "")
            if not kind or (wanted is not None and text.strip() not in wanted):
                continue
            value = element.attribute(attribute)
            if value is None or (attribute == "name" and own_kind(element)):
                continue
            span, name = steps(value)[0][0], value.text.strip()
            symbol = known.get((kind, name))
            if symbol is not None or (name and not is_expression(name)):
                yield Occurrence(span, symbol or Symbol(kind, name, span))


# The robots that an SRDF file may be about: those of its name, in the project around it.

MOST_FILES = 1000
MOST_ROBOTS = 6
"""So many files of a project are looked at, and so many robots compared."""
_MOST_GUESSES = 20
"""So many files are expanded because an expression may give the name of the robot."""

_ROBOT = pattern(r"<robot\b[^>]*?\sname\s*=\s*[\"']([^\"']*)[\"']")
_DECLARED = pattern(
    r"^ *urdf:[ \r]*\n *package: *([\w.-]+)[ \r]*\n *relative_path: *([\w./-]+)", re.IGNORECASE | re.MULTILINE
)
_DECLARED_FILE = pattern(r"^ *srdf:[ \r]*\n *relative_path: *([\w./-]+)", re.IGNORECASE | re.MULTILINE)
_GIVEN = pattern(r"^ *xacro_args: *(.*(?:\n(?! *\w+:[^=]).*)*)", re.MULTILINE)
_ARGUMENT = pattern(r"(\w+):=(?:\"([^\"]*)\"|'([^']*)'|([^\s\"']*))")
_FOR_CHAINS = "kdl_kinematics_plugin/KDLKinematicsPlugin"
_NO_ARGUMENTS: Mapping[str, str] = {}
_FEWEST = 0.5
"""A robot is not the one that is meant if it has fewer of the names."""

Expand = Callable[[Document, Mapping[str, str]], "Document | None"]
"""Expands a robot with some arguments."""


def find_robots(semantics: Semantics, expand: Expand | None) -> None:
    """Find the robots that an SRDF file may be about; ``expand`` expands xacro.

    They have the name of the file and most of what it names: the robot for which MoveIt's assistant made the file, or
    else those in the package of the file, and if there is none in the project around it. Without one, the robot that
    has it all in a file of the package that is called like the SRDF file. Where the robots of its name in the package
    have nothing of what it names they are its ``strangers``; where the package has robots of other names only, one
    that has it all is its ``namesake``.
    """
    library = library_of(semantics.document)
    if library is None or not semantics.name or not semantics.named:
        return
    path, is_complete = semantics.document.path, True
    own = Packages(_package(path))
    files = list(own.files(".yaml", MOST_FILES))
    solvers = [file for file in files if file.name == "kinematics.yaml"]
    semantics.beside = _beside(path, own, files)
    semantics.has_kinematics = bool(solvers)
    semantics.chained = _chained(solvers)
    if _is_elsewhere(path, library.packages(path)):
        return
    for robot in _declared_robots(semantics, library, expand):
        if robot is not None and (score := _score(semantics, robot)) >= _FEWEST:
            semantics.robots = (robot,) if score == 1 else _extended(semantics, robot, own, expand)
            return
        is_complete &= robot is not None
    for packages in (own, library.packages(path)):
        candidates = list(_candidates(semantics, packages, expand))
        is_complete &= None not in candidates
        scored = [(_score(semantics, robot), robot) for robot in candidates if robot is not None]
        if _is_decided(semantics, scored, own, is_complete=is_complete):
            return
        if packages is own and scored and max(scored, key=itemgetter(0))[0] == 0:
            semantics.strangers = tuple(robot for _, robot in scored)
    if not semantics.strangers:
        alike = _called_alike(semantics, own)
        semantics.robots = () if alike is None else (alike,)
        semantics.namesake = _declared_namesake(semantics, library, expand) or _namesake(semantics, own)


def _beside(path: Path, own: Packages, files: Sequence[Path]) -> Mapping[str, Path]:
    """The files of MoveIt's parameters in the package of an SRDF file, if each is the only one of its kind."""
    srdf = [
        each
        for suffix in (".srdf", ".xacro")
        for each in own.files(suffix, MOST_FILES)
        if ".srdf" in each.name
    ]
    if len(srdf) > 1 or not is_of_ros_2(path):
        return {}
    from sdfcheck.robot.controllers import MOVEIT_FILES, SERVO

    named: dict[str, list[Path]] = {}
    for file in files:
        name = SERVO if "servo" in file.name else file.name
        if name in MOVEIT_FILES:
            named.setdefault(name, []).append(file)
    return {name: found[0] for name, found in named.items() if len(found) == 1}


def _chained(solvers: Sequence[Path]) -> Mapping[str, bool]:
    """The groups for which MoveIt's only file of solvers names that of KDL, and whether it is for positions alone."""
    try:
        text = read_regular(solvers[0]).decode("utf-8", "replace") if len(solvers) == 1 else ""
    except OSError:
        return {}
    group, found = "", dict[str, bool]()
    places = set()
    for line in text.splitlines():
        key, colon, value = (part.strip() for part in line.partition("#")[0].partition(":"))
        if key == "kinematics_solver" and value.strip("\"'") == _FOR_CHAINS:
            found[group] = False
        elif key == "position_only_ik" and value.strip("\"'").lower() == "true":
            places.add(group)
        elif colon and not value:
            group = key.strip("\"'")
    return {name: name in places for name in found}


def _extended(semantics: Semantics, meant: Model, own: Packages, expand: Expand | None) -> tuple[Model, ...]:
    """The robot in the package of the file, which may add parts to that for which MoveIt's assistant made it.

    It is not known where one of them cannot be expanded.
    """
    candidates = list(_candidates(semantics, own, expand, but=meant.document.path))
    if None in candidates:
        return ()
    return (max((meant, *filter(None, candidates)), key=lambda robot: _score(semantics, robot)),)


def _is_decided(
    semantics: Semantics, scored: Sequence[tuple[float, Model]], own: Packages, *, is_complete: bool
) -> bool:
    """Take the robots with most of the names, unless another one may be meant; is the search at its end?"""
    best = max((score for score, _ in scored), default=0.0)
    if 0 < best < 1 and (alike := _called_alike(semantics, own, above=best)) is not None:
        semantics.robots = (alike,)  # the name was copied with another file
        return True
    if best < 1 and not is_complete:
        return True  # the robot that is meant may be the one that cannot be expanded
    if best >= _FEWEST:
        semantics.robots = tuple(robot for score, robot in scored if score == best)
        return True
    return False


def _declared_robots(semantics: Semantics, library: Library, expand: Expand | None) -> Iterator[Model | None]:
    """The robots of its name for which MoveIt's assistant made the file; None for each that cannot be expanded."""
    path = semantics.document.path
    for meant in declared(path, library.packages(path)):
        if (head := _own_head(meant.path, semantics)) is not None:
            yield _robot(meant.path, head, semantics, expand, meant.arguments)


def _is_elsewhere(path: Path, packages: Packages) -> bool:
    """Did MoveIt's assistant make the file for a robot that no file of the project is called like?"""
    found = _DECLARED.search(_declaration(path))
    if found is None:
        return False
    meant = Path(found[2])
    return not any(file.name == meant.name for file in packages.files(meant.suffix, MOST_FILES))


def _called_alike(semantics: Semantics, packages: Packages, above: float = 0.99) -> Model | None:
    """The robot of another name in the nearest URDF file called like the SRDF file, if it has enough of the names."""
    for path in files_of_robots(semantics.document, packages, (".urdf",)):
        if path.stem == semantics.document.path.stem:
            head = _head(path, semantics)
            robot = None if head is None else _robot(path, head, semantics, None)
            if robot is not None and robot.name != semantics.name and _score(semantics, robot) > above:
                return robot
    return None


def _declared_namesake(semantics: Semantics, library: Library, expand: Expand | None) -> Model | None:
    """The robot of another name that has all that a file names, for which MoveIt's assistant made the file."""
    path = semantics.document.path
    for meant in declared(path, library.packages(path)):
        head = _head(meant.path, semantics)
        if head is None or is_expression(head.name) or head.name == semantics.name:
            continue
        robot = _robot(meant.path, head, semantics, expand, meant.arguments)
        if robot is not None and robot.name == head.name and _score(semantics, robot) == 1:
            return robot
    return None


def _namesake(semantics: Semantics, packages: Packages) -> Model | None:
    """The URDF robot of another name that has all that a file names, where no robot may have its name."""
    heads: dict[Path, _Head] = {}
    for path in files_of_robots(semantics.document, packages, (".urdf", ".xacro")):
        head = _head(path, semantics)
        if head is not None:
            heads[path] = head
            if head.name == semantics.name or is_expression(head.name) or len(heads) > MOST_ROBOTS:
                return None
    robots = [_robot(path, head, semantics, None) for path, head in heads.items() if head.kind is Kind.URDF]
    fitting = [robot for robot in robots if robot is not None and _score(semantics, robot) == 1]
    if len(fitting) != 1 or _is_anothers(fitting[0].document.path, semantics.document.path):
        return None
    return fitting[0]


def _is_anothers(robot: Path, semantics: Path) -> bool:
    """Whether another SRDF file is called like a robot's file, beside it."""
    beside = robot.with_name(f"{_stem(robot)}.srdf")
    return beside != semantics and os.path.isfile(beside)


def descriptions_of(semantics: Semantics) -> Iterator[Document]:
    """The documents of robots that an SRDF file may be about, as they are written.

    First the one for which MoveIt's assistant made the file, then those that are called like the file or have the
    name of its robot, the nearest first.
    """
    library = library_of(semantics.document)
    if library is None or not semantics.name:
        return
    path = semantics.document.path
    meant = [each.path for each in declared(path, library.packages(path))]
    stem, seen = _stem(path), set[Path]()
    for file in chain(meant, _alike_first(semantics, library)):
        head = _head(file, semantics) if file not in seen else None
        seen.add(file)
        is_alike = file in meant or _stem(file) == stem
        if head is None or not (is_alike or may_become(head.name, semantics.name)):
            continue
        if (found := library.document(file, head.kind, semantics.document)) is not None:
            yield found


class Declared(NamedTuple):
    """The file of the robot for which MoveIt's assistant made a package, and the arguments with which it expands."""

    path: Path
    arguments: dict[str, str]


def declared(path: Path, packages: Packages) -> list[Declared]:
    """The robot that the settings of MoveIt's assistant name in the package of a file."""
    text = _declaration(path)
    found = _DECLARED.search(text)
    folder = packages.find(found[1], path) if found is not None else None
    if found is None or folder is None:
        return []
    given = _GIVEN.search(text)
    arguments = _ARGUMENT.findall(given[1]) if given is not None else []
    return [Declared(folder / found[2], {name: "".join(values) for name, *values in arguments})]


def _declaration(path: Path) -> str:
    """The settings of MoveIt's assistant in the package of a file, if they are about it."""
    settings = _package(path) / ".setup_assistant"
    try:
        text = read_regular(settings).decode("utf-8", "replace") if os.path.isfile(settings) else ""
    except OSError:
        return ""
    own = _DECLARED_FILE.search(text)
    is_other = own is not None and path.suffix == ".srdf" and path.name != os.path.basename(own[1])
    if own is not None and is_other and os.path.isfile(settings.parent / own[1]):
        return ""  # they are about the robot of that file
    return text


class Assistants:
    """The robots for which MoveIt's assistant made the packages of a project."""

    def __init__(self, packages: Packages) -> None:
        files = packages.files(".setup_assistant", MOST_FILES)
        self.declared = [each for path in files for each in declared(path, packages)]

    def arguments(self, path: Path) -> list[dict[str, str]]:
        """The arguments with which packages expand a robot, each once."""
        found = [each.arguments for each in self.declared if each.arguments and each.path == path]
        return [one for number, one in enumerate(found) if one not in found[:number]]


def _alike_first(semantics: Semantics, library: Library) -> Iterator[Path]:
    """The files that may hold robots, in the package and in the project; first those that are called alike."""
    path = semantics.document.path
    for packages in (Packages(_package(path)), library.packages(path)):
        files = files_of_robots(semantics.document, packages, (".urdf", ".xacro"))
        yield from sorted(files, key=lambda file: _stem(file) != _stem(path))


def _stem(path: Path) -> str:
    return path.name.partition(".")[0]


def _package(path: Path) -> Path:
    """The folder of the package that a file is in, else its own."""
    folders = path.absolute().parents
    return next((folder for folder in folders if os.path.isfile(folder / "package.xml")), folders[0])


def _score(semantics: Semantics, robot: Model) -> float:
    """The share of the names that a robot has."""
    known = {kind: names(robot, kind) for kind in ("link", "joint")}
    asked = [part for part in semantics.named if not semantics.is_added(part)]
    return sum(part.value.text.strip() in known[part.kind] for part in asked) / max(len(asked), 1)


def _candidates(
    semantics: Semantics, packages: Packages, expand: Expand | None, but: Path | None = None
) -> Iterator[Model | None]:
    """The robots of its name that have links, ``but`` that of a file; None for each that cannot be expanded."""
    found = guesses = 0
    suffixes = (".urdf", ".xacro") if expand is not None else (".urdf",)
    for path in files_of_robots(semantics.document, packages, suffixes):
        if found == MOST_ROBOTS:
            return
        head = _own_head(path, semantics) if path != but else None
        if head is None:
            continue
        guesses += is_expression(head.name)
        if guesses > _MOST_GUESSES:
            yield None  # another one may be meant
            return
        robot = _robot(path, head, semantics, expand)
        if robot is not None and robot.name != semantics.name:
            continue  # an expression gives another name
        if robot is None or robot.links:
            found += robot is not None
            yield robot


def files_of_robots(document: Document, packages: Packages, suffixes: tuple[str, ...]) -> list[Path]:
    """The files that may hold robots, the nearest first."""
    library = library_of(document)
    listed = {} if library is None else library.view(packages, _listed)
    for suffix in suffixes:
        if suffix not in listed:
            files = packages.files(suffix, MOST_FILES)
            listed[suffix] = [path for path in files if ".srdf" not in path.name]
    found = [path for suffix in suffixes for path in listed[suffix]]
    own = document.path.absolute().parts

    def distance(path: Path) -> tuple[int, str]:
        parts = path.absolute().parts
        same = next(
            (n for n, pair in enumerate(zip(own, parts, strict=False)) if pair[0] != pair[1]), len(own)
        )
        return len(own) + len(parts) - 2 * same, path.as_posix()

    return sorted(found, key=distance)


def _listed(_: Packages) -> dict[str, list[Path]]:
    """Suffix → the files that may hold robots, listed once."""
    return {}


class _Head(NamedTuple):
    """The name of the robot that a file describes, the kind of the file, and its content."""

    name: str
    kind: Kind
    data: bytes


def _head(path: Path, semantics: Semantics) -> _Head | None:
    """The beginning of a file, read; None where it describes no robot or cannot be read."""
    library = library_of(semantics.document)
    try:
        data = library.read(path, semantics.document) if library is not None else b""
    except OSError:
        return None
    match = _ROBOT.search(data[:8192].decode("utf-8", "replace"))
    is_xacro = path.suffix == ".xacro" or b"<xacro:" in data
    if match is None or sniff(data[:HEAD], path) is Kind.SRDF:
        return None
    return _Head(match[1], Kind.XACRO if is_xacro else Kind.URDF, data)


def _own_head(path: Path, semantics: Semantics) -> _Head | None:
    """The beginning of a file that describes a robot of the name, or of one that an expression gives."""
    head = _head(path, semantics)
    is_own = head is not None and (head.name == semantics.name or is_expression(head.name))
    return head if is_own else None


def _robot(
    path: Path,
    head: _Head,
    semantics: Semantics,
    expand: Expand | None,
    arguments: Mapping[str, str] = _NO_ARGUMENTS,
) -> Model | None:
    """The robot of a file; None where it cannot be expanded."""
    kind = head.kind
    document: Document | None = read(head.data, path, kind)
    assert document is not None
    document.library = semantics.document.library
    if kind is Kind.XACRO:
        document = expand(document, arguments) if expand is not None else None
        if document is not None:
            document.library = semantics.document.library
    if document is None or document.root is None or document.root.name != "robot":
        return None
    return root_of(document).scopes[0]  # type: ignore[return-value]
