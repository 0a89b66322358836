"""The program that runs Python, for what has to run in a process of its own."""

from __future__ import annotations

import os
import sys

from sdfcheck.source.errors import WrongUsage


def python_program() -> str:
    """The path of the running interpreter's program, or of another Python where an application embeds the interpreter.

    Raises:
        WrongUsage: neither is found.
    """
    if sys.executable:
        return sys.executable
    from shutil import which

    name = "python.exe" if os.name == "nt" else os.path.join("bin", "python3")
    for prefix in (sys.exec_prefix, sys.base_exec_prefix):
        if os.access(program := os.path.join(prefix, name), os.X_OK):
            return program
    program = which("python3") or which("python") or ""
    if not program:
        raise WrongUsage(
            "the application that runs sdfcheck does not say where Python is: set `sys.executable`"
        )
    return program
