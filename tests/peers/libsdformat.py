"""libsdformat, where its shared library is installed.

Loading it takes longer than most questions, it prints what it thinks, and it may crash: one
process loads it and forks for each question.
"""

from __future__ import annotations

import atexit
import ctypes
import ctypes.util
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

if sys.platform == "win32":
    pytest.skip("works on POSIX only", allow_module_level=True)

SECONDS = 120
_NEWEST, _OLDEST = 20, 9
_ASKING = threading.Lock()


class Question(NamedTuple):
    """A call of a function with a file: where from, where its output goes, and with which environment."""

    function: str
    path: str
    folder: str
    output: str
    errors: str
    environment: dict[str, str]


class Answer(NamedTuple):
    """The status that a function of libsdformat returned (None: it crashed or took too long), and its output."""

    status: int | None
    output: str
    errors: str


@cache
def library() -> str | None:
    """The newest libsdformat that the loader finds."""
    versions = range(_NEWEST, _OLDEST - 1, -1)
    found = (ctypes.util.find_library(f"sdformat{version}") for version in versions)
    return next((name for name in found if name), None)


def ask(function: str, path: Path, folder: Path | None = None) -> Answer:
    """Call ``cmdCheck`` or ``cmdPrint`` with a file; includes are looked for from ``folder``.

    Raises:
        FileNotFoundError: no libsdformat is installed.
    """
    with _ASKING, tempfile.TemporaryDirectory() as scratch:
        output, errors = Path(scratch, "output"), Path(scratch, "errors")
        process = _process()
        assert process.stdin is not None
        assert process.stdout is not None
        files = str(output), str(errors)
        place = str(path.absolute()), str(folder or Path.cwd())
        process.stdin.write(json.dumps(Question(function, *place, *files, dict(os.environ))) + "\n")
        process.stdin.flush()
        status: int | None = json.loads(process.stdout.readline())
        return Answer(status, *(file.read_text(errors="replace") for file in (output, errors)))


@cache
def _process() -> subprocess.Popen[str]:
    name = library()
    if name is None:
        raise FileNotFoundError("no libsdformat")
    command = [sys.executable, str(Path(__file__)), name]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    atexit.register(process.kill)
    return process


def _serve(name: str) -> None:
    loaded = ctypes.CDLL(name)
    for line in sys.stdin:
        child = os.fork()
        if not child:
            _call(loaded, Question(*json.loads(line)))
        _, status = os.waitpid(child, 0)
        print(json.dumps(os.WEXITSTATUS(status) if os.WIFEXITED(status) else None), flush=True)


def _call(loaded: ctypes.CDLL, question: Question) -> None:
    """Ends without the library's exit handlers, which may crash."""
    os.environ.clear()
    os.environ.update(question.environment)
    os.chdir(question.folder)
    for number, file in ((1, question.output), (2, question.errors)):
        os.dup2(os.open(file, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), number)
    signal.alarm(SECONDS)
    status = getattr(loaded, question.function)(os.fsencode(question.path))
    ctypes.CDLL(None).fflush(None)
    os._exit(0 if status == 0 else 1)


if __name__ == "__main__":
    _serve(sys.argv[1])
