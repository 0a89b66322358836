"""The process that expands may be taken over: of what it answers nothing is believed that it could not have read."""

from __future__ import annotations

import copy
import os
from collections.abc import Callable, Mapping
from pathlib import Path
from random import Random
from typing import Any

import pytest

from sdfcheck.cli.main import main
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import Expander, Expansion
from sdfcheck.xacro.process import worker
from sdfcheck.xacro.process.watch import Limits
from sdfcheck.xacro.process.worker import Worker
from tests.posix import make_pipe

SECRET = "<secret>not-for-the-authors-of-robots</secret>"
TEXT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:include filename="part.xacro"/>
<xacro:m a="x"/>
<xacro:m a="x"/>
</robot>
"""
PART = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:macro name="m" params="a"><link name="${a}"/></xacro:macro>
</robot>
"""
Answer = dict[str, Any]


@pytest.fixture
def robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A robot in a project with links that lead out of it; a secret lies beside the project, and in the environment."""
    project = tmp_path / "project"
    (project / ".git").mkdir(parents=True)
    (project / "part.xacro").write_text(PART)
    (project / "r.urdf.xacro").write_text(TEXT)
    (tmp_path / "secret.xacro").write_text(SECRET)
    (project / "link.xacro").symlink_to("../secret.xacro")
    (project / "environ.xacro").symlink_to("/proc/self/environ")
    (project / "device.xacro").symlink_to("/dev/zero")
    make_pipe(project / "pipe.xacro")
    monkeypatch.setenv("PLANTED", SECRET)
    monkeypatch.chdir(project)
    return project / "r.urdf.xacro"


def expand(robot: Path) -> Expansion:
    with Expander() as expander:
        return expander.expand(read(robot.read_bytes(), robot, Kind.XACRO))


def taken_over(monkeypatch: pytest.MonkeyPatch, change: Callable[[Answer], Answer]) -> None:
    """Let the process answer something else."""
    ask = Worker.ask

    def lie(worker: Worker, request: dict[str, Any], limits: Limits) -> Mapping[str, Any]:
        return change(copy.deepcopy(ask(worker, request, limits)))

    monkeypatch.setattr(Worker, "ask", lie)


def named(path: str) -> dict[str, Callable[[Answer], Answer]]:
    """Answers in which a path is an included file: where the elements are, where the expansion fails, or only so."""

    def placed(answer: Answer) -> Answer:
        places = [1 if number % 4 == 0 else value for number, value in enumerate(answer["places"])]
        return {**answer, "files": [answer["files"][0], path], "places": places, "others": [path]}

    def failed(answer: Answer) -> Answer:
        failure = {
            "kind": "expression",
            "message": "name 'x' is not defined",
            "place": [1, 1, 1],
            "step": -1,
            "attribute": "",
            "expression": "not-for-the-authors-of-robots",
        }
        return {"files": [answer["files"][0], path], "steps": [], "failure": failure, "others": []}

    def beside(answer: Answer) -> Answer:
        return {**answer, "others": [path]}

    return {"placed": placed, "failed": failed, "beside": beside}


PATHS = (
    "../secret.xacro",
    "link.xacro",
    "environ.xacro",
    "device.xacro",
    "pipe.xacro",
    "/proc/self/environ",
    "/proc/self/root/etc/hostname",
    "/etc/hostname",
    "/dev/stdin",
    ".",
    "x" * 5000,
    "\ud83d",
    "a\0b",
    "",
)


@pytest.mark.parametrize("how", ["placed", "failed", "beside"])
@pytest.mark.parametrize("path", PATHS, ids=ascii)
def test_a_file_from_outside_is_neither_read_nor_shown(
    path: str, how: str, robot: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    before = {file: file.read_bytes() for file in robot.parent.parent.rglob("*.xacro") if file.is_file()}
    wanted = os.path.join(robot.parent, path)
    taken_over(monkeypatch, named(wanted)[how])
    pieces: list[bytes] = []
    reading = os.read

    def note(handle: int, size: int) -> bytes:
        pieces.append(reading(handle, size))
        return pieces[-1]

    monkeypatch.setattr(os, "read", note)
    done = expand(robot)
    monkeypatch.undo()
    assert not any(b"not-for-the-authors" in piece for piece in pieces)
    assert sum(map(len, pieces)) < 10_000
    if done.document is not None:
        texts = [source.text for source in done.document.provenance.files]
        assert all(text in (TEXT, PART, "") for text in texts)
    monkeypatch.chdir(robot.parent)
    monkeypatch.setenv("PLANTED", SECRET)
    taken_over(monkeypatch, named(wanted)[how])
    for options in (["--output-format", "json"], ["--fix"]):
        assert main(["lint", "--isolated", "--no-fold", *options, str(robot)]) in {0, 1}
    shown = capsys.readouterr()
    assert "not-for-the-authors" not in (shown.out + shown.err).replace("`not-for-the-authors-of-robots`", "")
    assert {file: file.read_bytes() for file in before} == before


ANSWERING = (
    "import sys; sys.path += sys.argv[1:]; import sdfcheck.xacro.process.child as child; "
    "raw = open({!r}, 'rb').read(); child._answer = lambda *_: raw; child.main()"
)
RAW = {
    "no JSON": b"garbage",
    "no text": b"\xff\xfe{}",
    "a list": b"[1]",
    "nothing": b"null",
    "deep lists": b"[" * 200_000,
    "deep objects": b'{"files":' * 100_000,
    "a long number": b'{"files": ' + b"9" * 10_000 + b"}",
    "no file": b'{"files": []}',
    "closed: a number": b'{"closed": 5}',
    "closed: deep lists": b'{"closed": ' + b"[" * 200_000,
    "closed: NUL": b'{"closed": "a\\u0000b"}',
    "closed: half a character": b'{"closed": "\\ud800"}',
    "closed: outside": b'{"closed": "/etc/hostname"}',
    "closed: the kernel's": b'{"closed": "/proc/self/environ"}',
    "names that are numbers": b'{"files": [], "steps": [], "failure": {"kind": "arguments", "macro": 5, '
    b'"what": "Invalid", "names": [1], "parameters": [2], "attribute": 3, "expression": ""}}',
}


@pytest.mark.parametrize("raw", RAW.values(), ids=RAW)
def test_bytes_that_are_no_answer_are_a_finding(
    raw: bytes, robot: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    answer = robot.with_name("answer")
    answer.write_bytes(raw)
    monkeypatch.setattr(worker, "_START", ANSWERING.format(str(answer)))
    done = expand(robot)
    assert done.text is None
    assert len(done.problems) == 1
    for command in (
        "lint --output-format html",
        "lint --output-format json",
        "expand",
        "convert urdf-to-sdf",
    ):
        assert main([*command.split(), "--isolated", str(robot)]) == 1


def changed(answer: Answer, chance: Random) -> Answer:
    """An answer with a part that is something else."""
    odd: tuple[object, ...] = (
        None,
        -1,
        0,
        1,
        10**9,
        2**70,
        1.5,
        "",
        "x",
        "\0",
        [],
        [1],
        {},
        True,
        "/etc/hostname",
        ["a", 1],
    )
    holder: Any = answer
    key: Any = chance.choice(sorted(answer))
    while isinstance(holder[key], list | dict) and holder[key] and chance.random() < 0.7:
        holder = holder[key]
        key = chance.choice(sorted(holder) if isinstance(holder, dict) else range(len(holder)))
    if chance.random() < 0.2:
        del holder[key]
    else:
        holder[key] = chance.choice(odd)
    return answer


def test_any_answer_is_borne(robot: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    broken = robot.with_name("broken.urdf.xacro")
    broken.write_text(TEXT.replace('a="x"', 'a="${nothing}"'))
    with Expander() as expander:
        answers: list[Answer] = []

        def keep(answer: Answer) -> Answer:
            answers.append(answer)
            return answer

        taken_over(monkeypatch, keep)
        for file in (robot, broken):
            expander.expand(read(file.read_bytes(), file, Kind.XACRO))
        monkeypatch.undo()
        monkeypatch.chdir(robot.parent)
        chance = Random(1)
        for number in range(600):
            answer = changed(copy.deepcopy(answers[number % 2]), chance)
            monkeypatch.setattr(Worker, "ask", lambda *_, answer=answer: answer)
            document = read(robot.read_bytes(), robot, Kind.XACRO)
            done = expander.expand(document)
            if done.document is not None:
                for element in done.document.elements:
                    assert done.document.spans.name(element).text is not None
                    assert len(done.document.origins(element)) < 10
            else:
                assert all(problem.span.text is not None for problem in done.problems)
            monkeypatch.undo()
            monkeypatch.chdir(robot.parent)
