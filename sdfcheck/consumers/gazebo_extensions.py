"""Settings for links and joints in ``<gazebo>`` that do not do what they say."""

from __future__ import annotations

from collections.abc import Iterator

from sdfcheck.consumers.gazebo_materials import told_once
from sdfcheck.consumers.gazebo_problems import DisabledLumping, ExtensionLostByName, ScriptMaterial
from sdfcheck.formats.sdf.problems import MissingAttribute
from sdfcheck.formats.urdf.survey import survey
from sdfcheck.robot.gazebo_blocks import extension_parts
from sdfcheck.robot.urdf_tree import tree
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element, Value

_REACHING = {
    "collision": frozenset("collision fdir1 kd kp laserRetro maxContacts maxVel minDepth mu1 mu2".split()),
    "visual": frozenset(("material", "visual")),
}
"""The settings that libsdformat hands on to the collisions or visuals of the link."""

_TRUE = frozenset(("1", "true", "yes"))


def extension_problems(document: Document) -> Iterator[object]:
    """Everything wrong with the settings in a robot's ``<gazebo>`` blocks."""
    surveyed = survey(document)
    if surveyed.root is None:
        return
    robot = tree(document)
    kept = {
        block.attributes.get("reference", "")
        for block in surveyed.top("gazebo")
        if any(map(_is_on, block.children("preserveFixedJoint")))
    }
    scripts: list[ScriptMaterial] = []
    for block in surveyed.top("gazebo"):
        yield from _plugins(block)
        reference = block.attributes.get("reference", "")
        link, joint = robot.links.get(reference), robot.joint_named.get(reference)
        if link is not None:
            yield from _lost(block, link, reference)
            scripts += _scripts(block, link)
        elif joint is not None and joint.element.attributes.get("type") == "fixed":
            for element in block.children("disableFixedJointLumping"):
                if _is_on(element) and reference not in kept:
                    yield DisabledLumping(element, joint.element)
    yield from told_once(scripts)


def _lost(block: Element, link: Element, name: str) -> Iterator[ExtensionLostByName]:
    """A shape's own name hides it, unless it begins with that of the link."""
    for kind, reaching in _REACHING.items():
        settings = tuple(child for child in block.children() if child.name in reaching)
        hidden = []
        for shape in link.children(kind):
            value = shape.attribute("name")
            if value is not None and value.text.strip() and not value.text.startswith(name):
                hidden.append(value)
        if settings and hidden:
            yield ExtensionLostByName(settings, hidden[0], name, len(hidden))


def _plugins(block: Element) -> Iterator[MissingAttribute]:
    """libsdformat refuses the robot for a plugin without a file."""
    for element in extension_parts(block):
        if element.name == "plugin" and not element.attributes.get("filename"):
            yield MissingAttribute(element, "filename", empty="filename" in element.attributes)


def _scripts(block: Element, link: Element) -> Iterator[ScriptMaterial]:
    """``Gazebo/Red`` for a link that has a visual without material of its own."""
    if all(visual.has("material") for visual in link.children("visual")):
        return
    for material in block.children("material"):
        value = material.attribute("value") or Value(material, None, material.content)
        if value.text.strip():
            yield ScriptMaterial(value, value.text.strip())


def _is_on(setting: Element) -> bool:
    value = setting.attribute("value")
    return (value.text if value is not None else setting.content).strip().lower() in _TRUE
