"""The walls that the system puts around the process that expands: Landlock and a seccomp filter, where Linux has them.

They stand under the interpreter of expressions and know nothing of it: whatever code runs in this process, it reads
below some folders, writes nothing, starts nothing and talks to nobody. Both are plain system calls. Where there is
no filter, an audit hook of Python's does what it can; code that runs freely may switch that one off.
"""

from __future__ import annotations

import ctypes
import os
import struct
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from typing import Any, TextIO

from sdfcheck.files.regular import is_made_up
from sdfcheck.xacro.process.interpreter import Refused, TooMuch

LANDLOCK = "Landlock"
SECCOMP = "seccomp filter"
AUDIT = "audit hook"

# linux/landlock.h: the numbers are those of every architecture.
_CREATE_RULESET, _ADD_RULE, _RESTRICT_SELF = 444, 445, 446
_READ_FILE, _READ_DIR = 1 << 2, 1 << 3
_FILE_RIGHTS = {1: 13, 2: 14, 3: 15, 4: 15}
"""Version of Landlock → how many rights on files it knows; later ones know 16."""
_NETWORK, _SCOPES = 0b11, 0b11
"""TCP, since version 4; abstract sockets and signals of others, since version 6."""

_SET_NO_NEW_PRIVILEGES, _SET_SECCOMP, _FILTER = 38, 22, 2

# linux/bpf_common.h and linux/seccomp.h
_LOAD, _EQUAL, _ANY_BIT, _RETURN = 0x20, 0x15, 0x45, 0x06
_ALLOW, _REFUSE, _KILL = 0x7FFF0000, 0x00050000 | 38, 0x80000000
"""Other calls fail as if the kernel did not have it (ENOSYS), so that the C library does without."""
_NUMBER, _ARCHITECTURE, _ARGUMENTS = 0, 4, 16
_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND

_ALLOWED = {
    "access": (21, None),
    "brk": (12, 214),
    "clock_getres": (229, 114),
    "clock_gettime": (228, 113),
    "clock_nanosleep": (230, 115),
    "close": (3, 57),
    "dup": (32, 23),
    "exit": (60, 93),
    "exit_group": (231, 94),
    "faccessat": (269, 48),
    "faccessat2": (439, 439),
    "fadvise64": (221, 223),
    "fstat": (5, 80),
    "fstatfs": (138, 44),
    "futex": (202, 98),
    "getcwd": (79, 17),
    "getdents64": (217, 61),
    "getegid": (108, 177),
    "geteuid": (107, 175),
    "getgid": (104, 176),
    "getpid": (39, 172),
    "getrandom": (318, 278),
    "getrusage": (98, 165),
    "gettid": (186, 178),
    "gettimeofday": (96, 169),
    "getuid": (102, 174),
    "lseek": (8, 62),
    "lstat": (6, None),
    "madvise": (28, 233),
    "membarrier": (324, 283),
    "mmap": (9, 222),
    "mprotect": (10, 226),
    "mremap": (25, 216),
    "munmap": (11, 215),
    "nanosleep": (35, 101),
    "newfstatat": (262, 79),
    "poll": (7, None),
    "ppoll": (271, 73),
    "pread64": (17, 67),
    "read": (0, 63),
    "readlink": (89, None),
    "readlinkat": (267, 78),
    "readv": (19, 65),
    "restart_syscall": (219, 128),
    "rseq": (334, 293),
    "rt_sigaction": (13, 134),
    "rt_sigprocmask": (14, 135),
    "rt_sigreturn": (15, 139),
    "sched_getaffinity": (204, 123),
    "sched_yield": (24, 124),
    "set_robust_list": (273, 99),
    "sigaltstack": (131, 132),
    "stat": (4, None),
    "statfs": (137, 43),
    "statx": (332, 291),
    "sysinfo": (99, 179),
    "time": (201, None),
    "times": (100, 153),
    "uname": (63, 160),
    "write": (1, 64),
    "writev": (20, 66),
}
"""The calls of the kernel that reading and computing need, with their numbers on x86_64 and aarch64."""
_OPENING = {"open": (2, None, 1), "openat": (257, 56, 2)}
"""Allowed without a flag that writes; the last number is the place of the flags."""
_ASKING = {"fcntl": (72, 25, (0, 1, 2, 3, 1030)), "ioctl": (16, 29, (0x5401, 0x5450, 0x5451))}
"""Allowed for what asks about an open file, copies its number, or keeps it from programs that are started: as its
second argument says. Other questions have the kernel send signals, to any process of the user, or lock files."""

_ARCHITECTURES = {"x86_64": 0xC000003E, "aarch64": 0xC00000B7}

# Python's audit hook lets happen what evaluating and reading need.
_HARMLESS = frozenset(
    """
    builtins.id compile exec glob.glob glob.glob/2 import marshal.loads object.__getattr__ os.listdir os.scandir
    os.walk sys.excepthook sys.unraisablehook
    """.split()
)


def lock(
    readable: Callable[[str], bool], folders: Iterable[str], without: Iterable[str] = ()
) -> dict[str, bool]:
    """Lock this process up for good.

    ``readable`` says which files may be read, ``folders`` are those below which they lie, and single files;
    ``without`` names walls that stay open. Returns which walls stand.
    """
    walls = {
        LANDLOCK: lambda: restrict_files((*folders, *filter(os.path.isdir, sys.path))),
        SECCOMP: filter_calls,
    }
    standing = {name: name not in without and raise_wall() for name, raise_wall in walls.items()}
    if not standing[SECCOMP] and AUDIT not in without:
        _audit(readable)
        standing[AUDIT] = True
    return standing


def restrict_files(folders: Iterable[str]) -> bool:
    """From now on nothing but these folders and files is read, and nothing is written (Landlock); was it possible?"""
    if sys.platform != "linux":
        return False
    version = _call(_CREATE_RULESET, None, 0, 1)
    if version < 1:
        return False
    rights = (1 << _FILE_RIGHTS.get(version, 16)) - 1
    attributes = struct.pack("=QQQ", rights, _NETWORK, _SCOPES)
    size = 8 if version < 4 else 16 if version < 6 else 24
    rules = _call(_CREATE_RULESET, attributes, size, 0)
    if rules < 0:
        return False
    for folder in dict.fromkeys(folders):
        try:
            place = os.open(folder, os.O_PATH | os.O_CLOEXEC)
        except OSError:
            continue
        granted = _READ_FILE | _READ_DIR if os.path.isdir(folder) else _READ_FILE
        _call(_ADD_RULE, rules, 1, struct.pack("=Qi", granted, place), 0)
        os.close(place)
    is_restricted = _without_new_privileges() and _call(_RESTRICT_SELF, rules, 0) == 0
    os.close(rules)
    return is_restricted


def filter_calls() -> bool:
    """From now on the kernel does nothing but reading, computing and ending for this process; was it possible?"""
    if sys.platform != "linux":
        return False
    machine = os.uname().machine
    if machine not in _ARCHITECTURES or struct.calcsize("P") != 8:
        return False
    rows = _program(("x86_64", "aarch64").index(machine), _ARCHITECTURES[machine])
    code = ctypes.create_string_buffer(b"".join(struct.pack("=HBBI", *row) for row in rows))
    program = struct.pack("@HP", len(rows), ctypes.addressof(code))
    return _without_new_privileges() and _control(_SET_SECCOMP, _FILTER, program, 0, 0) == 0


def _program(column: int, architecture: int) -> list[tuple[int, int, int, int]]:
    """The filter: rows of operation, jump if true, jump if false, value."""
    numbers = [row[column] for row in _ALLOWED.values()]
    rows: list[tuple[int, int, int, int]] = [
        (_LOAD, 0, 0, _ARCHITECTURE),
        (_EQUAL, 1, 0, architecture),
        (_RETURN, 0, 0, _KILL),
        (_LOAD, 0, 0, _NUMBER),
    ]
    for number in numbers:
        if number is not None:
            rows += [(_EQUAL, 0, 1, number), (_RETURN, 0, 0, _ALLOW)]
    for *each, place in _OPENING.values():
        number = each[column]
        if number is not None:
            rows += [
                (_EQUAL, 0, 4, number),
                (_LOAD, 0, 0, _ARGUMENTS + 8 * place),
                (_ANY_BIT, 1, 0, _WRITING),
                (_RETURN, 0, 0, _ALLOW),
                (_RETURN, 0, 0, _REFUSE),
            ]
    for *each, questions in _ASKING.values():
        number = each[column]
        if number is not None:
            rows += [(_EQUAL, 0, 2 * len(questions) + 2, number), (_LOAD, 0, 0, _ARGUMENTS + 8)]
            for question in questions:
                rows += [(_EQUAL, 0, 1, question), (_RETURN, 0, 0, _ALLOW)]
            rows.append((_RETURN, 0, 0, _REFUSE))
    return [*rows, (_RETURN, 0, 0, _REFUSE)]


def _call(number: int, *arguments: int | bytes | None) -> int:
    """A system call; -1 for one that fails."""
    return _ask("syscall", number, *arguments)


def _control(option: int, *arguments: int | bytes) -> int:
    return _ask("prctl", option, *arguments)


def _ask(function: str, *arguments: int | bytes | None) -> int:
    """A function of the C library that takes numbers of the size of an address, and bytes."""
    call = getattr(ctypes.CDLL(None), function)
    result: int = call(*(ctypes.c_long(each) if isinstance(each, int) else each for each in arguments))
    return result


def _without_new_privileges() -> bool:
    """Give up what programs that are started could gain, as Linux demands first; was it possible?"""
    return _control(_SET_NO_NEW_PRIVILEGES, 1, 0, 0, 0) == 0


def _audit(readable: Callable[[str], bool]) -> None:
    own = tuple(os.path.join(os.path.realpath(folder), "") for folder in sys.path)

    def hook(event: str, arguments: tuple[Any, ...]) -> None:
        if event in _HARMLESS:
            return
        if event != "open":
            raise Refused(f"an expression tried to do what it must not: {event}")
        path, mode, flags = arguments
        if (flags or 0) & _WRITING or set(mode or "r") & set("wax+"):
            raise Refused("an expression tried to write a file")
        name = "" if isinstance(path, int) else os.fsdecode(path)
        if not name or not (os.path.realpath(name).startswith(own) or readable(name)):
            raise Refused(f"{path} lies outside of the project")

    sys.addaudithook(hook)


# Limits of an expansion: time, memory and the files that are read. Runs in the process that expands, nowhere
# else.


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
    """The files that may be read: in the ``places`` of the project, or below a folder that was pointed out.

    A link inside the project, or in what its workspace has ``installed``, does not lead out of them.
    ``linked`` are files behind links out of a folder that was pointed out, as far as they are known.
    """

    __slots__ = ("linked", "links", "roots")

    def __init__(self, places: Sequence[str], trusted: Sequence[str], installed: Sequence[str] = ()) -> None:
        self.roots = tuple(_plain(os.path.realpath(folder)) for folder in (*places, *installed, *trusted))
        self.links = tuple(_plain(os.path.abspath(folder)) for folder in trusted)
        self.linked: list[str] = []

    def __call__(self, path: str) -> bool:
        real = os.path.realpath(path)
        inside = _below(_plain(real), self.roots) or _below(_plain(os.path.abspath(path)), self.links)
        return (
            inside
            and not is_made_up(real)
            and (os.path.isfile(real) or os.path.isdir(real) or not os.path.exists(real))
        )


def _plain(path: str) -> str:
    """A path as systems compare it that do not distinguish letters by case; of Windows without ``\\\\?\\``."""
    return os.path.normcase(path.removeprefix("\\\\?\\") if os.sep == "\\" else path)


def _below(path: str, folders: Sequence[str]) -> bool:
    return any(path == folder or path.startswith(folder.rstrip(os.sep) + os.sep) for folder in folders)


class Door:
    """Opens the files that xacro reads, in place of Python's ``open``. Their text is UTF-8 in every locale.

    ``closed`` is a file that may be read and that the system, locked up, does not open: a link in a folder that
    was pointed out leads to it.
    """

    __slots__ = ("_readable", "closed")

    def __init__(self, readable: Readable) -> None:
        self._readable = readable
        self.closed = ""

    def __call__(self, name: str | bytes | os.PathLike[str], mode: str = "r") -> TextIO:
        path = os.path.abspath(os.fsdecode(name))
        if mode != "r" or not self._readable(path):
            raise Refused(f"{os.fsdecode(name)} lies outside of the project")
        try:
            return open(name, encoding="utf-8")
        except PermissionError:
            self.closed = path
            raise
