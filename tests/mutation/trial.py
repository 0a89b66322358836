"""One mutant in a process of its own: its text takes the place of the module's file, and tests run on it."""

from __future__ import annotations

import os
import resource
import signal
import sys
import time
from importlib.machinery import SourceFileLoader
from pathlib import Path

import pytest

if sys.platform == "win32":
    pytest.skip("works on POSIX only", allow_module_level=True)

SECONDS = 100
"""Processor time after which a mutant counts as killed, as it does not end; far more than its tests take."""
AT_MOST = 600
"""The same for the clock, in s."""
MEMORY = 4 << 30
KILLED, SURVIVED = 0, 1


def survives(path: Path, text: str, tests: list[str]) -> bool:
    """Do tests pass although a module has another text?"""
    child = os.fork()
    if child == 0:
        code = KILLED
        try:
            code = _attempt(path, text, tests)
        finally:
            os._exit(code)
    end = time.monotonic() + AT_MOST
    while True:
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            return os.WIFEXITED(status) and os.WEXITSTATUS(status) == SURVIVED
        if time.monotonic() > end:
            os.kill(child, signal.SIGKILL)
        time.sleep(0.05)


def _attempt(path: Path, text: str, tests: list[str]) -> int:
    void = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(void, stream)
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    _replace(path.resolve(), text)
    assert not [name for name in sys.modules if name.partition(".")[0] in {"sdfcheck", "sdfcheck_rules"}]
    code = pytest.main(["-x", "-q", "-n0", "-p", "no:randomly", "-p", "no:cacheprovider", *tests])
    return SURVIVED if code == 0 else KILLED


def _replace(path: Path, text: str) -> None:
    """Let imports find another text in a file."""
    sys.dont_write_bytecode = True
    read = SourceFileLoader.get_data

    def get_data(self: SourceFileLoader, place: str) -> bytes:
        if place.endswith(".pyc") and Path(self.path).resolve() == path:
            raise OSError("its bytecode is that of the original")
        return text.encode() if Path(place).resolve() == path else read(self, place)

    SourceFileLoader.get_data = get_data  # type: ignore[method-assign, assignment]
