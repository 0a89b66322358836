"""The side of the calling process: starts the process that expands, asks it, stops it."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Callable, Iterator
from contextlib import nullcontext, suppress
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

from sdfcheck.source.errors import REPORT_IT, WrongUsage
from sdfcheck.xacro.process.watch import Limits, Watch, is_needed

if TYPE_CHECKING:
    import subprocess

_START = "import sys; sys.path += sys.argv[1:]; from sdfcheck.xacro.process.child import main; main()"
_GRACE = 5.0
"""So many seconds after its own deadline the process is given up."""

OLDEST, NEWEST = (2, 1), (3,)
"""The versions of xacro that are understood: from the first on, before the second."""

_METADATA = re.compile(r"xacro-(\d+(?:\.\d+)*)[^/]*\.(?:dist|egg)-info$", re.IGNORECASE)


def python_program() -> str:
    """The program of the running Python, which an application that embeds it may not name; none is looked for on PATH.

    Raises:
        WrongUsage: it is not found.
    """
    name = "python.exe" if os.name == "nt" else os.path.join("bin", "python3")
    for program in (
        sys.executable,
        *(os.path.join(each, name) for each in (sys.exec_prefix, sys.base_exec_prefix)),
    ):
        if program and os.access(program, os.X_OK):
            return program
    raise WrongUsage("the application that runs sdfcheck does not say where Python is: set `sys.executable`")


class Worker:
    """A process that expands files, one after the other. Start-up is paid once; it ends with this object."""

    __slots__ = ("__weakref__", "_code", "_process", "_stop")

    def __init__(self, code: str | None = None) -> None:
        self._code = _START if code is None else code
        self._process: subprocess.Popen[bytes] | None = None
        self._stop: Callable[[], object] | None = None

    def ask(self, request: dict[str, Any], limits: Limits) -> dict[str, Any]:
        """The answer to a request.

        Raises:
            WrongUsage: the process failed, for a reason that is not the file's, or nothing can limit it.
        """
        from threading import Timer

        process = self.start()
        watch = Watch(process.pid, limits, lambda: _kill(process)) if is_needed() else None
        timer = Timer(limits.wall + _GRACE, _kill, [process])
        timer.start()
        answer: dict[str, Any] | None = None
        try:
            with watch or nullcontext(), suppress(OSError):
                answer = self._answer(process, request, limits)
        finally:
            timer.cancel()
        if watch is not None and watch.reason:
            answer = {"failure": {"kind": "limit", "message": watch.reason}, "files": [], "steps": []}
        broken = _last_words(process) if answer is None else answer.get("broken")
        if broken or not hasattr(os, "fork"):
            self.close()
        if answer is None or broken:
            raise _broken(str(broken))
        return answer

    def _answer(
        self, process: subprocess.Popen[bytes], request: dict[str, Any], limits: Limits
    ) -> dict[str, Any] | None:
        """The answer of the process; None if it ended. One of another form is empty: code in a file wrote it."""
        import json

        assert process.stdin
        assert process.stdout
        raw = json.dumps({**request, "limits": limits._asdict()}).encode()
        process.stdin.write(len(raw).to_bytes(8, "big") + raw)
        process.stdin.flush()
        data = _receive(process.stdout, 8 * limits.output)
        if data is None:
            return None
        try:
            answer = json.loads(data)
        except (ValueError, RecursionError):
            return {}
        return answer if isinstance(answer, dict) else {}

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

        # Names of files mean the same in both processes.
        encoding = f"utf8={sys.flags.utf8_mode}"
        command = [
            python_program(),
            "-I",
            "-S",
            "-W",
            "ignore",
            "-X",
            encoding,
            "-c",
            self._code,
            *_folders(),
        ]
        self._process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env={"PATH": os.defpath, **_needed_by_the_system()},
            start_new_session=True,
        )
        self._stop = finalize(self, _stop, self._process)
        return self._process


def _stop(process: subprocess.Popen[bytes]) -> None:
    _kill(process)
    for stream in (process.stdin, process.stdout, process.stderr):
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


def _last_words(process: subprocess.Popen[bytes]) -> str:
    """The words that a process left on stderr, which is ended if it still runs."""
    _kill(process)
    assert process.stderr
    return process.stderr.read(1 << 20).decode(errors="replace").strip() or "it came to an unexpected end"


def _broken(words: str) -> WrongUsage:
    """The error for a process that failed; its own words are a traceback, whose last line says what happened."""
    last = " ".join(words.strip().rpartition("\n")[2].split())
    words = f"\n{words}\n" if os.environ.get("SDFCHECK_DEBUG") else last
    return WrongUsage(
        f"xacro files cannot be expanded, the process for it failed: {words} "
        f"(`--no-expand` checks the files as they are written; {REPORT_IT})"
    )


def _folders() -> list[str]:
    """The folders from which the process imports after the standard library: this package's, xacro's and PyYAML's."""
    return list(dict.fromkeys([str(Path(__file__).parents[3]), *xacro_folder(), *_homes("yaml")[:1]]))


def xacro_folder() -> list[str]:
    """The folder that holds an xacro of a version that is understood; a shell for ROS may name others first.

    Raises:
        WrongUsage: there is an xacro, but none of such a version.
    """
    homes = _homes("xacro")
    unknown, others = [], []
    for folder in homes:
        version = _xacro_version(folder)
        if version and OLDEST <= version < NEWEST:
            return [folder]
        if version:
            others.append(f"{'.'.join(map(str, version))} in {folder}")
        else:
            unknown.append(folder)
    if others and not unknown:
        raise WrongUsage(
            f"xacro files cannot be expanded: xacro 2.1 or newer is needed, found is {', '.join(others)} "
            "(`pip install 'xacro>=2.1,<3'`; `--no-expand` checks the files as they are written)"
        )
    return unknown[:1]


def _xacro_version(folder: str) -> tuple[int, ...]:
    """The version of the xacro in a folder, as its metadata say it; empty without any."""
    for name in sorted(os.listdir(folder)):
        if match := _METADATA.match(name):
            return tuple(map(int, match[1].split(".")))
    return ()


def _homes(package: str) -> list[str]:
    """The folders that hold a package: those of this environment first, then the others that are imported from."""
    found = (os.path.abspath(folder or os.curdir) for folder in _import_folders())
    return [
        folder
        for folder in dict.fromkeys(found)
        if os.path.isfile(os.path.join(folder, package, "__init__.py"))
    ]


def _import_folders() -> Iterator[str]:
    own = os.path.join(sys.prefix, "")
    yield from (folder for folder in sys.path if folder.startswith(own))
    yield from sys.path


def _needed_by_the_system() -> dict[str, str]:
    names = ("LANG", "LC_ALL", "LC_CTYPE", "LOCPATH", "LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH", "SYSTEMROOT")
    return {name: os.environ[name] for name in names if name in os.environ}
