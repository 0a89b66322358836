"""The print of files by libsdformat: converted to its own version, with defaults written out.

Loading the library takes longer than printing, and it may crash: one process loads it
and forks for each file.
"""

from __future__ import annotations

import ctypes
import json
import os
import signal
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

SECONDS = 60


class Job(NamedTuple):
    """Print a file; includes are looked for from ``folder``."""

    path: Path
    folder: Path


def version_of(name: str) -> str:
    """The version that a library (``libsdformat12.so.12``) prints: that of libsdformat12 is 1.9."""
    return f"1.{int(name.removeprefix('libsdformat').partition('.')[0]) - 3}"


def printed(name: str, jobs: Sequence[Job], results: Path) -> list[str]:
    """The print of each file by the library of that name, empty for nothing; ``results`` is a
    folder to use.
    """
    outs = [results / f"{number}.txt" for number in range(len(jobs))]
    rows = [
        [str(job.path.absolute()), str(job.folder), str(out)] for job, out in zip(jobs, outs, strict=True)
    ]
    command = [sys.executable, str(Path(__file__).absolute()), name]
    subprocess.run(command, input=json.dumps(rows), text=True, check=True, cwd=results)
    texts = [out.read_text(encoding="utf-8", errors="replace") for out in outs]
    return [text[text.find("<sdf") :] if "<sdf" in text else "" for text in texts]


def _print_all(name: str) -> None:
    library = ctypes.CDLL(name)
    for path, folder, out in json.load(sys.stdin):
        child = os.fork()
        if not child:
            _print(library, path, folder, out)
        os.waitpid(child, 0)


def _print(library: ctypes.CDLL, path: str, folder: str, out: str) -> None:
    """Ends without the library's exit handlers, which may crash."""
    os.chdir(folder)
    os.dup2(os.open(out, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), 1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    signal.alarm(SECONDS)
    library.cmdPrint(os.fsencode(path))
    ctypes.CDLL(None).fflush(None)
    os._exit(0)


if __name__ == "__main__":
    _print_all(sys.argv[1])
