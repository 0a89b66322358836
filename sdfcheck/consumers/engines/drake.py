"""Drake: its parser, its plant, and its discrete simulation."""

from __future__ import annotations

import importlib.metadata
import math
from pathlib import Path
from typing import Any

import numpy as np

from sdfcheck.consumers.engines.behavior import Contact, Motion, World
from sdfcheck.consumers.engines.behavior import behave as behave_in

_KINDS = {"weld": "fixed", "revolute": "revolute", "prismatic": "prismatic", "ball_rpy": "ball"}


def version() -> str:
    import pydrake.all  # noqa: F401 - once, before the process is copied

    return importlib.metadata.version("drake")


class Plant:
    """A file in a plant, with a scene graph."""

    def __init__(self, question: dict[str, Any], time_step: float = 0.001) -> None:
        from pydrake.multibody.parsing import Parser
        from pydrake.multibody.plant import AddMultibodyPlant, MultibodyPlantConfig
        from pydrake.systems.framework import DiagramBuilder

        self.question = question
        config = MultibodyPlantConfig(time_step=time_step, discrete_contact_approximation="sap")
        self.builder = DiagramBuilder()
        self.plant, self.scene = AddMultibodyPlant(config, self.builder)
        parser = Parser(self.plant)
        known = parser.package_map()
        for name, folder in question.get("packages", ()):
            if known.Contains(name):
                known.Remove(name)
            known.Add(name, folder)
        self.models = parser.AddModels(Path(question["path"]))

    def finalize(self) -> None:
        self.plant.Finalize()

    def bodies(self) -> list[Any]:
        return [self.plant.get_body(i) for model in self.models for i in self.plant.GetBodyIndices(model)]

    def joints(self) -> list[Any]:
        return [self.plant.get_joint(i) for model in self.models for i in self.plant.GetJointIndices(model)]


def load(question: dict[str, Any]) -> Plant:
    model = Plant(question)
    if question["action"] != "behave":
        model.finalize()
    return model


def _body(body: Any) -> list[Any]:
    inertia = body.default_spatial_inertia()
    mass, center = inertia.get_mass(), inertia.get_com()
    about_origin = inertia.CalcRotationalInertia().CopyToFullMatrix3()
    moments = about_origin - mass * (center @ center * np.eye(3) - np.outer(center, center))
    return [mass, center.tolist(), moments.tolist()]


def _effort(plant: Any, joint: Any) -> float:
    for index in plant.GetJointActuatorIndices():
        actuator = plant.get_joint_actuator(index)
        if actuator.joint().index() == joint.index():
            return float(actuator.effort_limit())
    return math.inf


def _joint(plant: Any, context: Any, joint: Any) -> dict[str, Any]:
    axis = getattr(joint, "revolute_axis", None) or getattr(joint, "translation_axis", None)
    turn = joint.frame_on_parent().CalcPoseInWorld(context).rotation().matrix()
    one = joint.num_positions() == 1
    return {
        "kind": _KINDS.get(joint.type_name(), joint.type_name()),
        "parent": joint.parent_body().name(),
        "child": joint.child_body().name(),
        "axis": (turn @ axis()).tolist() if axis else [],
        "lower": float(joint.position_lower_limits()[0]) if one else -math.inf,
        "upper": float(joint.position_upper_limits()[0]) if one else math.inf,
        "velocity": float(joint.velocity_upper_limits()[0]) if one else math.inf,
        "effort": _effort(plant, joint) if one else math.inf,
    }


def facts(model: Plant, settings: dict[str, Any]) -> dict[str, Any]:
    plant, context = model.plant, model.plant.CreateDefaultContext()
    joints = {joint.name(): _joint(plant, context, joint) for joint in model.joints()}
    by_name = {joint.name(): joint for joint in model.joints() if joint.num_positions() == 1}
    poses = []
    for configuration in settings.get("configurations", [{}]):
        for name, value in configuration.items():
            if name in by_name:
                position = np.zeros(plant.num_positions())
                position[:] = plant.GetPositions(context)
                position[by_name[name].position_start()] = value
                plant.SetPositions(context, position)
        poses.append(
            {
                body.name(): plant.EvalBodyPoseInWorld(context, body).GetAsMatrix4().tolist()
                for body in model.bodies()
            }
        )
    return {"bodies": {b.name(): _body(b) for b in model.bodies()}, "joints": joints, "poses": poses}


class DrakeWorld(World):
    """A robot in Drake's discrete plant; ``base``: its root link is held."""

    def __init__(self, model: Plant, motion: Motion) -> None:
        from pydrake.geometry import HalfSpace
        from pydrake.math import RigidTransform
        from pydrake.multibody.plant import CoulombFriction
        from pydrake.systems.analysis import Simulator

        self.model = Plant(model.question, motion.time_step)
        plant = self.plant = self.model.plant
        self.floating = [body for body in self._roots() if motion.base == "free"]
        if motion.base == "held":
            for body in self._roots():
                plant.WeldFrames(plant.world_frame(), body.body_frame())
        if motion.base == "free":
            plant.RegisterCollisionGeometry(
                plant.world_body(), RigidTransform(), HalfSpace(), "ground", CoulombFriction(1.0, 1.0)
            )
        self.model.finalize()
        diagram = self.model.builder.Build()
        self.root = diagram.CreateDefaultContext()
        self.context = plant.GetMyMutableContextFromRoot(self.root)
        if not motion.gravity:
            plant.mutable_gravity_field().set_gravity_vector(np.zeros(3))
        if plant.num_actuators():
            plant.get_actuation_input_port().FixValue(self.context, np.zeros(plant.num_actuators()))
        self.simulator = Simulator(diagram, self.root)
        self.names = {int(body.index()): body.name() for body in self.model.bodies()}
        self.single = {j.name(): j for j in self.model.joints() if j.num_positions() == 1}

    def _roots(self) -> list[Any]:
        """The bodies that nothing carries."""
        carried = {int(joint.child_body().index()) for joint in self.model.joints()}
        return [body for body in self.model.bodies() if int(body.index()) not in carried]

    def ranges(self) -> dict[str, tuple[float, float]]:
        return {
            name: (float(joint.position_lower_limits()[0]), float(joint.position_upper_limits()[0]))
            for name, joint in self.single.items()
        }

    def place(self, positions: dict[str, float], height: float | None = None) -> None:
        values = np.array(self.plant.GetPositions(self.context))
        for name, joint in self.single.items():
            values[joint.position_start()] = positions.get(name, 0.0)
        self.plant.SetPositions(self.context, values)
        self.plant.SetVelocities(self.context, np.zeros(self.plant.num_velocities()))
        if height is not None:
            from pydrake.math import RigidTransform

            for body in self.floating:
                self.plant.SetFreeBodyPose(self.context, body, RigidTransform([0, 0, height]))

    def contacts(self) -> list[Contact]:
        query = self.scene_query()
        inspector = query.inspector()
        found = []
        for pair in query.ComputePointPairPenetration():
            ends = []
            for geometry in (pair.id_A, pair.id_B):
                body = self.plant.GetBodyFromFrameId(inspector.GetFrameId(geometry))
                ends.append(self.names.get(int(body.index()), ""))
            found.append(Contact(ends[0], ends[1], float(pair.depth), np.asarray(pair.p_WCa).tolist()))
        return found

    def scene_query(self) -> Any:
        scene = self.model.scene
        return scene.get_query_output_port().Eval(scene.GetMyContextFromRoot(self.root))

    def advance(self, seconds: float) -> None:
        self.simulator.AdvanceTo(self.root.get_time() + seconds)

    def poses(self) -> dict[str, list[list[float]]]:
        return {
            body.name(): self.plant.EvalBodyPoseInWorld(self.context, body).GetAsMatrix4().tolist()
            for body in self.model.bodies()
        }

    def speeds(self) -> dict[str, float]:
        found = {}
        for body in self.model.bodies():
            velocity = self.plant.EvalBodySpatialVelocityInWorld(self.context, body)
            found[body.name()] = float(np.linalg.norm(velocity.translational()))
        return found

    def energy(self) -> float:
        return float(
            self.plant.CalcPotentialEnergy(self.context) + self.plant.CalcKineticEnergy(self.context)
        )

    def loads(self) -> dict[str, float]:
        force = self.plant.CalcGravityGeneralizedForces(self.context)
        return {name: float(-force[joint.velocity_start()]) for name, joint in self.single.items()}


def behave(model: Plant, settings: dict[str, Any]) -> dict[str, Any]:
    return behave_in(lambda motion: DrakeWorld(model, motion), settings)
