"""The links and joints of a URDF robot, and how they hang together."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Iterator

from sdfcheck.formats.suggest import suggest, suggest_in
from sdfcheck.formats.urdf.survey import survey
from sdfcheck.formats.urdf.table import is_expression, urdf
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value
from sdfcheck.source.record import NamedTuple

MOVING = frozenset({"revolute", "continuous", "prismatic", "planar", "floating"})


class UrdfJoint(NamedTuple):
    """A joint as written; ``parent`` and ``child`` are None where there is no name of a link."""

    element: Element
    name: str
    type: str
    parent: Value | None
    child: Value | None


class UrdfTree:
    """Links by name and joints in document order, with what the names make of them.

    Of links of one name the first counts. Joints whose ends do not both name a link, or
    name the same one, are in ``joints`` and ``joint_named``, but in no other view.
    """

    __slots__ = (
        "children",
        "document",
        "doubled",
        "joint_named",
        "joints",
        "links",
        "nameless",
        "parents",
        "roots",
        "unknown_ends",
    )

    def __init__(self, document: Document) -> None:
        self.document = document
        surveyed = survey(document)
        self.links: dict[str, Element] = {}
        self.nameless = 0
        """How many links are not among ``links``: without name, with one that xacro should have made, or called
        otherwise than ``link`` by a slip."""
        self.doubled = 0
        """How many have the name of one before."""
        for link in surveyed.top("link"):
            name = link.attributes.get("name", "")
            if not name or is_expression(name):
                self.nameless += 1
            else:
                self.doubled += self.links.setdefault(name, link) is not link
        root = surveyed.root
        self.nameless += sum(
            suggest(child.name, ("joint", "link")) == "link"
            for child in (root.children() if root is not None else ())
            if child.name not in urdf().children
        )
        self.joints = [_joint(element) for element in surveyed.top("joint")]
        self.joint_named: dict[str, UrdfJoint] = {}
        self.children: defaultdict[str, list[UrdfJoint]] = defaultdict(list)
        """Link → the joints that lead on from it."""
        self.parents: defaultdict[str, list[UrdfJoint]] = defaultdict(list)
        """Link → the joints that lead to it: more than one is a mistake."""
        for joint in self.joints:
            self.joint_named.setdefault(joint.name, joint)
            if (ends := self.ends(joint)) is not None:
                self.children[ends[0]].append(joint)
                self.parents[ends[1]].append(joint)
        self.unknown_ends: defaultdict[str, list[Value]] = defaultdict(list)
        """The names that joints give and no link has, with the places where they stand."""
        for joint in self.joints:
            for value in (joint.parent, joint.child):
                if value is not None and value.text not in self.links and not is_expression(value.text):
                    self.unknown_ends[value.text].append(value)
        self.roots = [name for name in self.links if name not in self.parents]
        """The links that no joint leads to, in document order."""

    def ends(self, joint: UrdfJoint) -> tuple[str, str] | None:
        """The names of parent and child, if they are two links of the robot."""
        if joint.parent is None or joint.child is None:
            return None
        parent, child = joint.parent.text, joint.child.text
        if parent == child or parent not in self.links or child not in self.links:
            return None
        return parent, child

    def missed(self) -> set[str]:
        """The unknown names that are those of links which have lost them."""
        if len(self.unknown_ends) <= self.nameless:
            return set(self.unknown_ends)
        if not self.doubled:
            return set()
        # What is like the name of a link may be a slip of its own, a double has lost any name.
        unlike = {name for name in self.unknown_ends if suggest_in(self.document, name, self.links) is None}
        return unlike if len(unlike) <= self.nameless + self.doubled else set()

    def misnamed(self) -> dict[str, str]:
        """Names on which several ends of joints agree → the link, named by none, that they mean."""
        agreed = {name: ends for name, ends in self.unknown_ends.items() if len(ends) > 1}
        if not agreed:
            return {}
        named = {value.text for joint in self.joints for value in (joint.parent, joint.child) if value}
        free = [name for name in self.links if name not in named]
        found = {
            name: meant for name in agreed if (meant := suggest_in(self.document, name, free)) is not None
        }
        times = Counter(found.values())
        return {name: meant for name, meant in found.items() if times[meant] == 1}

    def below(self, link: str) -> Iterator[str]:
        """The link and all links below it, each once, even where joints lead round in a circle."""
        seen = {link}
        waiting = [link]
        while waiting:
            name = waiting.pop()
            yield name
            for joint in reversed(self.children.get(name, [])):
                assert joint.child is not None
                if joint.child.text not in seen:
                    seen.add(joint.child.text)
                    waiting.append(joint.child.text)

    def parts(self) -> list[list[str]]:
        """The links, grouped by what joints tie together: the largest group first, then by place."""
        tied: defaultdict[str, list[str]] = defaultdict(list)
        for joints in self.children.values():
            for joint in joints:
                assert joint.parent is not None
                assert joint.child is not None
                tied[joint.parent.text].append(joint.child.text)
                tied[joint.child.text].append(joint.parent.text)
        groups: list[list[str]] = []
        seen: set[str] = set()
        for name in self.links:
            if name in seen:
                continue
            seen.add(name)
            group = [name]
            for member in group:
                fresh = [other for other in dict.fromkeys(tied.get(member, ())) if other not in seen]
                seen.update(fresh)
                group += fresh
            groups.append(group)
        return sorted(groups, key=len, reverse=True)

    def loops(self) -> list[list[UrdfJoint]]:
        """Joints that lead round in a circle, going up from each link by the first joint that leads to it."""
        found: list[list[UrdfJoint]] = []
        done: set[str] = set()
        for name in self.links:
            path: list[UrdfJoint] = []
            on_path: dict[str, int] = {}
            link = name
            while link not in done and link not in on_path and link in self.parents:
                on_path[link] = len(path)
                path.append(self.parents[link][0])
                assert path[-1].parent is not None
                link = path[-1].parent.text
            if link in on_path:
                found.append(path[on_path[link] :][::-1])
            done.update(on_path)
            done.add(link)
        return found


def tree(document: Document) -> UrdfTree:
    """The tree of a document, made once."""
    return document.view(UrdfTree)


def _joint(element: Element) -> UrdfJoint:
    attributes = element.attributes
    name, kind = attributes.get("name", ""), attributes.get("type", "")
    return UrdfJoint(element, name, kind, _end(element, "parent"), _end(element, "child"))


def _end(element: Element, name: str) -> Value | None:
    end = element.find(name)
    value = None if end is None else end.attribute("link")
    return value if value is not None and value.text else None
