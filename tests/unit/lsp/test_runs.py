"""When the server lints, and what it keeps."""

from __future__ import annotations

import asyncio
import gc
import threading
import time
import weakref
from collections.abc import Callable
from pathlib import Path

import pytest
from lsprotocol import types

from benchmarks.editor import Editor
from sdfcheck.lsp.completion import complete
from sdfcheck.lsp.findings import Findings
from sdfcheck.lsp.register import make_server
from sdfcheck.lsp.worker import ANSWER, LINT, SURVEY, Schedule, Worker
from sdfcheck.lsp.workspace import Choices, Outdated, Workspace
from sdfcheck.robot.root import root_of
from sdfcheck.source.text import Source

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"


@pytest.mark.asyncio(loop_scope="function")
async def test_changes_in_quick_succession_make_few_runs_and_never_two_at_once() -> None:
    running, most, text = 0, 0, 0
    runs: list[int] = []

    async def lint(key: str) -> None:
        nonlocal running, most
        running += 1
        most = max(most, running)
        seen = text
        await asyncio.sleep(0.05)
        running -= 1
        runs.append(seen)

    schedule = Schedule(lint)
    for number in range(1, 60):
        text = number
        schedule.note("m.sdf")
        await asyncio.sleep(0.005)
    while running or not runs or runs[-1] != text:
        await asyncio.sleep(0.01)
    assert most == 1
    assert len(runs) < 30


@pytest.mark.asyncio(loop_scope="function")
async def test_a_message_that_was_handled_is_forgotten() -> None:
    server = make_server()
    document = types.TextDocumentIdentifier("file:///r.urdf")
    for _ in range(20):
        server.protocol._handle_notification(
            types.TEXT_DOCUMENT_DID_SAVE, types.DidSaveTextDocumentParams(document)
        )
    for _ in range(100):
        await asyncio.sleep(0.01)
        if not server.protocol._request_futures:
            break
    assert not server.protocol._request_futures


@pytest.mark.asyncio(loop_scope="function")
async def test_a_text_that_takes_long_is_looked_at_when_nobody_types(monkeypatch: pytest.MonkeyPatch) -> None:
    server, looks = make_server(), 0

    def glance(_: object) -> bool:
        nonlocal looks
        looks += 1
        time.sleep(0.5)
        return True

    monkeypatch.setattr(server.findings, "glance", glance)
    await server.opened(
        types.DidOpenTextDocumentParams(types.TextDocumentItem("file:///r.urdf", "urdf", 1, "<robot/>"))
    )
    await asyncio.sleep(1)
    assert looks == 1
    for version in range(2, 10):
        change = types.TextDocumentContentChangeWholeDocument(f"<robot/>{' ' * version}")
        text = types.VersionedTextDocumentIdentifier(version, "file:///r.urdf")
        await server.changed(types.DidChangeTextDocumentParams(text, [change]))
        await asyncio.sleep(0.03)
    assert looks == 1
    await asyncio.sleep(1)
    assert looks == 2
    server.ended()


@pytest.mark.asyncio(loop_scope="function")
async def test_one_thread_does_all_work_and_answers_first() -> None:
    worker = Worker()
    done: list[str] = []
    threads: set[int] = set()
    begun, may_go = threading.Event(), threading.Event()

    def job(name: str) -> None:
        if name == "first":
            begun.set()
            may_go.wait()
        threads.add(threading.get_ident())
        done.append(name)

    first = asyncio.ensure_future(worker.run(lambda: job("first"), LINT))
    while not begun.is_set():
        await asyncio.sleep(0.01)
    others = asyncio.gather(worker.run(lambda: job("lint"), LINT), worker.run(lambda: job("answer"), ANSWER))
    await asyncio.sleep(0)
    may_go.set()
    await asyncio.gather(first, others)
    worker.close()
    assert done == ["first", "answer", "lint"]
    assert len(threads) == 1


@pytest.mark.asyncio(loop_scope="function")
async def test_a_lint_gives_way_to_answers_and_to_no_other_lint() -> None:
    worker, done, loop = Worker(), list[str](), asyncio.get_running_loop()
    begun, may_go = asyncio.Event(), threading.Event()

    def lint() -> None:
        loop.call_soon_threadsafe(begun.set)
        worker.aside(may_go.wait, worker.give_way)
        done.append("portion")
        worker.give_way()
        done.append("lint")

    first = asyncio.ensure_future(worker.run(lint, SURVEY))
    await begun.wait()
    other = asyncio.ensure_future(worker.run(lambda: done.append("other lint"), LINT))
    await worker.run(lambda: done.append("answer"))
    assert done == ["answer"]
    may_go.set()
    await asyncio.gather(first, other)
    worker.close()
    assert done == ["answer", "portion", "lint", "other lint"]


@pytest.mark.asyncio(loop_scope="function")
async def test_a_look_at_a_text_that_changes_meanwhile_ends() -> None:
    path, loop = ROBOTS / "desk_arm" / "desk_arm.urdf", asyncio.get_running_loop()
    workspace = Workspace(worker := Worker())
    findings = Findings(workspace)
    buffer = workspace.open(path.as_uri(), path, path.read_text(), 1)
    begun, may_go = asyncio.Event(), threading.Event()

    def lint() -> None:
        loop.call_soon_threadsafe(begun.set)
        may_go.wait()
        findings.lint(buffer)

    first = asyncio.ensure_future(worker.run(lint, LINT))
    await begun.wait()
    new = Source(path, buffer.source.text.replace("base", "bottom"))
    second = asyncio.ensure_future(worker.run(lambda: workspace.write(buffer, new, 2)))
    await asyncio.sleep(0)
    may_go.set()
    with pytest.raises(Outdated):
        await first
    await second
    worker.close()
    assert not findings.at(path)


@pytest.mark.asyncio(loop_scope="function")
async def test_a_job_that_fails_does_not_end_the_thread() -> None:
    worker = Worker()
    with pytest.raises(ZeroDivisionError):
        await worker.run(lambda: 1 // 0)
    assert await worker.run(lambda: 7) == 7
    worker.close()


@pytest.mark.parametrize("name", ["diff_drive/model.sdf", "desk_arm/desk_arm.urdf"])
def test_an_old_reading_is_let_go_at_once(name: str, copied: Callable[[Path], Path]) -> None:
    path = copied(ROBOTS / name)
    workspace = Workspace()
    findings = Findings(workspace)
    buffer = workspace.open(path.as_uri(), path, path.read_text(), 1)
    findings.lint(buffer)
    gc.collect()
    gc.disable()
    try:
        old = weakref.ref(root_of(buffer.document))
        workspace.write(buffer, Source(path, f"{buffer.source.text} "), 2)
        findings.lint(buffer)
        buffer.tidy()
        assert old() is None
    finally:
        gc.enable()


@pytest.mark.parametrize(
    "name",
    ["diff_drive/model.sdf", "desk_arm/desk_arm.urdf", "rover/rover.urdf.xacro", "workcell/workcell.world"],
)
def test_edits_leave_no_rest(name: str, copied: Callable[[Path], Path]) -> None:
    path = copied(ROBOTS / name)
    text = path.read_text()
    workspace = Workspace()
    workspace.choose(Choices(expand=False))
    findings = Findings(workspace)
    buffer = workspace.open(path.as_uri(), path, text, 1)
    counts = []
    for number in range(60):
        broken = text.replace("</link>", "</lnik>", 1) if number % 3 == 1 else text
        workspace.write(buffer, Source(path, broken + " " * (number % 7)), number)
        findings.lint(buffer)
        if number % 20 == 19:
            gc.collect()
            counts.append(len(gc.get_objects()))
    assert counts[-1] - counts[0] < 50, counts


@pytest.mark.slow
def test_many_edits_of_a_robot_made_with_xacro_take_no_more_memory(tmp_path: Path) -> None:
    psutil = pytest.importorskip("psutil")
    macro = '<xacro:macro name="leg" params="n"><link name="${n}_a"/><link name="${n}_b"/></xacro:macro>'
    calls = "".join(f'<xacro:leg n="l{number}"/>\n' for number in range(150))
    text = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{macro}\n{calls}</robot>\n'
    path = tmp_path / "r.urdf.xacro"
    path.write_text(text)
    editor = Editor()
    buffer, sizes = editor.open(path, text), []
    at = text.index('"l7"') + 3
    for number in range(60):
        text = text[:at] + "x" * (number % 2) + text[at + (number - 1) % 2 * (number > 0) :]
        editor.workspace.write(buffer, Source(path, text), number, at)
        editor.findings.lint(buffer)
        place = editor.place(buffer, at)
        editor.answers.hover(buffer, types.HoverParams(**place))
        editor.answers.definition(buffer, types.DefinitionParams(**place))
        complete(editor.workspace, buffer, at)
        buffer.tidy()
        editor.workspace.caches.tidy()
        if number % 20 == 19:
            gc.collect()
            sizes.append(psutil.Process().memory_info().rss)
    editor.workspace.close()
    assert sizes[-1] - sizes[0] < 4_000_000, sizes
