"""How the links of one model hang together by its joints."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from sdfcheck.robot.values import lazy

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Model
    from sdfcheck.robot.parts.joint import Joint
    from sdfcheck.robot.parts.link import Link


class Tree:
    """The links of a model and the joints between two different ones of them.

    Links and joints are those of the model itself, in the order of the file; of several
    links of one name the first counts. In URDF one whose name is yet to be expanded is left out.
    """

    def __init__(self, model: Model) -> None:
        self.model = model
        self.links: dict[str, Link] = {}
        """Name → link."""
        is_name: Callable[[str], bool] = _is_name_in_urdf if model.is_urdf else bool
        for link in model.links:
            if is_name(link.name):
                self.links.setdefault(link.name, link)
        self.joints: tuple[Joint, ...] = model.joints
        """All joints, those that tie nothing as well."""
        self.children: dict[Link, list[Joint]] = {}
        """Link → the joints that lead on from it."""
        self.parents: dict[Link, list[Joint]] = {}
        """Link → the joints that lead to it: more than one is a mistake, or closes a loop."""
        for joint in self.joints:
            if (ends := self.ends(joint)) is not None:
                self.children.setdefault(ends[0], []).append(joint)
                self.parents.setdefault(ends[1], []).append(joint)

    def ends(self, joint: Joint) -> tuple[Link, Link] | None:
        """The links at the ends of a joint, if they are two."""
        parent, child = joint.parent_link, joint.child_link
        return None if parent is None or child is None or parent is child else (parent, child)

    @property
    def roots(self) -> list[Link]:
        """The links to which no joint leads, in the order of the file."""
        return [link for link in self.links.values() if link not in self.parents]

    def below(self, *links: Link) -> Iterator[Link]:
        """The links and all links below them, each once, even where joints lead round in a circle."""
        seen = set(links)
        waiting = list(reversed(links))
        while waiting:
            at = waiting.pop()
            yield at
            for joint in reversed(self.children.get(at, [])):
                child = joint.child_link
                if child is not None and child not in seen:
                    seen.add(child)
                    waiting.append(child)

    @lazy
    def main_roots(self) -> list[Link]:
        """The roots in the largest group: more than one where a link has several parents."""
        main = set(self.groups[0]) if self.links else ()
        return [link for link in self.roots if link in main]

    def top(self, group: list[Link]) -> Link:
        """The root of a group, or its first link where joints lead round in a circle."""
        return next((link for link in group if link not in self.parents), group[0])

    @lazy
    def loose_groups(self) -> list[list[Link]]:
        """The groups except the largest, unless mistakes in as many joints explain them."""
        others = self.groups[1:]
        if not others:
            return []
        broken = sum(self.ends(joint) is None for joint in self.joints) + len(self.loops())
        if len(others) <= broken:
            return []
        meant = set(self._meant_children())
        return [group for group in others if not meant.intersection(group)]

    def _meant_children(self) -> Iterator[Link]:
        """The links to which joints lead, or would if their ends were spelled right."""
        from sdfcheck.formats.near_names import suggest_in

        for joint in self.joints:
            name = joint.child_name
            if self.ends(joint) is not None or not name:
                continue
            meant = name if name in self.links else suggest_in(self.model.document, name, self.links)
            if meant is not None:
                yield self.links[meant]

    @lazy
    def groups(self) -> list[list[Link]]:
        """The links, grouped by what joints tie together: the largest group first, then by place."""
        tied: dict[Link, list[Link]] = {}
        for joints in self.children.values():
            for joint in joints:
                if (ends := self.ends(joint)) is not None:
                    tied.setdefault(ends[0], []).append(ends[1])
                    tied.setdefault(ends[1], []).append(ends[0])
        groups: list[list[Link]] = []
        seen: set[Link] = set()
        for link in self.links.values():
            if link in seen:
                continue
            seen.add(link)
            group = [link]
            for member in group:
                fresh = [other for other in dict.fromkeys(tied.get(member, ())) if other not in seen]
                seen.update(fresh)
                group += fresh
            groups.append(group)
        return sorted(groups, key=len, reverse=True)

    def loops(self) -> list[list[Joint]]:
        """Joints that lead round in a circle, going up from each link by the first joint that leads to it.

        Each begins with its first joint in the order of the file.
        """
        return loops(self.parents, self.joints)


def parents_in(joints: Iterable[Joint]) -> dict[Link, list[Joint]]:
    """Link → the joints that carry it: those whose parent moves with something else, or is the world.

    The links may be of several models. A gearbox carries nothing: it couples what others carry.
    """
    found: dict[Link, list[Joint]] = {}
    for joint in joints:
        child, parent = joint.child_link, joint.parent
        if child is None or parent is None or joint.type == "gearbox":
            continue
        if (carrier := parent.carrier) is not None and carrier is not child:
            found.setdefault(child, []).append(joint)
    return found


def loops(parents: Mapping[Link, Sequence[Joint]], joints: Iterable[Joint]) -> list[list[Joint]]:
    """The same for any links and the joints that lead to them, given in the order of the file."""
    found: list[list[Joint]] = []
    done: set[Link] = set()
    order = {joint: number for number, joint in enumerate(joints)}
    for start in parents:
        path: list[Joint] = []
        on_path: dict[Link, int] = {}
        link: Link | None = start
        while link is not None and link not in done and link not in on_path and link in parents:
            on_path[link] = len(path)
            path.append(parents[link][0])
            link = path[-1].parent_link
        if link is not None and link in on_path:
            ring = path[on_path[link] :][::-1]
            first = min(range(len(ring)), key=lambda number: order[ring[number]])
            found.append(ring[first:] + ring[:first])
        done.update(on_path)
    return found


def _is_name_in_urdf(name: str) -> bool:
    from sdfcheck.source.text import is_expression

    return bool(name) and not is_expression(name)
