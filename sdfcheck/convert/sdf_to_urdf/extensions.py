"""``gazebo`` elements: content for libsdformat alone, and joints that URDF cannot have."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sdfcheck.convert.ledger import TEXT
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate.up import renew
from sdfcheck.convert.sdf_to_urdf.carried import carry_comments, carry_inside, follow_names
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.plan import WORLD, is_identity, pose_text, shortened
from sdfcheck.formats.version import NEWEST
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.mechanism import Joint
from sdfcheck.robot.motion.poses import Array
from sdfcheck.robot.part import MergedFrame
from sdfcheck.robot.part import Node as RobotNode
from sdfcheck.robot.values import reference_of
from sdfcheck.source.altered import Xml, copied
from sdfcheck.source.document import Element

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
