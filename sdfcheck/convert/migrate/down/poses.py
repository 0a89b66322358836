"""Poses as older versions write them: plain numbers, relative to what the format prescribes."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate import numbers
from sdfcheck.convert.migrate.migration import Migration
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.places import Places
from sdfcheck.robot.motion.poses import PoseError, written_pose
from sdfcheck.robot.motion.rotations import Array, inverse
from sdfcheck.robot.node import Node as RobotNode
from sdfcheck.robot.parts.placement import reference_of
from sdfcheck.robot.scope import Scope

_FORMAT = ("rotation_format", "degrees")


def resolve_poses(migration: Migration) -> None:
    """Write poses without what the target lacks: references, other spellings of rotations, placement frames."""
    places, everything = Places(migration), migration.goes_below(7)
    changes: list[tuple[Node, Node | None, Array]] = []
    for owner in migration.root.standard():
        pose = owner.find("pose")
        placed = migration.goes_below(8) and owner.name in {"model", "include"} and places.is_placed(owner)
        if not placed and (pose is None or not _needs_change(pose, everything)):
            continue
        try:
            refers = everything and pose is not None and bool((pose.get("relative_to") or "").strip())
            plain = refers or placed
            element = migration.draft.element(owner).find("pose")
            changes.append((owner, pose, places.plain(owner) if plain else written_pose(element)))
        except (PoseError, KeyError) as error:
            migration.lose(pose or owner, f"the pose cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
    for owner, pose, value in changes:
        _write(migration, owner, pose, value, everything=everything)


def _needs_change(pose: Node, everything: bool) -> bool:
    given = pose.attributes()
    if everything and "relative_to" in given:
        return True
    return any(name in given for name in _FORMAT)


def _write(migration: Migration, owner: Node, pose: Node | None, value: Array, *, everything: bool) -> None:
    if migration.goes_below(8):
        owner.unset("placement_frame")
        if owner.name == "include" and (given := owner.find("placement_frame")) is not None:
            migration.merge(given)
    if pose is None:
        pose = owner.add("pose", first=True)
    text = numbers.pose(value)
    if _differs(pose, value):
        pose.write(text)
    for name in _FORMAT if migration.goes_below(9) else ():
        pose.unset(name)
    if everything or owner.name in {"model", "include"}:
        pose.unset("relative_to")


def _differs(pose: Node, value: Array) -> bool:
    """Does the text, read as plain radians, say something else?"""
    try:
        written = [float(part) for part in pose.content.split()]
    except ValueError:
        return True
    if not written and not pose.attributes().keys() & set(_FORMAT):
        return bool(np.abs(value - np.eye(4)).max() > 0)
    from sdfcheck.robot.motion.rotations import from_rpy, transform

    if len(written) != 6:
        return True
    return bool(np.abs(transform(from_rpy(*written[3:]), written[:3]) - value).max() > 1e-15)


def attach_joints_to_links(migration: Migration) -> None:
    """Below 1.8: a joint's parent and child are links; its pose stays where it was."""
    places = Places(migration)
    changes: list[tuple[Node, str, Array | None]] = []
    for joint in migration.root.of("joint"):
        frame = places.frame(joint)
        if frame is None:
            continue
        for role in ("parent", "child"):
            end = joint.find(role)
            named = places.named(frame, end.content) if end is not None else None
            if end is None or named is None or named.kind in {"link", "world"}:
                continue
            found = places.carrier(named)
            if found is None:
                text = f"{role} {end.content!r} of joint `{frame.name}` leads to no link"
                migration.lose(end, text, LossKind.UNKNOWN_REFERENCE)
                continue
            link, name = _as_seen(frame.scope, *found, named)
            moved = role == "child" and not reference_of(frame.element.find("pose"))
            pose = None
            if moved:
                pose = inverse(places.poses.reached(frame.scope, link)) @ places.poses.in_scope(frame)
            changes.append((end, name, pose))
    for end, name, pose in changes:
        migration.note(
            end, f"{end.name} `{end.content}` is written as its link `{name}`", LossKind.DROPPED_FRAME
        )
        end.write(name)
        own = end.parent.find("pose") if end.parent is not None else None
        if pose is not None and end.parent is not None and (own or np.abs(pose - np.eye(4)).max() > 0):
            own = own or end.parent.add("pose", first=True)
            own.write(numbers.pose(pose))
            for attribute in _FORMAT:
                own.unset(attribute)


def _as_seen(scope: Scope, link: RobotNode, name: str, named: RobotNode) -> tuple[RobotNode, str]:
    """A link and its name from a scope above that of the frame that leads to it."""
    at = named.scope
    while at is not scope and isinstance(at.holder, Scope):
        name = f"{at.name}::{name}"
        at = at.scope
    return link, name
