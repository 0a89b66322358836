"""libsdformat, by the program that checks and prints files: that of Gazebo, or the library's own.

Where only the library is installed, its functions that the program calls are called.
"""

from __future__ import annotations

import ctypes
import ctypes.util
import os
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path
from typing import Any

from sdfcheck.consumers.engines.child import Refused, say
from sdfcheck.files.python import python_program

_VALID = "Valid."
"""Printed where there is no error; the exit code does not say it in all releases."""
_COLOR = re.compile(r"\x1b\[[0-9;]*m")
_CANDIDATES = (("gz-sdformat-sdf",), ("gz", "sdf"), ("ign", "sdf"), ("sdf",))
"""Newest first; ``sdf`` may be another program, and must know the option ``--print``."""
_BESIDE = "libexec/gz/sdformat*/gz-sdformat-sdf"
"""Where the library's own program is installed, relative to the folder above that of programs."""

_NEWEST, _OLDEST = 20, 9
_CALL = (
    "import ctypes, os, sys; name, function, path = sys.argv[1:]; "
    "status = getattr(ctypes.CDLL(name), function)(os.fsencode(path)); "
    "ctypes.CDLL(None).fflush(None); os._exit(0 if status == 0 else 1)"
)
"""Ends without the library's exit handlers, which may crash."""
_FUNCTIONS = {"--check": "cmdCheck", "--print": "cmdPrint"}


@cache
def program() -> tuple[str, ...]:
    """The command that checks files; empty where there is none."""
    places = [Path(place).parent for place in os.environ.get("PATH", "").split(os.pathsep) if place]
    own = [(str(file),) for place in places for file in sorted(place.glob(_BESIDE), reverse=True)]
    for command in (*own, *_CANDIDATES):
        if shutil.which(command[0]) and "--print" in _run((*command, "--help")).stdout:
            return command
    return (library(),) if library() else ()


@cache
def library() -> str:
    """The newest library that the loader finds; empty where there is none."""
    versions = (ctypes.util.find_library(f"sdformat{version}") for version in range(_NEWEST, _OLDEST - 1, -1))
    return next((name for name in versions if name), "")


def _run(command: tuple[str, ...], **settings: Any) -> subprocess.CompletedProcess[str]:
    try:
        return subprocess.run(
            command, capture_output=True, text=True, errors="replace", check=False, timeout=60, **settings
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        return subprocess.CompletedProcess(command, 1, "", str(error))


def version() -> str:
    if program() == (library(),):
        return library().partition(".so.")[2]
    found = re.search(r"\d+\.\d+[\w.~]*", _run((*program(), "--version")).stdout)
    return found[0] if found else ""


def load(question: dict[str, Any]) -> dict[str, Any]:
    """Check a file, from the folder that it is in."""
    done = _call("--check", question)
    said = [line.strip() for line in _COLOR.sub("", done.stderr + done.stdout).splitlines() if line.strip()]
    say("\n".join(line for line in said if line != _VALID))
    if done.returncode < 0:
        os.kill(os.getpid(), -done.returncode)
    if done.returncode or not any(line.endswith(_VALID) for line in said):
        errors = [line for line in said if line.startswith("Error")]
        raise Refused(next(iter([*(e for e in errors if e.startswith("Error Code")), *errors, *said]), ""))
    return question


def _call(option: str, question: dict[str, Any]) -> subprocess.CompletedProcess[str]:
    path = question["path"]
    folder = Path(path).parent
    usual = [
        *question.get("model_paths", ()),
        os.environ.get("SDF_PATH", ""),
        str(folder.parent),
        str(folder),
    ]
    places = os.pathsep.join(filter(None, usual))  # as Gazebo has it, which looks beside models as well
    environment = {**os.environ, "SDF_PATH": places}
    command = (*program(), option, path)
    if program() == (library(),):
        command = (python_program(), "-I", "-c", _CALL, library(), _FUNCTIONS[option], path)
    return _run(command, cwd=folder, env=environment)


def facts(model: dict[str, Any], settings: dict[str, Any]) -> dict[str, Any]:
    """The robot as the library has it, as text of SDFormat."""
    done = _call("--print", model)
    start = done.stdout.find("<sdf")
    return {"sdf": done.stdout[start:] if start >= 0 else ""}
