"""MuJoCo's verdict on URDF files, where its package is installed.

Each file is loaded in a child process: ``python -m tests.peers.mujoco FILE…`` prints one line a file.
"""

from __future__ import annotations

import os
import sys
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

if sys.platform == "win32":
    pytest.skip("works on POSIX only", allow_module_level=True)


def is_installed() -> bool:
    return find_spec("mujoco") is not None


def verdict(path: Path) -> bool:
    """Does MuJoCo compile a model of the file? Its log goes into a folder of its own."""
    path = path.resolve()
    with TemporaryDirectory() as folder:
        child = os.fork()
        if child == 0:
            os.chdir(folder)
            silence = os.open(os.devnull, os.O_WRONLY)
            os.dup2(silence, 1)
            os.dup2(silence, 2)
            try:
                import mujoco

                mujoco.MjModel.from_xml_path(str(path))
            except BaseException:
                os._exit(1)
            os._exit(0)
        return os.waitpid(child, 0)[1] == 0


def main(paths: list[str]) -> int:
    import mujoco  # noqa: F401 - once, before the children part

    for path in paths:
        print(f"{'loads' if verdict(Path(path)) else 'fails'}\t{path}", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
