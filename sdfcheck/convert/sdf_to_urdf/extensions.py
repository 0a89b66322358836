"""``gazebo`` elements: what rides along for libsdformat, unread by others."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.poses import is_identity, pose_text
from sdfcheck.convert.writer import Node, copied
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.model.poses import reference_of
from sdfcheck.model.robot import Joint
from sdfcheck.model.rotations import Array
from sdfcheck.model.scopes import Frame
from sdfcheck.source.element import Element

_OF_LINKS = frozenset(
    {
        "audio_sink", "audio_source", "battery", "enable_wind", "gravity", "kinematic", "light", "must_be_base_link",
        "particle_emitter", "plugin", "projector", "self_collide", "sensor", "velocity_decay",
    }
)  # fmt: skip
_OF_JOINTS = frozenset({"physics", "plugin", "sensor"})
_OF_MODELS = frozenset({"allow_auto_disable", "enable_wind", "gripper", "plugin", "self_collide"})


def link_extensions(context: Context, name: str) -> None:
    """Keep what a link has beyond URDF; what has a pose stays where it is."""
    link, frame = context.robot.links[name], context.frames[name]
    shift = context.layout.within(name, link.pose)
    _keep(
        context, link.element, _OF_LINKS, context.links[name], lambda part: _pose(context, part, frame, shift)
    )


def joint_extensions(context: Context, name: str, reference: str) -> None:
    """Keep what a joint has beyond URDF."""
    frame = context.frames[name]
    same = np.eye(4)
    element = context.robot.joints[name].element
    _keep(context, element, _OF_JOINTS, reference, lambda part: _pose(context, part, frame, same))
    for axis in element.children("axis"):
        _keep_springs(context, axis, reference)


def model_extensions(context: Context, model: Element) -> None:
    """Keep the plugins and flags of a model, or of the include that brought it."""
    _keep(context, model, _OF_MODELS, "", None)


def keep_loop(context: Context, joint: Joint) -> None:
    """Keep a joint that would close a loop: libsdformat puts it back."""
    copy = copied(joint.element)
    copy.attributes["name"] = context.joints[joint.name]
    child = context.layout.within(joint.child, joint.pose)
    for part in list(copy.children):
        if isinstance(part, Node) and part.name in {"parent", "child", "pose"}:
            copy.children.remove(part)
    ends = [Node("pose", pose_text(child))]
    ends += [Node(role, context.link_name(getattr(joint, role))) for role in ("parent", "child")]
    copy.children[:0] = ends
    for number, axis in enumerate(joint.axes):
        node = copy.find("axis" if number == 0 else "axis2")
        if node is not None:
            node.children = [
                part
                for part in node.children
                if not (isinstance(part, Node) and part.name in {"xyz", "use_parent_model_frame"})
            ]
            node.children.insert(0, Node("xyz", " ".join(repr(float(value)) for value in axis.direction)))
    holder = Node("gazebo")
    holder.append(_renamed(context, copy))
    context.blobs.append(holder)
    context.ledger.take_whole(joint.element)


def _keep(
    context: Context,
    element: Element,
    names: frozenset[str],
    reference: str,
    pose: Callable[[Element], str | None] | None,
) -> None:
    kept = [
        child for child in element.children() if child.name in names and not context.ledger.is_done(child)
    ]
    if not kept:
        return
    holder = Node("gazebo", reference=reference) if reference else Node("gazebo")
    for child in kept:
        copy = _renamed(context, copied(child))
        written = pose(child) if pose is not None else None
        if written is not None:
            place = copy.find("pose")
            if place is None:
                place = Node("pose")
                copy.children.insert(0, place)
            place.text, place.attributes = written, {}
        holder.append(copy)
        context.ledger.take_whole(child)
        message = (
            f"{child.title} of {element.title} is kept as a gazebo extension, which libsdformat alone reads"
        )
        context.ledger.note(LossKind.KEPT_AS_EXTENSION, child, message, Severity.INFO)
    context.blobs.append(holder)


def _pose(context: Context, part: Element, frame: Frame, shift: Array) -> str | None:
    """The pose to write for a part of a link or joint; None where it is as it was."""
    if part.name in {"sensor", "light", "projector", "audio_source", "particle_emitter"}:
        given = part.find("pose")
        if is_identity(shift) and not reference_of(given):
            return None
        return pose_text(shift @ context.poses.of_part(part, frame))
    return None


def _renamed(context: Context, node: Node) -> Node:
    """The copy with the new names of links and joints, where a text is a scoped name."""
    if node.text and "::" in node.text:
        text = node.text.strip()
        node.text = context.links.get(text) or context.joints.get(text) or node.text
    for child in node.children:
        if isinstance(child, Node):
            _renamed(context, child)
    return node


def _keep_springs(context: Context, axis: Element, reference: str) -> None:
    dynamics, limit = axis.find("dynamics"), axis.find("limit")
    holder = Node("gazebo", reference=reference)
    for name, spelled in (("spring_reference", "springReference"), ("spring_stiffness", "springStiffness")):
        value = dynamics.find(name) if dynamics is not None else None
        if value is None:
            continue
        context.ledger.take(value)
        if value.own_value.number != 0:
            holder.add(spelled, value.content)
            message = (
                f"`{name}` ({value.content}) is kept as a gazebo extension, which libsdformat alone reads"
            )
            context.ledger.note(LossKind.KEPT_AS_EXTENSION, value, message, Severity.INFO)
    if holder.children:
        context.blobs.append(holder)
    for name, default in (("stiffness", 1e8), ("dissipation", 1.0)):
        value = limit.find(name) if limit is not None else None
        if value is not None and value.own_value.number == default:
            context.ledger.take(value)


def of_frame(context: Context, link: str, pose: Array) -> Array:
    """The pose of a frame of a link, given in the source's link frame, in that of the URDF."""
    return context.layout.within(link, context.robot.links[link].pose @ pose)


__all__ = ["joint_extensions", "keep_loop", "link_extensions", "model_extensions", "of_frame"]
