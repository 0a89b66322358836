"""What Drake makes of vendors' tags: read out of its plant and scene graph.

Drake may abort the process, so that each file is loaded in a process of its own:
``python -m tests.peers.drake_plants FILE…`` prints one line of JSON a file.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

if sys.platform == "win32":
    pytest.skip("works on POSIX only", allow_module_level=True)

ROOT = Path(__file__).parents[2]
Facts = dict[str, Any]


def is_installed() -> bool:
    return find_spec("pydrake") is not None


def facts(
    paths: Sequence[Path], *, packages: Mapping[str, Path] | None = None, timeout: float = 900
) -> dict[Path, Facts]:
    """The plants of files in Drake; those that Drake does not load have only ``error``."""
    roots = [f"--package={name}={folder}" for name, folder in (packages or {}).items()]
    command = [sys.executable, "-m", "tests.peers.drake_plants", *roots, *map(str, paths)]
    child = subprocess.run(
        command, capture_output=True, text=True, errors="replace", timeout=timeout, check=True, cwd=ROOT
    )
    answers = [json.loads(line) for line in child.stdout.splitlines() if line.startswith("[")]
    return {Path(name): answer for name, answer in answers}


def _load(path: str, packages: Sequence[str]) -> tuple[Any, Any, Any]:
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import AddMultibodyPlant, MultibodyPlantConfig
    from pydrake.systems.framework import DiagramBuilder

    config = MultibodyPlantConfig(time_step=0.001, discrete_contact_approximation="sap")
    plant, scene = AddMultibodyPlant(config, DiagramBuilder())
    parser = Parser(plant)
    known = parser.package_map()
    for package in packages:
        name, _, folder = package.partition("=")
        if known.Contains(name):
            known.Remove(name)
        known.Add(name, folder)
    models = parser.AddModels(Path(path))
    plant.Finalize()
    return plant, scene, models


def _facts(path: str, packages: Sequence[str]) -> Facts:
    plant, scene, models = _load(path, packages)
    bodies = [plant.get_body(i) for model in models for i in plant.GetBodyIndices(model)]
    joints = [plant.get_joint(i) for model in models for i in plant.GetJointIndices(model)]
    return {
        "accelerations": {
            joint.name(): joint.acceleration_upper_limits().tolist()
            for joint in joints
            if joint.num_velocities() and any(abs(x) < 1e300 for x in joint.acceleration_upper_limits())
        },
        "actuators": {
            key: value for joint in joints if (value := _actuator(plant, joint)) for key in [joint.name()]
        },
        "joints": {
            joint.name(): _joint(joint)
            for joint in joints
            if joint.type_name() not in {"weld", "quaternion_floating"}
        },
        "shapes": {body.name(): found for body in bodies if (found := _shapes(plant, scene, body))},
        "filters": _filters(plant, scene, bodies),
        "elements": plant.num_force_elements(),
        "constraints": plant.num_constraints(),
    }


def _actuator(plant: Any, joint: Any) -> list[float] | None:
    from pydrake.multibody.tree import JointActuatorIndex

    for number in range(plant.num_actuators()):
        actuator = plant.get_joint_actuator(JointActuatorIndex(number))
        if actuator.joint().index() == joint.index():
            gains = actuator.get_controller_gains() if actuator.has_controller() else None
            both = [gains.p, gains.d] if gains is not None else []
            return [actuator.default_rotor_inertia(), actuator.default_gear_ratio(), *both]
    return None


def _joint(joint: Any) -> list[Any]:
    damping = joint.default_damping_vector().tolist() if joint.num_velocities() else []
    return [joint.type_name(), joint.parent_body().name(), joint.child_body().name(), damping]


def _shapes(plant: Any, scene: Any, body: Any) -> list[Any]:
    """Shape and properties of the collisions of a body."""
    inspector = scene.model_inspector()
    found = []
    for geometry in plant.GetCollisionGeometriesForBody(body):
        properties = inspector.GetProximityProperties(geometry)
        values = {
            f"{group}/{name}": _value(properties, group, name)
            for group in sorted(properties.GetGroupNames())
            for name in sorted(properties.GetPropertiesInGroup(group))
        }
        pose = (inspector.GetPoseInFrame(geometry).GetAsMatrix4().round(9) + 0.0).tolist()
        values["mesh"] = type(inspector.maybe_get_hydroelastic_mesh(geometry)).__name__
        found.append([_shape(inspector.GetShape(geometry)), pose, values])
    return sorted(found, key=str)


def _shape(shape: Any) -> str:
    sizes = ("radius", "length", "width", "depth", "height", "a", "b", "c", "scale3")
    numbers = [f"{getattr(shape, name)()}" for name in sizes if callable(getattr(shape, name, None))]
    return " ".join((type(shape).__name__, *numbers))


def _value(properties: Any, group: str, name: str) -> Any:
    try:
        value = properties.GetProperty(group, name)
    except RuntimeError:  # of a type that Python does not know
        return ""
    if hasattr(value, "static_friction"):
        return [value.static_friction(), value.dynamic_friction()]
    return value if isinstance(value, (bool, int, float, str)) else str(value)


def _filters(plant: Any, scene: Any, bodies: Sequence[Any]) -> list[list[str]]:
    """The pairs of bodies whose shapes do not collide."""
    inspector = scene.model_inspector()
    shapes = [(body.name(), plant.GetCollisionGeometriesForBody(body)) for body in bodies]
    return [
        sorted((a, b))
        for index, (a, ours) in enumerate(shapes)
        for b, theirs in shapes[index + 1 :]
        if ours and theirs and inspector.CollisionFiltered(ours[0], theirs[0])
    ]


def _child(path: str, packages: Sequence[str]) -> Facts:
    """The facts of a file, read by a child of this process."""
    consumer, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(consumer)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
        try:
            answer = json.dumps(_facts(path, packages))
        except BaseException as error:
            answer = json.dumps({"error": str(error)})
        os.write(writer, answer.encode())
        os._exit(0)
    os.close(writer)
    with os.fdopen(consumer) as stream:
        text = stream.read()
    os.waitpid(child, 0)
    found: Facts = json.loads(text) if text else {"error": "the process ended"}
    return found


def main(arguments: list[str]) -> int:
    import pydrake.all  # noqa: F401 - once, before the children part

    packages = [text.removeprefix("--package=") for text in arguments if text.startswith("--package=")]
    for path in arguments[len(packages) :]:
        print(json.dumps([path, _child(path, packages)]), flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
