"""The side of the calling process: starts the process that expands, asks it, stops it."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from contextlib import nullcontext, suppress
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

from sdfcheck.xacro.process.watch import Limits, Watch, is_needed

if TYPE_CHECKING:
    import subprocess

_START = "import sys; sys.path[:0] = sys.argv[1:]; from sdfcheck.xacro.process.child import main; main()"
_GRACE = 5.0
"""So many seconds after its own deadline the process is given up."""


class Worker:
    """A process that expands files, one after the other. Start-up is paid once; it ends with this object."""

    __slots__ = ("__weakref__", "_process", "_stop")

    def __init__(self) -> None:
        self._process: subprocess.Popen[bytes] | None = None
        self._stop: Callable[[], object] | None = None

    def ask(self, request: dict[str, Any], limits: Limits) -> dict[str, Any] | None:
        """The answer to a request, None if the process failed.

        Raises:
            WrongUsage: nothing can limit the process.
        """
        from threading import Timer

        process = self.start()
        watch = Watch(process.pid, limits, lambda: _kill(process)) if is_needed() else None
        timer = Timer(limits.wall + _GRACE, _kill, [process])
        timer.start()
        answer: dict[str, Any] | None = None
        try:
            with watch or nullcontext():
                answer = self._answer(process, request, limits)
        except (OSError, ValueError):
            answer = None
        finally:
            timer.cancel()
            if not isinstance(answer, dict) or not hasattr(os, "fork"):
                self.close()
        if watch is not None and watch.reason:
            failure = {"kind": "limit", "message": watch.reason}
            return {"failure": failure, "files": [], "steps": []}
        return answer if isinstance(answer, dict) else None

    def _answer(self, process: subprocess.Popen[bytes], request: dict[str, Any], limits: Limits) -> Any:
        import json

        assert process.stdin
        assert process.stdout
        raw = json.dumps({**request, "limits": limits._asdict()}).encode()
        process.stdin.write(len(raw).to_bytes(8, "big") + raw)
        process.stdin.flush()
        data = _receive(process.stdout, 8 * limits.output)
        return None if data is None else json.loads(data)

    def close(self) -> None:
        if self._stop is not None:
            self._stop()
        self._process = self._stop = None

    def start(self) -> subprocess.Popen[bytes]:
        """The process, which is started if it does not run; it gets ready while the caller goes on."""
        if self._process is not None:
            return self._process
        import subprocess
        from weakref import finalize

        command = [sys.executable, "-I", "-S", "-W", "ignore", "-X", "utf8", "-c", _START, *_folders()]
        self._process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            env={"PATH": os.defpath, **_needed_by_the_system()},
            start_new_session=True,
        )
        self._stop = finalize(self, _stop, self._process)
        return self._process


def _stop(process: subprocess.Popen[bytes]) -> None:
    _kill(process)
    for stream in (process.stdin, process.stdout):
        assert stream
        with suppress(OSError):  # what was to be written to a process that is gone
            stream.close()
    process.wait()


def _kill(process: subprocess.Popen[bytes]) -> None:
    """End the process and the fork that may be at work for it."""
    if process.poll() is not None:
        return
    if sys.platform != "win32":
        import signal

        os.killpg(process.pid, signal.SIGKILL)
    else:
        process.kill()


def _receive(stream: IO[bytes], limit: int) -> bytes | None:
    head = stream.read(8)
    size = int.from_bytes(head, "big")
    if len(head) < 8 or size > limit:
        return None
    data = stream.read(size)
    return data if len(data) == size else None


def _folders() -> list[str]:
    """The folders from which the process imports: this package's, xacro's and PyYAML's."""
    from importlib.util import find_spec

    folders = [str(Path(__file__).parents[3])]
    for name in ("xacro", "yaml"):
        spec = find_spec(name)
        if spec is not None and spec.origin is not None:
            folders.append(str(Path(spec.origin).parents[1]))
    return list(dict.fromkeys(folders))


def _needed_by_the_system() -> dict[str, str]:
    names = ("SYSTEMROOT", "LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH")
    return {name: os.environ[name] for name in names if name in os.environ}
