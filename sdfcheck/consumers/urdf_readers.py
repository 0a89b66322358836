"""Reactions of the consumers of URDF, and of Drake, to a part that cannot be read as it is.

It depends on the place: urdfdom drops links in part and refuses joints, MuJoCo looks at no visual
but at its material, Drake ignores controllers. Checked by taking attributes and elements
away, and by misspelling values, with urdfdom 3.0, libsdformat 17, Drake 1.51, MuJoCo 4.0, PyBullet 3.2
and the converter of Isaac Sim 0.3.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from math import isfinite, isnan
from pathlib import Path

from sdfcheck.consumers.reaction import REFUSES, Consumer, Reaction, accepts, drops, refuses, warns
from sdfcheck.formats.urdf.schema import extension, urdf
from sdfcheck.source.document import Document, Element, Value
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

_NAMING = frozenset(("name", "link", "joint", "type", "reference", "filename"))
_FREE = frozenset(("transmission", "gazebo", "ros2_control"))
_UNREAD = accepts("does not read it")
_AS_IT_IS = warns("takes it as it is")
_OF_SPRINGS = frozenset(("spring_reference", "spring_stiffness"))
_ASIDE = frozenset(("safety_controller", "calibration"))
_NUMBER = r"[-+]?(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?"
_NUMBERS = re.compile(rf"(?:{_NUMBER}\s+)*{_NUMBER}(?![\d.eE])\S+")
"""Numbers, of which the last one is followed by something else."""
_HEXADECIMAL = re.compile(r"[-+]?0[xX][0-9a-fA-F]+")
_FIELDS = {"xyz": 3, "rpy": 3, "size": 3, "scale": 3, "rgba": 4, "quat_xyzw": 4}
"""Attribute → how many numbers it has, where these are several."""


_NEEDED_BY_ISAAC = {
    "robot": ("name", "link"),
    "link": ("name",),
    "joint": ("name", "type", "parent", "child"),
    "parent": ("link",),
    "child": ("link",),
    "sphere": ("radius",),
    "cylinder": ("radius", "length"),
    "mimic": ("joint",),
    "material": ("name",),
}
"""Element → the attributes and elements without which the converter of Isaac Sim (0.3.4) refuses the file."""


_SOLE = {
    "Drake": frozenset({Consumer.DRAKE}),
    "PyBullet": frozenset({Consumer.PYBULLET}),
    "MuJoCo": frozenset({Consumer.MUJOCO}),
    "nobody": frozenset(),
}
"""The consumers behind the names of the table, where these are about all that read an element."""
_NO_REST = drops("the rest of the link")
_WITHOUT_IT = warns("builds the robot without it")


def unreadable(at: Element | Value) -> Mapping[Consumer, Reaction]:
    """Reactions to a value that is malformed, or to a part that is missing; none in SDFormat."""
    element = at.element if isinstance(at, Value) else at
    if element.document.kind is Kind.SDF:
        return {}
    place = _place(element)
    if "gazebo" in place:
        parent = element.parent
        is_setting = parent is not None and parent.name == "gazebo" and element.name in extension().children
        return {Consumer.GAZEBO: refuses("crashes")} if is_setting else {}
    urdfdom = _urdfdom(place)
    found = {Consumer.URDFDOM: urdfdom, Consumer.GAZEBO: urdfdom, Consumer.DRAKE: REFUSES}
    found[Consumer.MUJOCO] = _UNREAD if is_unread_by_mujoco(at) else REFUSES
    if isinstance(at, Value) and (element.name, at.attribute, at.text) == ("joint", "type", "spherical"):
        found |= dict.fromkeys((Consumer.MUJOCO, Consumer.PYBULLET), accepts("makes a ball joint of it"))
    if isinstance(at, Value):
        found.update(_otherwise_read(at, found[Consumer.MUJOCO]))
    if place & _ASIDE:
        found[Consumer.DRAKE] = _UNREAD
    elif isinstance(at, Value) and at.attribute in _OF_SPRINGS:
        found.update(dict.fromkeys((Consumer.URDFDOM, Consumer.GAZEBO, Consumer.DRAKE), _UNREAD))
        found[Consumer.MUJOCO] = warns("takes no spring")
    if isinstance(at, Value) and element.name == "axis" and len(at.text.split()) < _FIELDS["xyz"]:
        found[Consumer.PYBULLET] = REFUSES
    if "inertial" in place and element.name != "inertia" and (reason := _needs_mass(element)):
        found[Consumer.GAZEBO] = refuses(f"refuses the file, for {reason}")
    return found | _ignoring(element)


def _ignoring(element: Element) -> dict[Consumer, Reaction]:
    """That others do not read it, where it is, or is in, an element that some consumers alone know.

    Nor do many what a joint has that does not move, or in more ways than one.
    """
    joint = element.parent
    if joint is not None and joint.name == "joint":
        return dict.fromkeys(_AT_REST.get((joint.text_of("type"), element.name), ()), _UNREAD)
    definition = urdf()
    for name in [element.name, *(each.name for each in element.around)][-2::-1]:
        if name not in definition.children:
            break
        definition = definition.children[name]
        if definition.consumers and all(each in _SOLE for each in definition.consumers):
            known = frozenset[Consumer]().union(*(_SOLE[each] for each in definition.consumers))
            return dict.fromkeys((one for one in Consumer if one not in known), _UNREAD)
    return {}


_AT_REST: Mapping[tuple[str | None, str], tuple[Consumer, ...]] = {
    ("fixed", "axis"): (Consumer.URDFDOM, Consumer.GAZEBO, Consumer.DRAKE, Consumer.PYBULLET),
    ("fixed", "limit"): (Consumer.DRAKE, Consumer.MUJOCO),
    ("fixed", "dynamics"): (Consumer.DRAKE, Consumer.MUJOCO),
    ("fixed", "mimic"): (Consumer.MUJOCO,),
    ("floating", "axis"): (Consumer.URDFDOM, Consumer.DRAKE, Consumer.PYBULLET),
    ("floating", "limit"): (Consumer.DRAKE,),
    ("floating", "dynamics"): (Consumer.DRAKE,),
}
"""The type of a joint and an element in it → who does not read that there."""


def _otherwise_read(value: Value, mujoco: Reaction) -> Mapping[Consumer, Reaction]:
    """Reactions to what some take for a number, and urdfdom does not."""
    words = value.text.split()
    if value.attribute == "scale" and re.fullmatch(_NUMBER, value.text.strip()):
        return {Consumer.DRAKE: accepts("takes it for all three axes")}
    if value.attribute in _NAMING or len(words) != _FIELDS.get(value.attribute or "", 1):
        return {}
    try:
        numbers = [float(word) for word in words]
    except ValueError:
        found = _begun(value)
    else:
        found = _IN_BLANKS if all(map(isfinite, numbers)) else _not_finite(value, words, numbers)
    if mujoco == REFUSES:
        return found
    return {consumer: reaction for consumer, reaction in found.items() if consumer is not Consumer.MUJOCO}


_IN_BLANKS = dict.fromkeys(
    (Consumer.DRAKE, Consumer.ISAAC, Consumer.MUJOCO), accepts("ignores the blank after it")
)


def _begun(value: Value) -> Mapping[Consumer, Reaction]:
    """Reactions to what begins with a number, such as ``1kg`` and ``0x10``."""
    name, text = value.element.name, value.text.strip()
    is_hexadecimal = _HEXADECIMAL.fullmatch(text) is not None
    found, number = {}, re.match(_NUMBER, text)
    if number and _NUMBERS.fullmatch(text) and not (name == "cylinder" and float(number[0]) <= 0):
        found[Consumer.DRAKE] = warns("reads the number at its beginning")
    if is_hexadecimal and name != "inertia":
        found[Consumer.MUJOCO] = warns("reads the hexadecimal number")
    return found


def _not_finite(value: Value, words: Sequence[str], numbers: Sequence[float]) -> Mapping[Consumer, Reaction]:
    """Reactions to ``inf``, ``nan`` and numbers that are too large, such as ``1e400``."""
    around = value.element.parent
    is_turned = value.element.name == "inertia" and around is not None and around.has("origin")
    found = {} if is_turned else {Consumer.ISAAC: _AS_IT_IS}
    is_written = all(
        word[-1].isalpha() for word, number in zip(words, numbers, strict=True) if not isfinite(number)
    )
    if is_written and _is_taken_by_mujoco(value, numbers):
        found[Consumer.MUJOCO] = _AS_IT_IS
    return found


def _is_taken_by_mujoco(value: Value, numbers: Sequence[float]) -> bool:
    """Does MuJoCo 4 take what is not finite: not as moments, and not as a negative mass or size?"""
    element, place = value.element, _place(value.element)
    if "inertial" in place and _stands(element):
        return True
    if any(map(isnan, numbers)):
        return "geometry" not in place and ("inertial" not in place or element.name == "mass")
    is_body = "geometry" in place or element.name == "mass"
    return element.name != "inertia" and not (is_body and min(numbers) < 0)


def _needs_mass(element: Element) -> str:
    """Why libsdformat refuses the robot without the mass of the link that an element is in; empty if it does not.

    It drops a link without mass, with all that it carries.
    """
    from sdfcheck.robot.root import root_of

    name = next((each.text_of("name") for each in element.around if each.name == "link"), None)
    for model in root_of(element.document).models:
        built = model.as_built_by(Consumer.GAZEBO)
        link = model.tree.links.get(name or "")
        if link is not None and built.base(link) not in built.with_mass:
            return built.refused_without(built.base(link))
    return ""


def _stands(element: Element) -> bool:
    """Is an element in a link that no joint moves, which MuJoCo makes a part of the world?"""
    link = next((each for each in element.around if each.name == "link"), None)
    return link is not None and link.text_of("name") not in element.document.view(_moved)


def _moved(document: Document) -> frozenset[str | None]:
    """The names of links that are moved, and of those that are fixed to them."""
    carried: dict[str | None, list[str | None]] = {}
    waiting: list[str | None] = []
    for joint in document.root.children("joint") if document.root is not None else ():
        parent, child = (
            None if end is None else end.text_of("link") for end in map(joint.find, ("parent", "child"))
        )
        (carried.setdefault(parent, []) if joint.text_of("type") == "fixed" else waiting).append(child)
    moved: set[str | None] = set()
    while waiting:
        link = waiting.pop()
        if link not in moved:
            moved.add(link)
            waiting += carried.get(link, ())
    return frozenset(moved)


def lacking(element: Element, name: str) -> Mapping[Consumer, Reaction]:
    """Reactions to an attribute or child that is not there or empty."""
    if element.document.kind is Kind.SDF:
        return {}
    if "gazebo" in _place(element):
        return unreadable(element)
    if (value := element.attribute(name)) is not None:
        return _lacking_text(value)
    if (element.name, name) == ("axis", "xyz"):
        return _without_direction(element)
    return {
        **unreadable(element),
        Consumer.PYBULLET: REFUSES,
        Consumer.ISAAC: REFUSES if name in _NEEDED_BY_ISAAC.get(element.name, ()) else _WITHOUT_IT,
        **_lacking_in(element, name),
        **_ignoring(element),
    }


def _lacking_text(value: Value) -> Mapping[Consumer, Reaction]:
    """Reactions to an attribute that is empty."""
    element, found = value.element, dict(unreadable(value))
    if value.attribute in _NAMING:
        if element.name in {"joint", "parent", "child", "mesh"}:
            found[Consumer.DRAKE] = REFUSES if _is_followed(element) else _WITHOUT_IT
        found |= {Consumer.PYBULLET: REFUSES, **_lacking_in(element, value.attribute)}
        is_needed = value.attribute in _NEEDED_BY_ISAAC.get(element.name, ())
        if element.name == "mesh":
            found[Consumer.GAZEBO] = REFUSES
        if element.name == "mimic":
            takers = (Consumer.URDFDOM, Consumer.MUJOCO, Consumer.ISAAC, Consumer.PYBULLET)
            return {**found, **dict.fromkeys(takers, warns("moves the joint alone"))}
    else:
        is_needed = True
        found[Consumer.PYBULLET] = REFUSES if element.name == "axis" else _UNREAD
        if element.name in {"origin", "limit", "dynamics", "mimic"}:
            found[Consumer.MUJOCO] = _UNREAD
    return {**found, Consumer.ISAAC: REFUSES if is_needed else _WITHOUT_IT, **_ignoring(element)}


def _is_followed(element: Element) -> bool:
    """Is an element a joint that another one mimics, or an end of it?"""
    joint = element if element.name == "joint" else element.parent
    return joint is not None and joint.text_of("name") in element.document.view(_leaders)


def _leaders(document: Document) -> frozenset[str | None]:
    joints = document.root.children("joint") if document.root is not None else ()
    found = (joint.find("mimic") for joint in joints)
    return frozenset(mimic.text_of("joint") for mimic in found if mimic is not None)


def _without_direction(axis: Element) -> Mapping[Consumer, Reaction]:
    """Reactions to an axis without direction, which libsdformat needs where something moves about it."""
    none, default = warns("takes no axis"), warns("takes a default")
    is_fixed = axis.parent is not None and axis.parent.text_of("type") == "fixed"
    return {
        Consumer.URDFDOM: none,
        Consumer.GAZEBO: none if is_fixed else REFUSES,
        Consumer.MUJOCO: REFUSES,
        **dict.fromkeys((Consumer.DRAKE, Consumer.PYBULLET, Consumer.ISAAC), default),
    }


_ZERO = warns("takes 0")
_UNLIMITED = warns("sets no limit")
_PRODUCT: Mapping[Consumer, Reaction] = {Consumer.DRAKE: _ZERO, Consumer.PYBULLET: _UNREAD}
_WITHOUT_LINKS = dict.fromkeys((Consumer.DRAKE, Consumer.MUJOCO), accepts("takes a robot without links"))
_LACKING: Mapping[str, Mapping[Consumer, Reaction]] = {
    "color": {Consumer.PYBULLET: _UNREAD},
    "dynamics": dict.fromkeys((Consumer.DRAKE, Consumer.MUJOCO), _UNREAD),
    "inertia": {Consumer.DRAKE: _ZERO},
    **dict.fromkeys(("inertia/ixy", "inertia/ixz", "inertia/iyz"), _PRODUCT),
    "inertial": {Consumer.DRAKE: _ZERO},
    "inertial/inertia": {Consumer.DRAKE: _ZERO, Consumer.GAZEBO: _NO_REST},
    "joint/limit": dict.fromkeys((Consumer.DRAKE, Consumer.MUJOCO), _UNLIMITED),
    "limit": dict.fromkeys((Consumer.DRAKE, Consumer.MUJOCO, Consumer.PYBULLET), _UNLIMITED),
    "mass": {Consumer.DRAKE: _ZERO},
    "mimic": {Consumer.PYBULLET: _UNREAD},
    "safety_controller": {Consumer.PYBULLET: _UNREAD},
}
"""Element, or element and what it lacks → the reactions that go by it."""


def _lacking_in(element: Element, name: str) -> Mapping[Consumer, Reaction]:
    """Reactions that go by the element."""
    match element.name:
        case "link" if name == "name":
            return {Consumer.URDFDOM: REFUSES if _has_joint(element) else drops("all of the link")}
        case "robot":
            if name == "link":
                return {} if element.has("joint") else _WITHOUT_LINKS
            return {Consumer.MUJOCO: _UNREAD}
        case "texture":
            unread = dict.fromkeys((Consumer.MUJOCO, Consumer.PYBULLET), _UNREAD)
            return {**unread, **_lacking_file(element)}
        case "material":
            mujoco = _UNREAD if any(element.children()) else REFUSES
            if "visual" not in _place(element):
                return {Consumer.MUJOCO: _UNREAD, Consumer.PYBULLET: _UNREAD}
            drake = accepts("needs no name there")
            others = {Consumer.DRAKE: drake, Consumer.MUJOCO: mujoco, Consumer.ISAAC: _WITHOUT_IT}
            return {**others, **dict.fromkeys((Consumer.URDFDOM, Consumer.GAZEBO), _NO_REST)}
    return _LACKING.get(f"{element.name}/{name}") or _LACKING.get(element.name, {})


def _has_joint(link: Element) -> bool:
    return link.parent is not None and link.parent.has("joint")


def _lacking_file(texture: Element) -> Mapping[Consumer, Reaction]:
    """Reactions to a texture without a file: they go by the material's name, or by the color beside it."""
    if "visual" in _place(texture):
        by_name = accepts("goes by the name of the material")
        return {**dict.fromkeys(Consumer, by_name), Consumer.DRAKE: REFUSES}
    has_color = texture.parent is not None and texture.parent.has("color")
    return dict.fromkeys(Consumer, accepts("takes the color")) if has_color else {}


def is_harmless(affects: Mapping[Consumer, Reaction]) -> bool:
    """Do all consumers of which reactions are known read on, but for those that one has to ask for?"""
    asked = [reaction for consumer, reaction in affects.items() if not consumer.is_on_request]
    return bool(asked) and not any(reaction.is_refusal or reaction == _NO_REST for reaction in asked)


def undersized(at: Value) -> Mapping[Consumer, Reaction]:
    """Reactions to a shape of no size; none in SDFormat."""
    if at.element.document.kind is Kind.SDF or "geometry" not in _place(at.element):
        return {}
    is_point = at.element.name == "sphere" and at.number == 0
    return {
        **dict.fromkeys(Consumer, warns("takes the number as it is")),
        Consumer.GAZEBO: warns("takes another value"),
        Consumer.DRAKE: accepts("takes the sphere for a point") if is_point else refuses("aborts"),
        Consumer.MUJOCO: _UNREAD if is_unread_by_mujoco(at) else REFUSES,
    }


def unexpanded(values: Iterable[Value]) -> Mapping[Consumer, Reaction]:
    """The worst reactions to values of URDF with expressions that xacro has yet to expand."""
    found = dict.fromkeys(Consumer, warns("keeps it as it is written"))
    for value in values:
        for consumer, reaction in _unexpanded(value).items():
            if reaction.severity > found[consumer].severity:
                found[consumer] = reaction
    return {**found, **dict.fromkeys((Consumer.ROS, Consumer.PINOCCHIO), found[Consumer.URDFDOM])}


def _unexpanded(value: Value) -> Mapping[Consumer, Reaction]:
    if value.attribute == "filename":
        is_texture = value.element.name == "texture"
        mujoco = _UNREAD if is_texture or is_unread_by_mujoco(value) else REFUSES
        unfound = refuses("does not find the file")
        pybullet = {} if is_texture else {Consumer.PYBULLET: unfound}
        return {Consumer.DRAKE: unfound, Consumer.MUJOCO: mujoco} | pybullet
    if value.attribute is None or value.attribute in _NAMING or _is_free(value.element):
        return {}
    return {**unreadable(value), Consumer.ISAAC: REFUSES}


def _is_free(element: Element) -> bool:
    """May it say anything: what is in it is for plugins, or is it not an element of URDF, so that nobody reads it?"""
    path = [each.name for each in (element, *element.around) if not each.name.startswith("xacro:")]
    return bool(_FREE.intersection(path)) or urdf().at("/".join(path[-2::-1])) is None


def repeating(element: Element) -> Mapping[Consumer, Reaction]:
    """Reactions to an element that is given again, of which one is enough."""
    if element.document.kind is Kind.SDF:
        return {}
    is_material = (
        element.name == "material" and element.parent is not None and element.parent.name == "visual"
    )
    is_unread = element.name == "texture" or (is_unread_by_mujoco(element) and not is_material)
    return ({Consumer.MUJOCO: _UNREAD} if is_unread else {}) | _ignoring(element)


def recurring(shape: Element) -> Mapping[Consumer, Reaction]:
    """Reactions to a second shape of the same kind in one geometry."""
    return {} if shape.document.kind is Kind.SDF else {Consumer.MUJOCO: REFUSES, **repeating(shape)}


def is_unread_by_mujoco(at: Element | Value) -> bool:
    """Whether MuJoCo ignores what is there."""
    element = at.element if isinstance(at, Value) else at
    place = _place(element)
    if place & _ASIDE or place & {"transmission", "gazebo"}:
        return True
    if isinstance(at, Value) and (element.name, at.attribute) == ("limit", "velocity"):
        return True
    return "visual" in place and not ("material" in place and element.name != "material")


def _urdfdom(place: frozenset[str]) -> Reaction:
    if "joint" in place:
        return REFUSES
    if "material" in place:
        return drops("the material")
    if place & {"visual", "collision", "inertial"}:
        return _NO_REST
    return REFUSES


def _place(element: Element) -> frozenset[str]:
    """The names of an element and of those around it."""
    return frozenset({element.name, *(each.name for each in element.around)})


# What Drake ignores of SDFormat and URDF, from data/drake-limits.txt.

_FILE = Path(__file__).with_name("data") / "drake-limits.txt"


class Ignored(NamedTuple):
    """An element ``name`` (or attribute ``@name``) in a parent; with ``unless``, only where the value is another."""

    parents: tuple[str, ...]
    """Names from the inside out."""
    name: str
    unless: str
    warned: bool
    """Does Drake say so?"""


@cache
def ignored_by_drake(dialect: str) -> tuple[Ignored, ...]:
    """Everything that Drake ignores in ``sdf`` or ``urdf``."""
    found = []
    for line in _FILE.read_text("utf-8").splitlines():
        if line.startswith("#"):
            continue
        own, parent, *lists = line.split("\t")
        if own != dialect:
            continue
        for warned, names in zip((True, False), lists, strict=False):
            for item in names.removeprefix("-").split(",") if names != "-" else ():
                name, _, unless = item.partition("!")
                found.append(Ignored(tuple(parent.split("/")[::-1]), name, unless, warned))
    return tuple(found)


def is_for_drake(document: Document) -> bool:
    """Is it a robot that Drake alone can build: by its joints, or by a joint to a `world` that is not there?

    The latter is meant for it where its prefix is declared, or a transmission has the type that it knows.
    """
    root = document.root
    if document.kind is not Kind.URDF or root is None or root.name != "robot":
        return False
    if root.has("drake:joint"):
        return True
    parents = (joint.find("parent") for joint in root.children("joint"))
    hangs_on_world = any(parent is not None and parent.text_of("link") == "world" for parent in parents)
    if not hangs_on_world or any(link.text_of("name") == "world" for link in root.children("link")):
        return False
    types = (each.text_of("type") for each in root.children("transmission"))
    return "drake" in root.namespaces or "SimpleTransmission" in types
