"""The process that expands: started once, it forks for every file, and the fork is locked up.

It reads requests from stdin and answers on stdout: eight bytes of length, then JSON.
"""

from __future__ import annotations

import gc
import json
import mmap
import os
import select
import signal
import sys
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any, BinaryIO
from xml.dom import minidom

import xacro
import yaml  # noqa: F401 - xacro loads it late, and then nothing may be loaded any more
from xacro import substitution_args

from sdfcheck.files.packages import Packages
from sdfcheck.xacro.language import ArgumentParser
from sdfcheck.xacro.process import failure, walls
from sdfcheck.xacro.process import walls as sandbox
from sdfcheck.xacro.process.interpreter import Interpreter, TooMuch
from sdfcheck.xacro.process.placeholders import MARK, Cautious, Perseverance
from sdfcheck.xacro.process.trace import KEY, Children, Crumbs, Step, Tracer

RECURSION_LIMIT = 3000
"""Above Python's own, since following xacro and evaluating its expressions take frames too."""

CRUMBS = 65536

Request = dict[str, Any]
Answer = dict[str, Any]


def main() -> None:
    requests = os.fdopen(os.dup(0), "rb")
    answers = os.fdopen(os.dup(1), "wb")
    void = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1):
        os.dup2(void, stream)
    gc.disable()
    known: dict[str, Packages] = {}
    while (request := receive(requests)) is not None:
        send(answers, _serve(json.loads(request), known))
        if not hasattr(os, "fork"):
            return


def receive(stream: BinaryIO) -> bytes | None:
    head = stream.read(8)
    if len(head) < 8:
        return None
    return stream.read(int.from_bytes(head, "big"))


def send(stream: BinaryIO, data: bytes) -> None:
    stream.write(len(data).to_bytes(8, "big"))
    stream.write(data)
    stream.flush()


def _packages(request: Request, known: dict[str, Packages]) -> Packages:
    """The folders of packages; looked up before the fork if they will be needed, so that it is done once."""
    key = json.dumps([request[name] for name in ("root", "packages", "paths", "environment", "flat")])
    if key not in known:
        named = {name: Path(folder) for name, folder in request["packages"].items()}
        paths = [Path(folder) for folder in request["paths"]]
        known[key] = Packages(
            Path(request["root"]), named, paths, request["environment"], is_flat=request["flat"]
        )
    if "$(find" in request["text"]:
        known[key].survey()
    return known[key]


def _serve(request: Request, known: dict[str, Packages]) -> bytes:
    packages = _packages(request, known)
    readable = sandbox.Readable(
        [*map(str, packages.places)], [*map(str, packages.trusted())], [*map(str, packages.installed())]
    )
    if sys.platform == "win32" or not hasattr(os, "fork"):
        return _answer(request, packages, readable, mmap.mmap(-1, CRUMBS))
    deadline = time.monotonic() + request["limits"]["wall"]
    while True:
        answer = _forked(request, packages, readable, deadline)
        path = _closed(answer)
        if not path or path in readable.linked or not readable(path):
            return answer
        readable.linked.append(path)


def _closed(answer: bytes) -> str:
    """The file that the fork may read and could not open; empty for any other answer: code in a file may write it."""
    if not answer.startswith(b'{"closed"'):
        return ""
    try:
        path = json.loads(answer)["closed"]
        os.fsencode(path)
    except (ValueError, TypeError, RecursionError):
        return ""
    return "" if "\0" in path else str(path)


def _forked(request: Request, packages: Packages, readable: sandbox.Readable, deadline: float) -> bytes:
    """The answer of a fork that expands the file, or the limit that it reached."""
    if sys.platform == "win32":
        raise NotImplementedError
    memory = mmap.mmap(-1, CRUMBS)
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            # Of what the process has open, the fork keeps its own pipe only.
            os.dup2(0, 2)
            os.closerange(3, writing)
            os.closerange(writing + 1, writing + 64)
            answer = _answer(request, packages, readable, memory)
            while answer:
                answer = answer[os.write(writing, answer) :]
        finally:
            os._exit(0)
    os.close(writing)
    answer, reason = _collect(reading, request["limits"], deadline)
    os.close(reading)
    if reason:
        os.kill(child, signal.SIGKILL)
    _, status = os.waitpid(child, 0)
    if not reason and (status or not answer):
        reason = "the expansion came to an unexpected end"
        if os.WIFSIGNALED(status) and os.WTERMSIG(status) in {signal.SIGKILL, signal.SIGXCPU}:
            reason = f"no end after {request['limits']['cpu']} s of computing"
    if not reason:
        return answer
    files, place = Crumbs.read(memory)
    report = {
        "kind": "limit",
        "message": reason,
        "place": place,
        "step": -1,
        "attribute": "",
        "expression": "",
    }
    return json.dumps({"files": files, "steps": [], "failure": report}).encode()


def _answer(request: Request, packages: Packages, readable: sandbox.Readable, memory: Any) -> bytes:
    """The expansion; a bug or an xacro that is not as expected is ``broken``, which says nothing of the file."""
    sys.stderr = open(os.devnull, "w")  # noqa: SIM115 - where xacro's warnings go
    try:
        answer = expand(request, packages, readable, memory)
    except BaseException:
        import traceback

        answer = {"broken": traceback.format_exc()}
    return json.dumps(answer).encode()


def _collect(stream: int, limits: dict[str, int], deadline: float) -> tuple[bytes, str]:
    """All that the fork writes, or why it must be stopped."""
    pieces: list[bytes] = []
    size = 0
    while True:
        left = deadline - time.monotonic()
        if left <= 0 or not select.select([stream], [], [], left)[0]:
            return b"", f"no end after {limits['wall']} s"
        piece = os.read(stream, 1 << 20)
        if not piece:
            return b"".join(pieces), ""
        pieces.append(piece)
        size += len(piece)
        if size > limits["output"]:
            return b"", f"the result is longer than {limits['output']} bytes"


def expand(request: Request, packages: Packages, readable: sandbox.Readable, memory: Any) -> Answer:
    """Expand one file, locked up; without a file say which walls stand."""
    path = request["path"]
    tracer = Tracer(xacro, {**request["texts"], path: request["text"]}, Crumbs(memory))
    os.chdir(request["cwd"])
    os.environ.clear()
    os.environ.update(request["environment"])
    is_partial = request["partial"]
    tracer.unprefixed = frozenset(map(tuple, request["unprefixed"]))
    _prepare(tracer, packages, Cautious if is_partial else Interpreter, path)
    rest = Perseverance(xacro, tracer) if is_partial else None
    xacro.open = door = sandbox.Door(readable)
    sys.setrecursionlimit(RECURSION_LIMIT)
    sandbox.limit(request["limits"])
    standing = walls.lock(readable, (*readable.roots, *readable.linked))
    if not path:
        return {"walls": standing}
    answer: Answer = {}
    steps = Steps()
    try:
        arguments = dict(request["arguments"])
        document = xacro.process_file(path, mappings=arguments, verbosity=0)
        places = steps.places(document.documentElement)
        text = document.toprettyxml(indent="  ")
        if len(text) > request["limits"]["output"]:
            raise TooMuch(f"the result is longer than {request['limits']['output']} bytes")
        answer = {"text": text, "places": places, "arguments": sorted(arguments)}
        if rest is not None:
            answer["text"] = text.replace(MARK, "$")
            answer["failures"] = [{**each, "step": steps.number(each.get("step"))} for each in rest.reports]
    except BaseException as error:
        report = failure.describe(error, tracer)
        report["step"] = steps.number(report.get("step"))
        answer = {"failure": report}
    if door.closed and door.closed not in readable.linked:
        return {"closed": door.closed}
    others = [str(name) for name in xacro.all_includes if name not in tracer.files]
    return {**answer, "files": tracer.files, "steps": steps.rows, "others": sorted(set(others))}


def _prepare(tracer: Tracer, packages: Packages, evaluator: type[Interpreter], path: str) -> None:
    """Put the evaluators, the search for packages and the notes in xacro's place for them, for one file."""
    absolute = xacro.abs_filename_spec

    def find(name: str) -> str:
        folder = packages.find(name, path)
        if folder is None:
            raise failure.MissingPackage(name)
        return str(folder)

    def variable(name: str) -> str:
        if name not in os.environ:
            raise failure.MissingVariable(name)
        return os.environ[name]

    def locate(spec: str) -> str:
        whole = str(absolute(spec))
        return whole if os.path.exists(whole) else str(packages.locate(Path(whole)))

    vars(minidom)["NodeList"] = Children
    _with_names(xacro.Macro)
    evaluator(xacro, substitution_args)
    xacro.parse_macro_arg = ArgumentParser()
    xacro.abs_filename_spec = locate
    substitution_args._eval_find = find
    substitution_args._eval_dict["find"] = find
    substitution_args._eval_env = variable
    substitution_args._eval_dict["env"] = variable
    tracer.install()


class Names:
    """The parameters of a macro, in place of xacro's list: each is found without going through the others."""

    __slots__ = ("_counts",)

    def __init__(self, names: Iterable[str]) -> None:
        self._counts = Counter(names)

    def append(self, name: str) -> None:
        self._counts[name] += 1

    def remove(self, name: str) -> None:
        self._counts[name] -= 1
        if not self._counts[name]:
            del self._counts[name]

    def __contains__(self, name: str) -> bool:
        return name in self._counts

    def __iter__(self) -> Iterator[str]:
        return self._counts.elements()

    def __len__(self) -> int:
        return len(self._counts)

    def __getitem__(self, every: slice) -> Names:
        return Names(self._counts.elements())


def _with_names(macro: type) -> None:
    """Let macros keep their parameters as Names, whatever list they are given."""
    name = "_parameters"
    macro.params = property(  # type: ignore[attr-defined]
        lambda self: vars(self)[name], lambda self, given: vars(self).update({name: Names(given)})
    )


class Steps:
    """Numbers the steps, so that they can be sent."""

    def __init__(self) -> None:
        self.rows: list[tuple[str, str, int, int, int, int]] = []
        self._numbers: dict[int, int] = {}

    def number(self, step: Step | None) -> int:
        """The row of a step, -1 for none; the steps around it are numbered first."""
        chain = []
        while step is not None and id(step) not in self._numbers:
            chain.append(step)
            step = step.outer
        number = -1 if step is None else self._numbers[id(step)]
        for inner in reversed(chain):
            self.rows.append((inner.kind, inner.name, *inner.place, number))
            number = self._numbers[id(inner)] = len(self.rows) - 1
        return number

    def places(self, root: Any) -> list[int]:
        """File, line, column and step of every element, in document order, in one row."""
        numbers: list[int] = []
        latest = (0, 1, 1, -1)
        todo = [root]
        while todo:
            node = todo.pop()
            data = node.getUserData(KEY)
            if data is not None:
                latest = (*data.place, self.number(data.step))
            numbers += latest
            todo += [child for child in reversed(node.childNodes) if child.nodeType == 1]
        return numbers
