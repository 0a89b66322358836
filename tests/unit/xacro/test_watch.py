"""Expansion where the system has no fork and no limits, as on Windows: simulated by a process without them."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck.source.document import read
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import Expander, Expansion, Surroundings
from sdfcheck.xacro.problems import ExpansionFailure, Failure
from sdfcheck.xacro.process import watch, worker
from sdfcheck.xacro.process.watch import Limits

HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
WITHOUT = "import os, sys; del os.fork; sys.modules['resource'] = None; "


@pytest.fixture
def expander(monkeypatch: pytest.MonkeyPatch) -> Iterator[Expander]:
    pytest.importorskip("psutil")
    monkeypatch.setattr(worker, "_START", WITHOUT + worker._START)
    monkeypatch.setattr(worker, "is_needed", lambda: True)
    monkeypatch.delattr("os.fork")
    limits = Limits(cpu=1, wall=30, memory=100_000_000, output=5_000_000)
    with Expander(Surroundings(limits=limits)) as one:
        yield one


def expanded(expander: Expander, folder: Path, body: str) -> Expansion:
    path = folder / "r.xacro"
    path.write_text(f"{HEAD}\n{body}\n</robot>")
    return expander.expand(read(path.read_bytes(), path, Kind.XACRO))


def failure(expansion: Expansion) -> ExpansionFailure:
    (found,) = expansion.problems
    assert isinstance(found, ExpansionFailure), found
    return found


def test_files_are_expanded_one_after_the_other(expander: Expander, tmp_path: Path) -> None:
    for number in range(3):
        done = expanded(expander, tmp_path, f'<link name="l${{{number} + 1}}"/>')
        assert done.text is not None
        assert f'<link name="l{number + 1}"/>' in done.text


@pytest.mark.parametrize(
    ("expression", "words"),
    [
        ("len([[x] * 9999 for x in range(10**9)])", "more memory"),
        ("len([x for x in range(10**12) if x > 10**13])", "no end after 1 s"),
    ],
)
def test_a_process_that_takes_too_much_is_stopped(
    expander: Expander, tmp_path: Path, expression: str, words: str
) -> None:
    found = failure(expanded(expander, tmp_path, f'<a b="${{{expression}}}"/>'))
    assert found.kind is Failure.LIMIT
    assert words in found.detail
    assert expanded(expander, tmp_path, '<link name="l"/>').text is not None


def test_the_guard_holds(expander: Expander, tmp_path: Path) -> None:
    found = failure(expanded(expander, tmp_path, '<a b="${().__class__}"/>'))
    assert found.kind is Failure.REFUSED


def test_nothing_is_expanded_where_nothing_can_watch(
    expander: Expander, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(watch, "find_spec", lambda name: None)
    with pytest.raises(WrongUsage, match=r"psutil.* is not installed \(`--no-expand`"):
        expanded(expander, tmp_path, '<link name="l"/>')


@pytest.mark.parametrize(
    ("platform", "has_limits", "needed"),
    [("linux", True, False), ("linux", False, True), ("darwin", True, True), ("win32", False, True)],
)
def test_where_a_watch_is_needed(
    platform: str, has_limits: bool, needed: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sys, "platform", platform)
    monkeypatch.setattr(watch, "find_spec", lambda name: object() if has_limits else None)
    assert watch.is_needed() is needed
