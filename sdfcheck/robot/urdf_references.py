"""What refers to parts of a URDF robot by name: materials, transmissions, ros2_control, extensions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import asin, isfinite, pi, sin
from typing import cast

from sdfcheck.formats.sdf.values import floats
from sdfcheck.formats.suggest import suggest, suggest_in
from sdfcheck.formats.urdf.survey import UrdfSurvey, survey
from sdfcheck.formats.urdf.table import is_expression
from sdfcheck.robot.robot_problems import (
    DelimiterInExtension,
    DifferentMaterial,
    EmptyMaterial,
    SingularPitch,
    UndefinedMaterial,
    UnknownControlJoint,
    UnknownTransmissionJoint,
    UnreferencedExtension,
)
from sdfcheck.robot.urdf_tree import UrdfTree, tree
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

_POLE = 0.99999
"""Where the sine of the pitch is beyond this, urdfdom takes the angle for a right one."""
_NOTABLE = 1e-4
"""An error in radians that is worth a word: 1.5708 is right, 1.57 is not."""


def problems(document: Document) -> Iterator[object]:
    """Everything wrong with references in a URDF document, in no particular order."""
    surveyed = survey(document)
    if surveyed.root is None:
        return
    robot = tree(document)
    yield from _materials(surveyed)
    yield from _joints_in(robot, surveyed)
    # A name that joints give to a link, too, is reported with them.
    known = {*robot.links, *robot.joint_named, *robot.unknown_ends}
    delimited = "::" in document.source.text
    for block in surveyed.top("gazebo"):
        yield from _extension(known, surveyed, block)
        if delimited:
            yield from _delimiters(block)
    for origin in surveyed.index.get("origin", ()):
        yield from _pitch(origin)


# Materials


def _materials(surveyed: UrdfSurvey) -> Iterator[object]:
    """urdfdom reads those of the robot first, then those of each link as it comes."""
    defined: dict[str, Element] = {}
    nameless = 0
    for material in surveyed.top("material"):
        if name := material.attributes.get("name"):
            defined.setdefault(name, material)
        else:
            nameless += 1
        if not _look(material) and not any(
            suggest(c.name, ("color", "texture")) for c in material.children()
        ):
            yield EmptyMaterial(material)
    missing: dict[str, list[Value]] = {}
    for value in _used(surveyed):
        material, name = value.element, value.text
        if look := _look(material):
            first = defined.setdefault(name, material)
            if first is not material and _look(first) not in ({}, look):
                yield DifferentMaterial(value, Value(first, "name", name))
        elif name not in defined:
            missing.setdefault(name, []).append(value)
    # A material that has lost its name is reported there, not wherever it is missed.
    if len(missing) > nameless:
        yield from _undefined(missing, defined)


def _used(surveyed: UrdfSurvey) -> Iterator[Value]:
    """The names of materials in visuals (those in collisions nobody reads)."""
    for material in surveyed.index.get("material", ()):
        value = material.attribute("name")
        parent = material.parent
        if value is not None and value.text and parent is not None and parent.name == "visual":
            yield value


def _undefined(missing: dict[str, list[Value]], defined: dict[str, Element]) -> Iterator[UndefinedMaterial]:
    for name, uses in missing.items():
        if is_expression(name):
            continue
        later = Value(defined[name], "name", name) if name in defined else None
        near = None if later is not None else suggest_in(uses[0].element.document, name, defined)
        yield UndefinedMaterial(uses[0], near, later, len(uses))


def _look(material: Element) -> dict[str, object]:
    """Colour and texture of a material, even if what they are is not said; empty if it has neither."""
    look: dict[str, object] = {}
    for name, attribute in (("color", "rgba"), ("texture", "filename")):
        if (element := material.find(name)) is not None:
            value = element.attribute(attribute)
            text = value.text if value is not None else ""
            look[name] = floats(text) or text
    return look


# Joints that something drives


def _joints_in(robot: UrdfTree, surveyed: UrdfSurvey) -> Iterator[object]:
    names = {
        *robot.joint_named,
        *(c.attributes.get("name", "") for c in surveyed.customs if c.name == "drake:joint"),
    }
    for transmission in surveyed.top("transmission"):
        for value in _named_joints(transmission, names):
            yield UnknownTransmissionJoint(
                value, transmission, suggest_in(surveyed.document, value.text, names)
            )
    for control in surveyed.top("ros2_control"):
        for value in _named_joints(control, names):
            yield UnknownControlJoint(value, control, suggest_in(surveyed.document, value.text, names))


def _named_joints(owner: Element, names: set[str]) -> Iterator[Value]:
    """The names of joints in a transmission or ros2_control that the robot does not have."""
    for joint in owner.children("joint"):
        value = joint.attribute("name")
        if value is not None and value.text and value.text not in names and not is_expression(value.text):
            yield value


# Extensions


def _extension(known: set[str], surveyed: UrdfSurvey, block: Element) -> Iterator[object]:
    value = block.attribute("reference")
    if value is not None and value.text and value.text not in known and not is_expression(value.text):
        yield UnreferencedExtension(
            value, suggest_in(surveyed.document, value.text, known), _kind(surveyed, value.text)
        )


def _delimiters(block: Element) -> Iterator[DelimiterInExtension]:
    for element in cast("Iterable[Element]", block.iterdescendants("*")):
        value = element.attribute("name") if element.tag != "plugin" else None
        if value is not None and "::" in value.text:
            yield DelimiterInExtension(value, block)


def _kind(surveyed: UrdfSurvey, name: str) -> str | None:
    """What else in the robot has that name."""
    for kind in ("visual", "collision", "material", "robot"):
        if any(element.attributes.get("name") == name for element in surveyed.index.get(kind, ())):
            return kind
    return None


# Angles


def _pitch(origin: Element) -> Iterator[SingularPitch]:
    """Poses of shapes only: those of joints and masses do not pass through that conversion."""
    parent = origin.parent
    value = origin.attribute("rpy")
    if value is None or parent is None or parent.tag not in {"visual", "collision"}:
        return
    numbers = floats(value.text)
    if numbers is None or len(numbers) != 3 or not isfinite(numbers[1]):
        return
    sine = sin(numbers[1])
    error = pi / 2 - asin(min(abs(sine), 1.0))
    if abs(sine) >= _POLE and error > _NOTABLE:
        yield SingularPitch(value, numbers[1], error)
