"""The consumers themselves, as far as they are installed: what each makes of a file.

An engine is a program or a Python package that reads robot descriptions. It is asked in a process
of its own with limits on time and memory, so that its crash is its verdict. A package may be
installed beside sdfcheck (``pip install 'sdfcheck[mujoco]'``) or in another environment, whose
interpreter the variable ``SDFCHECK_ENGINES`` names.
"""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterable, Iterator, Mapping, Sequence
from enum import Enum
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from sdfcheck.consumers.reaction import Consumer
from sdfcheck.files.python import python_program
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple

VARIABLE = "SDFCHECK_ENGINES"
"""The environment variable with the Python interpreter of another environment, which has the packages."""
_ROOT = Path(__file__).parents[3]
_START = (
    "import sys; sys.path = [one for one in sys.path if one]; before = list(sys.path); "
    "sys.path.insert(0, {root!r}); from sdfcheck.consumers.engines import child; "
    "sys.path[:] = before; child.main({name!r})"
)
"""The child finds this package only while it starts, and never the current folder."""


class Engine(Enum):
    """A consumer that can be run; the value is its name."""

    LIBSDFORMAT = "libsdformat"
    DRAKE = "drake"
    URDFDOM = "urdfdom"
    MUJOCO = "mujoco"
    PYBULLET = "pybullet"
    PINOCCHIO = "pinocchio"
    USD = "usd"
    YOURDFPY = "yourdfpy"

    @property
    def package(self) -> str:
        """The Python package that it is imported from; empty for a program."""
        return _PACKAGES.get(self, "")

    @property
    def advice(self) -> str:
        """How to install it."""
        return _PROGRAMS.get(self) or f"pip install 'sdfcheck[{_EXTRAS.get(self, self.value)}]'"


_PACKAGES = {
    Engine.DRAKE: "pydrake",
    Engine.MUJOCO: "mujoco",
    Engine.PYBULLET: "pybullet",
    Engine.PINOCCHIO: "pinocchio",
    Engine.USD: "urdf_usd_converter",
    Engine.YOURDFPY: "yourdfpy",
}
_EXTRAS = {Engine.YOURDFPY: "verify"}
_PROGRAMS = {
    Engine.LIBSDFORMAT: "install Gazebo, or libsdformat with its command `gz sdf`",
    Engine.URDFDOM: "install liburdfdom-tools, which has `check_urdf`",
}

RUN_BY: Mapping[Consumer, Engine] = {
    Consumer.GAZEBO: Engine.LIBSDFORMAT,
    Consumer.DRAKE: Engine.DRAKE,
    Consumer.URDFDOM: Engine.URDFDOM,
    Consumer.MUJOCO: Engine.MUJOCO,
    Consumer.ROS: Engine.URDFDOM,
    Consumer.PYBULLET: Engine.PYBULLET,
    Consumer.PINOCCHIO: Engine.PINOCCHIO,
    Consumer.ISAAC: Engine.USD,
}
"""Consumer → what of it can be run: of ROS the parser that all its programs use, of Isaac Sim its converter."""
SIMULATORS = (Engine.MUJOCO, Engine.DRAKE, Engine.PYBULLET)
"""The engines that can let a robot move."""


class Outcome(Enum):
    """The end of a question."""

    ACCEPTED = "accept"
    REFUSED = "reject"
    CRASHED = "crash"
    """It ended by a signal, or by an exit of its own."""
    TOO_LONG = "too long"
    """It took more time than it was given."""
    MISSING = "not installed"


class Limits(NamedTuple):
    """The limits of one question: seconds and bytes of memory."""

    seconds: float = 60.0
    memory: int = 8 << 30


LIMITS = Limits()


class Question(NamedTuple):
    """A file, and what to do with it: ``load``, ``facts`` or ``behave``, with the settings of that."""

    path: Path
    action: str = "load"
    settings: Mapping[str, Any] = {}
    packages: tuple[tuple[str, str], ...] = ()
    """Name → folder of ROS packages."""
    model_paths: tuple[str, ...] = ()
    is_copy: bool = False
    """Is the file a copy that was made for engines, away from the files that are around the description?"""


class Answer(NamedTuple):
    """The verdict of an engine on a file, its messages, and what else it was asked for."""

    engine: Engine
    outcome: Outcome
    version: str = ""
    error: str = ""
    """Why it does not take the file, in its own words or those of the system."""
    messages: tuple[str, ...] = ()
    """Its output, line by line."""
    result: Mapping[str, Any] = {}

    @property
    def is_accepted(self) -> bool:
        return self.outcome is Outcome.ACCEPTED

    @property
    def is_missing(self) -> bool:
        """Is the consumer not installed?"""
        return self.outcome is Outcome.MISSING


@cache
def interpreter(engine: Engine) -> str:
    """The Python interpreter in which an engine can be asked; empty where it is not installed."""
    if not engine.package or find_spec(engine.package) is not None:
        return python_program()
    return os.environ.get(VARIABLE, "") if engine in _elsewhere(os.environ.get(VARIABLE, "")) else ""


@cache
def _elsewhere(python: str) -> frozenset[Engine]:
    """The engines that another environment has.

    Raises: WrongUsage: the variable names no program.
    """
    if not python:
        return frozenset()
    code = (
        "import sys; sys.path = [one for one in sys.path if one]; from importlib.util import find_spec; "
        f"print(*(one for one in {sorted(_PACKAGES.values())!r} if find_spec(one)))"
    )
    try:
        done = subprocess.run([python, "-c", code], capture_output=True, text=True, timeout=30, check=False)
    except OSError as error:
        raise WrongUsage(f"{VARIABLE}: cannot run {python}: {error.strerror}") from None
    except subprocess.TimeoutExpired:
        return frozenset()
    found = done.stdout.split()
    return frozenset(engine for engine, package in _PACKAGES.items() if package in found)


def is_installed(engine: Engine) -> bool:
    """Whether an engine can be asked at all."""
    if engine is Engine.LIBSDFORMAT:
        from sdfcheck.consumers.engines import libsdformat

        return bool(libsdformat.program())
    if engine is Engine.URDFDOM:
        from sdfcheck.consumers.engines import urdfdom

        return bool(urdfdom.program())
    return bool(interpreter(engine))


def ask(engine: Engine, question: Question, limits: Limits = LIMITS) -> Answer:
    """Ask an engine about one file."""
    (answer,) = ask_all(engine, [question], limits)
    return answer


def ask_all(engine: Engine, questions: Iterable[Question], limits: Limits = LIMITS) -> Iterator[Answer]:
    """Ask an engine about files one after the other; it is loaded once, if the system can copy processes."""
    waiting = list(questions)
    if not is_installed(engine):
        yield from (Answer(engine, Outcome.MISSING, error=engine.advice) for _ in waiting)
        return
    while waiting:
        answered = 0
        for answer in _serve(engine, waiting, limits):
            answered += 1
            yield answer
        waiting = waiting[answered:]
        if waiting and not answered:
            yield Answer(engine, Outcome.CRASHED, error="it ended while it was loaded")
            waiting = waiting[1:]


def _serve(engine: Engine, questions: Sequence[Question], limits: Limits) -> Iterator[Answer]:
    """The answers of one process, which may end before it has answered all questions."""
    command = [interpreter(engine), "-c", _START.format(root=str(_ROOT), name=engine.value)]
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1", "PYTHONUNBUFFERED": "1"}
    process = subprocess.Popen(
        command,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
        encoding="utf-8",
        errors="replace",
        env=environment,
    )
    assert process.stdin is not None
    assert process.stdout is not None
    with process:
        try:
            for question in questions:
                asked = {
                    **question._asdict(),
                    "path": os.fspath(question.path.absolute()),
                    "limits": tuple(limits),
                }
                try:
                    process.stdin.write(json.dumps(asked) + "\n")
                    process.stdin.flush()
                    line = process.stdout.readline()
                except OSError:
                    return
                if not line:
                    return
                yield _answer(engine, json.loads(line))
        finally:
            process.kill()


def _answer(engine: Engine, said: Mapping[str, Any]) -> Answer:
    return Answer(
        engine,
        Outcome(said["outcome"]),
        said["version"],
        said["error"],
        tuple(said["messages"]),
        said["result"],
    )
