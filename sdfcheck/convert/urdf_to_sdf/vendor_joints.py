"""Joints that only Drake knows in URDF: those of SDFormat as such, the others as ``drake:joint``."""

from __future__ import annotations

import math

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.urdf_to_sdf.context import Context, pose_of
from sdfcheck.convert.writer import Node, number, spaced
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.mechanism import Joint
from sdfcheck.robot.motion.poses import origin_of
from sdfcheck.robot.motion.rotations import Array, transform, z_towards
from sdfcheck.source.element import Element

_READ = frozenset({"origin", "parent", "child", "axis", "dynamics"})
_NO_DAMPING = {"planar": "0 0 0", "curvilinear": "0"}


def write_special_axes(joint: Joint, node: Node, context: Context) -> None:
    """The axes of a ball, universal or screw joint; a ball joint has one for its damping only."""
    damping = _damping(joint.element)
    if joint.kind == "ball":
        directions = ["0 0 1"] if damping else []
    elif joint.kind == "universal":
        directions = ["1 0 0", "0 1 0"]
    else:
        directions = [" ".join(number(float(part)) for part in joint.axes[0].direction)]
    for name, direction in zip(("axis", "axis2"), directions, strict=False):
        axis = node.add(name)
        axis.add("xyz", direction)
        if damping:
            axis.add("dynamics").add("damping", damping)
    if joint.kind == "screw":
        _write_pitch(joint, node, context)


def _write_pitch(joint: Joint, node: Node, context: Context) -> None:
    """m a turn, or what older versions have: radians per m, left-handed."""
    if context.allows("joint/screw_thread_pitch"):
        pitch = joint.element.find("drake:screw_thread_pitch")
        if pitch is not None:
            node.add("screw_thread_pitch", spaced(pitch.attributes.get("value", "")))
    elif joint.pitch:
        node.add("thread_pitch", number(-1 / joint.pitch))


def _damping(element: Element) -> str:
    """The damping as its author wrote it; empty where there is none."""
    dynamics = element.find("dynamics")
    text = "" if dynamics is None else spaced(dynamics.attributes.get("damping", ""))
    return text if any(_number(word) for word in text.split()) else ""


def _number(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        return math.nan


def write_for_drake(joint: Joint, model: Node, context: Context) -> None:
    """A planar or curvilinear joint between two frames, which have the joint's axis along z."""
    plan, element = context.plan, joint.element
    names = plan.names
    turn = z_towards(joint.axes[0].direction) if joint.kind == "planar" else np.eye(3)
    survivor, offset = plan.home[joint.parent]
    own = names.joints[joint.name]
    start = _frame(
        model, f"{own}_frame", names.links[survivor], offset @ origin_of(element) @ _turned(turn), context
    )
    end = names.links[joint.child]
    if not np.array_equal(turn, np.eye(3)):
        end = _frame(model, f"{own}_child_frame", end, _turned(turn), context)
    node = model.add("drake:joint", None, name=own, type=joint.kind)
    context.ledger.take(element)
    context.carry_attributes(element, node)
    context.carry_comments(element, node)
    for name in _READ:
        context.ledger.take(element.find(name))
    node.add("drake:parent", start)
    node.add("drake:child", end)
    node.add("drake:damping", _damping(element) or _NO_DAMPING[joint.kind])
    for child in element.children():
        if child.name not in _READ:
            context.keep(child, node)
    text = (
        f"SDFormat has no {joint.kind} joints: joint `{joint.name}` is written as a `drake:joint`; "
        "for other simulators its child floats freely"
    )
    context.note(element, LossKind.APPROXIMATED_JOINT, text, Severity.WARNING)


def _frame(model: Node, wished: str, link: str, pose: Array, context: Context) -> str:
    """A new frame on a link; returns its name."""
    name = context.plan.names.free(wished)
    frame = model.add("frame", None, name=name, attached_to=link)
    if (text := pose_of(pose)) is not None:
        frame.add("pose", text)
    return name


def _turned(rotation: Array) -> Array:
    return transform(rotation, (0.0, 0.0, 0.0))
