"""The process in which an engine runs: it loads the engine once, and forks for each question.

A question and its answer are a line of JSON each. Only the standard library and the engine are
imported here, since the engine may be in an environment without sdfcheck.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import tempfile
import time
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

LINES = 200
"""How many lines of an engine's output are kept."""
WIDTH = 400
"""How long such a line may be."""
_PAUSE = 0.002


class Refused(Exception):
    """An engine does not take a file; the text says why."""


def say(text: str) -> None:
    """Add to the messages of the engine."""
    os.write(2, text.encode("utf-8", "replace"))


def main(name: str) -> None:
    """Answer the questions on stdin until it ends."""
    answers = os.fdopen(os.dup(1), "w", encoding="utf-8")
    void = os.open(os.devnull, os.O_WRONLY)
    os.dup2(void, 1)
    os.dup2(void, 2)
    adapter = import_module(f"sdfcheck.consumers.engines.{name}")
    try:
        version, failure = adapter.version(), ""
    except Exception as error:
        version, failure = "", f"it cannot be loaded: {_one_line(error)}"
    for line in sys.stdin:
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            question = json.loads(line)
            answer = {"outcome": "reject", "error": failure} if failure else _asked(adapter, question, folder)
            os.chdir("/" if os.name == "posix" else tempfile.gettempdir())
        filled = {"error": "", "messages": [], "result": {}, "version": version, **answer}
        answers.write(json.dumps(filled) + "\n")
        answers.flush()


def _asked(adapter: Any, question: dict[str, Any], folder: str) -> dict[str, Any]:
    output, result = Path(folder, "output"), Path(folder, "answer")

    def work() -> None:
        stream = os.open(output, os.O_WRONLY | os.O_CREAT | os.O_APPEND)
        os.dup2(stream, 1)
        os.dup2(stream, 2)
        result.write_text(json.dumps(_worked(adapter, question)), encoding="utf-8")

    ended = _apart(work, *question["limits"])
    said = _lines(output)
    if ended:
        return {**ended, "messages": said}
    return {**json.loads(result.read_text("utf-8")), "messages": said}


def _worked(adapter: Any, question: dict[str, Any]) -> dict[str, Any]:
    """Load a file, and then ask; only the first can refuse it."""
    try:
        model = adapter.load(question)
    except Exception as error:
        kind = "" if isinstance(error, (Refused, RuntimeError, ValueError)) else f"{type(error).__name__}: "
        return {"outcome": "reject", "error": f"{kind}{_one_line(error)}"}
    if question["action"] == "load":
        return {"outcome": "accept"}
    try:
        result = getattr(adapter, question["action"])(model, question["settings"])
    except Exception as error:
        return {"outcome": "accept", "error": f"{type(error).__name__}: {_one_line(error)}"}
    return {"outcome": "accept", "result": result}


def _apart(work: Callable[[], None], seconds: float, memory: int) -> dict[str, Any]:
    """Do something in a copy of this process; says how the copy ended, if not well.

    Where processes cannot be copied, a crash ends this one, which the asking process sees.
    """
    if sys.platform == "win32" or not hasattr(os, "fork"):
        work()
        return {}
    child = os.fork()
    if child == 0:
        code = 1
        try:
            _limit(seconds, memory)
            work()
            code = 0
        finally:
            os._exit(code)
    end = time.monotonic() + seconds
    while True:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            break
        if time.monotonic() > end:
            os.kill(child, signal.SIGKILL)
            os.waitpid(child, 0)
            return {"outcome": "too long", "error": f"it was not done after {seconds:g} s"}
        time.sleep(_PAUSE)
    if os.WIFSIGNALED(status):
        number = os.WTERMSIG(status)
        if number == signal.SIGXCPU:
            return {"outcome": "too long", "error": f"it was not done after {seconds:g} s"}
        return {"outcome": "crash", "error": f"it ended by {signal.Signals(number).name}"}
    return {"outcome": "crash", "error": "it ended the process"} if status else {}


def _limit(seconds: float, memory: int) -> None:
    if sys.platform == "win32":
        return
    import resource

    for kind, most in ((resource.RLIMIT_CPU, int(seconds) + 1), (resource.RLIMIT_AS, memory)):
        _, hard = resource.getrlimit(kind)
        allowed = most if hard == resource.RLIM_INFINITY else min(most, hard)
        resource.setrlimit(kind, (allowed, hard))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def _lines(output: Path) -> list[str]:
    if not os.path.isfile(output):
        return []
    with output.open(errors="replace") as stream:
        text = stream.read(LINES * WIDTH)
    return [line.strip()[:WIDTH] for line in text.splitlines() if line.strip()][:LINES]


def _one_line(error: BaseException) -> str:
    return " ".join(str(error).split())[: 2 * WIDTH] or type(error).__name__
