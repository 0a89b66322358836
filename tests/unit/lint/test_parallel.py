"""A run in several processes says what one process says."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.lint import parallel
from sdfcheck.lint.config import Configuration
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import InternalError, Notice, Options, run

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


@pytest.mark.parametrize("paths", [[Path()], [Path("worlds"), Path("parts")], [Path("worlds")]])
def test_the_result_is_the_same(folder: Path, monkeypatch: pytest.MonkeyPatch, paths: list[Path]) -> None:
    monkeypatch.setattr(parallel, "LEAST", 2)
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    options = Options(Configuration(isolated=True))
    notices: list[Notice] = []
    told: list[int] = []
    many = parallel.run_in_parallel(
        paths, options, 2, progress=lambda done, of, path: told.append(done), notify=notices.append
    )
    expected: list[Notice] = []
    one = run(paths, options, notify=expected.append)
    assert shape(many) == shape(one)
    assert many._replace(diagnostics=()) == one._replace(diagnostics=())
    assert (notices, told[-1], told == sorted(told)) == (expected, len(one.files), True)
    assert {d.code for d in one.diagnostics} >= {"NS001", "SCH011", "XAC004"}


@pytest.mark.parametrize(("jobs", "cpus"), [(1, 8), (8, 1), (8, None)])
def test_without_a_second_processor_there_is_one_process(
    folder: Path, monkeypatch: pytest.MonkeyPatch, jobs: int, cpus: int | None
) -> None:
    monkeypatch.setattr(parallel, "LEAST", 1)
    monkeypatch.setattr("os.cpu_count", lambda: cpus)
    monkeypatch.setattr("concurrent.futures.ProcessPoolExecutor", None)
    options = Options(Configuration(isolated=True))
    done = parallel.run_in_parallel([Path()], options, jobs, progress=None, notify=lambda notice: None)
    assert len(done.files) == 14


def test_a_bug_comes_through_whole() -> None:
    import pickle

    error = pickle.loads(pickle.dumps(InternalError(Path("a.sdf"), "ValueError: no luck")))
    assert str(error) == "a.sdf: ValueError: no luck"
