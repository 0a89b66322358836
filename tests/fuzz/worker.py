"""The process that runs commands: within limits, and stopped from outside where that does not help."""

from __future__ import annotations

import multiprocessing
import os
import resource
import signal
import sys
import tempfile
import traceback
from multiprocessing.connection import Connection
from pathlib import Path
from types import FrameType

import pytest

from tests.fuzz.commands import Failure, attempt
from tests.fuzz.documents import Text
from tests.fuzz.language_server import LanguageServer, converse

if sys.platform == "win32":
    pytest.skip("works on POSIX only", allow_module_level=True)

SECONDS = 10
"""Processor time of one command; what the clock shows may be much more on a busy machine."""
MEMORY = 1 << 30
"""The memory of a command beyond that of the idle process, in bytes."""
AT_MOST = 600
SERVER = "server"


class OutOfTime(BaseException):
    """A command has not ended in time; no command catches it."""


class Worker:
    """Runs commands in a child process, which is started again when one has ended it."""

    def __init__(self, renew: int = 2000) -> None:
        self._renew = renew
        self._done = 0
        self.seconds = 0.0
        """Processor time of all commands so far, with that of the server and of processes that have ended."""
        self._process: multiprocessing.process.BaseProcess | None = None
        self._connection: Connection | None = None

    def run(self, command: str, text: Text) -> Failure | None:
        """The promise that a command has not kept on a text."""
        if self._process is None or self._done >= self._renew:
            self.start()
        assert self._connection
        assert self._process
        self._done += 1
        try:
            self._connection.send((command, text))
            if not self._connection.poll(AT_MOST):
                self.stop()
                return Failure("hang", f"no end after {AT_MOST} s")
            found: Failure | None
            found, seconds = self._connection.recv()
            self.seconds += seconds
        except (EOFError, OSError):
            code = self._process.exitcode
            self.stop()
            return Failure(f"the process ends ({code})", "")
        return found

    def start(self) -> None:
        self.stop()
        context = multiprocessing.get_context("spawn")
        self._connection, theirs = context.Pipe()
        self._process = context.Process(target=serve, args=(theirs,))
        self._process.start()
        theirs.close()
        self._done = 0

    def stop(self) -> None:
        if self._process is not None and self._connection is not None:
            self._connection.close()
            self._process.join(2)
            self._process.kill()
            self._process.join()
        self._process = None


def serve(connection: Connection) -> None:
    """Run what is sent, until nothing is."""
    _limit_memory()
    signal.signal(signal.SIGPROF, _stop)
    server: LanguageServer | None = None
    while True:
        try:
            command, text = connection.recv()
        except EOFError:
            break
        begin = _processor_time(server)
        with tempfile.TemporaryDirectory(prefix="fuzz-") as folder:
            # A repository: otherwise all files beside the folder could be the project.
            file = Path(folder, "robot", f"file{text.suffix}")
            file.parent.mkdir()
            Path(folder, ".git").mkdir()
            file.write_bytes(text.data)
            if command == SERVER:
                server = server or LanguageServer(file.parent)
                failure = converse(server, file, text.data)
            else:
                failure = _in_time(command, file)
        seconds = _processor_time(server) - begin
        if server is not None and command == SERVER and failure is not None:
            server.close()
            server = None
        connection.send((failure, seconds))
    if server is not None:
        server.close()


def _processor_time(server: LanguageServer | None) -> float:
    return sum(os.times()[:4]) + (server.computed if server is not None else 0.0)


def _in_time(command: str, file: Path) -> Failure | None:
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    try:
        return attempt(command, file)
    except OutOfTime as error:
        frames = traceback.extract_tb(error.__traceback__)
        place = next((each.name for each in reversed(frames) if "sdfcheck" in each.filename), "")
        return Failure(f"out of time in {place}", "".join(traceback.format_tb(error.__traceback__)))
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def _stop(number: int, frame: FrameType | None) -> None:
    raise OutOfTime


def _limit_memory() -> None:
    """Bound what the process maps: what it has now, with the libraries that commands load, and what it may take."""
    if sys.platform == "linux":
        import numpy  # noqa: F401 - its threads map much memory that they never use

        pages = int(Path("/proc/self/statm").read_text().split()[0])
        limit = pages * resource.getpagesize() + MEMORY
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
