"""Links that became part of another when URDF was converted, as links again.

That conversion leaves marks (:mod:`sdfcheck.convert.writer`). Where inertials were summed up, and the sum has been
changed since, its parts are not known any more, and the links stay together.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Container, Iterator, Mapping, Sequence

import numpy as np

from sdfcheck.convert.include_expansion import finish
from sdfcheck.convert.writer import INERTIAL, JOINT, LINK, MERGED, NONE, NOTHING, PARENT, WAS, numbers
from sdfcheck.formats.sdf.values import number
from sdfcheck.robot.graph import Model
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mass import MassProperties
from sdfcheck.robot.motion.mechanism import Mechanism
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import Array, inverse, to_rpy, written_pose
from sdfcheck.robot.root import root_of
from sdfcheck.source.altered import Altered, Xml
from sdfcheck.source.document import Document, Element
from sdfcheck.source.errors import DescriptionError

# Links that became part of another when URDF was converted, as links again.
#
# That conversion leaves marks (:mod:`sdfcheck.convert.writer`). Where inertials were summed up, and the sum
# has been changed since, its parts are not known any more, and the links stay together.


_MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_EQUAL = 1e-9


def is_marked(document: Document) -> bool:
    """Has a document frames that were links?"""
    return document.root is not None and any(map(_was_link, document.root.walk()))


def _was_link(element: Element) -> bool:
    return element.name == "frame" and JOINT in element.attributes and PARENT in element.attributes


_Survivor = tuple[Element | None, str]
"""A model, and a link of it that others became part of."""


def separated(document: Document) -> Document:
    """The document with those frames as links and joints; itself where that is not known."""
    kept: set[_Survivor] = set()
    while True:
        try:
            made = _Separation(document, kept)
        except (DescriptionError, PoseError):
            return document
        if not made.survivors:
            return document
        changed = set(made.unequal())
        if not changed:
            return made.document
        kept |= changed


class _Separation:
    """A document in which the links that became part of others are apart; those in ``kept`` stay as they are."""

    def __init__(self, document: Document, kept: Container[_Survivor]) -> None:
        self.before, self.document = document, Altered(document)
        self.survivors: dict[_Survivor, list[str]] = {}
        assert self.document.root is not None
        for model in [element for element in self.document.root.walk() if element.name == "model"]:
            self._separate(model, kept)
        finish(self.document)

    def _separate(self, model: Xml, kept: Container[_Survivor]) -> None:
        frames, links = _by_name(model, "frame"), _by_name(model, "link")
        parts: dict[str, dict[str, Xml]] = {}
        """Link → what became part of it, by name."""
        for name, frame in frames.items():
            if not _was_link(frame):
                continue
            joint, parent = frame.attributes[JOINT], frame.attributes[PARENT]
            survivor = frame.attributes.get("attached_to", "")
            if (
                survivor in links
                and (model.origin, survivor) not in kept
                and joint in frames
                and joint != name
                and frames[joint].attributes.get("attached_to") == survivor
                and (parent in links or (parent in frames and parent not in {name, joint}))
            ):
                parts.setdefault(survivor, {})[name] = frame
                _to_joint(frames[joint], name, parent)
        for survivor, own in parts.items():
            self.survivors[model.origin, survivor] = list(own)
            for one in own.values():
                _to_link(one)
            _take_apart(links[survivor], own)
        _restore_names(model, {name for own in parts.values() for name in own})

    def unequal(self) -> Iterator[_Survivor]:
        """The links whose mass is not that of their parts, as far as both are known."""
        for before, after in zip(_models(self.before), _models(self.document), strict=True):
            own = [one for one in self.survivors if one[0] is before.element]
            try:
                whole, apart = (mechanism_of(before), mechanism_of(after)) if own else (None, None)
            except (DescriptionError, PoseError):
                yield from own
                continue
            for one in own:
                if whole is None or apart is None or not _is_sum(whole, apart, one[1], self.survivors[one]):
                    yield one


def _by_name(model: Xml, kind: str) -> dict[str, Xml]:
    """The parts of a model of one kind whose names nothing else of that kind has."""
    named = [(one.attributes.get("name", ""), one) for one in model.children(kind)]
    counts = Counter(name for name, _ in named)
    return {name: one for name, one in named if name and counts[name] == 1}


def _restore_names(model: Xml, apart: Container[str]) -> None:
    """Let joints and plugins name the links that are apart again."""
    for part in model.walk():
        end = part.find("parent") if part.name == "joint" else None
        if end is not None and end.attributes.get(LINK) in apart:
            end.write(end.attributes.pop(LINK))
        if part.name == "plugin" and any(one.attributes.get(WAS, "") in apart for one in part.children()):
            _as_before(part)


def _as_before(plugin: Xml) -> None:
    """Give the parameters of a plugin the texts that they had."""
    for part in [part for part in plugin.children() if WAS in part.attributes]:
        before = part.attributes.pop(WAS)
        if before == NONE:
            plugin.remove(part)
        else:
            part.write(before)


def _models(document: Document) -> list[Model]:
    return list(root_of(document).each(Model))


def _to_joint(frame: Xml, child: str, parent: str) -> None:
    """The frame that a fixed joint has left becomes the joint."""
    place = _pose(frame)
    frame.name = "joint"
    frame.attributes = {
        "name": frame.attributes["name"],
        "type": "fixed",
        MERGED: "true",
        **{name: text for name, text in frame.attributes.items() if ":" in name},
    }
    frame.insert(0, place, Xml("parent", parent), Xml("child", child))


def _pose(frame: Xml) -> Xml:
    """The pose of a frame, which is in what it is attached to where it says nothing else."""
    pose = frame.find("pose")
    if pose is None:
        pose = Xml("pose", "0 0 0 0 0 0")
    else:
        frame.remove(pose)
    pose.attributes.setdefault("relative_to", frame.attributes.get("attached_to", ""))
    return pose


def _to_link(frame: Xml) -> None:
    place, inertial = _pose(frame), frame.find(INERTIAL)
    frame.name = "link"
    frame.attributes = {
        name: text for name, text in frame.attributes.items() if name not in {JOINT, PARENT, "attached_to"}
    }
    frame.insert(0, place)
    if inertial is None:
        frame.insert(1, _none())
    else:
        inertial.name = "inertial"


def _none() -> Xml:
    """The inertial of a link that URDF gives none."""
    made = Xml("inertial", **{NOTHING: "true"})
    made.add("mass", "0")
    moments = made.add("inertia")
    for name in _MOMENTS:
        moments.add(name, "0")
    return made


def _take_apart(link: Xml, apart: Mapping[str, Xml]) -> None:
    """Give the links what was theirs."""
    for part in link.children():
        owner = apart.get(part.attributes.get(LINK, ""))
        if owner is not None:
            link.remove(part)
            del part.attributes[LINK]
            pose = part.find("pose")
            if part.name in {"visual", "collision"} or pose is not None:
                _place_in(part, pose, link, owner)
            owner.append(part)
    own, total = link.find(INERTIAL), link.find("inertial")
    if own is None and not any(map(_has_mass, apart.values())):
        return
    if total is not None:
        link.remove(total)
    if own is None:
        link.append(_none())
    else:
        own.name = "inertial"


def _has_mass(link: Xml) -> bool:
    inertial = link.find("inertial")
    mass = inertial.find("mass") if inertial is not None else None
    return mass is not None and number(mass.content) != 0


def _place_in(part: Xml, pose: Xml | None, link: Xml, owner: Xml) -> None:
    """Say where a part is in its own link, which has a pose in the one that it was in."""
    place = owner.find("pose")
    assert place is not None
    offset = _matrix(place)
    if (pose is not None and pose.attributes.get("relative_to")) or np.array_equal(offset, np.eye(4)):
        return
    here = inverse(offset) @ (_matrix(pose) if pose is not None else np.eye(4))
    made = Xml("pose", numbers((*here[:3, 3], *to_rpy(here[:3, :3]))))
    if pose is not None:
        part.put(made)
        made.origin = pose.origin
    else:
        part.insert(0, made)


def _matrix(pose: Xml) -> Array:
    return np.eye(4) if pose.origin is None else written_pose(pose.origin)


def _is_sum(before: Mechanism, after: Mechanism, survivor: str, names: Sequence[str]) -> bool:
    if survivor not in before.links or not after.links.keys() >= {survivor, *names}:
        return False
    whole = before.links[survivor].body
    total: MassProperties | None = None
    for name in (survivor, *names):
        link = after.links[name]
        if link.body is None:
            continue
        seen = link.body.seen_from(inverse(after.links[survivor].pose) @ link.pose)
        total = seen if total is None else total.joined_with(seen)
    if whole is None or total is None:
        return whole is total
    return all(
        np.allclose(one, other, rtol=_EQUAL, atol=_EQUAL)
        for one, other in (
            (whole.mass, total.mass),
            (whole.center, total.center),
            (whole.moments, total.moments),
        )
    )
