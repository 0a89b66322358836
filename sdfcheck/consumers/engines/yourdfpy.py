"""yourdfpy: its reading of a URDF file, and its kinematics."""

from __future__ import annotations

import importlib.metadata
import math
from typing import Any

import numpy as np


def version() -> str:
    import yourdfpy

    del yourdfpy
    return importlib.metadata.version("yourdfpy")


def load(question: dict[str, Any]) -> Any:
    import yourdfpy

    return yourdfpy.URDF.load(
        question["path"], load_meshes=False, build_scene_graph=True, mesh_dir="", filename_handler=str
    )


def facts(model: Any, settings: dict[str, Any]) -> dict[str, Any]:
    poses = []
    actuated = set(model.actuated_joint_names)
    for configuration in settings.get("configurations", [{}]):
        model.update_cfg({name: configuration.get(name, 0.0) for name in actuated})
        poses.append({name: model.get_transform(name).tolist() for name in model.link_map})
    bodies = {name: _body(link) for name, link in model.link_map.items()}
    joints = {name: _joint(joint, poses[0]) for name, joint in model.joint_map.items()}
    return {"bodies": bodies, "joints": joints, "poses": poses}


def _body(link: Any) -> list[Any] | None:
    inertial = link.inertial
    if inertial is None or inertial.mass is None or inertial.inertia is None:
        return None
    pose = np.eye(4) if inertial.origin is None else inertial.origin
    turn = pose[:3, :3]
    return [inertial.mass, pose[:3, 3].tolist(), (turn @ inertial.inertia @ turn.T).tolist()]


def _joint(joint: Any, poses: dict[str, Any]) -> dict[str, Any]:
    limit = joint.limit
    axis = np.array(poses[joint.child])[:3, :3] @ joint.axis
    length = float(np.linalg.norm(axis))

    def given(name: str, default: float) -> float:
        value = getattr(limit, name, None)
        return default if value is None else float(value)

    return {
        "kind": "revolute" if joint.type == "continuous" else joint.type,
        "parent": joint.parent,
        "child": joint.child,
        "axis": (axis / length).tolist() if length else [],
        "lower": given("lower", -math.inf),
        "upper": given("upper", math.inf),
        "effort": given("effort", math.inf),
        "velocity": given("velocity", math.inf),
    }
