"""The contents of an SDFormat file beyond bodies and joints that move."""

from __future__ import annotations

from sdfcheck.convert.contents.entry import Contents, Entry, entry_of
from sdfcheck.convert.contents.vendor import attribute_entries, custom_entries, take_attributes
from sdfcheck.convert.marks import BLOCK, is_mark
from sdfcheck.formats.schema import Definition
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.sdf.survey import survey
from sdfcheck.formats.urdf.schema import settings
from sdfcheck.robot.errors import DescriptionError
from sdfcheck.robot.graph import MergedFrame, Model, World
from sdfcheck.robot.motion.poses import PoseError
from sdfcheck.robot.parts.link import Link
from sdfcheck.source.document import Element
from sdfcheck.source.sniff import Kind

_OF_MODELS = frozenset({"link", "joint", "frame", "model", "include", "pose", "static", "drake:joint"})
_OF_WORLDS = frozenset({"model", "include", "joint", "frame"})
_FIELDS = frozenset({"gravity", "magnetic_field"})
"""They were in the physics before 1.6."""
_OF_LINKS = frozenset({"pose", "inertial", "visual", "collision"})
_OF_SHAPES = frozenset({"pose", "geometry", "density", "auto_inertia_params"})
_OF_JOINTS = frozenset(
    {"pose", "parent", "child", "axis", "axis2", "screw_thread_pitch", "thread_pitch", "drake:mimic"}
)
_OF_AXES = frozenset({"xyz", "use_parent_model_frame", "mimic", "limit", "dynamics"})
_LIMITS = frozenset({"lower", "upper", "effort", "velocity"})
_DYNAMICS = frozenset({"damping", "friction"})
_OF_BLOCKS = frozenset({"axis", "child", "material", "parent", "pose"})
_ENDS = {"parent": "", "child": ""}


def of_model(model: Model) -> Contents:
    """The contents of a model and of all models in it, by names from the top."""
    found = Contents(model.name)
    _model(found, model, "", _definition(model.element, "model"))
    for name, node in model.all_nodes():
        if isinstance(node, Model):
            if node.is_readable:
                _model(found, node, name, _definition(node.element, "model"))
        elif isinstance(node, MergedFrame):
            inner = _entry(node.model.element, _definition(node.model.element, "model"), _OF_MODELS)
            found.of("model", name.rpartition("::")[0]).children += inner.children
        elif isinstance(node, Link):
            _link(found, node, name)
        elif node.kind == "joint":
            found.add("joint", name, _joint(node.element))
    return found


def of_world(world: World) -> Entry:
    """The contents of a world in addition to models."""
    definition = schema(survey(world.document).version).root.children.get("world")
    made = _entry(world.element, definition, _OF_WORLDS)
    for physics in [child for child in made.children if child.name == "physics"]:
        for field in [child for child in physics.children if child.name in _FIELDS]:
            physics.children.remove(field)
            if made.find(field.name) is None:
                made.add(field)
    return made


def _model(found: Contents, model: Model, name: str, definition: Definition | None) -> None:
    made = _entry(model.element, definition, _OF_MODELS)
    for attribute in ("canonical_link", "placement_frame"):
        made.attributes.pop(attribute, None)
    for child in () if model.include is None else model.include.children("plugin"):
        made.add(entry_of(child, definition.children.get("plugin") if definition is not None else None))
    found.add("model", name, made)


def _link(found: Contents, link: Link, name: str) -> None:
    element = link.element
    definition = _definition(element, "link")
    made = found.add("link", name, _entry(element, definition, _OF_LINKS))
    for child in made.children:
        _place(child, link)
    for part in (part for role in ("visual", "collision") for part in element.children(role)):
        inner = definition.children.get(part.name) if definition is not None else None
        shape = found.shapes[part] = _entry(part, inner, _OF_SHAPES)
        geometry = part.find("geometry")
        for solid in () if geometry is None else geometry.children():
            _add_custom(shape, solid)


def _place(entry: Entry, link: Link) -> None:
    """Let the pose of a part of a link be in the link's frame, whatever it is relative to."""
    pose = entry.find("pose")
    if pose is None or entry.element is None or entry.definition is None:
        return
    try:
        placed = link.root.poses.of_part(entry.element, link)
    except (DescriptionError, PoseError):
        return
    entry.children.remove(pose)
    entry.pose = placed


def _joint(element: Element) -> Entry:
    definition = _definition(element, "joint")
    made = _entry(element, definition, _OF_JOINTS)
    if made.attributes.pop("type", None) == "fixed":
        made.children = [
            child for child in made.children if child.element is None or not _is_idle(child.element)
        ]
    for name in ("axis", "axis2"):
        axis, inner = element.find(name), definition.children.get(name) if definition is not None else None
        if axis is None:
            continue
        place = made.add(_entry(axis, inner, _OF_AXES))
        _lift_custom(place, made)
        for part, without in (("limit", _LIMITS), ("dynamics", _DYNAMICS)):
            written = axis.find(part)
            if written is not None:
                known = inner.children.get(part) if inner is not None else None
                _lift_custom(place.add(_entry(written, known, without)), made)
    return made


def _is_idle(element: Element) -> bool:
    """Is it kept from a fixed joint of URDF, where it meant nothing? What a block said counts."""
    return element.name.startswith("urdf:") and BLOCK not in element.attributes


def _lift_custom(part: Entry, joint: Entry) -> None:
    """Move what is custom in an axis or its limit to the joint: URDF has these elsewhere."""
    joint.children += [child for child in part.children if ":" in child.name]
    part.children = [child for child in part.children if ":" not in child.name]
    if part.element is not None:
        joint.children += attribute_entries(part.element, Kind.SDF)
    part.attributes = {name: text for name, text in part.attributes.items() if ":" not in name}


def _entry(element: Element, definition: Definition | None, without: frozenset[str]) -> Entry:
    """An element without what is compared as part of the mechanism, custom data as such."""
    customs = frozenset(child.name for child in element.children() if child.is_custom)
    made = entry_of(element, definition, without | customs)
    made.attributes = {name: text for name, text in made.attributes.items() if name not in _ENDS}
    take_attributes(made, element, Kind.SDF)
    others = (
        child
        for child in element.children()
        if child.name not in without and not is_mark(child) and not _is_kept_idle(child)
    )
    made.children += custom_entries(others, Kind.SDF)
    return made


def _is_kept_idle(element: Element) -> bool:
    """Is it kept from URDF, where it meant nothing: in a link, or in a block for a joint or about another kind?"""
    local = element.name.removeprefix("urdf:")
    if local == element.name or element.parent is None:
        return False
    holder = element.parent.name
    if BLOCK not in element.attributes:
        return holder == "link"
    return local in (settings("joint") if holder == "link" else _OF_BLOCKS)


def _add_custom(shape: Entry, element: Element) -> None:
    """The custom parts of a shape."""
    shape.children += custom_entries(element.children(), Kind.SDF)


def _definition(element: Element, kind: str) -> Definition | None:
    """The definition of a link, joint or model in the version of its file."""
    model = schema(survey(element.document).version).root.children.get("model")
    return model if kind == "model" or model is None else model.children.get(kind)
