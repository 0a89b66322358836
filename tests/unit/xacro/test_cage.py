"""Neither the interpreter of expressions nor the walls of the system lets code out: each is tried without the other."""

from __future__ import annotations

import json
import os
import shutil
import socket
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from random import Random
from typing import Any

import pytest

from sdfcheck.source.document import read
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import Expander, Expansion, Surroundings
from sdfcheck.xacro.process import interpreter, walls, worker
from sdfcheck.xacro.process.watch import Limits
from sdfcheck.xacro.process.worker import python_program

HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
IMPORTED = "import sys; sys.path += sys.argv[1:]; import sdfcheck.xacro.process.child as child; "
WITHOUT_INTERPRETER = (
    f"{IMPORTED}child.Interpreter = lambda *_: None; child.sandbox.Door = type('Door', (), "
    "{'__init__': lambda *_: None, '__call__': lambda _, name: open(name), 'closed': ''}); child.main()"
)
WITH_AUDIT_HOOK = WITHOUT_INTERPRETER.replace(
    "child.main()",
    "child.walls.restrict_files = lambda *_: False; child.walls.filter_calls = lambda: False; child.main()",
)
WITHOUT_WALLS = f"{IMPORTED}child.walls.lock = lambda *_: {{}}; child.main()"
SECRET = "not-for-the-authors-of-robots"
MADE = "made-by-an-expression"

# xacro looks for underscores outside of functions only.
BUILTINS = "(lambda f: f.__globals__)(xacro.load_yaml)['__builtins__']"
TYPES = (
    "(lambda v, T, f: (lambda F: (lambda g: v(T(g))['__get__'](g, f, F))(v(F)['__globals__']))(T(f)))"
    "(python.vars, python.type, xacro.load_yaml)"
)


class Ground:
    """A project with a secret beside it, and somebody who listens."""

    def __init__(self, folder: Path) -> None:
        self.project = folder / "project"
        self.project.mkdir()
        (self.project / ".git").mkdir()
        self.secret = folder / "secret.yaml"
        self.secret.write_text(f"token: {SECRET}")
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.listener.setblocking(False)

    def expand(self, expander: Expander, body: str, name: str = "r.xacro") -> Expansion:
        path = self.project / name
        path.write_text(f"{HEAD}\n{body}\n</robot>", encoding="utf-8")
        return expander.expand(read(path.read_bytes(), path, Kind.XACRO))

    def assert_nothing_escaped(self, expansion: Expansion) -> None:
        shown = f"{expansion.text}{expansion.problems}"
        assert SECRET not in shown
        assert not list(self.project.parent.rglob(f"*{MADE}*"))
        with pytest.raises(BlockingIOError):
            self.listener.accept()

    def insert(self, code: str) -> str:
        """A piece of code with the places of this ground in it, escaped for an attribute."""
        port = self.listener.getsockname()[1]
        code = code.replace("SECRET", str(self.secret)).replace("MADE_NAME", MADE)
        code = code.replace("MADE", f"{self.project}/{MADE}")
        code = code.replace("PORT", str(port)).replace("PARENT", str(os.getpid()))
        return code.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")


@pytest.fixture
def ground(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Ground]:
    one = Ground(tmp_path)
    monkeypatch.chdir(one.project)
    yield one
    one.listener.close()


def _expander(start: str) -> Iterator[Expander]:
    with Expander(Surroundings(limits=Limits(cpu=5))) as one:
        one._worker = worker.Worker(start)
        yield one


@pytest.fixture(scope="module")
def interpreter_alone() -> Iterator[Expander]:
    yield from _expander(WITHOUT_WALLS)


@pytest.fixture(scope="module")
def walls_alone() -> Iterator[Expander]:
    yield from _expander(WITHOUT_INTERPRETER)


# The walls of the system: code runs freely

OS = f"{BUILTINS}['__import__']('os')"
CTYPES = f"{BUILTINS}['__import__']('ctypes').CDLL(None)"
DEEDS = [
    # starting programs
    f"{OS}.system('touch MADE')",
    f"{OS}.popen('touch MADE').read()",
    f"{OS}.execv('/bin/sh', ['sh', '-c', 'touch MADE'])",
    f"{OS}.posix_spawn('/bin/sh', ['sh', '-c', 'touch MADE'], dict())",
    f"{OS}.spawnl(0, '/bin/sh', 'sh', '-c', 'touch MADE')",
    f"{OS}.fork()",
    f"{OS}.forkpty()",
    f"{CTYPES}.system(b'touch MADE')",
    f"{BUILTINS}['__import__']('pty').spawn(['touch', 'MADE'])",
    f"{BUILTINS}['__import__']('multiprocessing').Process(target=print).start()",
    # writing
    f"{OS}.open('/tmp', 0o20200002)",
    f"{OS}.mkdir('MADE')",
    f"{OS}.link('SECRET', 'MADE')",
    f"{OS}.rename('SECRET', 'MADE')",
    f"{OS}.replace('SECRET', 'MADE')",
    f"{OS}.memfd_create('MADE')",
    f"{BUILTINS}['__import__']('shutil').copy('SECRET', 'MADE')",
    f"{BUILTINS}['__import__']('sqlite3').connect('MADE')",
    f"{BUILTINS}['__import__']('tempfile').mkstemp(prefix='{MADE}', dir='/tmp')",
    # reading
    f"{OS}.read({OS}.open('secret.yaml', 0, dir_fd={OS}.open('..', 0)), 99)",
    f"{BUILTINS}['__import__']('pathlib').Path('SECRET').read_text()",
    f"{BUILTINS}['__import__']('linecache').getline('SECRET', 1)",
    f"{BUILTINS}['__import__']('mmap').mmap({OS}.open('SECRET', 0), 9)[:]",
    "xacro.load_yaml('SECRET').token",
    # the network
    f"{BUILTINS}['__import__']('socket').create_connection(('127.0.0.1', PORT))",
    f"{BUILTINS}['__import__']('socket').socket(1)",
    f"{BUILTINS}['__import__']('urllib.request').request.urlopen('http://127.0.0.1:PORT')",
    # the three ways out that were found first, with their own steps
    f"(lambda E: E['os'].execv('/bin/sh', ['sh', '-c', 'touch MADE']))({TYPES})",
    f"(lambda E: E['os'].mkfifo('MADE'))({TYPES})",
    f"(lambda E: E['__builtins__']['open']('SECRET').read())({TYPES})",
]
FORBIDDEN_CALLS = [
    "fork()", "vfork()", "unshare(0x10000000)", "unshare(0x40000000)", "setns(0, 0)", "kill(PARENT, 0)",
    "ptrace(16, PARENT, 0, 0)", "mount(0, b'/', 0, 0, 0)", "umount2(b'/', 0)", "chroot(b'/')", "chdir(b'/')",
    "mkfifo(b'MADE', 511)", "mknod(b'MADE', 4534, 0)", "mkdir(b'MADE', 511)", "symlink(b'/', b'MADE')",
    "truncate(b'SECRET', 0)", "unlink(b'SECRET')", "rmdir(b'.git')", "chmod(b'SECRET', 511)",
    "chown(b'SECRET', 1, 1)", "utimes(b'SECRET', 0)", "setxattr(b'SECRET', b'user.a', b'b', 1, 0)",
    "socket(1, 1, 0)", "socket(2, 1, 0)", "socket(16, 3, 0)", "open(b'MADE', 65)", "open(b'SECRET', 0)",
    "open(b'SECRET', 2)", "open(b'/proc/PARENT/environ', 0)", "open(b'/proc/PARENT/mem', 2)", "open(b'/dev/tty', 0)",
    "open(b'/etc/passwd', 0)", "eventfd(0, 0)", "inotify_init()", "setuid(1)", "setpgid(0, 0)", "nice(1)",
    "sethostname(b'x', 1)", "prctl(1, 9)", "setrlimit(0, b'0' * 16)", "process_vm_readv(PARENT, 0, 0, 0, 0, 0)",
    "syscall(425, 1, b'0' * 120)", "syscall(321, 0, b'0' * 8, 8)", "syscall(298, b'0' * 128, 0, 0, 0, 0)",
    "syscall(323, 0)", "syscall(434, PARENT, 0)", "syscall(435, b'0' * 88, 88)",
    "syscall(437, 0, b'SECRET', b'0' * 24, 24)",
    "syscall(319, b'x', 0)", "syscall(322, 0, b'/bin/true', 0, 0, 0)", "syscall(317, 1, 0, b'0' * 16)",
    "syscall(248, b'user', b'a', b'b', 1, 0)", "syscall(9999)", "fcntl(0, 8, PARENT)", "fcntl(0, 10, 9)",
    "fcntl(0, 15, b'0' * 8)", "fcntl(0, 4, 0x2000)", "fcntl(0, 6, b'0' * 32)", "fcntl(0, 1024, 0)", "flock(0, 2)",
]  # fmt: skip

SUBPROCESS, PATHLIB, IO, SOCKET = (
    f"{BUILTINS}['__import__']('{name}')" for name in ("subprocess", "pathlib", "io", "socket")
)
BUFFER = f"{BUILTINS}['__import__']('ctypes').create_string_buffer(99)"
READERS = [
    f"{BUILTINS}['open']('FILE', 'rb').read(99)", f"{IO}.FileIO('FILE').read(99)",
    f"{PATHLIB}.Path('FILE').read_bytes()[:99]", f"{OS}.read({OS}.open('FILE', 0), 99)",
    f"{OS}.read({OS}.open('FILE', 0o4000), 99)", f"{OS}.pread({OS}.open('FILE', 0), 99, 0)",
    f"{OS}.fdopen({OS}.open('FILE', 0), 'rb').read(99)",
    f"(lambda o, p: o.read(o.open(p[1], 0, dir_fd=o.open(p[0] or '.', 0)), 99))({OS}, {OS}.path.split('FILE'))",
    f"{BUILTINS}['__import__']('codecs').open('FILE', 'rb').read(99)",
    f"{BUILTINS}['__import__']('fileinput').input('FILE', mode='rb').readline()",
    f"(lambda c, b: c.read(c.open(b'FILE', 0), b, 99) + 1 and b.raw or 1/0)({CTYPES}, {BUFFER})",
    f"(lambda c, b: c.read(c.openat(-100, b'FILE', 0), b, 99) + 1 and b.raw or 1/0)({CTYPES}, {BUFFER})",
]  # fmt: skip
SECRETS = [
    "SECRET", "../secret.yaml", "link.yaml", "folder/secret.yaml", "/proc/self/cwd/../secret.yaml",
    "/proc/self/rootSECRET", "/proc/PARENT/environ", "/proc/PARENT/cmdline", "/proc/self/environ", "/etc/passwd",
]  # fmt: skip
READING = [reader.replace("FILE", secret) for reader in READERS for secret in SECRETS]
WRITERS = [
    *(f"{BUILTINS}['open']('FILE', '{mode}')" for mode in ("w", "a", "x", "w+b")),
    *(f"{OS}.open('FILE', {flags})" for flags in (0o101, 0o102, 0o2101, 0o1101)),
    f"{IO}.FileIO('FILE', 'w')", f"{PATHLIB}.Path('FILE').touch()", f"{PATHLIB}.Path('FILE').mkdir()",
    f"{PATHLIB}.Path('FILE').symlink_to('/')", f"{OS}.makedirs('FILE')", f"{OS}.mkfifo('FILE')",
    f"{OS}.mknod('FILE')", f"{OS}.link('r.xacro', 'FILE')", f"{OS}.rename('victim', 'FILE')",
    f"{OS}.symlink('/etc', 'FILE')", f"{CTYPES}.creat(b'FILE', 511) + 1 or 1/0",
    f"{CTYPES}.fopen(b'FILE', b'w') or 1/0", f"{CTYPES}.mkdir(b'FILE', 511) + 1 or 1/0",
]  # fmt: skip
PLACES_OF_FILES = ["MADE", "MADE.yaml", "../MADE_NAME", "/proc/self/cwd/MADE_NAME", "out/MADE_NAME"]
WRITING = [writer.replace("FILE", place) for writer in WRITERS for place in PLACES_OF_FILES]
STARTING = [
    *(f"{SUBPROCESS}.{how}(['touch', 'MADE'])" for how in ("run", "call", "check_call", "check_output")),
    *(f"{SUBPROCESS}.Popen({words})" for words in ("['touch', 'MADE']", "'touch MADE', shell=True")),
    f"{SUBPROCESS}.getoutput('touch MADE')", f"1 / ({OS}.system('touch MADE MADE') == 0)",
    f"1 / ({CTYPES}.system(b'touch MADE MADE') == 0)", f"{OS}.popen('touch MADE MADE').read()",
    *(f"{OS}.{how}('/bin/touch', 'touch', 'MADE')" for how in ("execl", "execlp")),
    *(f"{OS}.{how}('/bin/touch', ['touch', 'MADE'])" for how in ("execv", "execvp")),
    *(f"{OS}.{how}('/bin/touch', ['touch', 'MADE'], {{}})".replace("{}", "dict()") for how in ("execve", "execvpe")),
    *(f"{OS}.{how}('/bin/touch', ['touch', 'MADE'], dict())" for how in ("posix_spawn", "posix_spawnp")),
    *(f"{OS}.{how}(0, '/bin/touch', ['touch', 'MADE'])" for how in ("spawnv", "spawnvp")),
    f"{OS}.fork() or {OS}.system('touch MADE')", f"{BUILTINS}['__import__']('pty').fork()",
    f"(lambda a: a.run(a.create_subprocess_shell('touch MADE')))({BUILTINS}['__import__']('asyncio'))",
    f"{BUILTINS}['__import__']('threading').Thread(target={BUILTINS}['open'], args=['MADE', 'w']).start()",
    f"{BUILTINS}['__import__']('_thread').start_new_thread({BUILTINS}['open'], ('MADE', 'w'))",
]  # fmt: skip
CONNECTING = [
    f"{SOCKET}.create_connection(('127.0.0.1', PORT), 1)", f"{SOCKET}.create_connection(('localhost', PORT), 1)",
    *(f"{SOCKET}.socket({family}, {kind})" for family in (1, 2, 10, 16, 17, 38, 40) for kind in (1, 2, 3)),
    f"{SOCKET}.socketpair()", f"{SOCKET}.create_server(('127.0.0.1', 0))",
    f"{BUILTINS}['__import__']('urllib.request').request.urlopen('http://127.0.0.1:PORT', timeout=1)",
    f"{BUILTINS}['__import__']('http.client').client.HTTPConnection('127.0.0.1', PORT).connect()",
    f"{BUILTINS}['__import__']('asyncio').new_event_loop()",
]  # fmt: skip
REACHING = [
    *(f"{OS}.kill({process}, {number})" for process in ("PARENT", f"{OS}.getppid()") for number in (0, 9, 15, 18)),
    f"{OS}.killpg({OS}.getpgid(0), 0)", f"{OS}.killpg(0, 9)", f"{OS}.kill(-1, 0)", f"{OS}.pidfd_open(PARENT)",
    f"{OS}.setpriority(0, PARENT, 19)", f"{OS}.sched_setaffinity(PARENT, [0])", f"{OS}.chdir('/')", f"{OS}.chroot('/')",
    f"{BUILTINS}['__import__']('fcntl').fcntl(0, 8, PARENT)", f"{BUILTINS}['__import__']('fcntl').flock(0, 2)",
    f"{BUILTINS}['__import__']('resource').prlimit(PARENT, 0)", f"{OS}.unshare(0x10000000)", f"{OS}.setsid()",
    f"{BUILTINS}['__import__']('multiprocessing.shared_memory').shared_memory.SharedMemory('x', True, 9)",
]  # fmt: skip
FREELY = {
    "read": READING, "write": WRITING, "start": STARTING, "connect": CONNECTING, "reach": REACHING,
}  # fmt: skip
"""Attempts of code that runs freely; each must fail with an exception, behind the walls."""
WITHOUT_RESULT = [code for codes in FREELY.values() for code in codes]


def needs_walls(expander: Expander) -> None:
    standing = expander.walls()
    if not all(standing.get(name) for name in ("Landlock", "seccomp filter")):
        pytest.skip("the system has neither Landlock nor seccomp")


@pytest.mark.parametrize("code", DEEDS)
def test_the_walls_hold_code_that_runs_freely(walls_alone: Expander, ground: Ground, code: str) -> None:
    needs_walls(walls_alone)
    ground.assert_nothing_escaped(ground.expand(walls_alone, f'<a b="${{{ground.insert(code)}}}"/>'))


@pytest.mark.parametrize("call", FORBIDDEN_CALLS)
def test_the_walls_refuse_system_calls(walls_alone: Expander, ground: Ground, call: str) -> None:
    needs_walls(walls_alone)
    code = ground.insert(f"{CTYPES}.{call}")
    done = ground.expand(walls_alone, f'<a b="${{{code}}}"/>')
    ground.assert_nothing_escaped(done)
    assert done.text is None or '<a b="-1"/>' in done.text
    assert ground.secret.read_text() == f"token: {SECRET}"


def place_links(ground: Ground) -> None:
    (ground.project / "link.yaml").symlink_to("../secret.yaml")
    (ground.project / "folder").symlink_to("..")
    (ground.project / "out").symlink_to("..")
    (ground.project / "victim").touch()


@pytest.mark.parametrize("deed", FREELY)
def test_code_that_runs_freely_gets_nothing_done(walls_alone: Expander, ground: Ground, deed: str) -> None:
    needs_walls(walls_alone)
    place_links(ground)
    for code in FREELY[deed]:
        done = ground.expand(walls_alone, f'<a b="${{{ground.insert(code)}}}"/>')
        ground.assert_nothing_escaped(done)
        assert done.text is None, f"{code}: {done.text}"
    assert (ground.project / "victim").exists()


def test_no_other_system_call_passes(walls_alone: Expander, ground: Ground) -> None:
    """All numbers that a kernel may know, those for other processors, and those that are no calls."""
    needs_walls(walls_alone)
    column = 0 if os.uname().machine == "x86_64" else 1
    allowed = {
        row[column] for table in (walls._ALLOWED, walls._OPENING, walls._ASKING) for row in table.values()
    }
    allowed |= {335, 336}  # of uprobes: no filter sees them, and who calls them is ended
    others = [number for number in (*range(1024), *range(2**30, 2**30 + 600)) if number not in allowed]
    code = f"(lambda c: [n for n in {others} if c.syscall(n, 0, 0, 0, 0, 0, 0) != -1])({CTYPES})"
    done = ground.expand(walls_alone, f'<a b="${{{code}}}"/>')
    assert done.text is not None, done.problems
    assert '<a b="[]"/>' in done.text


def test_where_the_system_has_no_walls_a_hook_stops_what_does_not_look_for_it(ground: Ground) -> None:
    for expander in _expander(WITH_AUDIT_HOOK):
        assert expander.walls() == {"Landlock": False, "seccomp filter": False, "audit hook": True}
        for deed in [*DEEDS, *STARTING, *CONNECTING]:
            if not any(word in deed for word in ("mkfifo", "mknod", "memfd_create", "ctypes")):
                ground.assert_nothing_escaped(ground.expand(expander, attribute(ground, deed)))
        assert ground.expand(expander, "<a b='${1 + 1}'/>").text is not None


def test_without_walls_the_same_code_runs(ground: Ground) -> None:
    """Else the tests above would prove nothing."""
    both = WITHOUT_INTERPRETER.replace("child.main()", "child.walls.lock = lambda *_: {}; child.main()")
    for expander in _expander(both):
        for code in (DEEDS[0], f"{OS}.mkfifo('MADE')", f"{CTYPES}.system(b'touch MADE')"):
            ground.expand(expander, f'<a b="${{{ground.insert(code)}}}"/>')
            made = ground.project / MADE
            assert made.exists()
            made.unlink()
        read = ground.insert(f"(lambda E: E['__builtins__']['open']('SECRET').read())({TYPES})")
        assert SECRET in (ground.expand(expander, f'<a b="${{{read}}}"/>').text or "")
        place_links(ground)
        for code in READING:
            assert ground.expand(expander, f'<a b="${{{ground.insert(code)}}}"/>').text is not None, code
        for code in WRITING:
            (ground.project / "victim").touch()
            assert ground.expand(expander, f'<a b="${{{ground.insert(code)}}}"/>').text is not None, code
            made = next(ground.project.parent.rglob(f"*{MADE}*"))
            made.rmdir() if made.is_dir() and not made.is_symlink() else made.unlink()


# The interpreter: expressions that look for a way to such code

SEEDS = [
    "''", "b''", "()", "[]", "1", "1.5", "1j", "True", "None", "...", "python.set()", "python.slice(1)", "range(3)",
    "str", "list", "dict", "python.tuple", "len", "sorted", "math.sin", "math.factorial", "xacro.load_yaml",
    "xacro.warning", "xacro.dotify", "(lambda: 0)", "(x for x in [1])", "map(len, [''])", "python.zip([1])", "python",
    "math", "xacro", "'a'.upper", "'a'.format", "[].append", "str.upper", "dict(a=1).items()", "value", "tree",
    "tree.list", "tree.day",
]  # fmt: skip
WAYS = [
    "__class__", "__dict__", "__init__", "__globals__", "__self__", "__func__", "__code__", "__closure__",
    "__reduce_ex__", "__getattribute__", "__subclasses__", "__mro__", "__module__", "__builtins__", "__wrapped__",
    "gi_frame", "f_back", "tb_frame", "mro", "func_globals",
]  # fmt: skip
FORBIDDEN = [
    "getattr", "setattr", "delattr", "hasattr", "type", "vars", "eval", "exec", "compile", "open", "globals", "locals",
    "dir", "object", "super", "classmethod", "staticmethod", "property", "memoryview", "input", "print", "breakpoint",
    "callable", "id", "iter", "next", "help", "exit", "__import__", "__build_class__",
]  # fmt: skip
FORMATS = [
    "'{0.__class__}'.format(1)",
    "'{0.real}'.format(1)",
    "'{0[0].__class__}'.format([1])",
    "'{:{0.__class__}}'.format(1)",
    "'{:{:{0.__class__}}}'.format(1, 2)",
    "'{a.__init__.__globals__}'.format(a=xacro.load_yaml)",
    "'{a.__class__}'.format_map(dict(a=1))",
    "'{a.__class__}'.format_map(xacro.dotify(dict(a=1)))",
    "str.format('{0.__class__}', 1)",
    "str.format_map('{a.__class__}', dict(a=1))",
    "list(map('{0.__class__}'.format, [1]))",
    "list(map(str.format, ['{0.__class__}'], [1]))",
    "sorted([1, 2], key='{0.__class__}'.format)",
    "max([1, 2], key=str.format)['{.__class__}']",
    "[1].sort(key='{.__class__}'.format) or [1].__class__",
    "(lambda f: f('{0.__class__}', 1))(str.format)",
    "'{0!r:{1.__class__}}'.format(1, 2)",
    "f'{(1).__class__}'",
    "f'{1:{().__class__}}'",
    "'%s' % ().__class__",
    "'%(a)s' % dict(a=().__class__)",
]
SYNTAX = [
    "(lambda: (yield 1))()",
    "(lambda: (yield from [1]))()",
    "(lambda x=().__class__: x)()",
    "(lambda *a, **k: a.__class__)()",
    "[x.__class__ for x in [1]]",
    "[0 for x.__class__ in [1]]",
    "[0 for x[0] in [1]]",
    "dict(a=().__class__)",
    "len(*[().__class__])",
    "len(**().__class__)",
    "[*().__class__]",
    "1 if ().__class__ else 2",
    "().__class__ and 1",
    "0 and ().__class__",
    "[1][().__class__]",
    "[1][().__class__:]",
    "-().__class__",
    "1 < ().__class__",
    "(a := ().__class__)",
    "().\uff3f\uff3fclass\uff3f\uff3f",
    "().__clas\uff53__",
    "__builtins__",
    "__loader__",
    "__name__",
    "(lambda: __builtins__)()",
    "list[int]",
    "str['a']",
    "dict(__builtins__=1)['__builtins__'].__class__",
    "(x for x in [1]).send",
    "(x for x in [1]).throw",
    "(x for x in [1]).close",
    "python.parent",
    "math.root",
    "xacro.unevaluated",
    "xacro.recursive",
    "xacro.top",
    "python['type'](1)",
    "python.get('vars')(1)",
    "list(python.values())[0].__class__",
    "[f for f in python.values() if 'type' in str(f)]",
    "map(python.type, [1]).__class__",
    "list(map(python.get('type'), [1]))",
    "python.update(len=1)",
    "math.clear()",
    "xacro.pop('arg')",
    "python.setdefault('a', 1)",
    "xacro.load_yaml('../secret.yaml').token",
    "xacro.load_yaml(b'../secret.yaml').token",
    "load_yaml('./x/../../secret.yaml').token",
    "xacro.load_yaml('/proc/self/environ')",
    "xacro.load_yaml(0)",
    "xacro.load_yaml('tags.yaml')",
    "xacro.load_yaml('units.yaml')",
]
ATTEMPTS = [
    *(f"{seed}.{way}" for seed in SEEDS for way in WAYS),
    *(
        form
        for name in FORBIDDEN
        for form in (f"{name}(1)", f"python.{name}(1)", f"xacro.{name}", f"math.{name}")
    ),
    *FORMATS,
    *SYNTAX,
    *DEEDS,
    *WITHOUT_RESULT,
]
PREPARED = (
    "<xacro:property name='value' value='1 2'/>"
    "<xacro:property name='tree' value=\"${xacro.load_yaml('t.yaml')}\"/>"
)


def attribute(ground: Ground, code: str) -> str:
    """An attribute of this code; what has braces in it is evaluated as a number with a unit in a YAML file."""
    if "}" not in code:
        return f'<a b="${{{ground.insert(code)}}}"/>'
    (ground.project / "code.yaml").write_text(f"a: !radians {json.dumps(code)}\n")
    return "<a b=\"${xacro.load_yaml('code.yaml').a}\"/>"


def prepare(ground: Ground) -> None:
    (ground.project / "t.yaml").write_text("list: [1, {a: 2}]\nday: 2001-12-14\na: 1\n")
    (ground.project / "tags.yaml").write_text('a: !!python/object/apply:os.system ["touch x"]\n')
    (ground.project / "units.yaml").write_text('a: !degrees "().__class__"\n')


@pytest.mark.parametrize("first", range(0, len(ATTEMPTS), 50))
def test_the_interpreter_refuses(interpreter_alone: Expander, ground: Ground, first: int) -> None:
    prepare(ground)
    passed = []
    for code in ATTEMPTS[first : first + 50]:
        number = f"[{code}] and 1" if "}" in code else code
        done = ground.expand(interpreter_alone, PREPARED + attribute(ground, number))
        ground.assert_nothing_escaped(done)
        if done.text is not None:
            passed.append(f"{code}: {done.text}")
    assert passed == []


def test_there_are_enough_attempts() -> None:
    for attempts in (ATTEMPTS, [*DEEDS, *WITHOUT_RESULT]):
        assert len(attempts) > 300
        assert len(set(attempts)) == len(attempts)


WAY_OUT = "().__class__"
PLACES = [
    '<a b="${CODE}"/>',
    '<a b="1 ${CODE} 2"/>',
    "<a>${CODE}</a>",
    '<xacro:property name="p" value="${CODE}"/><a b="${p}"/>',
    '<xacro:property name="p" value="${CODE}" lazy_eval="false"/>',
    '<xacro:property name="p" value="${CODE}" scope="global"/>',
    '<xacro:property name="p" default="${CODE}"/><a b="${p}"/>',
    '<xacro:property name="${CODE}" value="1"/>',
    '<xacro:property name="p" value="CODE"/><a b="${${p}}"/>',
    '<xacro:property name="p" value="__class__"/><a b="${().${p}}"/>',
    '<xacro:property name="p" value="${q}"/><xacro:property name="q" value="${CODE}"/><a b="${p}"/>',
    '<xacro:property name="p" value="1" remove="${CODE}"/>',
    '<xacro:macro name="m" params="p:=${CODE}"><a b="${p}"/></xacro:macro><xacro:m/>',
    '<xacro:macro name="m" params="p:=^|${CODE}"><a b="${p}"/></xacro:macro><xacro:m/>',
    '<xacro:macro name="m" params="p"><a b="${p}"/></xacro:macro><xacro:m p="${CODE}"/>',
    '<xacro:macro name="m" params="*p"><xacro:insert_block name="p"/></xacro:macro><xacro:m><a b="${CODE}"/></xacro:m>',
    '<xacro:call macro="${CODE}"/>',
    '<xacro:if value="${CODE}"/>',
    '<xacro:unless value="${CODE}"/>',
    '<xacro:include filename="${CODE}"/>',
    '<xacro:include filename="x.xacro" ns="${CODE}"/>',
    '<xacro:arg name="a" default="${CODE}"/>',
    '<xacro:element xacro:name="${CODE}"/>',
    '<a><xacro:attribute name="b" value="${CODE}"/></a>',
    "<!-- xacro:eval-comments --><!-- ${CODE} -->",
    '<a b="$(eval CODE ${end}"/>',
    "<a b=\"$(eval getattr${begin}1, 'real'${end}\"/>",
    "<a b=\"$(eval open${begin}'/etc/passwd'${end}\"/>",
    '<a b="$(eval [].append)"/><a b="$(eval (lambda: ${CODE}))"/>',
]


@pytest.mark.parametrize("body", PLACES)
def test_every_place_that_xacro_evaluates_is_interpreted(
    interpreter_alone: Expander, ground: Ground, body: str
) -> None:
    (ground.project / "x.xacro").write_text(f"{HEAD}</robot>")
    given = '<xacro:property name="begin" value="("/><xacro:property name="end" value=")"/>'
    code = WAY_OUT if "eval" not in body else "'x'.__class__"
    done = ground.expand(interpreter_alone, given + body.replace("CODE", code))
    assert done.text is None, done.text


@pytest.mark.parametrize(
    "poison",
    [
        "[f for f in [xacro.load_yaml('t.yaml')] if f.update(a=9)]",
        "xacro.load_yaml('t.yaml').list.append(9)",
        "(len := 9)",
        "(python := 9)",
        "list(map([].append, [9]))",
    ],
)
def test_nothing_is_left_for_the_next_file(interpreter_alone: Expander, ground: Ground, poison: str) -> None:
    prepare(ground)
    ground.expand(interpreter_alone, f'{PREPARED}<a b="${{{poison}}}"/>')
    done = ground.expand(
        interpreter_alone, f"{PREPARED}<a b=\"${{tree.a}} ${{len('ab')}} ${{python.len(tree.list)}}\"/>"
    )
    assert done.text is not None
    assert 'b="1 2 2"' in done.text


@pytest.mark.parametrize(
    "poison",
    [
        "(lambda f: f.__globals__)(xacro.load_yaml).update(process_file=None, safe_eval=None)",
        f"{BUILTINS}.update(open=None, len=None)",
        f"{BUILTINS}['setattr']({BUILTINS}['__import__']('json'), 'dumps', None)",
        f"{BUILTINS}['setattr']({OS}, 'write', print)",
        f"{BUILTINS}['__import__']('sys').modules.clear()",
        f"{CTYPES}.memset({BUILTINS}['id'](None), 255, 8)",
        f"{OS}._exit(0)",
        f"{OS}.closerange(0, 99)",
        f"{BUILTINS}['__import__']('gc').get_objects().clear()",
    ],
)
def test_code_that_runs_freely_leaves_nothing_for_the_next_file(
    walls_alone: Expander, ground: Ground, poison: str
) -> None:
    needs_walls(walls_alone)
    ground.expand(walls_alone, f'<a b="${{{ground.insert(poison)}}}"/>')
    done = ground.expand(walls_alone, "<a b=\"${len('ab')}\"/>")
    assert done.text is not None, done.problems
    assert '<a b="2"/>' in done.text


@pytest.mark.skipif(sys.platform == "win32", reason="no fork")
def test_no_method_or_function_leads_out_of_the_values() -> None:
    """Every method of every type and every function, on values of all types: what they give has these types, too.

    Then chains of them, each on what others before gave.
    """
    import multiprocessing

    context = multiprocessing.get_context("fork")
    receiving, sending = context.Pipe(duplex=False)
    process = context.Process(target=_reach, args=(sending,))
    process.start()
    sending.close()
    found, calls = receiving.recv()
    process.join()
    assert found == []
    assert calls > 60_000


def _known(xacro: Any) -> set[type]:
    """The types that values may have."""
    return {
        *interpreter._METHODS, xacro.YamlDictWrapper, xacro.YamlListWrapper, xacro.NameSpace, type(None), type(...),
        type, type(len), type("".upper), type(prepare), interpreter.Refusal,
        map, filter, zip, enumerate, type(iter(())),
        *map(type, ({}.items(), {}.keys(), {}.values(), reversed([]), reversed({}), reversed({}.items()),
                    reversed({}.values()),
                    reversed(range(1)), reversed(()), (x for x in ""), iter([]), iter(""), iter(range(1)))),
    }  # fmt: skip


class Reach:
    """Calls functions and methods of values as the interpreter does, and looks at what they give, inside too."""

    def __init__(self, xacro: Any, one: interpreter.Interpreter) -> None:
        self.known = _known(xacro)
        self.one = one
        self.methods = {
            kind: [name for name in sorted(names) if callable(getattr(kind, name, None))]
            for kind, names in one._methods.items()
            if kind is not xacro.NameSpace
        }
        self.given: list[Any] = []
        self.wrong: list[str] = []
        self.calls = 0

    def method(self, value: Any, name: str, *arguments: Any) -> object:
        return self.one._attribute(self.fresh(value), name)(*arguments)

    @staticmethod
    def fresh(value: Any) -> Any:
        return type(value)(value) if isinstance(value, list | set) or type(value) is dict else value

    def attempt(self, what: str, call: Callable[..., object], *arguments: object) -> None:
        self.calls += 1
        try:
            result: Any = call(*map(self.fresh, arguments))
        except Exception:
            return
        if self.is_foreign(result):
            self.wrong.append(f"{what}: {type(result)}")
        elif not hasattr(result, "__len__") or len(result) < 50:
            self.given.append(result)

    def is_foreign(self, value: object, depth: int = 3) -> bool:
        inside: Any = ()
        if isinstance(value, dict):
            inside = (*dict.keys(value), *dict.values(value))
        elif isinstance(value, list | tuple | set | frozenset):
            inside = value
        is_inside = depth > 0 and any(self.is_foreign(each, depth - 1) for each in inside)
        return type(value) not in self.known or is_inside


def _reach(sending: object) -> None:
    import xacro
    from xacro import substitution_args

    reach = Reach(xacro, interpreter.Interpreter(xacro, substitution_args))
    spaces = [table for table in dict.values(xacro._global_symbols) if isinstance(table, xacro.NameSpace)]
    silent = {"message", "warning", "error", "print_location", "load_yaml"}
    functions = {name: value for table in spaces for name, value in dict.items(table) if name not in silent}
    callables = [(name, value) for name, value in sorted(functions.items()) if callable(value)]
    values: list[object] = [
        "a b", "", b"a", 3, -1, 0.5, 1j, True, None, [1, "a"], (1, "b"), {"a": 1}, {1}, frozenset({2}), range(3),
        slice(1), ..., xacro.YamlDictWrapper(a=[1]), xacro.YamlListWrapper([{"a": 1}]), str, dict, len, spaces[0],
        lambda *_: 0,
    ]  # fmt: skip
    methods = [
        (f"{type(value)}.{name}", partial(reach.method, value, name))
        for value in values
        for name in reach.methods.get(type(value), ())
    ]
    for what, call in (*callables, *methods):
        for arguments in ((), *((value,) for value in values), *((a, b) for a in values for b in values[:8])):
            reach.attempt(what, call, *arguments)
    chance = Random(1)
    for _ in range(40_000):
        value, *others = chance.choices(reach.given, k=chance.randint(1, 4))
        names = reach.methods.get(type(value), ())
        if names and chance.random() < 0.7:
            name = chance.choice(names)
            reach.attempt(f"a chain to {type(value)}.{name}", partial(reach.method, value, name), *others)
        else:
            reach.attempt(*chance.choice(callables), value, *others)
    sending.send((reach.wrong[:20], reach.calls))  # type: ignore[attr-defined]


# Expressions that work

WORKS = {
    "1 + 2 * 3 ** 2 // 4 % 5 - -1": "6",
    "1 < 2 <= 2 != 3 and not 0 or 5": "True",
    "'a' if 1 in [1] else 'b'": "a",
    "[x * y for x in range(3) for y in (1, 2) if x]": "[1, 2, 2, 4]",
    "sorted(python.set([3, 1]), key=lambda x: -x)": "[3, 1]",
    "[a + b for a, (b, *c) in [(1, (2, 3))]]": "[3]",
    "python.sum(x for x in [1, 2])": "3",
    "' '.join(map(str, [1, 2]))": "1 2",
    "list(map(str.upper, ['a']))": "['A']",
    "'%s-%.2f' % ('a', 1)": "a-1.00",
    "int('{0:0>4}{a[0]}{0:0>{w}}'.format(1, a=[2], w=3))": "12001.0",
    "int(f'{1}{2:0>3}') if f'{3!r:>2}' == ' 3' else 0": "1002.0",
    "len('%(a)5s' % {**{'a': 1}, 'b': {2}})": "5.0",
    "'abc'[::-1] + 'abc'[1:]": "cbabc",
    "(lambda a, b=2, *c, d=4, **e: [a, b, c, d, e])(1, d=3, f=5)": "[1, 2, (), 3, {'f': 5}]",
    "(lambda f: f(f, 5))(lambda f, n: 1 if n < 2 else n * f(f, n - 1))": "120",
    "dict(a=1).get('b', 2)": "2",
    "tree.list[1].a + tree['a']": "3",
    "[k for k in tree]": "['list', 'day', 'a']",
    "tree.day.year": "2001",
    "len(xacro.tokenize('a;b'))": "2",
    "round(math.cos(pi), 2)": "-1.0",
    "python.isinstance('', str)": "True",
    "math.factorial(5) + math.comb(5, 2) + math.perm(4)": "154",
    "'serial 20230101123 %s' % 1": "serial 20230101123 1",
    " + ".join(["1"] * 2000): "2000",
}


@pytest.mark.parametrize("code", WORKS)
def test_expressions_that_work(ground: Ground, code: str) -> None:
    prepare(ground)
    with Expander() as expander:
        done = ground.expand(expander, PREPARED + attribute(ground, code))
    assert done.text is not None, done.problems
    assert f'b="{WORKS[code].replace(">", "&gt;")}"' in done.text


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("9 ** 9 ** 9", "digits"),
        ("1 <<" + " 10 ** 9", "digits"),
        ("math.factorial(10 ** 9)", "digits"),
        ("math.comb(10 ** 9, 10 ** 8)", "digits"),
        ("math.perm(10 ** 6)", "digits"),
        ("'a' * 10 ** 9", "parts"),
        ("10 ** 9 * [1]", "parts"),
        ("'a'.ljust(10 ** 9)", "parts"),
        ("'{:999999999}'.format(1)", "parts"),
        ("'{:{}}'.format(1, 10 ** 9)", "parts"),
        ("'%999999999d' % 1", "parts"),
        ("'%*d' % (10 ** 9, 1)", "parts"),
        ("f'{1:999999999}'", "parts"),
        ("len([1 for a in range(10 ** 4) for b in range(10 ** 4)])", "no end"),
    ],
)
def test_work_and_size_are_counted(ground: Ground, code: str, words: str) -> None:
    with Expander() as expander:
        done = ground.expand(expander, attribute(ground, code))
    assert done.text is None
    assert words in f"{done.problems}"


# The child on its own feet


def test_backports_of_the_standard_library_are_not_imported(
    tmp_path: Path, ground: Ground, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("pathlib", "typing", "enum", "re"):
        (tmp_path / f"{name}.py").write_text("raise ImportError('of another Python')")
    folders = worker._folders()
    monkeypatch.setattr(worker, "_folders", lambda: [str(tmp_path), *folders])
    with Expander() as expander:
        assert ground.expand(expander, "<a/>").text is not None


def test_an_application_that_embeds_python_finds_a_program(
    ground: Ground, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr(sys, "executable", "")
    with Expander() as expander:
        assert ground.expand(expander, "<a/>").text is not None
    for prefix in ("exec_prefix", "base_exec_prefix"):
        monkeypatch.setattr(sys, prefix, str(tmp_path))
    with pytest.raises(WrongUsage, match=r"set `sys\.executable`"):
        python_program()


def old_xacro(folder: Path, version: str) -> Path:
    (folder / "xacro").mkdir(parents=True)
    (folder / "xacro" / "__init__.py").write_text("raise ImportError('too old')")
    (folder / f"xacro-{version}.dist-info").mkdir()
    return folder


def test_an_older_xacro_that_comes_first_is_passed_over(
    tmp_path: Path, ground: Ground, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.syspath_prepend(old_xacro(tmp_path / "ros", "2.0.10"))
    with Expander() as expander:
        assert ground.expand(expander, "<a/>").text is not None


@pytest.mark.parametrize(
    ("version", "is_taken"), [("2.0.10", False), ("2.1", True), ("2.9.1", True), ("3.0", False)]
)
def test_which_versions_of_xacro_are_taken(
    tmp_path: Path, version: str, is_taken: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = old_xacro(tmp_path / "only", version)
    monkeypatch.setattr(sys, "path", [str(folder)])
    if is_taken:
        assert worker.xacro_folder() == [str(folder)]
    else:
        with pytest.raises(WrongUsage, match=f"found is {version}"):
            worker.xacro_folder()


@pytest.mark.parametrize(
    "start", ["raise ImportError('no such thing')", f"{IMPORTED}del child.xacro.NameSpace; child.main()"]
)
def test_a_failure_of_the_process_is_no_finding(
    ground: Ground, monkeypatch: pytest.MonkeyPatch, start: str
) -> None:
    monkeypatch.setattr(worker, "_START", start)
    with (
        Expander() as expander,
        pytest.raises(WrongUsage, match=r"the process for it failed: .*Error: "),
    ):
        ground.expand(expander, "<a/>")


def test_the_process_is_started_again_after_it_was_killed(ground: Ground) -> None:
    with Expander() as expander:
        expander.start()
        process = expander._worker.start()
        process.kill()
        with pytest.raises(WrongUsage):
            ground.expand(expander, "<a/>")
        assert ground.expand(expander, "<a/>").text is not None


def test_names_of_files_in_another_encoding(tmp_path: Path) -> None:
    """A folder with ö, in a locale whose encoding is Latin-1; the text of the files is UTF-8 there, too."""
    name = "f\xf6lder".encode("latin-1")
    folder = os.path.join(os.fsencode(tmp_path), name)
    try:
        os.mkdir(folder)
    except OSError:
        pytest.skip("the file system does not take such a name")
    (tmp_path / ".git").mkdir()
    for file, body in (("r.xacro", '<xacro:include filename="i.xacro"/>'), ("i.xacro", '<a b="\xe4 ${1}"/>')):
        with open(os.path.join(folder, file.encode()), "w", encoding="utf-8") as stream:
            stream.write(f"{HEAD}{body}</robot>")
    probe = (
        "import os, sys; from pathlib import Path; from sdfcheck.xacro.expansion import expand\n"
        "assert os.fsdecode(b'\\xf6') == '\\xf6', sys.getfilesystemencoding()\n"
        "done = expand(next(Path(sys.argv[1]).glob('f*')) / 'r.xacro')\n"
        "assert '<a b=\"\\xe4 1\"/>' in (done.text or ''), done.problems\n"
    )
    command = ["localedef", "-i", "de_DE", "-f", "ISO-8859-1", str(tmp_path / "de_DE.iso88591")]
    if (
        shutil.which("localedef") is None
        or subprocess.run(command, capture_output=True, check=False).returncode
    ):
        pytest.skip("a locale with Latin-1 cannot be made")
    environment = {**os.environ, "LC_ALL": "de_DE.iso88591", "LOCPATH": str(tmp_path), "PYTHONUTF8": "0"}
    done = subprocess.run(
        [sys.executable, "-c", probe, str(tmp_path)],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize(
    "file", ["/proc/version", "/proc/self/environ", "/dev/zero", "/sys/kernel/mm/ksm/run"]
)
def test_links_to_what_the_kernel_makes_up_are_not_followed(
    ground: Ground, tmp_path: Path, file: str
) -> None:
    package = tmp_path / "arm"
    package.mkdir()
    (package / "package.xml").write_text("<package><name>arm</name></package>")
    (package / "a.yaml").symlink_to(file)
    with Expander(Surroundings(packages={"arm": package})) as expander:
        done = ground.expand(expander, "<c d=\"${xacro.load_yaml('$(find arm)/a.yaml')}\"/>")
    assert done.text is None
    assert "lies outside of the project" in f"{done.problems}"


def test_links_out_of_a_folder_that_was_pointed_out(ground: Ground, tmp_path: Path) -> None:
    """As ``colcon build --symlink-install`` makes them; the system opens what the guard lets through."""
    package = tmp_path / "underlay" / "arm"
    package.mkdir(parents=True)
    (package / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "elsewhere.xacro").write_text(f"{HEAD}<b/></robot>")
    (package / "b.xacro").symlink_to(tmp_path / "elsewhere.xacro")
    (package / "c.yaml").symlink_to(tmp_path / "c.yaml")
    (tmp_path / "c.yaml").write_text("a: 7")
    body = (
        '<xacro:include filename="$(find arm)/b.xacro"/><c d="${xacro.load_yaml(\'$(find arm)/c.yaml\').a}"/>'
    )
    with Expander(Surroundings(packages={"arm": package})) as expander:
        done = ground.expand(expander, body)
    assert done.text is not None, done.problems
    assert "<b/>" in done.text
    assert '<c d="7"/>' in done.text
