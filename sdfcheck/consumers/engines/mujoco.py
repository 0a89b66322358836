"""MuJoCo: its compiler of URDF, and its simulation."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from sdfcheck.consumers.engines.behavior import Contact, Motion, World
from sdfcheck.consumers.engines.behavior import behave as behave_in

_KINDS = ("floating", "ball", "prismatic", "revolute")


def version() -> str:
    import mujoco

    return str(mujoco.__version__)


def load(question: dict[str, Any]) -> Any:
    import mujoco

    if question["action"] == "behave":
        spec = mujoco.MjSpec.from_file(question["path"])
        spec.compiler.fusestatic = False
        spec.compile()
        return spec
    return mujoco.MjModel.from_xml_path(question["path"])


def _turn(quaternion: Any) -> Any:
    import mujoco

    flat = np.zeros(9)
    mujoco.mju_quat2Mat(flat, quaternion)
    return flat.reshape(3, 3)


def _body(model: Any, number: int) -> list[Any]:
    turn = _turn(model.body_iquat[number])
    moments = turn @ np.diag(model.body_inertia[number]) @ turn.T
    return [float(model.body_mass[number]), model.body_ipos[number].tolist(), moments.tolist()]


def _pose(data: Any, number: int) -> list[list[float]]:
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = data.xmat[number].reshape(3, 3), data.xpos[number]
    return pose.tolist()


def _joint(model: Any, data: Any, number: int) -> dict[str, Any]:
    body = int(model.jnt_bodyid[number])
    limited, forced = bool(model.jnt_limited[number]), bool(model.jnt_actfrclimited[number])
    return {
        "kind": _KINDS[model.jnt_type[number]],
        "parent": model.body(model.body_parentid[body]).name,
        "child": model.body(body).name,
        "axis": data.xaxis[number].tolist(),
        "lower": float(model.jnt_range[number][0]) if limited else -math.inf,
        "upper": float(model.jnt_range[number][1]) if limited else math.inf,
        "velocity": math.inf,
        "effort": float(model.jnt_actfrcrange[number][1]) if forced else math.inf,
    }


def facts(model: Any, settings: dict[str, Any]) -> dict[str, Any]:
    import mujoco

    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    joints = {model.joint(n).name: _joint(model, data, n) for n in range(model.njnt)}
    poses = []
    for configuration in settings.get("configurations", [{}]):
        for number in range(model.njnt):
            name = model.joint(number).name
            if name in configuration and model.jnt_type[number] >= 2:
                data.qpos[model.jnt_qposadr[number]] = configuration[name]
        mujoco.mj_kinematics(model, data)
        poses.append({model.body(n).name: _pose(data, n) for n in range(1, model.nbody)})
    bodies = {model.body(n).name: _body(model, n) for n in range(1, model.nbody)}
    return {"bodies": bodies, "joints": joints, "poses": poses}


class MujocoWorld(World):
    """A robot in MuJoCo, of which no link is merged into another, nor the root into the world."""

    def __init__(self, spec: Any, motion: Motion) -> None:
        import mujoco

        self.mj = mujoco
        spec = spec.copy()
        spec.option.timestep = motion.time_step
        kinds = mujoco.mjtIntegrator
        # A robot that only falls keeps its energy; contacts with the ground want damping.
        spec.option.integrator = kinds.mjINT_IMPLICITFAST if motion.base == "free" else kinds.mjINT_RK4
        if not motion.gravity:
            spec.option.gravity = [0, 0, 0]
        self.free: list[str] = []
        if motion.base == "free":
            plane = mujoco.mjtGeom.mjGEOM_PLANE
            spec.worldbody.add_geom(name="ground", type=plane, size=[0, 0, 1], friction=[1, 0.005, 0.0001])
            for body in spec.worldbody.bodies:
                if not list(body.joints):
                    self.free.append(body.add_freejoint().name or body.name)
        self.model = spec.compile()
        self.data = mujoco.MjData(self.model)
        self.single = {
            self.model.joint(n).name: n for n in range(self.model.njnt) if self.model.jnt_type[n] >= 2
        }
        mujoco.mj_forward(self.model, self.data)

    def ranges(self) -> dict[str, tuple[float, float]]:
        model = self.model
        return {
            name: (float(model.jnt_range[n][0]), float(model.jnt_range[n][1]))
            if model.jnt_limited[n]
            else (-math.inf, math.inf)
            for name, n in self.single.items()
        }

    def place(self, positions: dict[str, float], height: float | None = None) -> None:
        self.mj.mj_resetData(self.model, self.data)
        for name, number in self.single.items():
            self.data.qpos[self.model.jnt_qposadr[number]] = positions.get(name, 0.0)
        if height is not None:
            for number in range(self.model.njnt):
                if self.model.jnt_type[number] == 0:
                    self.data.qpos[self.model.jnt_qposadr[number] + 2] = height
        self.mj.mj_forward(self.model, self.data)

    def contacts(self) -> list[Contact]:
        found = []
        for contact in self.data.contact[: self.data.ncon]:
            a, b = (self.model.geom_bodyid[geometry] for geometry in contact.geom)
            names = [self.model.body(n).name if n else "" for n in (a, b)]
            found.append(Contact(names[0], names[1], float(-contact.dist), contact.pos.tolist()))
        return found

    def advance(self, seconds: float) -> None:
        steps = max(1, round(seconds / self.model.opt.timestep))
        self.mj.mj_step(self.model, self.data, nstep=steps)
        if any(self.data.warning[kind].number for kind in _BAD):
            raise ArithmeticError("its positions, velocities or accelerations are not finite")

    def poses(self) -> dict[str, list[list[float]]]:
        self.mj.mj_kinematics(self.model, self.data)
        return {self.model.body(n).name: _pose(self.data, n) for n in range(1, self.model.nbody)}

    def speeds(self) -> dict[str, float]:
        self.mj.mj_forward(self.model, self.data)
        found, velocity = {}, np.zeros(6)
        for number in range(1, self.model.nbody):
            kind = self.mj.mjtObj.mjOBJ_BODY
            self.mj.mj_objectVelocity(self.model, self.data, kind, number, velocity, 0)
            found[self.model.body(number).name] = float(np.linalg.norm(velocity[3:]))
        return found

    def energy(self) -> float:
        self.mj.mj_energyPos(self.model, self.data)
        self.mj.mj_energyVel(self.model, self.data)
        return float(self.data.energy.sum())

    def loads(self) -> dict[str, float]:
        self.mj.mj_forward(self.model, self.data)
        return {
            name: float(self.data.qfrc_bias[self.model.jnt_dofadr[number]])
            for name, number in self.single.items()
        }


_BAD = (3, 4, 5)
"""The numbers of its warnings about positions, velocities and accelerations that are not finite."""


def behave(model: Any, settings: dict[str, Any]) -> dict[str, Any]:
    return behave_in(lambda motion: MujocoWorld(model, motion), settings)
