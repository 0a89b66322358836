"""Links of a URDF robot: their names, whether they are one tree, and where mass is missing."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from sdfcheck.formats.suggest import suggest_in
from sdfcheck.formats.urdf.survey import UrdfSurvey, survey
from sdfcheck.robot.robot_problems import (
    DisconnectedLink,
    MasslessMovingLink,
    MisnamedLink,
    RootWithInertia,
    SeveralRoots,
    VanishingRoot,
)
from sdfcheck.robot.urdf_tree import MOVING, UrdfTree, tree
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

_KEEPS = frozenset({"preserveFixedJoint", "disableFixedJointLumping"})
_TRUE = frozenset({"true", "yes", "1"})
_ODD = re.compile(r"::|\A__|\A\s*\Z")


def problems(document: Document) -> Iterator[object]:
    """Everything wrong with names and links of a URDF document, in no particular order."""
    surveyed = survey(document)
    if surveyed.root is None:
        return
    yield from _names(surveyed, surveyed.root)
    robot = tree(document)
    if not robot.links:
        return
    misnamed = robot.misnamed()
    for name, link in misnamed.items():
        value = robot.links[link].attribute("name")
        assert value is not None
        yield MisnamedLink(value, name, tuple(robot.unknown_ends[name]))
    parts = robot.parts()
    yield from _parts(robot, parts)
    yield from _masses(robot, surveyed, set(parts[0]))


def _names(surveyed: UrdfSurvey, root: Element) -> Iterator[object]:
    if (robot_name := root.attribute("name")) is not None and not robot_name.text.strip():
        from sdfcheck.formats.sdf.problems import EmptyName

        yield EmptyName(robot_name)
    given = [
        (kind, value)
        for kind in ("link", "joint", "material")
        for element in surveyed.top(kind)
        if (value := element.attribute("name")) is not None
    ]
    shared = {("" if kind == "joint" else kind.replace("link", ""), value.text) for kind, value in given}
    if len(shared) == len(given) and not any(_ODD.search(name) for _, name in shared):
        return
    from sdfcheck.formats.sdf.problems import EmptyName
    from sdfcheck.robot.names import ClashingName, DuplicateName

    taken: dict[tuple[str, str], Value] = {}
    for kind, value in given:
        name = value.text
        if not name.strip():
            yield EmptyName(value)
            continue
        earlier = taken.setdefault((kind, name), value)
        if earlier is not value:
            yield DuplicateName(value, earlier, root, name, kind)
        elif kind == "joint" and ("link", name) in taken:
            yield ClashingName(
                value, taken["link", name], root, name, "joint", "link", makes_frame=True, renamed=False
            )
        if kind != "material":
            yield from _unfit_for_sdformat(value)


def _unfit_for_sdformat(value: Value) -> Iterator[object]:
    """Names that are nothing special in URDF, and that libsdformat refuses in what it makes of it."""
    from sdfcheck.robot.names import DelimiterInName, ReservedName

    name = value.text
    if len(name) >= 4 and name.startswith("__") and name.endswith("__"):
        yield ReservedName(value)
    if "::" in name:
        yield DelimiterInName(value, refused=True, foreign=None)


def _parts(robot: UrdfTree, parts: list[list[str]]) -> Iterator[object]:
    """Links that are not tied to the rest, unless mistakes in as many joints explain it."""
    main, *others = parts
    broken = sum(robot.ends(joint) is None for joint in robot.joints) + len(robot.loops())
    if len(others) <= broken:
        return
    astray = set(_meant_children(robot))
    top = robot.links[_top(robot, main)]
    for group in others:
        if astray.intersection(group):
            continue
        name = _top(robot, group)
        if len(group) > 1:
            yield SeveralRoots(robot.links[name], top, len(group))
        else:
            yield DisconnectedLink(robot.links[name], top)


def _meant_children(robot: UrdfTree) -> Iterator[str]:
    """The links that joints lead to, or would if their ends were spelt right."""
    for joint in robot.joints:
        if robot.ends(joint) is not None or joint.child is None:
            continue
        child = joint.child.text
        if child in robot.links:
            yield child
        elif (meant := suggest_in(joint.element.document, child, filter(None, robot.links))) is not None:
            yield meant


def _top(robot: UrdfTree, group: Iterable[str]) -> str:
    """The root of a group of links, or its first link where joints lead round in a circle."""
    names = list(group)
    return next((name for name in names if name not in robot.parents), names[0])


def _masses(robot: UrdfTree, surveyed: UrdfSurvey, main: set[str]) -> Iterator[object]:
    masses = {name: _mass(link) for name, link in robot.links.items()}
    kept = _kept(surveyed)
    heavy = _with_lumped(robot, {name for name, mass in masses.items() if _is_mass(mass)}, kept)
    for root in robot.roots:
        if root not in main:
            continue  # that it is apart is worse
        link = robot.links[root]
        if root == "world":
            tops = [joint.child.text for joint in robot.children.get(root, ()) if joint.child is not None]
        else:
            tops = [root]
            inertial = link.find("inertial")
            if inertial is not None and _is_mass(masses[root]) and robot.children.get(root):
                yield RootWithInertia(link, inertial)
        for top in tops:
            members = list(robot.below(top))
            if top not in heavy:
                massless = not any(_is_mass(masses[name]) for name in members)
                yield VanishingRoot(robot.links[top], len(members), massless)
                if massless:
                    continue
            below = [name for name in members if name != top]
            yield from _apart(robot, masses, [name for name in below if name not in heavy], kept)


def _apart(
    robot: UrdfTree, masses: dict[str, Value | None], light: list[str], kept: set[str]
) -> Iterator[object]:
    """The links without mass that are not merged into the one above."""
    for name in light:
        joint = robot.parents[name][0]
        if joint.type in MOVING or joint.name in kept:
            lost = sum(1 for _ in robot.below(name))
            yield MasslessMovingLink(robot.links[name], joint.element, masses[name], lost)


def _with_lumped(robot: UrdfTree, heavy: set[str], kept: set[str]) -> set[str]:
    """The links that have mass once libsdformat has merged those that fixed joints tie to them."""
    found = set(heavy)
    waiting = list(heavy)
    while waiting:
        name = waiting.pop()
        for joint in robot.parents.get(name, ()):
            assert joint.parent is not None
            parent = joint.parent.text
            if joint.type == "fixed" and parent != "world" and joint.name not in kept and parent not in found:
                found.add(parent)
                waiting.append(parent)
    return found


def _kept(surveyed: UrdfSurvey) -> set[str]:
    """The fixed joints that libsdformat is told to keep."""
    found = set()
    for block in surveyed.index.get("gazebo", ()):
        for child in block.children():
            if child.name in _KEEPS:
                value = child.attribute("value") or child.own_value
                if value.text.lower() in _TRUE:
                    found.add(block.attributes.get("reference", ""))
    return found


def _mass(link: Element) -> Value | None:
    inertial = link.find("inertial")
    mass = inertial.find("mass") if inertial is not None else None
    return mass.attribute("value") if mass is not None else None


def _is_mass(value: Value | None) -> bool:
    """Whether there is mass; what is no number, or negative, is somebody else's business."""
    return value is not None and value.number != 0
