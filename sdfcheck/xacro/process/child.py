"""The process that expands: started once, it forks for every file, and the fork is locked up.

It reads requests from stdin and answers on stdout: eight bytes of length, then JSON.
"""

from __future__ import annotations

import gc
import json
import mmap
import os
import re
import select
import signal
import sys
import time
from pathlib import Path
from typing import Any, BinaryIO

import xacro
import yaml  # noqa: F401 - xacro loads it late, and then nothing may be loaded any more
from xacro import substitution_args

from sdfcheck.files.packages import Packages
from sdfcheck.xacro.parameters import ArgumentParser
from sdfcheck.xacro.process import failure, sandbox
from sdfcheck.xacro.process.trace import KEY, Crumbs, Step, Tracer

RECURSION_LIMIT = 1500
"""Above Python's own, since following xacro takes frames too."""

CRUMBS = 65536

_FOUND = re.compile(r"\$\(find\s+([^\s$)]+)\s*\)")

Request = dict[str, Any]
Answer = dict[str, Any]


def main() -> None:
    requests = os.fdopen(os.dup(0), "rb")
    answers = os.fdopen(os.dup(1), "wb")
    void = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(void, stream)
    sandbox.isolate_network()
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
    key = json.dumps([request[name] for name in ("root", "packages", "paths", "environment")])
    if key not in known:
        named = {name: Path(folder) for name, folder in request["packages"].items()}
        paths = [Path(folder) for folder in request["paths"]]
        known[key] = Packages(Path(request["root"]), named, paths, request["environment"])
    if "$(find" in request["text"]:
        known[key].survey()
    return known[key]


def _serve(request: Request, known: dict[str, Packages]) -> bytes:
    packages = _packages(request, known)
    memory = mmap.mmap(-1, CRUMBS)
    if sys.platform == "win32" or not hasattr(os, "fork"):
        return json.dumps(expand(request, packages, memory)).encode()
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        try:
            answer = json.dumps(expand(request, packages, memory)).encode()
            while answer:
                answer = answer[os.write(writing, answer) :]
        finally:
            os._exit(0)
    os.close(writing)
    answer, reason = _collect(reading, request["limits"])
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


def _collect(stream: int, limits: dict[str, int]) -> tuple[bytes, str]:
    """All that the fork writes, or why it must be stopped."""
    deadline = time.monotonic() + limits["wall"]
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


def expand(request: Request, packages: Packages, memory: Any) -> Answer:
    """Expand one file, locked up."""
    path = request["path"]
    tracer = Tracer(xacro, {**request["texts"], path: request["text"]}, Crumbs(memory))
    os.chdir(request["cwd"])
    os.environ.clear()
    os.environ.update(request["environment"])
    _prepare(tracer, packages, is_partial=request["partial"])
    sys.setrecursionlimit(RECURSION_LIMIT)
    readable = sandbox.Readable(
        request["root"], [*map(str, packages.trusted())], [*map(str, packages.installed())]
    )
    sandbox.limit(request["limits"])
    sandbox.guard(readable)
    answer: Answer = {}
    steps = Steps()
    try:
        arguments = dict(request["arguments"])
        document = xacro.process_file(path, mappings=arguments, verbosity=0)
        places = steps.places(document.documentElement)
        text = document.toprettyxml(indent="  ")
        if len(text) > request["limits"]["output"]:
            raise sandbox.TooMuch(f"the result is longer than {request['limits']['output']} bytes")
        answer = {"text": text, "places": places, "arguments": sorted(arguments)}
    except BaseException as error:
        report = failure.describe(error, tracer)
        report["step"] = steps.number(report.get("step"))
        answer = {"failure": report}
    others = [str(name) for name in xacro.all_includes if name not in tracer.files]
    return {**answer, "files": tracer.files, "steps": steps.rows, "others": sorted(set(others))}


def _prepare(tracer: Tracer, packages: Packages, *, is_partial: bool) -> None:
    """Put the evaluators, the search for packages and the notes in xacro's place for them.

    A reference to a package that is not found is kept if the expansion may be partial.
    """
    absolute = xacro.abs_filename_spec

    def find(name: str) -> str:
        folder = packages.find(name)
        if folder is None and is_partial:
            return f"$(find {name})"
        if folder is None:
            raise failure.MissingPackage(name)
        return str(folder)

    def is_left_out(filename: str) -> bool:
        return any(packages.find(name) is None for name in _FOUND.findall(filename))

    if is_partial:
        tracer.is_left_out = is_left_out

    def variable(name: str) -> str:
        if name not in os.environ:
            raise failure.MissingVariable(name)
        return os.environ[name]

    def locate(spec: str) -> str:
        path = str(absolute(spec))
        return path if os.path.exists(path) else str(packages.locate(Path(path)))

    xacro.safe_eval = sandbox.evaluate
    xacro.parse_macro_arg = ArgumentParser()
    xacro.abs_filename_spec = locate
    substitution_args.eval = sandbox.evaluate_substitution
    substitution_args._eval_find = find
    substitution_args._eval_dict["find"] = find
    substitution_args._eval_env = variable
    substitution_args._eval_dict["env"] = variable
    tracer.install()


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
