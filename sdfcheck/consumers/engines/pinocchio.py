"""Pinocchio: its model of a URDF file, without contacts."""

from __future__ import annotations

import math
from typing import Any

import numpy as np


def version() -> str:
    import pinocchio

    return str(pinocchio.__version__)


def load(question: dict[str, Any]) -> Any:
    import pinocchio

    return pinocchio.buildModelFromUrdf(question["path"])


def facts(model: Any, settings: dict[str, Any]) -> dict[str, Any]:
    import pinocchio

    data = model.createData()
    body = pinocchio.FrameType.BODY
    frames = {n: f for n, f in enumerate(model.frames) if f.type == body and f.name != "universe"}
    bodies = {f.name: _body(model, f) for f in frames.values()}
    poses: list[dict[str, Any]] = []
    for configuration in settings.get("configurations", [{}]):
        position = pinocchio.neutral(model)
        for number, joint in enumerate(model.joints):
            value = configuration.get(model.names[number])
            if number and value is not None and joint.nv == 1:
                both = (math.cos(value), math.sin(value))
                position[joint.idx_q : joint.idx_q + joint.nq] = both if joint.nq == 2 else value
        pinocchio.framesForwardKinematics(model, data, position)
        poses.append({f.name: data.oMf[n].homogeneous.tolist() for n, f in frames.items()})
    neutral = pinocchio.neutral(model)
    pinocchio.computeJointJacobians(model, data, neutral)
    pinocchio.framesForwardKinematics(model, data, neutral)
    joints = {model.names[n]: _joint(model, data, n, list(frames.values())) for n in range(1, model.njoints)}
    return {"bodies": bodies, "joints": joints, "poses": poses}


def _body(model: Any, frame: Any) -> list[Any] | None:
    """The body that a joint carries, as that of its link; links that are fixed to it have none, nor the base."""
    import pinocchio

    if not frame.parentJoint or model.frames[frame.parentFrame].type != pinocchio.FrameType.JOINT:
        return None
    inertia = frame.placement.actInv(model.inertias[frame.parentJoint])
    return [inertia.mass, inertia.lever.tolist(), inertia.inertia.tolist()]


def _joint(model: Any, data: Any, number: int, frames: list[Any]) -> dict[str, Any]:
    joint = model.joints[number]
    name, one = joint.shortname(), joint.nv == 1
    prismatic = name.startswith("JointModelP")
    column = np.array(data.J).reshape(6, -1)[:, joint.idx_v]
    direction = column[:3] if prismatic else column[3:]
    start = joint.idx_q
    bounded = one and joint.nq == 1
    own = next((f for f in model.frames if f.name == model.names[number]), None)
    parent = model.frames[own.parentFrame].name if own is not None else ""
    child = next((f.name for f in frames if model.frames[f.parentFrame].name == model.names[number]), "")
    return {
        "kind": "prismatic" if prismatic else "revolute" if one else name,
        "parent": parent,
        "child": child,
        "axis": direction.tolist() if one else [],
        "lower": float(model.lowerPositionLimit[start]) if bounded else -math.inf,
        "upper": float(model.upperPositionLimit[start]) if bounded else math.inf,
        "effort": float(model.effortLimit[joint.idx_v]) if one else math.inf,
        "velocity": float(model.velocityLimit[joint.idx_v]) if one else math.inf,
    }
