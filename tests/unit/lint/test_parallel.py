"""A run in several processes says what one process says."""

from __future__ import annotations

import os
import signal
import time
from pathlib import Path
from typing import Any

import pytest

from sdfcheck.lint import parallel, session
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.one_file import lint_file
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import InternalError, Notice, Options, run
from sdfcheck.source.wrong_usage import WrongUsage

PART = '<sdf version="1.12"><model name="part"><static>maybe</static><link name="l"/></model></sdf>'
INCLUDE = "<include><uri>../parts/part.sdf</uri></include>"
PREFIX = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name in ("parts", "worlds"):
        (tmp_path / name).mkdir()
    (tmp_path / "parts/part.sdf").write_text(PART)
    for number in range(12):
        text = f'<sdf version="1.12"><world name="w{number}" foo="1">{INCLUDE}</world></sdf>'
        (tmp_path / f"worlds/{number:02}.sdf").write_text(text)
    (tmp_path / "worlds/r.xacro").write_text(f'<robot name="r" {PREFIX}><link name="${{x}}"/></robot>')
    (tmp_path / "worlds/a.sdf").write_text("no XML")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def shape(done: Run) -> list[tuple[object, ...]]:
    return [
        (
            d.code,
            d.message,
            str(d.span),
            [str(label.span) for label in d.labels],
            [str(o.span) for o in d.origins],
        )
        for d in done.diagnostics
    ]


@pytest.fixture
def two_processors(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(parallel, "LEAST", 2)
    monkeypatch.setattr(parallel, "processors", lambda: 2)


@pytest.mark.parametrize("copies", [parallel.COPIES, False])
@pytest.mark.parametrize("paths", [[Path()], [Path("worlds"), Path("parts")], [Path("worlds")]])
def test_the_result_is_the_same(
    folder: Path, two_processors: None, monkeypatch: pytest.MonkeyPatch, paths: list[Path], copies: bool
) -> None:
    monkeypatch.setattr(parallel, "COPIES", copies)
    options = Options(Configuration(isolated=True))
    notices: list[Notice] = []
    told: list[int] = []

    def progress(done: int, of: int, path: Path) -> None:
        told.append(done)

    many = parallel.run_in_parallel(paths, options, progress=progress, notify=notices.append)
    expected: list[Notice] = []
    one = run(paths, options, notify=expected.append)
    assert shape(many) == shape(one)
    assert many._replace(diagnostics=()) == one._replace(diagnostics=())
    assert notices == expected
    assert told == sorted(told)
    assert {d.code for d in one.diagnostics} >= {"NS001", "SCH011", "XAC004"}


@pytest.mark.parametrize(("jobs", "processors"), [(1, 8), (8, 1), (None, 1)])
def test_one_process_needs_no_worker(
    folder: Path, monkeypatch: pytest.MonkeyPatch, jobs: int | None, processors: int
) -> None:
    monkeypatch.setattr(parallel, "LEAST", 1)
    monkeypatch.setattr(parallel, "processors", lambda: processors)
    monkeypatch.setattr(parallel, "_share", None)
    done = parallel.run_in_parallel([Path()], Options(Configuration(isolated=True)), jobs)
    assert len(done.files) == 14


@pytest.mark.parametrize(
    ("what", "error"),
    [
        ("multiprocessing.context.BaseContext.SimpleQueue", ImportError("no semaphores")),
        ("multiprocessing.process.BaseProcess.start", OSError("too many processes")),
    ],
)
def test_a_system_that_grants_no_process_gets_by_with_one(
    folder: Path, two_processors: None, monkeypatch: pytest.MonkeyPatch, what: str, error: Exception
) -> None:
    def refuse(*given: Any) -> Any:
        raise error

    monkeypatch.setattr(what, refuse)
    options = Options(Configuration(isolated=True))
    assert shape(parallel.run_in_parallel([Path()], options)) == shape(run([Path()], options))


def test_what_goes_wrong_in_a_worker_is_told(
    folder: Path, two_processors: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not parallel.COPIES:
        pytest.skip("a worker that is no copy of this process knows nothing of the planted bug")
    here = os.getpid()

    def slow_here_and_wrong_there(*given: Any) -> Any:
        if os.getpid() != here:
            raise ValueError("no luck")
        time.sleep(0.05)
        return lint_file(*given)

    monkeypatch.setattr(session, "lint_file", slow_here_and_wrong_there)
    with pytest.raises(InternalError, match="no luck"):
        parallel.run_in_parallel([Path()], Options(Configuration(isolated=True)))


def test_a_worker_that_is_killed_is_told_of(
    folder: Path, two_processors: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    if not parallel.COPIES:
        pytest.skip("a worker that is no copy of this process knows nothing of the planted end")
    here = os.getpid()

    def slow_here_and_killed_there(*given: Any) -> Any:
        if os.getpid() != here:
            os.kill(os.getpid(), signal.SIGKILL)
        time.sleep(0.05)
        return lint_file(*given)

    monkeypatch.setattr(session, "lint_file", slow_here_and_killed_there)
    with pytest.raises(WrongUsage, match="ended from outside"):
        parallel.run_in_parallel([Path()], Options(Configuration(isolated=True)))


def test_a_bug_comes_through_whole() -> None:
    import pickle

    error = pickle.loads(pickle.dumps(InternalError(Path("a.sdf"), "ValueError: no luck")))
    assert str(error) == "a.sdf: ValueError: no luck"
