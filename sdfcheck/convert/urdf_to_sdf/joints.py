"""Joints: frame, ends, axis, limits; and those that only Drake knows."""

from __future__ import annotations

import math

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.urdf_to_sdf.plan import (
    WORLD,
    Context,
    has_custom,
    is_for_drake,
    is_quaternion,
    pose_of,
    pose_text,
)
from sdfcheck.convert.vendor_spelling import uses
from sdfcheck.convert.writer import JOINT, PARENT, number, numbers, spaced
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.mechanism import Joint
from sdfcheck.robot.motion.poses import Array, inverse, origin_of, transform, z_towards
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Element

# Joints that only Drake knows in URDF: those of SDFormat as such, the others as ``drake:joint``.


_READ_OF_VENDORS = frozenset({"origin", "parent", "child", "axis", "dynamics"})
_NO_DAMPING = {"planar": "0 0 0", "curvilinear": "0"}


def write_special_axes(joint: Joint, node: Xml, context: Context) -> None:
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


def _write_pitch(joint: Joint, node: Xml, context: Context) -> None:
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


def write_for_drake(joint: Joint, model: Xml, context: Context) -> None:
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
    for name in _READ_OF_VENDORS:
        context.ledger.take(element.find(name))
    node.add("drake:parent", start)
    node.add("drake:child", end)
    node.add("drake:damping", _damping(element) or _NO_DAMPING[joint.kind])
    for child in element.children():
        if child.name not in _READ_OF_VENDORS:
            context.keep(child, node)
    text = (
        f"SDFormat has no {joint.kind} joints: joint `{joint.name}` is written as a `drake:joint`; "
        "for other simulators its child floats freely"
    )
    context.note(element, LossKind.APPROXIMATED_JOINT, text, Severity.WARNING)


def _frame(model: Xml, wished: str, link: str, pose: Array, context: Context) -> str:
    """A new frame on a link; returns its name."""
    name = context.plan.names.free(wished)
    frame = model.add("frame", None, name=name, attached_to=link)
    if (text := pose_of(pose)) is not None:
        frame.add("pose", text)
    return name


def _turned(rotation: Array) -> Array:
    return transform(rotation, (0.0, 0.0, 0.0))


# Joints: frame, ends, axis, limits.


_KINDS = {
    "fixed": "fixed", "revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic",
    "ball": "ball", "universal": "universal", "screw": "screw",
}  # fmt: skip
_READ = frozenset(
    {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic", "drake:screw_thread_pitch"}
)
_FOLLOWING = {"multiplier": "1", "offset": "0"}
_AXIS_PARTS = ("axis", "limit", "dynamics", "mimic")


class Joints:
    """Writes joints, and places the links that they carry."""

    def __init__(self, context: Context) -> None:
        self.context = context

    def write(self, joint: Joint, model: Xml) -> None:
        """Write the joint, unless SDFormat expresses it by having none."""
        element = joint.element
        context = self.context
        if is_for_drake(context.plan, joint, context.options):
            write_for_drake(joint, model, context)
            return
        if joint.kind not in _KINDS:
            self._free(joint)
            return
        names = context.plan.names
        node = model.add("joint", None, name=names.joints[joint.name], type=_KINDS[joint.kind])
        context.ledger.take(element)
        context.carry_attributes(element, node)
        context.carry_comments(element, node)
        context.ledger.take(element.find("origin"))
        if context.options.has_frames and (pose := self._pose(joint)) is not None:
            node.append(pose)
            context.carry(element.find("origin"), pose)
        world = joint.parent == WORLD or context.plan.is_world(joint.parent)
        parent = WORLD if world else names.links[context.plan.home[joint.parent][0]]
        end = node.add("parent", parent)
        if not world:
            context.mark(end, joint.parent)
        context.carry(element.find("parent"), end)
        context.carry(element.find("child"), node.add("child", names.links[joint.child]))
        if joint.kind == "fixed":
            self._idle(element)
        elif joint.kind in {"ball", "universal", "screw"}:
            self._special(joint, node)
        else:
            self._axis(joint, node.add("axis"))
            self._mimic_of_drake(joint, node)
        for child in element.children():
            if child.name not in _READ:
                context.keep(child, node)
        context.joints[joint.name] = node

    def _special(self, joint: Joint, node: Xml) -> None:
        """A joint that URDF has for Drake only, and its settings."""
        write_special_axes(joint, node, self.context)
        for name in ("axis", "dynamics", "drake:screw_thread_pitch"):
            part = joint.element.find(name)
            axis = node.find("axis")
            if part is not None and part.is_custom:
                self.context.ledger.take_whole(part)
            elif axis is None:
                self.context.ledger.take(part)
            else:
                self.context.carry(part, axis)
        for name in ("limit", "mimic"):
            part = joint.element.find(name)
            if part is not None:
                text = f"<{name}> of {joint.kind} {joint.element.title} is left out: nobody reads it there"
                self.context.lose(part, LossKind.DROPPED_ELEMENT, text)

    def place(self, joint: Joint | None, link: str, node: Xml) -> None:
        """Give a link its pose: in its joint's frame, else in its parent's, else in the model."""
        context = self.context
        if not context.options.has_frames:
            if (text := pose_of(context.plan.robot.links[link].pose)) is not None:
                node.add("pose", text)
        elif joint is not None:
            if joint.kind in _KINDS:
                node.add("pose", None, relative_to=context.plan.names.joints[joint.name])
            elif (pose := self._pose(joint)) is not None:
                node.append(pose)

    def _pose(self, joint: Joint) -> Xml | None:
        """Where the joint is, in what carries it, with the author's numbers where that has not changed."""
        plan = self.context.plan
        if plan.is_world(joint.parent) or joint.parent not in plan.home:
            return Xml("pose", self._text(joint, None) or "0 0 0 0 0 0", relative_to="__model__")
        survivor, offset = plan.home[joint.parent]
        text = self._text(joint, offset if survivor != joint.parent else None)
        return Xml("pose", text or "0 0 0 0 0 0", relative_to=plan.names.links[survivor])

    def _text(self, joint: Joint, offset: Array | None) -> str | None:
        if offset is not None:
            return pose_of(offset @ origin_of(joint.element))
        if is_quaternion(joint.element):
            return pose_of(origin_of(joint.element))
        return pose_text(joint.element)

    def _axis(self, joint: Joint, node: Xml) -> None:
        axis, dynamics = joint.element.find("axis"), joint.element.find("dynamics")
        text = spaced(axis.attributes.get("xyz", "1 0 0")) if axis is not None else "1 0 0"
        turn = joint.pose[:3, :3]
        if self.context.options.has_axes_of_models and not np.array_equal(turn, np.eye(3)):
            text = numbers(turn @ joint.axes[0].direction)
        node.add("xyz", text)
        self._mimic(joint, node)
        limit = joint.element.find("limit")
        self.context.ledger.take(limit)
        bounds = {**self._range(joint), **self._strength(joint)}
        if bounds or has_custom(limit):
            written = node.add("limit")
            for name, text in bounds.items():
                written.add(name, spaced(text))
            self.context.carry(limit, written)
        for name in ("damping", "friction"):
            value = dynamics.attributes.get(name) if dynamics is not None else None
            if value is not None:
                node.reach("dynamics").add(name, spaced(value))
        self.context.ledger.take(dynamics)
        if has_custom(dynamics):
            self.context.carry(dynamics, node.reach("dynamics"))
        self.context.carry(axis, node)

    def _range(self, joint: Joint) -> dict[str, str]:
        """Where the joint stops; nothing for one that does not."""
        limit = joint.element.find("limit")
        if joint.kind == "continuous":
            self._idle_range(limit)
            return {}
        if limit is None:
            message = f"joint `{joint.name}` has no limits; it is taken as unlimited"
            self.context.note(joint.element, LossKind.CHANGED_DEFAULT, message)
            return {}
        lower, upper = (limit.attributes.get(name) or self._bound(joint, name) for name in ("lower", "upper"))
        if self.context.options.like is not None and joint.axes and joint.axes[0].lower > joint.axes[0].upper:
            message = f"the limits of joint `{joint.name}` are exchanged, as Gazebo exchanges them"
            self.context.note(joint.element, LossKind.CHANGED_LIMIT, message)
            lower, upper = upper, lower
        return {"lower": lower, "upper": upper}

    def _idle_range(self, limit: Element | None) -> None:
        for name in ("lower", "upper"):
            if limit is not None and name in limit.attributes:
                text = f"`{name}` means nothing on a continuous joint and is left out"
                self.context.ledger.lose_attribute(limit, name, text, severity=Severity.INFO)

    def _strength(self, joint: Joint) -> dict[str, str]:
        limit = joint.element.find("limit")
        found: dict[str, str] = {}
        for name in ("effort", "velocity"):
            text = limit.attributes.get(name) if limit is not None else None
            if text is None:
                continue
            if joint.axes and getattr(joint.axes[0], name) < 0:
                no_limit = f"has a negative {name}, which means no limit in SDFormat; it is left out"
                message = f"joint `{joint.name}` {no_limit}"
                self.context.note(joint.element, LossKind.CHANGED_LIMIT, message)
            else:
                found[name] = text
        return found

    def _bound(self, joint: Joint, name: str) -> str:
        value = getattr(joint.axes[0], name) if joint.axes else 0.0
        text = f"joint `{joint.name}` has no {name} limit; what URDF means by that, {number(value)}, is written out"
        self.context.note(joint.element, LossKind.CHANGED_DEFAULT, text, Severity.INFO)
        return number(value)

    def _mimic(self, joint: Joint, node: Xml) -> None:
        mimic = joint.element.find("mimic")
        if mimic is None:
            return
        plan, name = self.context.plan, mimic.attributes.get("joint", "")
        leader = plan.robot.joints.get(name)
        if not self.context.options.has_mimic:
            reason = f"SDFormat {self.context.options.version} has no mimic joints"
        elif leader is None or leader.kind not in _KINDS or leader.kind == "fixed":
            reason = f"`{name}` is not a joint that moves"
        else:
            made = node.add("mimic", None, joint=plan.names.joints[name])
            made.add("multiplier", spaced(mimic.attributes.get("multiplier", "1")))
            made.add("offset", spaced(mimic.attributes.get("offset", "0")))
            made.add("reference", "0")
            self.context.carry(mimic, made)
            return
        text = f"joint `{joint.name}` does not follow `{name}` any more: {reason}"
        self.context.lose(mimic, LossKind.DROPPED_MIMIC, text)
        self.context.lost_mimics.add(joint.name)

    def _mimic_of_drake(self, joint: Joint, node: Xml) -> None:
        """Drake has a tag of its own where SDFormat says which joint another follows, and reads no other."""
        mimic = joint.element.find("mimic")
        context = self.context
        if mimic is None or joint.name in context.lost_mimics or not uses(context.plan.root, "drake"):
            return
        values = {name: spaced(mimic.attributes.get(name, default)) for name, default in _FOLLOWING.items()}
        leader = context.plan.names.joints.get(mimic.attributes.get("joint", ""))
        if leader is not None:
            node.add("drake:mimic", None, joint=leader, **values)

    def _idle(self, element: Element) -> None:
        """The settings that have no meaning on a fixed joint."""
        for name in _AXIS_PARTS:
            part = element.find(name)
            if part is not None:
                text = f"<{name}> means nothing on fixed {element.title} and is left out"
                self.context.lose(part, LossKind.DROPPED_ELEMENT, text, Severity.INFO)

    def merge(self, joint: Joint) -> None:
        """Enter a joint whose links become one."""
        ledger = self.context.ledger
        ledger.take(joint.element)
        for name in ("origin", "parent", "child"):
            ledger.take(joint.element.find(name))
        self._idle(joint.element)

    def leave_frame(self, joint: Joint, link: Element) -> list[Xml]:
        """The frames that a merged joint and its child leave behind, with the custom data of both."""
        context, element = self.context, joint.element
        of_joint, of_link = frame_of(joint, context)
        self.merge(joint)
        context.carry(element, of_joint)
        context.carry_attributes(link, of_link)
        for child in element.children():
            if child.name not in _READ and not child.is_custom:
                context.keep(child, of_joint)
        context.carry_comments(element, of_joint)
        return [of_joint, of_link]

    def _free(self, joint: Joint) -> None:
        if joint.kind == "floating":
            text = f"joint `{joint.name}` has no counterpart: in SDFormat a link without joint floats"
            self.context.lose(joint.element, LossKind.APPROXIMATED_JOINT, text, Severity.INFO)
        else:
            text = f"SDFormat has no {joint.kind} joints; the child of joint `{joint.name}` floats freely"
            self.context.lose(joint.element, LossKind.APPROXIMATED_JOINT, text)


def frame_of(joint: Joint, context: Context) -> tuple[Xml, Xml]:
    """The frames that a merged joint and its child leave behind, attached to the link that survives."""
    plan, names = context.plan, context.plan.names
    survivor, outer = plan.home[joint.parent]
    pose = outer @ inverse(plan.robot.links[joint.parent].pose) @ joint.pose
    nodes = []
    for name in (names.joints[joint.name], names.links[joint.child]):
        node = Xml("frame", None, name=name, attached_to=names.links[survivor])
        if (text := pose_of(pose)) is not None:
            node.add("pose", text)
        nodes.append(node)
    nodes[1].attributes.update({JOINT: names.joints[joint.name], PARENT: names.links[joint.parent]})
    return nodes[0], nodes[1]
