"""A run in several processes says what one process says."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from sdfcheck.cli.main import main
from sdfcheck.lint import parallel, processes, session
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.one_file import Selected, lint_file
from sdfcheck.lint.processes import DIED
from sdfcheck.lint.session import InternalError, Notice, Options, run
from tests.unit.lint.many_files import folder as folder  # noqa: PLC0414
from tests.unit.lint.many_files import shape


@pytest.fixture
def two_processors(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(parallel, "LEAST", 2)
    monkeypatch.setattr(parallel, "processors", lambda: 2)


@pytest.mark.parametrize("copies", [processes.COPIES, False])
@pytest.mark.parametrize("paths", [[Path()], [Path("worlds"), Path("parts")], [Path("worlds")]])
def test_the_result_is_the_same(
    folder: Path, two_processors: None, monkeypatch: pytest.MonkeyPatch, paths: list[Path], copies: bool
) -> None:
    monkeypatch.setattr(processes, "COPIES", copies)
    options = Options(Configuration(isolated=True))
    notices: list[Notice] = []
    counts: list[int] = []

    def progress(done: int, of: int, path: Path) -> None:
        counts.append(done)

    many = parallel.run_in_parallel(paths, options, progress=progress, notify=notices.append)
    expected: list[Notice] = []
    one = run(paths, options, notify=expected.append)
    assert shape(many) == shape(one)
    assert many._replace(diagnostics=()) == one._replace(diagnostics=())
    assert notices == expected
    assert counts == sorted(counts)
    assert {d.code for d in one.diagnostics} >= {"NS001", "SCH011", "XAC004"}


@pytest.mark.parametrize(("jobs", "count"), [(1, 8), (8, 1), (None, 1)])
def test_one_process_needs_no_worker(
    folder: Path, monkeypatch: pytest.MonkeyPatch, jobs: int | None, count: int
) -> None:
    monkeypatch.setattr(parallel, "LEAST", 1)
    monkeypatch.setattr(parallel, "processors", lambda: count)
    monkeypatch.setattr(processes, "_processes", None)
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


def test_a_bug_in_a_worker_is_raised(
    folder: Path, two_processors: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    needs_copies()
    monkeypatch.setattr(session, "lint_file", in_workers(wrong))
    with pytest.raises(InternalError, match="no luck"):
        parallel.run_in_parallel([Path()], Options(Configuration(isolated=True)))


def needs_copies() -> None:
    if not processes.COPIES:
        pytest.skip("a worker that is not a copy of this process knows nothing of what is planted here")


def in_workers(act: Callable[[Selected], None]) -> Callable[..., Any]:
    """``lint_file``, after ``act`` in every process but this one."""
    here = os.getpid()

    def lint_after(file: Selected, *given: Any) -> Any:
        if os.getpid() != here:
            act(file)
        return lint_file(file, *given)

    return lint_after


def wrong(file: Selected) -> None:
    raise ValueError("no luck")


def killed(file: Selected) -> None:
    if file.path.stem in DEADLY:
        os.kill(os.getpid(), getattr(signal, "SIGKILL", signal.SIGTERM))


def ended(file: Selected) -> None:
    if file.path.stem in DEADLY:
        os._exit(0)


DEADLY = ("03", "04", "11")


@pytest.mark.parametrize("end", [killed, ended])
def test_a_worker_that_dies_is_reported_with_its_file(
    folder: Path, two_processors: None, monkeypatch: pytest.MonkeyPatch, end: Callable[[Selected], None]
) -> None:
    needs_copies()
    expected = shape(run([Path()], Options(Configuration(isolated=True))))
    monkeypatch.setattr(session, "lint_file", in_workers(end))
    notices: list[Notice] = []
    done = parallel.run_in_parallel([Path()], Options(Configuration(isolated=True)), notify=notices.append)
    lost = [Path(f"worlds/{name}.sdf") for name in DEADLY]
    assert [path for path, reason in done.skipped if reason == DIED] == lost
    assert [notice.text for notice in notices if DIED in notice.text] == [
        f"{path}: not linted: {DIED}" for path in lost
    ]
    assert not set(lost) & set(done.files)
    assert len(done.files) == 14 - len(lost)
    assert shape(done) == [row for row in expected if not any(f"{name}.sdf" in str(row) for name in DEADLY)]


def test_the_command_reports_a_worker_that_dies(
    folder: Path,
    two_processors: None,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    needs_copies()
    monkeypatch.setattr(session, "lint_file", in_workers(killed))
    assert main(["lint", "--isolated", "--fail-on", "error"]) == 2
    shown = capsys.readouterr()
    assert "error: worlds/03.sdf: not linted: the process that linted it died" in shown.err
    assert "worlds/02.sdf" in shown.out


def test_an_interrupt_leaves_no_process(folder: Path, tmp_path: Path) -> None:
    needs_copies()
    child = interruptible([sys.executable, "-c", SLOW])
    pids = tmp_path / "pids"
    for _ in range(12_000):
        if pids.exists() and len(pids.read_text().split()) == 2:
            break
        time.sleep(0.05)
    child.send_signal(signal.SIGINT)
    assert child.communicate(timeout=600)[1].strip() == ""
    assert child.returncode == 130
    for pid in pids.read_text().split():
        assert not Path(f"/proc/{pid}").exists()


def interruptible(command: list[str]) -> subprocess.Popen[str]:
    """A process that an interrupt ends, also where the parent of the tests ignores interrupts, as `nohup` does."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        return subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
    finally:
        signal.signal(signal.SIGINT, before)


SLOW = """
import os, sys, time
from sdfcheck.cli.main import main
from sdfcheck.lint import parallel, session
def slow(*given):
    with open("pids", "a") as file:
        file.write(f"{os.getpid()}\\n")
    time.sleep(3000)
parallel.LEAST, parallel.processors, session.lint_file = 2, lambda: 2, slow
sys.exit(main(["lint", "--isolated"]))
"""


def test_a_bug_comes_through_whole() -> None:
    import pickle

    error = pickle.loads(pickle.dumps(InternalError(Path("a.sdf"), "ValueError: no luck")))
    assert str(error) == "a.sdf: ValueError: no luck"
