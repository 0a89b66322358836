"""The consumers themselves, as far as they are installed: does each take a file?"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from sdfcheck.consumers.reaction import Consumer
from tests.peers import cmdcheck, drake, libsdformat, mujoco


def _gazebo(paths: Sequence[Path]) -> dict[Path, bool]:
    return {path: cmdcheck.check(path).accepted is True for path in paths}


def _urdfdom(paths: Sequence[Path]) -> dict[Path, bool]:
    return {
        path: subprocess.run(["check_urdf", str(path)], capture_output=True, check=False).returncode == 0
        for path in paths
    }


def _mujoco(paths: Sequence[Path]) -> dict[Path, bool]:
    return {path: mujoco.verdict(path) for path in paths}


def installed() -> Mapping[Consumer, Callable[[Sequence[Path]], dict[Path, bool]]]:
    """Consumer → the function that finds out which of some files it takes."""
    found: dict[Consumer, Callable[[Sequence[Path]], dict[Path, bool]]] = {}
    if libsdformat.library() is not None:
        found[Consumer.GAZEBO] = _gazebo
    if drake.is_installed():
        found[Consumer.DRAKE] = drake.loads
    if shutil.which("check_urdf"):
        found[Consumer.URDFDOM] = _urdfdom
    if mujoco.is_installed():
        found[Consumer.MUJOCO] = _mujoco
    return found
