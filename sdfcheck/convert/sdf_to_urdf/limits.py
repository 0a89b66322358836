"""Limits, dynamics and mimics of joints.

SDF leaves unlimited bounds out; URDF before 1.2 requires numbers, and reads an absent one as 0.
"""

from __future__ import annotations

import math

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.sdf_to_urdf.context import Context
from sdfcheck.convert.sdf_to_urdf.plan.meaning import TWO_AXES
from sdfcheck.convert.writer import Node, number
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.robot.motion.mechanism import Axis, Joint
from sdfcheck.source.element import Element


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
    given = [name for name in ("lower", "upper") if abs(_number(limit, name)) < _ENDLESS]
    if given and joint.element.attributes.get("type", "").strip() == "continuous":
        message = (
            f"the {' and '.join(given)} limit of {joint.element.title} is left out: it turns without end"
        )
        context.ledger.note(LossKind.CHANGED_LIMIT, limit, message)


_ENDLESS = 1e15


def _number(limit: Element, name: str) -> float:
    value = limit.number(name)
    return math.inf if value is None else value.number


def add_limit(context: Context, node: Node, joint: Joint, axis: Axis) -> None:
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


def add_dynamics(node: Node, axis: Axis) -> None:
    if axis.damping or axis.friction:
        node.add("dynamics", damping=number(axis.damping), friction=number(axis.friction))


def add_mimic(context: Context, node: Node, joint: Joint, axis: Axis) -> None:
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
