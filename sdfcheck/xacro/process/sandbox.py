"""Limits of an expansion. Runs in the process that expands, nowhere else.

A xacro file is a program: its expressions are Python, and the evaluator's own check is easily
evaded. So attribute tricks are refused before an expression runs, the interpreter's audit hook lets
nothing happen but evaluating and reading the project's files, and the kernel limits time, memory
and writing.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from contextlib import suppress
from types import CodeType
from typing import Any

VALUE_LIMIT = 10_000_000
"""The longest text or list that an expression may make."""

# Through these attributes code reaches other frames, and from them everything.
_FRAMES = frozenset(
    """
    gi_frame gi_code gi_yieldfrom cr_frame cr_code cr_await cr_origin ag_frame ag_code ag_await tb_frame
    tb_next f_back f_builtins f_code f_globals f_locals f_trace func_globals func_code
    """.split()
)
# Exceptions of evaluating and reading; an expansion catches no others.
_HARMLESS = frozenset(
    """
    builtins.id compile exec glob.glob glob.glob/2 object.__getattr__ os.listdir os.scandir os.walk
    sys.excepthook sys.unraisablehook
    """.split()
)
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND


class Refused(Exception):
    """An expression tried what it must not."""


class TooMuch(Exception):
    """A limit is reached."""


def check_code(code: CodeType) -> None:
    """Raise Refused for code that reaches for the interpreter, also in functions inside it."""
    for name in code.co_names:
        if name.startswith("__") or name in _FRAMES:
            raise Refused(f"`{name}` must not be used in an expression")
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            check_code(constant)


def check_value(value: object) -> object:
    if isinstance(value, str | list | tuple | bytes) and len(value) > VALUE_LIMIT:
        raise TooMuch(f"the value has {len(value)} parts, more than {VALUE_LIMIT}")
    return value


def evaluate(expression: str, symbols: Any, locals: Any = None) -> object:
    """Evaluate an expression as xacro does, once it has been looked at."""
    code = compile(expression.strip(), "<expression>", "eval")
    check_code(code)
    symbols.update(__builtins__={})
    return check_value(eval(code, symbols, locals))


def evaluate_substitution(expression: str, symbols: dict[str, Any], locals: Any) -> object:
    """Evaluate the text of ``$(eval …)``, which xacro gives all of Python's built-in functions."""
    code = compile(expression.strip(), "<expression>", "eval")
    check_code(code)
    return check_value(eval(code, {"__builtins__": {}}, locals))


def isolate_network() -> None:
    """Leave the network where the system lets an ordinary process do so."""
    unshare = getattr(os, "unshare", None)
    if unshare is not None:
        with suppress(OSError):
            unshare(os.CLONE_NEWUSER | os.CLONE_NEWNET)  # type: ignore[attr-defined,unused-ignore]


def limit(limits: Mapping[str, int]) -> None:
    """Bound processor time (s), memory and written files (none); reaching the time raises TooMuch.

    Where the system has no such limits, :mod:`sdfcheck.xacro.process.watch` keeps them from outside.
    """
    if sys.platform == "win32":
        return
    try:
        import resource
        import signal
    except ImportError:
        return

    def out_of_time(number: int, frame: object) -> None:
        raise TooMuch(f"no end after {seconds} s of computing")

    seconds = limits["cpu"]
    signal.signal(signal.SIGXCPU, out_of_time)
    for what, soft, hard in (
        (resource.RLIMIT_CPU, seconds, seconds + 1),
        (resource.RLIMIT_AS, limits["memory"], limits["memory"]),
        (resource.RLIMIT_FSIZE, 0, 0),
        (resource.RLIMIT_CORE, 0, 0),
        (getattr(resource, "RLIMIT_NPROC", None), 0, 0),
    ):
        if what is not None:
            with suppress(OSError, ValueError):  # not every system has every limit
                resource.setrlimit(what, (soft, hard))


class Readable:
    """The files that may be read: below the project's root, or below a folder that was pointed out.

    A link inside the project, or in what its workspace has ``installed``, does not lead out of them.
    """

    __slots__ = ("links", "roots")

    def __init__(self, root: str, trusted: Sequence[str], installed: Sequence[str] = ()) -> None:
        self.roots = tuple(_plain(os.path.realpath(folder)) for folder in (root, *installed, *trusted))
        self.links = tuple(_plain(os.path.abspath(folder)) for folder in trusted)

    def __call__(self, path: str) -> bool:
        real = os.path.realpath(path)
        inside = _below(_plain(real), self.roots) or _below(_plain(os.path.abspath(path)), self.links)
        return inside and (os.path.isfile(real) or os.path.isdir(real) or not os.path.exists(real))


def _plain(path: str) -> str:
    """A path as systems compare it that do not distinguish letters by case; of Windows without ``\\\\?\\``."""
    return os.path.normcase(path.removeprefix("\\\\?\\") if os.sep == "\\" else path)


def _below(path: str, folders: Sequence[str]) -> bool:
    return any(path == folder or path.startswith(folder.rstrip(os.sep) + os.sep) for folder in folders)


def guard(readable: Readable) -> None:
    """From now on this process evaluates and reads, and does nothing else."""

    def hook(event: str, arguments: tuple[Any, ...]) -> None:
        if event in _HARMLESS:
            return
        if event != "open":
            raise Refused(f"an expression tried to do what it must not: {event}")
        path, mode, flags = arguments
        if (flags or 0) & _WRITING or set(mode or "r") & set("wax+"):
            raise Refused("an expression tried to write a file")
        if isinstance(path, int) or not readable(os.fspath(path)):
            raise Refused(f"{path} lies outside of the project")

    sys.addaudithook(hook)
