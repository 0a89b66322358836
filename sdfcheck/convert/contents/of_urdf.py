"""The contents of a URDF file beyond bodies and joints that move, in SDFormat's words.

That is ``<gazebo>`` blocks, materials and custom data.
"""

from __future__ import annotations

from collections.abc import Iterable

from sdfcheck.convert.contents.entry import Contents, Entry, entry_of
from sdfcheck.convert.contents.vendor import attribute_entries, custom_entries, custom_entry, take_attributes
from sdfcheck.convert.marks import SCRIPTS
from sdfcheck.convert.vendor_spelling import uses
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.urdf.schema import settings
from sdfcheck.formats.version import NEWEST
from sdfcheck.robot.graph import Model
from sdfcheck.robot.parts.gazebo import text_of_setting
from sdfcheck.robot.parts.joint import PRESERVING, Joint
from sdfcheck.robot.parts.link import Link
from sdfcheck.robot.parts.shape import Material, Shape, Visual
from sdfcheck.source.document import Element
from sdfcheck.source.sniff import Kind

_TRANSLATED = {
    "axis": frozenset({"xyz"}),
    "dynamics": frozenset({"damping", "friction"}),
    "robot": frozenset({"frame", "gazebo", "joint", "link", "material", "origin"}),
    "collision": frozenset({"geometry", "origin"}),
    "joint": frozenset({"axis", "child", "dynamics", "limit", "mimic", "origin", "parent"}),
    "limit": frozenset({"effort", "lower", "upper", "velocity"}),
    "visual": frozenset({"geometry", "material", "origin"}),
}
"""Element → the parts and attributes for which SDFormat has words; it has others under a prefix only."""
_HINTS = frozenset({*PRESERVING, "material"})
_OF_MODELS = frozenset({"pose", "static", "frame", "joint", "link", "model", "include"})
_MOTION = frozenset({"axis", "pose", "parent", "child"})


def of_urdf(model: Model) -> Contents:
    """The contents of a robot."""
    found = Contents(model.name)
    sdf = schema(NEWEST).root.children["model"]
    robot = found.add("model", "", _entry("model", model.element, sdf))
    _add_customs(robot, model.element.children(), ("drake:joint",))
    for kept in _add_own(robot, model.element):
        for actuator in (child for child in kept.children if child.name == "actuator"):
            # Vendor tags of it are the joint's.
            actuator.children = [child for child in actuator.children if ":" not in child.name]
    for link in model.links:
        _link(found, link, sdf.children["link"])
    for joint in model.joints:
        _joint(found, joint, sdf.children["joint"])
    for block in model.blocks_by_reference.get("", ()):
        for entry in block.element.children():
            if entry.name not in _OF_MODELS and entry.name not in (
                settings("link").keys() | settings("joint").keys()
            ):
                _add(robot, entry)
    _drive(found, model)
    return found


def _link(found: Contents, link: Link, definition: Definition) -> None:
    made = found.add("link", link.name, _entry("link", link.element, definition))
    _add_customs(made, link.element.children())
    shapes = [(shape, _shape(shape, definition)) for shape in link.shapes]
    for shape, entry in shapes:
        found.shapes[shape.element] = entry
    for block in link.gazebo_blocks:
        for element in block.element.children():
            _of_block(made, link, element, shapes)


def _of_block(made: Entry, link: Link, element: Element, shapes: list[tuple[Shape, Entry]]) -> None:
    """The settings that a block has for a link."""
    name = element.name
    setting = settings("link").get(name)
    if name in {"visual", "collision"}:
        for entry in (entry for shape, entry in shapes if shape.kind == name):
            _lay_over(entry, entry_of(element, entry.definition))
    elif setting is not None:
        text = setting.translated(text_of_setting(element))
        for path in setting.counterparts:
            if path[0] == "collision":
                for entry in (entry for shape, entry in shapes if shape.kind == "collision"):
                    entry.reach(path[1:], element).text = text
            else:
                made.reach(path, element).text = text
    elif name == "material":
        _script(element, [entry for shape, entry in shapes if shape.kind == "visual"])
    elif name not in _HINTS and name not in settings("joint") and not _is_of_joint(link, element):
        _add(made, element)


def _script(element: Element, visuals: Iterable[Entry]) -> None:
    """The script of classic Gazebo that a block has for the visuals of a link."""
    if name := text_of_setting(element):
        for visual in visuals:
            for part, text in (("name", name), ("uri", SCRIPTS)):
                visual.reach(("material", "script", part), element).text = text


def _is_of_joint(link: Link, element: Element) -> bool:
    """Where a joint has the link's name: is a setting the joint's?"""
    return element.name == "physics" and any(joint.name == link.name for joint in link.model.joints)


def _shape(shape: Shape, definition: Definition) -> Entry:
    made = _entry(shape.kind, shape.element, definition.children.get(shape.kind))
    _add_customs(made, shape.element.children())
    _add_own(made, shape.element)
    geometry = shape.geometry.shape_element
    _add_customs(made, () if geometry is None else geometry.children())
    if isinstance(shape, Visual) and shape.own_material.is_given:
        _material(made, shape.material)
    return made


def _material(shape: Entry, material: Material) -> None:
    color, texture = material.element.find("color"), material.element.find("texture")
    if color is not None and (rgba := color.attributes.get("rgba", "").split()):
        # URDF has one color, in whatever light.
        shape.reach(("material", "diffuse"), color).text = " ".join(rgba)
    if texture is not None and (file := texture.attributes.get("filename", "").strip()):
        shape.reach(("material", "pbr", "metal", "albedo_map"), texture).text = file
        if texture.document.root is not None and uses(texture.document.root, "drake"):
            shape.reach(("material", "drake:diffuse_map"), texture).text = file


def _joint(found: Contents, joint: Joint, definition: Definition) -> None:
    made = found.add("joint", joint.name, _entry("joint", joint.element, definition))
    _add_customs(made, joint.element.children())
    if not joint.is_fixed:  # of one that was merged nothing is left but a frame
        _add_own(made, joint.element)
    for name in ("axis", "limit", "dynamics"):
        inner = joint.find(name)
        if inner is not None:
            _add_customs(made, inner.children())
            made.children += attribute_entries(inner, Kind.URDF)
            own = inner.attributes.items() if not joint.is_fixed else ()
            made.children += [
                Entry(key, text, inner)
                for key, text in own
                if key not in _TRANSLATED[name] and ":" not in key
            ]
    for element in (element for block in joint.gazebo_blocks for element in block.element.children()):
        if (setting := settings("joint").get(element.name)) is not None:
            for path in setting.counterparts:
                made.reach(path, element).text = setting.translated(text_of_setting(element))
        elif element.name not in _HINTS and element.name not in _MOTION and not _is_of_link(joint, element):
            _add(made, element)


def _is_of_link(joint: Joint, element: Element) -> bool:
    """Where a link has the joint's name: is a setting the link's?"""
    model = joint.model
    return (
        model is not None
        and any(link.name == joint.name for link in model.links)
        and element.name != "physics"
    )


def _drive(found: Contents, model: Model) -> None:
    """Vendor tags of the actuator of a joint."""
    for transmission in model.transmissions:
        kind, names = transmission.type_value, transmission.joint_names
        if kind is None or "SimpleTransmission" not in kind.text or not names or not transmission.actuators:
            continue
        joint = found.parts.get(("joint", names[0].text))
        if joint is not None:
            _add_customs(joint, transmission.actuators[0].children())


def _add(made: Entry, element: Element) -> None:
    """A setting that a block has as SDFormat has it."""
    definition = made.definition.children.get(element.name) if made.definition is not None else None
    entry = custom_entry(element, Kind.SDF) if element.is_custom else entry_of(element, definition)
    there = made.find(element.name) if definition is not None and definition.single else None
    if there is not None:
        _lay_over(there, entry)
    else:
        made.add(entry)


def _lay_over(entry: Entry, other: Entry) -> None:
    """The values of one setting take precedence over those of the other."""
    entry.attributes.update(other.attributes)
    entry.text = other.text or entry.text
    for child in other.children:
        there = entry.find(child.name) if child.name not in {"plugin", "sensor"} else None
        if there is None:
            entry.add(child)
        else:
            _lay_over(there, child)


def _add_own(made: Entry, element: Element) -> list[Entry]:
    """What URDF alone has in an element, or nobody."""
    translated = _TRANSLATED[element.name]
    found = [child for child in element.children() if not child.is_custom and child.name not in translated]
    return [made.add(custom_entry(child, Kind.URDF)) for child in found]


def _entry(kind: str, element: Element, definition: Definition | None) -> Entry:
    """A part of the robot, with the attributes that are custom."""
    made = Entry(kind, "", element, definition)
    made.attributes = {name: text for name, text in element.attributes.items() if ":" in name}
    take_attributes(made, element, Kind.URDF)
    return made


def _add_customs(made: Entry, elements: Iterable[Element], without: tuple[str, ...] = ()) -> None:
    made.children += custom_entries((e for e in elements if e.name not in without), Kind.URDF)
