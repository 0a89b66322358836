"""Any executor gives the result of one process, and what it loses is reported."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Callable, Container
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

import sdfcheck
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.processes import checked, lint_portion, portions
from sdfcheck.lint.session import Options, find
from sdfcheck.source.errors import WrongUsage
from tests.unit.lint.many_files import PART, shape
from tests.unit.lint.many_files import folder as folder  # noqa: PLC0414


@pytest.mark.parametrize("kind", ["threads", "processes"])
def test_any_executor_gives_the_same_result(folder: Path, kind: str) -> None:
    one = sdfcheck.lint([Path("worlds"), Path("parts")], isolated=True)
    executor: Executor = (
        ThreadPoolExecutor(3)
        if kind == "threads"
        else ProcessPoolExecutor(2, multiprocessing.get_context("spawn"))
    )
    with executor:
        for _ in range(3):
            many = sdfcheck.lint([Path("worlds"), Path("parts")], isolated=True, executor=executor)
            assert shape(many) == shape(one)
            assert many._replace(diagnostics=()) == one._replace(diagnostics=())


def test_configured_settings_reach_the_workers(folder: Path) -> None:
    (folder / "sdfcheck.toml").write_text('ignore = ["SCH011"]\n[per-file-ignores]\n"worlds/0*" = ["NS"]\n')
    one = sdfcheck.lint(folder)
    with ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as executor:
        many = sdfcheck.lint(folder, executor=executor)
    assert shape(many) == shape(one)
    assert many.rules == one.rules


def test_texts_go_through_an_executor(folder: Path) -> None:
    with ThreadPoolExecutor(1) as executor:
        assert shape(sdfcheck.lint(PART, isolated=True, executor=executor)) == shape(
            sdfcheck.lint(PART, isolated=True)
        )
        assert sdfcheck.lint([], isolated=True, executor=executor).files == ()


def test_the_rest_of_a_broken_executor_is_linted_here(folder: Path) -> None:
    expected = sdfcheck.lint(folder, isolated=True)
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as executor:
        with pytest.raises(BrokenExecutor):
            executor.submit(os._exit, 1).result()
        assert shape(sdfcheck.lint(folder, isolated=True, executor=executor)) == shape(expected)


class Forgetful(Executor):
    """Loses some of its work, as clusters do that lose workers."""

    def __init__(self, lost: Container[int]) -> None:
        self.lost = lost
        self.count = 0

    def submit(self, function: Callable[..., Any], /, *given: Any, **named: Any) -> Future[Any]:
        future: Future[Any] = Future()
        if self.count in self.lost:
            future.set_exception(RuntimeError("the worker is gone"))
        else:
            future.set_result(function(*given, **named))
        self.count += 1
        return future


def test_files_of_lost_workers_are_skipped_with_the_reason(folder: Path) -> None:
    done = sdfcheck.lint(folder, isolated=True, executor=Forgetful({0, 5}))
    lost = [path for path, reason in done.skipped if reason == "RuntimeError: the worker is gone"]
    assert len(lost) == 2
    assert len(done.files) == 12
    with pytest.raises(WrongUsage, match="the executor linted nothing: RuntimeError: the worker is gone"):
        sdfcheck.lint(folder, isolated=True, executor=Forgetful(range(100)))


def test_relative_paths_need_workers_in_the_same_folder(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    options = Options(Configuration(isolated=True))
    portion = portions(find([Path("worlds")], options), options, 1, is_listening=False)[0]
    absolute = portions(find([folder / "worlds"], options), options, 1, is_listening=False)[0]
    monkeypatch.chdir(folder / "parts")
    with pytest.raises(WrongUsage, match=r"worlds/00\.sdf is relative to .* give absolute paths"):
        checked(lint_portion(portion))
    assert len(checked(lint_portion(absolute)).part.files) == 13


def test_the_signature_is_visible() -> None:
    import inspect
    import pydoc

    assert "executor" in inspect.signature(sdfcheck.lint).parameters
    assert "to" in inspect.signature(sdfcheck.convert).parameters
    assert "executor: " in pydoc.render_doc(sdfcheck.lint)
    assert "Files whose worker" in pydoc.render_doc(sdfcheck.lint)
