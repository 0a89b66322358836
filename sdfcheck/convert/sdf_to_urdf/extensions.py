"""Elements that URDF does not have: those of vendors, custom data, and settings of Gazebo."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import takewhile

import numpy as np

from sdfcheck.convert.ledger import TEXT
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.up import renew
from sdfcheck.convert.sdf_to_urdf.plan import (
    WORLD,
    Context,
    is_identity,
    is_same,
    mesh_uri,
    pose_text,
    shortened,
)
from sdfcheck.convert.vendor_spelling import Spelling, moved, spellings
from sdfcheck.convert.writer import (
    EMPTY,
    INERTIAL,
    JOINT,
    LINK,
    MERGED,
    NOTHING,
    PACKAGES,
    PARENT,
    declare,
    is_mark,
    undeclared_prefixes,
)
from sdfcheck.formats.sdf.survey import PARAMETERS
from sdfcheck.formats.vendor import known_tables
from sdfcheck.formats.vendor.definitions import Tag
from sdfcheck.formats.vendor.table import vendor
from sdfcheck.formats.version import NEWEST
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.mechanism import Joint
from sdfcheck.robot.motion.poses import Array, to_rpy
from sdfcheck.robot.part import MergedFrame
from sdfcheck.robot.part import Node as RobotNode
from sdfcheck.robot.values import reference_of
from sdfcheck.source.altered import Xml, copied
from sdfcheck.source.document import Comment, Document, Element
from sdfcheck.source.document import Node as Written
from sdfcheck.source.sniff import Kind

# Vendors' own elements, in the words and at the places that URDF has for them.


_ACTUATOR = "actuator"
_SIMPLE = "transmission_interface/SimpleTransmission"
_DRIVEN = frozenset({"revolute", "continuous", "prismatic", "screw"})
_MATERIAL = "material/"
_INTERFACE = "hardware_interface/EffortJointInterface"


class VendorTags:
    """Writes the tags of one model or of a part of it; ``scope`` is the nested model, seen from the top."""

    def __init__(self, context: Context, scope: str) -> None:
        self.context = context
        self.scope = scope
        self.spellings = spellings(context.scope.element.document, Kind.URDF, self)

    def put(self, element: Element, node: Xml) -> bool:
        """Write a tag into the counterpart of its parent; False if no table has it."""
        made = self.spellings.get(element.name.partition(":")[0])
        tag = made.target.tags.get(element.name) if made is not None else None
        if made is None or tag is None:
            return False
        self.context.ledger.take_whole(element)
        if not tag.places:
            return self._elsewhere(element, node, made, tag.absent.use if tag.absent else "")
        if tag.name == "drake:joint" or node.name == "geometry":
            return True  # joints and shapes are written
        if tag.places[0].path[0].name == _ACTUATOR:
            self._drive(element, node, made)
        else:
            self._rename(made.write(element, node), tag)
        return True

    def put_attribute(self, element: Element, name: str, node: Xml) -> bool:
        """Write an attribute into the counterpart of its element; False if it is not read there, or no table has it."""
        made, ledger = self.spellings.get(name.partition(":")[0]), self.context.ledger
        if made is None:
            return False
        place = made.place(name, node)
        if made.write_attribute(element, name, node):
            ledger.take(element, name)
        elif made.attribute(element, name) is not None:
            text = f"{made.source.name} does not read attribute `{name}` of {element.title} there in URDF"
            ledger.note(LossKind.KEPT_AS_EXTENSION, element, text)
            return False
        elif place is not None and place.carrier == "attribute":
            text = f"attribute `{name}` of {element.title} is left out: it is ignored here, and would not be in URDF"
            ledger.lose_attribute(element, name, text)
        else:
            return False
        return True

    def _elsewhere(self, element: Element, node: Xml, made: Spelling, use: str) -> bool:
        """What URDF says without a tag, or cannot say."""
        if use == "joint/mimic" and node.name == "joint":
            self._mimic(element, node)
        elif use.startswith(_MATERIAL) and node.name == "material":
            node.add("texture", filename=mesh_uri(self.context, element.content, element))
        else:
            self._keep(element, node, made)
        return True

    def _rename(self, written: Xml | None, tag: Tag) -> None:
        """Names of tags of nested models get those of the models in front, as links do."""
        slot = tag.attributes.get("name")
        if (
            self.scope
            and written
            and slot is not None
            and not slot.references
            and "name" in written.attributes
        ):
            written.attributes["name"] = f"{self.scope}::{written.attributes['name']}".replace("::", "__")

    def _keep(self, element: Element, node: Xml, made: Spelling) -> None:
        """Keep what the vendor has in SDFormat only where the other way round looks for it."""
        reference = node.attributes.get("name", "") if node.name in {"link", "joint"} else ""
        self.context.blob(reference).append(copied(element))
        message = (
            f"{made.source.name} has `{element.name}` in SDFormat only: it is kept as a gazebo extension"
        )
        self.context.ledger.note(LossKind.KEPT_AS_EXTENSION, element, message, Severity.WARNING)

    # The parts that names refer to

    def name(self, text: str, kinds: tuple[str, ...]) -> str:
        """The name in the URDF; where a frame is wanted, one that is there for Drake."""
        full = f"{self.scope}::{text}" if self.scope else text
        context = self.context
        for kind in kinds:
            if kind == "joint" and full in context.joints:
                return context.joints[full]
            if kind == "frame" and full in context.read.frames:
                return self._frame(full, context.frame_names[full], *context.read.frames[full])
            if kind == "link" and full in context.links:
                own = context.links[full]
                return self._frame(full, f"{own}_frame", full, np.eye(4)) if "frame" in kinds else own
            if ":" in kind:
                return full.replace("::", "__")
        return text

    def _frame(self, name: str, wished: str, link: str, pose: Array) -> str:
        """A frame at a pose on a link of the source; the link itself where it is the same."""
        context = self.context
        within = context.layout.within(link, context.robot.links[link].pose @ pose)
        is_link = name in context.links
        if is_link and is_same(within, np.eye(4)):
            return context.links[link]
        if not is_link and context.options.frames:
            return wished
        if (known := context.drake_frames.get(name)) is not None:
            return known
        own = context.drake_frames[name] = context.naming.unique(wished) if is_link else wished
        angles = shortened(to_rpy(within[:3, :3]))
        node = context.root.add("frame", None, name=own, link=context.links[link])
        node.attributes.update(xyz=shortened(within[:3, 3]), rpy=angles)
        return own

    def vector(self, link: str, text: str, *, is_point: bool) -> str:
        """A point or direction of a link whose frame may have moved to its joint."""
        full = f"{self.scope}::{link}" if self.scope and not link.startswith(f"{self.scope}::") else link
        source = self.context.robot.links.get(full)
        if source is None:
            return text
        return moved(text, self.context.layout.within(full, source.pose), is_point=is_point)

    # Joints

    def _drive(self, element: Element, joint: Xml, made: Spelling) -> None:
        """A tag in the joint is in its actuator in URDF."""
        if joint.attributes.get("type") in _DRIVEN:
            self.context.actuators.setdefault(joint.attributes["name"], []).append(made.element(element))
            return
        message = f"`{element.name}` is left out: what is written for the joint has no actuator"
        self.context.ledger.lose(LossKind.DROPPED_ELEMENT, element, message)

    def _mimic(self, element: Element, joint: Xml) -> None:
        """URDF's own, which may be there for another reason."""
        if joint.find("mimic") is None:
            values = {name: element.attributes.get(name, "") for name in ("multiplier", "offset")}
            leader = self.name(element.attributes.get("joint", ""), ("joint",))
            joint.add("mimic", None, joint=leader, **values)


def write_actuators(context: Context) -> None:
    """Write what was in joints into the transmissions of those, which are made where there are none.

    In SDFormat Drake drives each joint with an effort other than 0, in URDF those with a transmission.
    """
    for edge in context.made.edges if context.natives else ():
        joint = context.robot.joints[edge.joint.name]
        if joint.kind in _DRIVEN and joint.axes and joint.axes[0].effort != 0:
            context.actuators.setdefault(context.joints[joint.name], [])
    for name, tags in context.actuators.items():
        actuator = _actuator_of(context, name) or _new_actuator(context, name)
        actuator.extend(*[tag for tag in tags if actuator.find(tag.name) is None])


def _actuator_of(context: Context, joint: str) -> Xml | None:
    for node in context.root.children("transmission"):
        driven = node.find("joint")
        if driven is not None and driven.attributes.get("name") == joint:
            return node.find(_ACTUATOR)
    return None


def _new_actuator(context: Context, joint: str) -> Xml:
    transmission = context.root.add("transmission", None, name=f"{joint}_transmission")
    transmission.add("type", _SIMPLE)
    transmission.add("joint", None, name=joint).add("hardwareInterface", _INTERFACE)
    return transmission.add(_ACTUATOR, None, name=joint)


# Comments go where what they speak of goes.


def carry_comments(context: Context, node: Xml, element: Element) -> None:
    """Write the comments right before an element at the end of a node."""
    found = list(takewhile(lambda each: isinstance(each, Comment), element.before))
    node.extend(*_taken(context, reversed(found)))


def carry_inside(context: Context, node: Xml, element: Element) -> None:
    """Write what comments an element has that are not written yet at the start of a node."""
    node.insert(0, *_taken(context, _below(element)))


def carry_around(context: Context, node: Xml, model: Element) -> None:
    """Write the comments of a model that are before no written element: at the start, or at the end."""
    written = ("link", "joint", "model", "include", "frame")
    last = next((child for child in reversed(list(model.children())) if child.name in written), None)
    node.extend(*_taken(context, last.after if last is not None else ()))
    node.insert(0, *_taken(context, model.nodes))


def around_root(element: Element, *, preceding: bool) -> list[Comment]:
    """The comments before or after the root of a document."""
    document = element.document
    nodes = document.prolog if preceding else document.epilog
    return [node for node in nodes if isinstance(node, Comment)]


def _below(element: Element) -> Iterator[Written]:
    """All nodes in an element, in the order of the document."""
    for node in element.nodes:
        yield node
        if isinstance(node, Element):
            yield from _below(node)


def _taken(context: Context, nodes: Iterable[Written]) -> list[Comment]:
    """The comments among nodes that are not written yet."""
    return [node for node in nodes if isinstance(node, Comment) and context.ledger.take_comment(node)]


# Names of links, joints and frames in sensors, plugins and custom elements: rewritten where they change.


_REFERENCES = re.compile(
    "joint|link|body|frame|parent|child|member|relative_to|attached_to|expressed_in", re.IGNORECASE
)
"""Words in the names of parameters that hold names of parts."""
_WORDS = re.compile(r"[^\s,;]+")
_OWN = frozenset({"name", "type", "filename", "reference"})


def follow_names(context: Context, node: Xml, source: Element, scope: str) -> None:
    """Rewrite what a copy of ``source``, which was in a nested model ``scope``, calls by name."""
    done: dict[str, str] = {}
    doubtful: dict[str, str] = {}
    for holder, attribute, name, text in _texts(node, is_top=True):
        renamed = _WORDS.sub(lambda word, name=name: _new_name(context, word[0], name, scope), text)  # type: ignore[misc]
        if renamed == text:
            continue
        if "::" not in text and not _REFERENCES.search(name):
            doubtful[text.strip()] = renamed.strip()
            continue
        done[text.strip()] = renamed.strip()
        if attribute:
            holder.attributes[attribute] = renamed
        else:
            holder.write(renamed)
    if done:
        message = f"names in {source.title} follow the parts that they name: {_list(done)}"
        context.ledger.note(LossKind.RENAMED, source, message, Severity.INFO)
    if doubtful:
        message = f"{source.title} may name what is renamed, and is left as it is: {_list(doubtful)}"
        context.ledger.note(LossKind.RENAMED, source, message)


def _texts(node: Xml, *, is_top: bool = False) -> Iterator[tuple[Xml, str, str, str]]:
    """Xml, attribute or nothing, name of the parameter, and text, of all that may hold a name."""
    for attribute, text in list(node.attributes.items()):
        if not (is_top and attribute in _OWN) and not attribute.startswith("xmlns"):
            yield node, attribute, attribute if attribute not in _OWN | {"value"} else node.name, text
    if node.content:
        yield node, "", node.name, node.content
    for child in node.children():
        yield from _texts(child)


def _new_name(context: Context, text: str, parameter: str, scope: str) -> str:
    """The name in the URDF of what a text names, seen from a nested model; the text itself if it names nothing."""
    tables = [context.links, context.joints, context.frame_names]
    if "joint" in parameter.lower():
        tables.insert(0, context.joints)
    around = scope.split("::") if scope else []
    for depth in range(len(around), -1, -1):
        full = "::".join((*around[:depth], text))
        for table in tables:
            if (new := _within(table, full)) is not None:
                return new
    return text


def _within(table: Mapping[str, str], name: str) -> str | None:
    """The new name of a part, also where something in that part is named."""
    head, rest = name, ""
    while head:
        if head in table:
            return table[head] + rest
        head, delimiter, last = head.rpartition("::")
        rest = f"{delimiter}{last}{rest}"
    return None


def _list(names: Mapping[str, str]) -> str:
    shown = [f"`{old}` → `{new}`" for old, new in list(names.items())[:3]]
    return ", ".join(shown) + (" …" if len(names) > 3 else "")


# Custom elements and attributes: carried over for their consumers, spelled as they are in URDF.


_OF_URDF = "urdf:"
"""The prefix under which the conversion from URDF to SDFormat keeps what URDF alone has."""


def carry_custom(context: Context, node: Xml, element: Element | None, scope: str) -> None:
    """Write the custom attributes and children of an element of a nested model ``scope`` into its equal."""
    if element is None:
        return
    for name, text in element.attributes.items():
        if ":" in name:
            _carry_attribute(context, node, element, name, text, VendorTags(context, scope))
    for child in element.children():
        if not child.is_custom or child.name == PARAMETERS:
            continue
        if child.name.startswith(_OF_URDF) and not (child.name == INERTIAL and is_mark(child)):
            _give_back(context, node, child, scope)
            continue
        if VendorTags(context, scope).put(child, node):
            continue
        copy = copied(child)
        for prefix in {child.name.partition(":")[0], *undeclared_prefixes(copy)}:
            declare(copy, child, prefix, context.namespaces)
        follow_names(context, copy, child, scope)
        node.append(copy)
        message = f"`{child.name}` is carried over for those who read it; poses in it are not translated"
        context.ledger.copy(child)
        context.ledger.note(LossKind.KEPT_AS_EXTENSION, child, message, Severity.INFO)


def _carry_attribute(
    context: Context, node: Xml, element: Element, name: str, text: str, tags: VendorTags
) -> None:
    if name in {MERGED, NOTHING, PACKAGES}:
        context.ledger.take(element, name)
        return
    if name.startswith(_OF_URDF):
        _give_back_attribute(context, node, element, name, text)
        return
    declare(node, element, name.partition(":")[0], context.namespaces)
    if tags.put_attribute(element, name, node):
        return
    if node.attributes.get(name) == text:
        context.ledger.take(element, name)  # one for both
    elif node.attributes.setdefault(name, text) == text:
        context.ledger.copy_attribute(element, name)
    else:
        message = f"attribute `{name}` of {element.title} is left out: there is another one"
        context.ledger.lose_attribute(element, name, message)


def _give_back(context: Context, node: Xml, element: Element, scope: str) -> None:
    """Write what came from URDF, and means something there only, as it was."""
    copy = copied(element)
    for name in [name for name in copy.attributes if name.startswith("xmlns:urdf")]:
        del copy.attributes[name]
    for part in copy.walk():
        part.attributes.update(dict.fromkeys(part.attributes.pop(EMPTY, "").split(), ""))
        part.attributes = {name.removeprefix(_OF_URDF): text for name, text in part.attributes.items()}
    copy.name = element.name.removeprefix(_OF_URDF)
    follow_names(context, copy, element, scope)
    context.ledger.take_whole(element)
    if copy.attributes.pop("block", None) is None:
        node.append(copy)
    else:
        context.blob(node.attributes["name"] if node.name in {"link", "joint"} else "").append(copy)


def _give_back_attribute(context: Context, node: Xml, element: Element, name: str, text: str) -> None:
    """Write an attribute that came from URDF as it was, where nothing is written under its name."""
    own = name.removeprefix(_OF_URDF)
    if node.attributes.setdefault(own, text) == text and name not in {JOINT, LINK, PARENT}:
        context.ledger.take(element, name)
        return
    message = f"attribute `{name}` of {element.title} is left out: it means nothing here"
    context.ledger.lose_attribute(element, name, message)


def carry_parts(context: Context, node: Xml, element: Element, scope: str, *parts: str) -> None:
    """The same for an element and parts of it that are written: ``pose=origin`` where URDF calls them otherwise."""
    carry_custom(context, node, element, scope)
    for part in parts:
        name, _, counterpart = part.partition("=")
        own = element.find(name)
        if own is None or not has_custom(own):
            continue
        # An origin may be empty; a limit may not.
        equal = node.reach(counterpart) if counterpart == "origin" else node.find(counterpart or name)
        if equal is not None:
            carry_custom(context, equal, own, scope)


def has_custom(element: Element) -> bool:
    """Are there custom attributes or children that need an equal to hang on?"""
    return any(":" in name for name in element.attributes) or any(
        child.is_custom for child in element.children()
    )


def namespace_of(document: Document, prefix: str) -> str:
    """The URI to declare for a prefix that its document does not declare."""
    table = known_tables(document.library).get(prefix)
    return f"urn:{prefix}" if table is None else vendor(table, "urdf").namespace


# ``gazebo`` elements: what rides along for libsdformat, unread by others.


_OF_LINKS = frozenset(
    {
        "audio_sink", "audio_source", "battery", "enable_wind", "gravity", "kinematic", "light", "must_be_base_link",
        "particle_emitter", "plugin", "projector", "self_collide", "sensor", "velocity_decay",
    }
)  # fmt: skip
_OF_JOINTS = frozenset({"physics", "plugin", "sensor"})
_OF_MODELS = frozenset({"allow_auto_disable", "enable_wind", "gripper", "plugin", "self_collide"})
_PLACED = frozenset({"sensor", "light", "projector", "audio_source", "particle_emitter"})


def link_extensions(context: Context, name: str) -> None:
    """Keep what a link has beyond URDF; what has a pose stays where it is."""
    link, frame = context.robot.links[name], context.frames[name]
    shift = context.layout.within(name, link.pose)
    scope, reference = name.rpartition("::")[0], context.links[name]
    _keep(context, link.element, _OF_LINKS, scope, reference, lambda part: _pose(context, part, frame, shift))


def joint_extensions(context: Context, name: str, reference: str) -> None:
    """Keep what a joint has beyond URDF."""
    frame = context.frames[name]
    same = np.eye(4)
    element = context.robot.joints[name].element
    scope = name.rpartition("::")[0]
    _keep(context, element, _OF_JOINTS, scope, reference, lambda part: _pose(context, part, frame, same))
    for axis in element.children("axis"):
        _keep_springs(context, axis, reference)


def model_extensions(context: Context, model: Element, scope: str) -> None:
    """Keep the plugins and flags of a model, or of the include that brought it."""
    _keep(context, model, _OF_MODELS, scope, "", None)


def keep_place(context: Context, pose: Array) -> None:
    """Keep where the robot is, which a URDF cannot say."""
    context.blob().add("pose", pose_text(pose))


def keep_static(context: Context, static: Element) -> None:
    """Keep that the model does not move."""
    context.blob().add("static", "true")
    context.ledger.take(static, TEXT)


def keep_base(context: Context, joint: str, pose: Array, parent: str = "__model__") -> None:
    """Keep where a floating or planar joint is: libsdformat drops the joint, and still places its child by it."""
    parent = "__model__" if parent == WORLD else parent
    context.blob().add("frame", name=joint, attached_to=parent).add("pose", pose_text(pose))


def keep_frame(context: Context, name: str, link: str, pose: Array, frame: RobotNode) -> None:
    """Keep a frame by this name, on a link of the URDF in whose frame it has this pose."""
    holder = context.blob()
    carry_comments(context, holder, frame.element)
    node = holder.add("frame", name=name, attached_to=link)
    text = pose_text(pose)
    if text != "0 0 0 0 0 0":
        node.add("pose", text)
    if isinstance(frame, MergedFrame):
        return
    carry_inside(context, node, frame.element)
    context.ledger.take_parts(frame.element, "pose")
    message = f"{frame.element.title} is kept for libsdformat alone; --frames makes it a link"
    context.ledger.note(LossKind.KEPT_AS_EXTENSION, frame.element, message, Severity.INFO)


def _keep(
    context: Context,
    element: Element,
    names: frozenset[str],
    scope: str,
    reference: str,
    pose: Callable[[Element], str | None] | None,
) -> None:
    kept = [child for child in element.children() if child.name in names]
    if not kept:
        return
    holder = context.blob(reference)
    for child in kept:
        carry_comments(context, holder, child)
        copy = copied(child)
        for said in renew(copy, NEWEST, child):
            context.ledger.note(LossKind.CHANGED_DEFAULT, child, *said)
        written = pose(child) if pose is not None else None
        if written is not None:
            place = copy.find("pose")
            if place is None:
                place = Xml("pose")
                copy.insert(0, place)
            place.say(written)
        follow_names(context, copy, child, scope)
        holder.append(copy)
        context.ledger.copy(child)
        message = (
            f"{child.title} of {element.title} is kept as a gazebo extension, which libsdformat alone reads"
        )
        context.ledger.note(LossKind.KEPT_AS_EXTENSION, child, message, Severity.INFO)


def _pose(context: Context, part: Element, frame: RobotNode, shift: Array) -> str | None:
    """The pose to write for a part of a link or joint; None where it is as it was."""
    if part.name not in _PLACED or (is_identity(shift) and not reference_of(part.find("pose"))):
        return None
    return pose_text(shift @ context.poses.of_part(part, frame))


def _keep_springs(context: Context, axis: Element, reference: str) -> None:
    dynamics, limit = axis.find("dynamics"), axis.find("limit")
    for name, spelled in (("spring_reference", "springReference"), ("spring_stiffness", "springStiffness")):
        value = dynamics.find(name) if dynamics is not None else None
        if value is None:
            continue
        context.ledger.take(value, TEXT)
        if value.own_value.number != 0:
            context.blob(reference).add(spelled, value.content)
            message = (
                f"`{name}` ({value.content}) is kept as a gazebo extension, which libsdformat alone reads"
            )
            severity = Severity.WARNING if context.natives else Severity.INFO  # Drake reads it in SDFormat
            context.ledger.note(LossKind.KEPT_AS_EXTENSION, value, message, severity)
    for name, default in (("stiffness", 1e8), ("dissipation", 1.0)):
        value = limit.find(name) if limit is not None else None
        if value is not None and value.own_value.number == default:
            context.ledger.take(value, TEXT)


def of_frame(context: Context, link: str, pose: Array) -> Array:
    """The pose of a frame of a link, given in the source's link frame, in that of the URDF."""
    return context.layout.within(link, context.robot.links[link].pose @ pose)


# Joints that URDF cannot have, kept as SDFormat: libsdformat puts them back.


_REPLACED = frozenset({"parent", "child", "pose"})
_DIRECTION = frozenset({"xyz", "use_parent_model_frame"})


def keep_joint(context: Context, joint: Joint, *, in_parent: bool = False) -> None:
    """Keep a joint, its ends and directions as they are in the URDF.

    ``in_parent``: say where it is in its parent. libsdformat places the child of a floating
    joint by that joint, which it drops: this one takes its name, and must not lean on the child.
    """
    copy = copied(joint.element)
    copy.attributes["name"] = context.joints[joint.name]
    copy.drop(_REPLACED)
    follow_names(context, copy, joint.element, joint.name.rpartition("::")[0])
    parent, child = context.link_name(joint.parent), context.link_name(joint.child)
    pose = pose_text(context.layout.within(joint.parent if in_parent else joint.child, joint.pose))
    if in_parent:
        place = [Xml("pose", pose, relative_to="__model__" if parent == "world" else parent)]
    else:
        place = [Xml("pose", pose)] if pose != "0 0 0 0 0 0" else []
    ends = (Xml("parent", parent), Xml("child", child))
    copy.insert(0, *(_with_custom(node, joint.element) for node in (*place, *ends)))
    for number, axis in enumerate(joint.axes):
        node = copy.find("axis" if number == 0 else "axis2")
        if node is not None:
            node.drop(_DIRECTION)
            written = joint.element.find(node.name)
            xyz = Xml("xyz", shortened(axis.direction))
            node.insert(0, xyz if written is None else _with_custom(xyz, written))
    context.blob().append(copy)
    context.kept.add(joint.name)
    context.ledger.take_whole(joint.element)


def _with_custom(node: Xml, holder: Element) -> Xml:
    """A new node with the custom attributes of what it takes the place of in ``holder``."""
    old = holder.find(node.name)
    for name, text in () if old is None else old.attributes.items():
        if ":" in name:
            node.attributes.setdefault(name, text)
    return node
