"""Values of a model that its text leaves to defaults, and those that URDF writes otherwise.

The robot that comes out moves and weighs as the model does, and is what the URDF is
compared with: every link has its mass, every moving joint its axis.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from sdfcheck.convert.sdf_to_urdf.options import Planes
from sdfcheck.convert.sdf_to_urdf.shapes import pieces
from sdfcheck.robot.motion.mass import default_mass
from sdfcheck.robot.motion.mechanism import Axis, Joint, Link, Mechanism, Mimic
from sdfcheck.robot.motion.poses import Array

ONE_AXIS = frozenset({"revolute", "continuous", "prismatic", "screw", "planar"})
TWO_AXES = frozenset({"universal", "revolute2"})
_UP = (0.0, 0.0, 1.0)


def understood(
    robot: Mechanism, planes: Planes = Planes.DROP, natives: frozenset[str] = frozenset()
) -> Mechanism:
    """The robot with defaults filled in, without gearboxes: those are a coupling of two other joints.

    ``natives`` are shapes that stay what they are.
    """
    links = {name: _link(link, planes, natives) for name, link in robot.links.items()}
    joints = {name: _joint(joint) for name, joint in robot.joints.items()}
    for gearbox in robot.joints.values():
        if gearbox.kind == "gearbox":
            _couple(joints, gearbox)
    kept = {name: joint for name, joint in joints.items() if joint.kind != "gearbox"}
    return Mechanism(robot.name, links, kept, robot.frames)


def _link(link: Link, planes: Planes, natives: frozenset[str]) -> Link:
    body = default_mass() if link.body is None else link.body
    shown = [
        piece
        for geometry in link.geometries
        for piece in ([geometry] if geometry.kind in natives else pieces(geometry, planes))
    ]
    return Link(link.name, link.pose, link.element, body, shown)


def _joint(joint: Joint) -> Joint:
    wanted = 1 if joint.kind in ONE_AXIS else 2 if joint.kind in TWO_AXES else 0
    axes = list(joint.axes[:wanted])
    axes += [Axis(np.array(_UP)) for _ in range(wanted - len(axes))]
    kind = joint.kind
    if kind == "continuous":
        axes[0] = replace(axes[0], lower=-math.inf, upper=math.inf)
    elif kind == "revolute" and math.isinf(axes[0].lower) and math.isinf(axes[0].upper):
        kind = "continuous"
    return replace(joint, kind=kind, axes=tuple(axes))


def _couple(joints: dict[str, Joint], gearbox: Joint) -> None:
    """Let the output turn as the gearbox makes it, where both its joints start at the reference body."""
    found = coupling(list(joints.values()), gearbox)
    if found is not None:
        joint, mimic = found
        joints[joint.name] = replace(joint, axes=(replace(joint.axes[0], mimic=mimic),))


def coupling(joints: list[Joint], gearbox: Joint) -> tuple[Joint, Mimic] | None:
    """The joint that a gearbox drives, and how it follows; None where URDF cannot say it."""
    body = gearbox.element.find("gearbox_reference_body")
    ratio = gearbox.element.number("gearbox_ratio")
    if body is None or len(gearbox.axes) < 1:
        return None
    scope = gearbox.name.rpartition("::")[0]
    reference = f"{scope}::{body.content}" if scope else body.content

    def turning(child: str) -> Joint | None:
        ends = (reference, child)
        kinds = {"revolute", "continuous"}
        return next((j for j in joints if (j.parent, j.child) == ends and j.kind in kinds), None)

    driver, driven = turning(gearbox.parent), turning(gearbox.child)
    if driver is None or driven is None or driven.axes[0].mimic is not None:
        return None
    first = gearbox.axes[0].direction
    second = gearbox.axes[1].direction if len(gearbox.axes) > 1 else first
    sign = _agreement(gearbox, first, driver) * _agreement(gearbox, second, driven)
    if sign == 0:
        return None
    return driven, Mimic(driver.name, -sign * (ratio.number if ratio is not None else 1.0))


def _agreement(gearbox: Joint, direction: Array, joint: Joint) -> int:
    """Do the axes of a gearbox and of a joint point the same way (1), against each other (-1) or apart (0)?"""
    cosine = float((gearbox.pose[:3, :3] @ direction) @ (joint.pose[:3, :3] @ joint.axes[0].direction))
    return 0 if abs(abs(cosine) - 1) > 1e-6 else 1 if cosine > 0 else -1
