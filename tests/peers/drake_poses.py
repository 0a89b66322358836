"""Where Drake says that frames are, and what bodies weigh, for files that it can load.

Drake may abort the process, so files are loaded in a process of their own, which is
started anew for what follows a file that ended it: ``python -m tests.peers.drake_poses FILE…``.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[2]

Frames = dict[str, list[list[float]]]
"""Scoped name → the 4×4 pose in the frame of the model that the name begins with."""
Bodies = dict[str, list[list[float]]]
"""Name of a body → (mass), center of mass, rows of the inertia about the origin; all in the body's frame."""


def is_installed() -> bool:
    import importlib.util

    return importlib.util.find_spec("pydrake") is not None


def poses(paths: Sequence[Path], *, timeout: float = 600) -> dict[Path, Frames]:
    """The frames of each file's links and frames; files that Drake does not load are left out."""
    return _ask("--frames", paths, timeout)


def bodies(paths: Sequence[Path], *, timeout: float = 600) -> dict[Path, Bodies]:
    """The masses of the bodies in each file; files that Drake does not load are left out."""
    return _ask("--bodies", paths, timeout)


def _ask(what: str, paths: Sequence[Path], timeout: float) -> dict[Path, dict[str, list[list[float]]]]:
    found = {}
    waiting = list(paths)
    while waiting:
        # As a module, so that no file beside this one is taken for Drake's own `drake`.
        command = [sys.executable, "-m", "tests.peers.drake_poses", what, *map(str, waiting)]
        child = subprocess.run(
            command, capture_output=True, text=True, errors="replace", timeout=timeout, check=False, cwd=ROOT
        )
        if child.returncode > 0:
            raise RuntimeError(child.stderr)
        answers = [json.loads(line) for line in child.stdout.splitlines() if line.startswith("[")]
        for name, answer in answers:
            if answer is not None:
                found[Path(name)] = answer
        # A file without an answer ended the process: go on after it.
        waiting = waiting[len(answers) + 1 :]
    return found


def _load(path: str) -> tuple[Any, Any]:
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    plant: Any = MultibodyPlant(0.0)
    models = Parser(plant).AddModels(Path(path))
    plant.Finalize()
    return plant, models


def _bodies(path: str) -> Bodies:
    plant, models = _load(path)
    found: Bodies = {}
    for model in models:
        for index in plant.GetBodyIndices(model):
            body = plant.get_body(index)
            weight = body.default_spatial_inertia()
            mass = weight.get_mass()
            rows = (mass * weight.get_unit_inertia().CopyToFullMatrix3()).tolist() if mass else []
            found[body.name()] = [[mass], weight.get_com().tolist(), *rows]
    return found


def _frames(path: str) -> Frames:
    plant, models = _load(path)
    context = plant.CreateDefaultContext()
    found: Frames = {}
    tops = {plant.GetModelInstanceName(model).partition("::")[0] for model in models}
    for model in models:
        scope = plant.GetModelInstanceName(model)
        top = scope.partition("::")[0]
        if top not in tops or not plant.HasModelInstanceNamed(top):
            continue
        base = plant.GetFrameByName("__model__", plant.GetModelInstanceByName(top))
        for index in plant.GetFrameIndices(model):
            frame = plant.get_frame(index)
            pose = frame.CalcPose(context, base).GetAsMatrix4()
            found[f"{scope}::{frame.name()}"] = pose.tolist()
    return found


def _child(what: str, paths: Sequence[str]) -> None:
    import logging

    logging.disable()
    look = _bodies if what == "--bodies" else _frames
    for path in paths:
        try:
            answer: dict[str, list[list[float]]] | None = look(path)
        except (RuntimeError, ValueError, SystemExit):
            answer = None
        print(json.dumps([path, answer]), flush=True)


if __name__ == "__main__":
    if sys.argv[1:2] and sys.argv[1].startswith("--"):
        _child(sys.argv[1], sys.argv[2:])
    else:
        for loaded, frames in poses([Path(argument) for argument in sys.argv[1:]]).items():
            print(f"{loaded}: {len(frames)} frames")
