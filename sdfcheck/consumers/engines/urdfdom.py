"""urdfdom, by its program ``check_urdf``."""

from __future__ import annotations

import ctypes.util
import os
import re
import shutil
import subprocess
from typing import Any

from sdfcheck.consumers.engines.child import Refused, say

_CHILD = re.compile(r"^ +child\(\d+\): +(.+)$")
_ROOT = re.compile(r"^root Link: (.+) has \d+ child")


def program() -> str:
    """The program; empty where it is not installed."""
    return shutil.which("check_urdf") or ""


def version() -> str:
    """The version in the name of the library, as far as the loader says it."""
    name = ctypes.util.find_library("urdfdom_model") or ""
    return name.rpartition(".so.")[2]


def load(question: dict[str, Any]) -> list[str]:
    """The output of the program, line by line."""
    done = subprocess.run(
        [program(), question["path"]], capture_output=True, text=True, errors="replace", check=False
    )
    said = [line for line in done.stdout.splitlines() if line.strip()]
    say(done.stderr)
    if done.returncode < 0:
        os.kill(os.getpid(), -done.returncode)
    if done.returncode:
        first = next((line for line in done.stderr.splitlines() if line.strip()), "")
        raise Refused(first.strip() or (said[0] if said else ""))
    return said


def facts(model: list[str], settings: dict[str, Any]) -> dict[str, Any]:
    """The names of the links; the program says nothing else of them."""
    names = [found[1].strip() for line in model if (found := _ROOT.match(line) or _CHILD.match(line))]
    return {"bodies": dict.fromkeys(names)}
