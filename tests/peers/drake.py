"""Drake's verdict on files, where pydrake is installed.

Drake ends the process at some faults, so each file is loaded in a child of a process that has
imported it: ``python -m tests.peers.drake FILE…`` prints one line a file.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path

import pytest

if sys.platform == "win32":
    pytest.skip("works on POSIX only", allow_module_level=True)

SECONDS = 60


def is_installed() -> bool:
    return find_spec("pydrake") is not None


def loads(paths: Sequence[Path]) -> dict[Path, bool]:
    """Which files Drake loads, scene graph and all, and finalizes."""
    module = "tests.peers.drake"
    command = [sys.executable, "-m", module, *map(str, paths)]
    child = subprocess.run(command, capture_output=True, text=True, check=True, errors="replace")
    lines = [line.split("\t") for line in child.stdout.splitlines() if "\t" in line]
    return {Path(name): verdict == "loads" for verdict, name, *_ in lines}


def _load(path: str) -> None:
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import AddMultibodyPlant, MultibodyPlantConfig
    from pydrake.systems.framework import DiagramBuilder

    config = MultibodyPlantConfig(time_step=0.001, discrete_contact_approximation="sap")
    plant, _ = AddMultibodyPlant(config, DiagramBuilder())
    Parser(plant).AddModels(Path(path))
    plant.Finalize()


def _verdict(path: str) -> str:
    child = os.fork()
    if child == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
        try:
            _load(path)
        except BaseException:
            os._exit(1)
        os._exit(0)
    _, status = os.waitpid(child, 0)
    return "loads" if status == 0 else "fails"


def main(paths: list[str]) -> int:
    import pydrake.all  # noqa: F401 - once, before the children part

    for path in paths:
        print(f"{_verdict(path)}\t{path}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
