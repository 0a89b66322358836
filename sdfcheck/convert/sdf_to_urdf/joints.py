"""Joints: where they are, how they move, what stops them."""

from __future__ import annotations

import math

import numpy as np

from sdfcheck.convert.ledger import TEXT
from sdfcheck.convert.loss import LossKind, refusal
from sdfcheck.convert.sdf_to_urdf.extensions import (
    carry_comments,
    carry_inside,
    carry_parts,
    joint_extensions,
    keep_base,
    keep_joint,
)
from sdfcheck.convert.sdf_to_urdf.links import TWO_AXES
from sdfcheck.convert.sdf_to_urdf.plan import Context, Edge, Unsupported, add_origin, shortened
from sdfcheck.convert.writer import MERGED, number
from sdfcheck.formats.sdf.values import floats
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.graph import ENDLESS
from sdfcheck.robot.motion.mass import SMALL
from sdfcheck.robot.motion.mechanism import Axis, Joint
from sdfcheck.robot.motion.poses import Array, inverse
from sdfcheck.source.altered import Xml
from sdfcheck.source.document import Element

# Limits, dynamics and mimics of joints.
#
# SDF leaves unlimited bounds out; URDF before 1.2 requires numbers, and reads an absent one as 0.


def enter_axis(context: Context, joint: Joint, which: int) -> None:
    """Enter what of an axis is written."""
    axis = joint.element.find("axis" if which == 0 else "axis2")
    if axis is None:
        message = f"{joint.element.title} has no axis: 0 0 1 is written, as simulators take"
        context.ledger.note(LossKind.CHANGED_DEFAULT, joint.element, message, Severity.INFO)
        return
    ledger = context.ledger
    ledger.take_parts(axis, "xyz", "use_parent_model_frame")
    ledger.take_parts(axis.find("limit"), "lower", "upper", "effort", "velocity")
    ledger.take_parts(axis.find("dynamics"), "damping", "friction")
    if joint.kind == "continuous" and (limit := axis.find("limit")) is not None:
        _report_useless(context, joint, limit)


def _report_useless(context: Context, joint: Joint, limit: Element) -> None:
    given = [name for name in ("lower", "upper") if abs(_number(limit, name)) < ENDLESS]
    if given and joint.element.attributes.get("type", "").strip() == "continuous":
        message = (
            f"the {' and '.join(given)} limit of {joint.element.title} is left out: it turns without end"
        )
        context.ledger.note(LossKind.CHANGED_LIMIT, limit, message)


def _number(limit: Element, name: str) -> float:
    value = limit.number(name)
    return math.inf if value is None else value.number


def add_limit(context: Context, node: Xml, joint: Joint, axis: Axis) -> None:
    """Write the limits of an axis."""
    kind = node.attributes["type"]
    unlimited = context.options.unlimited
    bounds = {"effort": axis.effort, "velocity": axis.velocity}
    if kind == "continuous" and all(math.isinf(bound) for bound in bounds.values()):
        return
    attributes = {}
    if kind != "continuous":
        attributes = {
            "lower": number(max(axis.lower, -unlimited)),
            "upper": number(min(axis.upper, unlimited)),
        }
        _report_unlimited(context, joint, axis)
    attributes.update((name, number(min(bound, unlimited))) for name, bound in bounds.items())
    node.add("limit", **attributes)


def _report_unlimited(context: Context, joint: Joint, axis: Axis) -> None:
    open_ends = [name for name in ("lower", "upper") if math.isinf(getattr(axis, name))]
    if open_ends:
        message = (
            f"{joint.element.title} has no {' and no '.join(open_ends)} limit: "
            f"{number(context.options.unlimited)} is written, as URDF wants a number"
        )
        at = joint.element.find("axis")
        context.ledger.note(
            LossKind.CHANGED_LIMIT, at if at is not None else joint.element, message, Severity.INFO
        )


def add_dynamics(node: Xml, axis: Axis) -> None:
    if axis.damping or axis.friction:
        node.add("dynamics", damping=number(axis.damping), friction=number(axis.friction))


def add_mimic(context: Context, node: Xml, joint: Joint, axis: Axis) -> None:
    """Write how a joint follows another; the reference goes into the offset."""
    mimic = axis.mimic
    written = next(
        (found for part in joint.element.children() if (found := part.find("mimic")) is not None), None
    )
    if mimic is None:
        return
    leader = context.robot.joints.get(mimic.leader)
    second = written is not None and written.attributes.get("axis", "axis").strip() == "axis2"
    if leader is None or second or joint.kind in TWO_AXES or leader.kind in TWO_AXES or not leader.moves:
        if written is not None:
            message = f"URDF cannot say how {joint.element.title} follows `{mimic.leader}`"
            context.ledger.lose(LossKind.DROPPED_MIMIC, written, message)
        context.unmimicked.add(joint.name)
        return
    offset = mimic.offset - mimic.multiplier * mimic.reference
    if written is not None:
        context.ledger.take_all(written)
    node.add(
        "mimic",
        joint=context.joints[mimic.leader],
        multiplier=number(mimic.multiplier),
        offset=number(offset),
    )


_SAME_IN_URDF = frozenset({"revolute", "continuous", "prismatic", "fixed"})


def add_edge(context: Context, edge: Edge) -> None:
    """Write a joint of the tree."""
    joint = context.robot.joints[edge.joint.name]
    element = joint.element
    context.ledger.take_parts(element, "parent", "child", "pose")
    for pitch in ("screw_thread_pitch", "thread_pitch"):
        context.ledger.take(element.find(pitch), TEXT)
    carry_comments(context, context.root, element)
    if edge.is_reversed:
        _report_reversed(context, edge)
    parent, child = context.link_name(edge.parent), context.link_name(edge.child)
    below = context.layout.joint_links.get(edge.child)
    carried = below[0] if below is not None else child
    if _is_for_drake(context, edge, joint):
        written = _add_unsupported(context, edge, joint, parent, carried)
    elif joint.kind in TWO_AXES:
        written = _add_two_axes(context, edge, joint, parent, carried)
    elif joint.kind == "screw":
        written = _add_screw(context, edge, joint, parent, carried)
    elif joint.kind in _SAME_IN_URDF:
        written = _add_plain(context, edge, joint, parent, carried)
    elif joint.kind == "planar" and not edge.is_reversed:
        written = _add_planar(context, edge, joint, parent, carried)
    else:
        written = _add_unsupported(context, edge, joint, parent, carried)
    scope = joint.name.rpartition("::")[0]
    ends = ("parent=child", "child=parent") if edge.is_reversed else ("parent", "child")
    carry_parts(context, written, element, scope, "pose=origin", *ends)
    if below is not None:
        context.root.add("link", name=below[0])
        add_fixed(
            context,
            f"{below[0]}_fixed",
            below[0],
            child,
            inverse(below[1]) @ context.layout.frames[edge.child],
        )
    if joint.name not in context.kept and element.name == "joint":
        joint_extensions(context, joint.name, context.joints[joint.name])
    carry_inside(context, written, element)


def add_fixed(context: Context, name: str, parent: str, child: str, pose: Array, kind: str = "fixed") -> str:
    """A joint that the source does not have; returns its name."""
    name = context.naming.unique(name)
    node = context.root.add("joint", name=name, type=kind)
    _connect(node, parent, child, pose)
    return name


def _connect(
    node: Xml, parent: str, child: str, pose: Array | None, authors: tuple[Element | None, ...] = ()
) -> None:
    if pose is not None:
        add_origin(node, pose, *authors)
    node.add("parent", link=parent)
    node.add("child", link=child)


def _start(context: Context, edge: Edge) -> tuple[Array, tuple[Element | None, ...]]:
    """The pose of the joint in its parent, and the elements that may say the same."""
    child = context.robot.links.get(edge.child)
    places = (edge.joint.element, child.element if child is not None else None)
    authors = tuple(None if place is None else place.find("pose") for place in places)
    return context.layout.within(edge.parent, edge.joint.pose), authors


def _add_plain(context: Context, edge: Edge, joint: Joint, parent: str, child: str) -> Xml:
    name = context.joints[joint.name]
    node = context.root.add("joint", name=name, type=joint.kind)
    _connect(node, parent, child, *_start(context, edge))
    if joint.kind == "fixed":
        _enter_fixed(context, joint, name)
        return node
    enter_axis(context, joint, 0)
    _add_axis(context, node, joint, joint.axes[0], edge)
    return node


def _add_planar(context: Context, edge: Edge, joint: Joint, parent: str, child: str) -> Xml:
    """A ``drake:joint`` of SDFormat is a plain joint of URDF, which has planar ones."""
    node = context.root.add("joint", name=context.joints[joint.name], type="planar")
    _connect(node, parent, child, *_start(context, edge))
    keep_base(context, context.joints[joint.name], _start(context, edge)[0], parent)
    node.add("axis", xyz="0 0 1")
    if (damping := joint.element.find("drake:damping")) is not None and any(
        values := floats(damping.content) or ()
    ):
        message = (
            f"the damping of planar {joint.element.title} is left out: urdfdom refuses {len(values)} numbers"
        )
        context.ledger.lose(LossKind.DROPPED_ELEMENT, damping, message)
    return node


def _add_axis(context: Context, node: Xml, joint: Joint, axis: Axis, edge: Edge) -> None:
    direction = -axis.direction if edge.is_reversed else axis.direction
    written = node.add("axis", xyz=shortened(direction))
    add_limit(context, node, joint, axis)
    add_dynamics(node, axis)
    add_mimic(context, node, joint, axis)
    source = joint.element.find("axis" if axis is joint.axes[0] else "axis2")
    if source is None:
        return
    scope = joint.name.rpartition("::")[0]
    carry_parts(context, written, source, scope)
    for part in source.children():
        equal = written if part.name == "xyz" else node.find(part.name)
        if part.name in {"xyz", "limit", "dynamics", "mimic"} and equal is not None:
            carry_parts(context, equal, part, scope)


def _enter_fixed(context: Context, joint: Joint, name: str) -> None:
    """A fixed joint's axis says nothing, but a coupling there would; libsdformat is asked to keep the joint."""
    for axis in joint.element.children():
        if axis.name in {"axis", "axis2"}:
            if (mimic := axis.find("mimic")) is not None:
                message = f"the mimic of {joint.element.title} is left out: the joint is fixed"
                context.ledger.lose(LossKind.DROPPED_MIMIC, mimic, message)
            context.ledger.take_all(axis)
    if MERGED not in joint.element.attributes:
        context.blob(name).add("preserveFixedJoint", "true")


def _add_two_axes(context: Context, edge: Edge, joint: Joint, parent: str, child: str) -> Xml:
    """Two revolute joints with a small link between them; their motion is exact, also in reverse."""
    name = context.joints[joint.name]
    names = (name, context.naming.unique(f"{name}_axis2"))
    between = _add_between(context, name)
    order = (1, 0) if edge.is_reversed else (0, 1)
    ends = ((parent, between), (between, child))
    made = []
    for (above, below), which in zip(ends, order, strict=True):
        axis = joint.axes[which]
        node = context.root.add("joint", name=names[which], type=_turning(axis))
        _connect(node, above, below, *(_start(context, edge) if above == parent else (None,)))
        _add_axis(context, node, joint, axis, edge)
        made.append(node)
        enter_axis(context, joint, which)
    context.parts[joint.name] = names
    _report_split(context, joint, f"joints `{names[0]}` and `{names[1]}`", between)
    return made[0]


def _turning(axis: Axis) -> str:
    return "continuous" if math.isinf(axis.lower) and math.isinf(axis.upper) else "revolute"


def _add_screw(context: Context, edge: Edge, joint: Joint, parent: str, child: str) -> Xml:
    """A turning joint, and a sliding one that follows it."""
    name = context.joints[joint.name]
    travel, between = context.naming.unique(f"{name}_travel"), _add_between(context, name)
    axis = joint.axes[0]
    node = context.root.add("joint", name=name, type=_turning(axis))
    _connect(node, parent, between, *_start(context, edge))
    _add_axis(context, node, joint, axis, edge)
    enter_axis(context, joint, 0)
    slide = context.root.add("joint", name=travel, type="prismatic")
    _connect(slide, between, child, None)
    direction = -axis.direction if edge.is_reversed else axis.direction
    slide.add("axis", xyz=shortened(direction))
    unlimited = number(context.options.unlimited)
    reach = sorted(
        _finite(limit * joint.pitch, context.options.unlimited) for limit in (axis.lower, axis.upper)
    )
    slide.add("limit", lower=number(reach[0]), upper=number(reach[1]), effort=unlimited, velocity=unlimited)
    slide.add("mimic", joint=name, multiplier=number(joint.pitch), offset="0")
    _report_split(context, joint, f"joint `{name}` and `{travel}`, which follows it", between)
    return node


def _add_between(context: Context, joint: str) -> str:
    """The name of a new link that parts the joints that a joint becomes.

    It has some mass: libsdformat drops a moving link without, and everything below it; MuJoCo refuses it.
    """
    name = context.naming.unique(f"{joint}_between")
    inertial = context.root.add("link", name=name).add("inertial")
    inertial.add("mass", value=number(SMALL.mass))
    moments = {
        f"i{a}{b}": number(SMALL.moments[i, j])
        for i, a in enumerate("xyz")
        for j, b in enumerate("xyz")
        if i <= j
    }
    inertial.add("inertia", **moments)
    context.between.add(name)
    return name


def _finite(value: float, unlimited: float) -> float:
    return value if math.isfinite(value) else math.copysign(unlimited, value)


def _report_split(context: Context, joint: Joint, by: str, between: str) -> None:
    message = (
        f"URDF has no {joint.kind} joint: {joint.element.title} is written as {by}, "
        f"with the new link `{between}` of {SMALL.mass:g} kg"
    )
    if context.natives:
        message += f"; Drake takes contacts between `{joint.parent}` and `{joint.child}` into account now"
    context.ledger.note(LossKind.APPROXIMATED_JOINT, joint.element, message)


def _add_unsupported(context: Context, edge: Edge, joint: Joint, parent: str, child: str) -> Xml:
    """A joint that URDF cannot express, by the user's choice."""
    policy = context.options.ball
    what = f"URDF has no {joint.kind} joint"
    if policy is Unsupported.ERROR:
        raise refusal(joint.element, f"{what}, as {joint.element.title} is")
    context.floating.add(joint.name)
    name = context.joints[joint.name]
    node = context.root.add("joint", name=name, type=policy.value)
    _connect(node, parent, child, *_start(context, edge))
    message = f"{what}: {joint.element.title} is written as {policy.value}"
    if policy is Unsupported.FLOATING and joint.element.name == "joint":
        keep_joint(context, joint, in_parent=True)
        message += ", and kept for libsdformat"
    elif policy is Unsupported.FLOATING:
        keep_base(context, name, _start(context, edge)[0], parent)
    severity = Severity.ERROR
    if _is_for_drake(context, edge, joint):
        node = _add_for_drake(context, edge, joint, parent, child)
        message += ", and as `drake:joint` for Drake"
        severity = Severity.WARNING
    context.ledger.note(LossKind.APPROXIMATED_JOINT, joint.element, message, severity)
    return node


def _is_for_drake(context: Context, edge: Edge, joint: Joint) -> bool:
    """Is it a joint that Drake has in URDF, in a description that is written for it?"""
    if not context.natives or edge.is_reversed or context.options.ball is not Unsupported.FLOATING:
        return False
    if joint.kind == "universal":  # there it turns about x, then y
        directions = [axis.direction for axis in joint.axes]
        return len(directions) == 2 and bool(np.allclose(directions, np.eye(3)[:2], atol=1e-9))
    return joint.kind in {"ball", "curvilinear", "screw"}


def _add_for_drake(context: Context, edge: Edge, joint: Joint, parent: str, child: str) -> Xml:
    """Drake makes nothing of a floating joint, and this in its place."""
    node = context.root.add("drake:joint", name=context.joints[joint.name], type=joint.kind)
    _connect(node, parent, child, *_start(context, edge))
    axis = joint.element.find("axis")
    if joint.kind == "screw":
        node.add("axis", xyz=shortened(joint.axes[0].direction))
        node.add("drake:screw_thread_pitch", value=number(joint.pitch * 2 * math.pi))
        if 0 < joint.axes[0].effort < math.inf:
            message = (
                f"Drake reads no effort of screw {joint.element.title} in URDF: its actuator has no limit"
            )
            context.ledger.note(LossKind.CHANGED_LIMIT, joint.element, message)
    dynamics = axis.find("dynamics") if axis is not None else None
    damping = dynamics.find("damping") if dynamics is not None else joint.element.find("drake:damping")
    if damping is not None:
        node.add("dynamics", damping=" ".join(damping.content.split()))
    return node


def _report_reversed(context: Context, edge: Edge) -> None:
    message = (
        f"{edge.joint.element.title} goes the other way round, from `{edge.parent}` to `{edge.child}`: "
        "in a tree a link has one parent"
    )
    context.ledger.note(LossKind.REVERSED_JOINT, edge.joint.element, message)
