"""The directions of joint axes as older versions write them."""

from __future__ import annotations

import numpy as np

from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.migrate import numbers
from sdfcheck.convert.migrate.migration import Migration
from sdfcheck.convert.migrate.node import Node
from sdfcheck.convert.migrate.places import Places
from sdfcheck.formats.sdf.version import Version
from sdfcheck.robot.motion.poses import PoseError
from sdfcheck.robot.motion.rotations import Array
from sdfcheck.robot.node import Node as RobotNode

_MODEL = "__model__"
_FLAG = "use_parent_model_frame"
_CLOSE = 1e-15


def express_axes(migration: Migration) -> None:
    """Below 1.7: in the joint's frame or, flagged, in the model's; below 1.5 always in the model's."""
    places = Places(migration)
    changes: list[tuple[Node, Array, str]] = []
    for joint in migration.root.of("joint"):
        frame = places.frame(joint)
        if frame is None:
            continue
        axes = (*joint.children("axis"), *joint.children("axis2"))
        turned = ((axis, _turned(migration, places, frame, axis)) for axis in axes)
        changes += [(axis, *turn) for axis, turn in turned if turn is not None]
    for axis, turn, flag in changes:
        _write(migration, axis, turn, flag)


def _turned(migration: Migration, places: Places, joint: RobotNode, axis: Node) -> tuple[Array, str] | None:
    try:
        return _turn(migration, places, joint, axis)
    except (PoseError, ValueError) as error:
        migration.lose(axis, f"the axis cannot be resolved: {error}", LossKind.UNKNOWN_REFERENCE)
        return None


def _turn(migration: Migration, places: Places, joint: RobotNode, axis: Node) -> tuple[Array, str]:
    """How to turn the numbers, and what the flag is to say (nothing: no flag)."""
    xyz, flag = axis.find("xyz"), axis.find(_FLAG)
    expressed = (xyz.get("expressed_in") or "").strip() if xyz is not None else ""
    flagged = flag is not None and flag.content.lower() in {"true", "1"}
    source = migration.source
    if not expressed and source < Version(1, 7) and (flagged or source < Version(1, 5)):
        expressed = _MODEL
    to_model = migration.goes_below(5)
    in_joint = places.poses.in_scope(joint)[:3, :3] if expressed or to_model else np.eye(3)
    if not expressed:
        return (in_joint if to_model else np.eye(3)), ""
    if expressed == _MODEL:
        return np.eye(3), "" if to_model else "true"
    in_model = places.poses.named(joint.scope, expressed)[:3, :3]
    return (in_model if to_model else in_joint.T @ in_model), ""


def _write(migration: Migration, axis: Node, turn: Array, flag: str) -> None:
    xyz, old = axis.find("xyz"), axis.find(_FLAG)
    if xyz is not None:
        xyz.unset("expressed_in")
    if np.abs(turn - np.eye(3)).max() > _CLOSE:
        text = xyz.content if xyz is not None and xyz.content else "0 0 1"
        turned = turn @ np.array([float(part) for part in text.split()])
        (xyz or axis.add("xyz")).write(numbers.vector(turned))
    elif xyz is None and migration.goes_below(5):
        axis.add("xyz").write("0 0 1")  # the default since 1.5; before, there must be one
    if flag and old is None:
        added = Node(_FLAG)
        added.parts.append(flag)
        axis.append(added, after=xyz)
    elif flag and old is not None and old.content.lower() not in {"true", "1"}:
        old.write(flag)
    elif not flag and old is not None:
        migration.merge(old)
