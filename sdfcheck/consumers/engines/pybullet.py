"""PyBullet: its importers of URDF and SDFormat, and its simulation."""

from __future__ import annotations

import importlib.metadata
import math
import os
import re
from pathlib import Path
from typing import Any

import numpy as np

from sdfcheck.consumers.engines.behavior import Contact, Motion, World
from sdfcheck.consumers.engines.behavior import behave as behave_in
from sdfcheck.consumers.engines.child import Refused

_KINDS = ("revolute", "prismatic", "ball", "planar", "fixed")
_ENDLESS = 1e9
_RELATIVE = re.compile(r"""(\sfilename\s*=\s*["'])(?!/|\w+:)""")
"""The beginning of a relative path."""


def version() -> str:
    import pybullet

    del pybullet
    return importlib.metadata.version("pybullet")


class Loaded:
    """A file in a client of its own."""

    def __init__(self, question: dict[str, Any], *, held: bool = False, gravity: bool = True) -> None:
        import pybullet as bullet

        self.question = question
        self.bullet = bullet
        self.client = bullet.connect(bullet.DIRECT)
        for path in question.get("model_paths", ()):
            bullet.setAdditionalSearchPath(path, self.client)
        # Not URDF_MAINTAIN_LINK_ORDER: with it PyBullet 3.2.7 writes beyond an array of large robots.
        flags = bullet.URDF_USE_INERTIA_FROM_FILE | bullet.URDF_USE_SELF_COLLISION
        try:
            if question["path"].endswith((".sdf", ".world")):
                robots = bullet.loadSDF(question["path"], physicsClientId=self.client)
            else:
                robots = [
                    bullet.loadURDF(
                        with_packages(question), useFixedBase=held, flags=flags, physicsClientId=self.client
                    )
                ]
        except bullet.error as error:
            raise Refused(str(error)) from None
        if not robots:
            raise Refused("it finds no model in the file")
        self.robot = robots[0]
        if gravity:
            bullet.setGravity(0, 0, -9.81, physicsClientId=self.client)
        count = bullet.getNumJoints(self.robot, self.client)
        self.joints = [bullet.getJointInfo(self.robot, n, self.client) for n in range(count)]
        base = bullet.getBodyInfo(self.robot, self.client)[0].decode("utf-8", "replace")
        self.names = [base, *(joint[12].decode("utf-8", "replace") for joint in self.joints)]
        self.single = {
            joint[1].decode("utf-8", "replace"): joint for joint in self.joints if joint[2] in (0, 1)
        }

    def matrix(self, position: Any, quaternion: Any) -> Any:
        pose = np.eye(4)
        pose[:3, :3] = np.array(self.bullet.getMatrixFromQuaternion(quaternion)).reshape(3, 3)
        pose[:3, 3] = position
        return pose

    def inertial(self, number: int) -> tuple[float, Any, Any]:
        """Mass, moments along the principal axes, and the pose of the center of mass in the link's frame."""
        found = self.bullet.getDynamicsInfo(self.robot, number, self.client)
        return found[0], np.array(found[2]), self.matrix(found[3], found[4])

    def poses(self) -> dict[str, Any]:
        """The poses of the frames of links."""
        bullet, found = self.bullet, {}
        position, turn = bullet.getBasePositionAndOrientation(self.robot, self.client)
        base = self.matrix(position, turn) @ np.linalg.inv(self.inertial(-1)[2])
        found[self.names[0]] = base.tolist()
        for number, name in enumerate(self.names[1:]):
            state = bullet.getLinkState(
                self.robot, number, computeForwardKinematics=1, physicsClientId=self.client
            )
            found[name] = self.matrix(state[4], state[5]).tolist()
        return found

    def place(self, positions: dict[str, float]) -> None:
        for name, joint in self.single.items():
            value = positions.get(name, 0.0)
            self.bullet.resetJointState(self.robot, joint[0], value, 0.0, self.client)


def with_packages(question: dict[str, Any]) -> str:
    """The file; a copy names the folders of packages, which PyBullet looks for above the file, by their own names."""
    path: str = question["path"]
    packages = question.get("packages", ())
    above = [folder / name for folder in Path(path).absolute().parents for name, _ in packages]
    if not question.get("is_copy") and all(Path(folder) in above for _, folder in packages):
        return path
    text = Path(path).read_text("utf-8", "surrogateescape")
    for name, folder in packages:
        text = text.replace(f"package://{name}/", f"{folder}/")
    if not question.get("is_copy"):  # relative paths lead from the file
        text = _RELATIVE.sub(lambda found: f"{found[1]}{os.path.dirname(path)}/", text)
    Path("copy.urdf").write_text(text, "utf-8", "surrogateescape")
    return os.path.abspath("copy.urdf")


def load(question: dict[str, Any]) -> Loaded:
    return Loaded(question)


def _range(joint: Any) -> tuple[float, float]:
    """A joint whose upper limit is not above its lower one has none."""
    lower, upper = float(joint[8]), float(joint[9])
    return (lower, upper) if lower <= upper else (-math.inf, math.inf)


def facts(model: Loaded, settings: dict[str, Any]) -> dict[str, Any]:
    bodies, joints, poses = {}, {}, []
    for number, name in enumerate(model.names, -1):
        mass, moments, frame = model.inertial(number)
        turn = frame[:3, :3]
        bodies[name] = [mass, frame[:3, 3].tolist(), (turn @ np.diag(moments) @ turn.T).tolist()]
    for configuration in settings.get("configurations", [{}]):
        model.place(configuration)
        poses.append(model.poses())
    for joint in model.joints:
        lower, upper = _range(joint)
        principal = np.array(poses[0][joint[12].decode("utf-8", "replace")]) @ model.inertial(joint[0])[2]
        joints[joint[1].decode("utf-8", "replace")] = {
            "kind": _KINDS[joint[2]] if joint[2] < len(_KINDS) else "fixed",
            "parent": model.names[joint[16] + 1],
            "child": joint[12].decode("utf-8", "replace"),
            "axis": (principal[:3, :3] @ np.array(joint[13])).tolist(),
            "lower": lower,
            "upper": upper,
            "effort": float(joint[10]) or math.inf,
            "velocity": float(joint[11]) or math.inf,
        }
    return {"bodies": bodies, "joints": joints, "poses": poses}


class BulletWorld(World):
    """A robot in a client of its own; its joints have no motors."""

    def __init__(self, model: Loaded, motion: Motion) -> None:
        self.model = Loaded(model.question, held=motion.base == "held", gravity=motion.gravity)
        self.bullet, self.client, self.robot = model.bullet, self.model.client, self.model.robot
        self.bullet.setTimeStep(motion.time_step, self.client)
        self.time_step, self.gravity = motion.time_step, 9.81 if motion.gravity else 0.0
        self.base = motion.base
        if motion.base == "free":
            plane = self.bullet.createCollisionShape(self.bullet.GEOM_PLANE, physicsClientId=self.client)
            self.ground = self.bullet.createMultiBody(0, plane, physicsClientId=self.client)
        for number in range(-1, len(self.model.joints)):
            self.bullet.changeDynamics(
                self.robot, number, linearDamping=0, angularDamping=0, jointDamping=0,
                lateralFriction=1.0, activationState=self.bullet.ACTIVATION_STATE_DISABLE_SLEEPING,
                physicsClientId=self.client,
            )  # fmt: skip
        for joint in self.model.single.values():
            control = self.bullet.VELOCITY_CONTROL
            self.bullet.setJointMotorControl2(
                self.robot, joint[0], control, force=0, physicsClientId=self.client
            )

    def ranges(self) -> dict[str, tuple[float, float]]:
        return {name: _range(joint) for name, joint in self.model.single.items()}

    def place(self, positions: dict[str, float], height: float | None = None) -> None:
        frame = self.model.inertial(-1)[2]
        place = frame[:3, 3] + np.array([0, 0, height or 0.0])
        turn = self.bullet.getDynamicsInfo(self.robot, -1, self.client)[4]
        self.bullet.resetBasePositionAndOrientation(self.robot, place, turn, self.client)
        self.bullet.resetBaseVelocity(self.robot, (0, 0, 0), (0, 0, 0), self.client)
        self.model.place(positions)

    def contacts(self) -> list[Contact]:
        self.bullet.performCollisionDetection(self.client)
        found = []
        for point in self.bullet.getContactPoints(physicsClientId=self.client):
            ends = [
                self.model.names[link + 1] if body == self.robot else ""
                for body, link in ((point[1], point[3]), (point[2], point[4]))
            ]
            found.append(Contact(ends[0], ends[1], -float(point[8]), list(point[5])))
        return found

    def advance(self, seconds: float) -> None:
        for _ in range(max(1, round(seconds / self.time_step))):
            self.bullet.stepSimulation(self.client)

    def poses(self) -> dict[str, list[list[float]]]:
        return self.model.poses()

    def _velocities(self) -> list[tuple[Any, Any]]:
        base = self.bullet.getBaseVelocity(self.robot, self.client)
        links = (
            self.bullet.getLinkState(self.robot, n, computeLinkVelocity=1, physicsClientId=self.client)[6:8]
            for n in range(len(self.model.joints))
        )
        return [base, *links]

    def speeds(self) -> dict[str, float]:
        velocities = self._velocities()
        return {
            name: float(np.linalg.norm(linear))
            for name, (linear, _) in zip(self.model.names, velocities, strict=True)
        }

    def energy(self) -> float:
        poses, total = self.model.poses(), 0.0
        for number, (linear, angular) in enumerate(self._velocities(), -1):
            if number < 0 and self.base == "held":
                continue
            mass, moments, frame = self.model.inertial(number)
            pose = np.array(poses[self.model.names[number + 1]]) @ frame
            turning = pose[:3, :3].T @ np.array(angular)
            total += 0.5 * mass * float(np.dot(linear, linear)) + 0.5 * float(moments @ turning**2)
            total += mass * self.gravity * float(pose[2, 3])
        return total

    def loads(self) -> dict[str, float]:
        moving = [joint for joint in self.model.joints if joint[2] != 4]
        if not moving or any(joint[2] not in (0, 1) for joint in moving) or self.base != "held":
            return {}
        states = [self.bullet.getJointState(self.robot, joint[0], self.client)[0] for joint in moving]
        none = [0.0] * len(states)
        forces = self.bullet.calculateInverseDynamics(
            self.robot, states, none, none, physicsClientId=self.client
        )
        return {
            joint[1].decode("utf-8", "replace"): force for joint, force in zip(moving, forces, strict=True)
        }


def behave(model: Loaded, settings: dict[str, Any]) -> dict[str, Any]:
    return behave_in(lambda motion: BulletWorld(model, motion), settings)
