"""Findings of the fuzzer stay fixed, and the fuzzer finds."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from random import Random

import pytest
from hypothesis import HealthCheck, given, seed, settings

from tests.fuzz import commands, kills, messages
from tests.fuzz.commands import COMMANDS, Failure, attempt
from tests.fuzz.documents import FIXTURES, Text
from tests.fuzz.driver import Case, Fuzzer, cases
from tests.fuzz.language_server import Ended, LanguageServer, converse
from tests.fuzz.minimize import minimize
from tests.fuzz.worker import SERVER, Worker

FINDINGS = sorted(path for path in (FIXTURES / "fuzz").iterdir() if path.suffix != ".txt")
TEXT = Text(".sdf", b'<sdf version="1.9"><model name="m"><link name="l"/></model></sdf>')


@pytest.mark.parametrize("finding", FINDINGS, ids=lambda path: path.name)
def test_every_command_bears_what_was_found(
    finding: Path, tmp_path: Path, stride: Callable[[int], int]
) -> None:
    """Usually a third of them, of each finding another one."""
    failures = {}
    step = stride(3)
    for number, command in enumerate(COMMANDS[FINDINGS.index(finding) % step :: step]):
        folder = tmp_path / str(number)
        folder.mkdir()
        file = folder / finding.name
        file.write_bytes(finding.read_bytes())
        failures[command] = attempt(command, file)
    assert {command: failure for command, failure in failures.items() if failure} == {}


def test_the_server_bears_what_was_found(tmp_path: Path) -> None:
    server = LanguageServer(tmp_path)
    try:
        for finding in FINDINGS:
            assert converse(server, finding, finding.read_bytes()) is None
    finally:
        server.close()


def test_the_server_answers_any_messages(tmp_path: Path) -> None:
    assert messages.weather(tmp_path, 1, 100) == []


def test_a_request_without_an_answer_is_noticed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def silence(_: LanguageServer) -> object:
        raise Ended

    monkeypatch.setattr(LanguageServer, "next_message", silence)
    monkeypatch.setattr(LanguageServer, "request", lambda *_: {})
    with pytest.raises(messages.Unanswered, match=r"no answer to \[1"):
        messages.weather(tmp_path, 1, messages.BURST)


@seed(1)
@settings(max_examples=20, database=None, deadline=None, suppress_health_check=list(HealthCheck))
@given(cases())
def test_a_few_texts(tmp_path_factory: pytest.TempPathFactory, case: Case) -> None:
    for command in case.commands:
        file = tmp_path_factory.mktemp("case") / f"file{case.text.suffix}"
        file.write_bytes(case.text.data)
        assert command == SERVER or attempt(command, file) is None


@pytest.mark.parametrize("kill", kills.KILLS, ids=lambda kill: kill.__name__)
def test_a_kill_tears_no_file(kill: object, tmp_path: Path) -> None:
    assert callable(kill)
    chance = Random(1)
    for _ in range(2):
        kill(chance, tmp_path)


def test_a_torn_file_is_noticed() -> None:
    with pytest.raises(kills.Torn, match=r"a\.sdf: 2 bytes, neither 4 nor 5"):
        kills._compare({"a.sdf": b"ne"}, {"a.sdf": b"old\n"}, {"a.sdf": b"newer"})
    assert kills._compare({"a": b"new", "b": b"b"}, {"a": b"old", "b": b"b"}, {"a": b"new", "b": b"c"})
    assert not kills._compare({"a": b"new"}, {"a": b"old"}, {"a": b"new"})


@pytest.mark.parametrize(
    ("ends", "mark"),
    [
        (lambda _: 7, "exit code 7"),
        (lambda _: 2, "exit code 2 without a word"),
        (lambda _: int("one"), "ValueError in "),
    ],
)
def test_broken_promises_are_failures(
    ends: object, mark: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = tmp_path / "a.sdf"
    file.write_bytes(TEXT.data)
    monkeypatch.setattr(commands, "main", ends)
    failure = attempt("inertia", file)
    assert failure is not None
    assert failure.mark.startswith(mark)


def test_a_fix_without_end_is_a_failure(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = tmp_path / "a.sdf"
    file.write_bytes(TEXT.data)

    def grow(_: object) -> int:
        file.write_bytes(file.read_bytes() + b"\n")
        return 0

    monkeypatch.setattr(commands, "main", grow)
    failure = attempt("lint --fix", file)
    assert failure is not None
    assert failure.mark == "the fix is not stable"
    failure = attempt("lint", file)
    assert failure is not None
    assert failure.mark == "lint changes the file"


def test_a_process_that_ends_is_a_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    worker = Worker()
    try:
        assert worker.run("inertia", TEXT) is None
        assert worker._process is not None
        os.kill(worker._process.pid or 0, 9)
        failure = worker.run("inertia", TEXT)
        assert failure is not None
        assert failure.mark.startswith("the process ends")
        assert worker.run("inertia", TEXT) is None
    finally:
        worker.stop()


def test_a_text_is_made_small() -> None:
    data = b"a\nb\nc needle d\n" * 3
    assert minimize(data, lambda part: b"needle" in part) == b"needle"
    assert minimize(data, lambda part: False) == data


def test_a_finding_is_kept_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    fuzzer = Fuzzer(tmp_path)
    monkeypatch.setattr(fuzzer.worker, "run", lambda *_: Failure("boom", "story"))
    fuzzer.take(Case(TEXT, ("inertia", "inertia --format json")), 5)
    assert fuzzer.marks == {"inertia: boom": 2}
    kept, story = sorted(tmp_path.iterdir())
    assert kept.read_bytes() == b""
    assert story.read_text().startswith("inertia\ninertia: boom\nseed 5\n")
