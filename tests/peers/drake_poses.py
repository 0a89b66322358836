"""Where Drake says that frames are, for files that it can load.

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


def is_installed() -> bool:
    import importlib.util

    return importlib.util.find_spec("pydrake") is not None


def poses(paths: Sequence[Path], *, timeout: float = 600) -> dict[Path, Frames]:
    """The frames of each file's links and frames; files that Drake does not load are left out."""
    found: dict[Path, Frames] = {}
    waiting = list(paths)
    while waiting:
        # As a module, so that no file beside this one is taken for Drake's own `drake`.
        command = [sys.executable, "-m", "tests.peers.drake_poses", "--child", *map(str, waiting)]
        child = subprocess.run(
            command, capture_output=True, text=True, errors="replace", timeout=timeout, check=False, cwd=ROOT
        )
        if child.returncode > 0:
            raise RuntimeError(child.stderr)
        answers = [json.loads(line) for line in child.stdout.splitlines() if line.startswith("[")]
        for name, frames in answers:
            if frames is not None:
                found[Path(name)] = frames
        # What has no answer ended the process: go on behind it.
        waiting = waiting[len(answers) + 1 :]
    return found


def _load(path: str) -> Frames:
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    plant: Any = MultibodyPlant(0.0)
    models = Parser(plant).AddModels(Path(path))
    plant.Finalize()
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


def _child(paths: Sequence[str]) -> None:
    import logging

    logging.disable()
    for path in paths:
        try:
            answer: Frames | None = _load(path)
        except (RuntimeError, ValueError):
            answer = None
        print(json.dumps([path, answer]), flush=True)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--child"]:
        _child(sys.argv[2:])
    else:
        for loaded, frames in poses([Path(argument) for argument in sys.argv[1:]]).items():
            print(f"{loaded}: {len(frames)} frames")
