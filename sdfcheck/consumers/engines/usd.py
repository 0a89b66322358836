"""OpenUSD by urdf-usd-converter: the robot that Isaac Sim and Newton take in."""

from __future__ import annotations

import importlib.metadata
import math
from typing import Any

import numpy as np

_PHYSICS = "physics:"


def version() -> str:
    import urdf_usd_converter
    from pxr import UsdPhysics

    del urdf_usd_converter, UsdPhysics
    return importlib.metadata.version("urdf-usd-converter")


def load(question: dict[str, Any]) -> Any:
    """Convert a file into the current folder, and open the result."""
    import urdf_usd_converter
    from pxr import Usd

    packages = [{"name": name, "path": folder} for name, folder in question.get("packages", ())]
    converter = urdf_usd_converter.Converter(layer_structure=False, ros_packages=packages)
    return Usd.Stage.Open(converter.convert(question["path"], ".").path)


def facts(model: Any, settings: dict[str, Any]) -> dict[str, Any]:
    from pxr import UsdGeom, UsdPhysics

    bodies: dict[str, Any] = {}
    joints: dict[str, Any] = {}
    poses: dict[str, Any] = {}
    for prim in model.Traverse():
        if prim.IsA(UsdPhysics.Joint):
            if joint := _joint(prim):
                joints[_name(prim)] = joint
        elif prim.IsA(UsdGeom.Xform) and "Geometry" in str(prim.GetPath()):
            bodies[_name(prim)] = _body(prim) if prim.HasAPI(UsdPhysics.MassAPI) else None
            matrix = UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(0)
            poses[_name(prim)] = np.array(matrix).T.tolist()
    return {"bodies": bodies, "joints": joints, "poses": [poses]}


def _name(prim: Any) -> str:
    """The name in the source, which USD may not allow as it is."""
    return str(prim.GetDisplayName() or prim.GetName())


def _value(prim: Any, name: str) -> Any:
    return prim.GetAttribute(_PHYSICS + name).Get()


def _body(prim: Any) -> list[Any]:
    center = [float(x) if math.isfinite(x) else 0.0 for x in _value(prim, "centerOfMass")]
    own = prim.GetAttribute("newton:inertia").Get()
    xx, yy, zz, xy, xz, yz = own if own is not None else (*_value(prim, "diagonalInertia"), 0, 0, 0)
    moments = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
    return [float(_value(prim, "mass")), center, [[float(x) for x in row] for row in moments]]


def _joint(prim: Any) -> dict[str, Any]:
    ends = [[str(one) for one in prim.GetRelationship(f"physics:body{n}").GetTargets()] for n in (0, 1)]
    kind = str(prim.GetTypeName()).removeprefix("Physics").removesuffix("Joint").lower()
    if not all(ends) or "/Geometry/" not in ends[0][0]:
        return {}
    scale = math.pi / 180 if kind == "revolute" else 1.0
    lower, upper = _value(prim, "lowerLimit"), _value(prim, "upperLimit")
    effort = prim.GetAttribute("urdf:limit:effort").Get()
    return {
        "kind": kind,
        "parent": ends[0][0].rpartition("/")[2],
        "child": ends[1][0].rpartition("/")[2],
        "axis": [],
        "lower": -math.inf if lower is None else float(lower) * scale,
        "upper": math.inf if upper is None else float(upper) * scale,
        "effort": math.inf if effort is None else float(effort),
        "velocity": math.inf,
    }
