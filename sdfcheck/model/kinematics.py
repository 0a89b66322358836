"""Forward kinematics and total mass of a robot at any joint positions."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from sdfcheck.model.robot import Axis, Body, Joint, Robot
from sdfcheck.model.rotations import Array, about_axis, inverse, transform

Positions = Mapping[str, tuple[float, ...]]
"""Joint → its positions (rad or m), one for each axis; three for a ball joint (a rotation vector)."""


def degrees_of_freedom(joint: Joint) -> int:
    """How many positions a joint takes."""
    return {"fixed": 0, "ball": 3, "universal": 2, "revolute2": 2, "planar": 3, "floating": 6}.get(
        joint.kind, 1
    )


def motion(joint: Joint, positions: tuple[float, ...]) -> Array:
    """The 4×4 displacement of a joint's child in the joint's frame."""
    kind, axes = joint.kind, joint.axes
    if kind == "fixed" or not positions:
        return np.eye(4)
    if kind == "ball":
        angle = float(np.linalg.norm(positions))
        turn = about_axis(np.asarray(positions) / angle, angle) if angle > 0 else np.eye(3)
        return transform(turn, (0, 0, 0))
    if kind == "prismatic":
        return transform(np.eye(3), _direction(axes) * positions[0])
    if kind in {"universal", "revolute2"}:
        first = about_axis(_direction(axes), positions[0])
        return transform(first @ about_axis(_direction(axes, 1), positions[1]), (0, 0, 0))
    if kind == "screw":
        direction = _direction(axes)
        return transform(about_axis(direction, positions[0]), direction * joint.pitch * positions[0])
    if kind == "planar":
        across = _perpendicular(_direction(axes))
        along = across[0] * positions[0] + across[1] * positions[1]
        return transform(about_axis(_direction(axes), positions[2]), along)
    if kind == "floating":
        angle = float(np.linalg.norm(positions[3:]))
        turn = about_axis(np.asarray(positions[3:]) / angle, angle) if angle > 0 else np.eye(3)
        return transform(turn, positions[:3])
    return transform(about_axis(_direction(axes), positions[0]), (0, 0, 0))


def link_poses(robot: Robot, positions: Positions) -> dict[str, Array]:
    """The 4×4 pose of every link in the model's frame; joints that close loops are passed over.

    ``positions`` leaves out joints at zero; followers are worked out from their leaders.
    What hangs together is placed from the world, or else from its first link that no joint carries.
    """
    values = with_followers(robot, positions)
    beside: dict[str, list[Joint]] = {}
    for joint in robot.spanning():
        for end in (joint.parent, joint.child):
            beside.setdefault(end, []).append(joint)
    poses: dict[str, Array] = {}
    for start in ("world", *robot.roots(), *robot.links):
        if start in poses:
            continue
        poses[start] = _zero(robot, start)
        waiting = [start]
        while waiting:
            here = waiting.pop()
            for joint in beside.get(here, ()):
                there = joint.child if here == joint.parent else joint.parent
                if there not in poses:
                    poses[there] = poses[here] @ _step(robot, joint, values, here)
                    waiting.append(there)
    return {name: poses[name] for name in robot.links}


def _zero(robot: Robot, name: str) -> Array:
    link = robot.links.get(name)
    return np.eye(4) if link is None else link.pose


def _step(robot: Robot, joint: Joint, values: Positions, start: str) -> Array:
    """The pose of one end of a joint in the other, ``start``."""
    moved = joint.pose @ motion(joint, values.get(joint.name, ())) @ inverse(joint.pose)
    across = inverse(_zero(robot, joint.parent)) @ moved @ _zero(robot, joint.child)
    return across if start == joint.parent else inverse(across)


def with_followers(robot: Robot, positions: Positions) -> dict[str, tuple[float, ...]]:
    """The positions, with those of mimicking joints worked out (chains too; a ring keeps what is given)."""
    result = dict(positions)

    def value(name: str, seen: frozenset[str]) -> float:
        joint = robot.joints.get(name)
        mimic = joint.axes[0].mimic if joint is not None and joint.axes else None
        if mimic is not None and name not in seen and mimic.leader in robot.joints:
            leader = value(mimic.leader, seen | {name})
            return mimic.multiplier * (leader - mimic.reference) + mimic.offset
        given = result.get(name, ())
        return given[0] if given else 0.0

    for name, joint in robot.joints.items():
        if joint.axes and joint.axes[0].mimic is not None:
            result[name] = (value(name, frozenset()),)
    return result


def total_body(robot: Robot, poses: Mapping[str, Array]) -> Body | None:
    """All links joined at the given poses, in the model's frame; None if no link has mass properties."""
    total: Body | None = None
    for name, link in robot.links.items():
        if link.body is not None:
            body = link.body.seen_from(poses[name])
            total = body if total is None else total.joined_with(body)
    return total


def _direction(axes: tuple[Axis, ...], number: int = 0) -> Array:
    return axes[number].direction if len(axes) > number else np.array([0.0, 0.0, 1.0])


def _perpendicular(normal: Array) -> tuple[Array, Array]:
    """Two unit vectors that span the plane across a normal."""
    start = np.array([1.0, 0, 0]) if abs(normal[0]) < 0.9 else np.array([0, 1.0, 0])
    first = start - normal * float(normal @ start)
    first /= float(np.linalg.norm(first))
    return first, np.cross(normal, first)
