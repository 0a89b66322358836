"""The line on a terminal that says how far a long run has come."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.parts.progress import Progress
from tests.unit.cli.terminals import Terminal, screen


def drawn(stream: Terminal, width: int) -> list[str]:
    return [row for row in screen(stream.getvalue(), width, 5) if row]


def test_short_runs_show_no_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    times = iter([0.0, 0.5, 0.9])
    monkeypatch.setattr("sdfcheck.cli.parts.progress.time.monotonic", lambda: next(times))
    stream = Terminal()
    progress = Progress(stream, 80)
    progress(0, 9, Path("a.sdf"))
    progress(1, 9, Path("b.sdf"))
    progress.clear()
    assert stream.getvalue() == ""


@pytest.mark.parametrize("width", [40, 80, 160])
def test_long_runs_show_rate_and_time_left_in_one_line(width: int, monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr("sdfcheck.cli.parts.progress.time.monotonic", lambda: now[0])
    stream = Terminal()
    progress = Progress(stream, width)
    for second in range(1, 11):
        now[0] = second + 0.5
        progress(second * 20, 1000, Path("robots") / ("長" * 40) / f"{second}.sdf")
    rows = drawn(stream, width)
    assert len(rows) == 1
    assert "200/1000" in rows[0]
    if width >= 80:
        assert "20 files/s" in rows[0]
        assert "0:00:40" in rows[0]
        assert "robots/" in rows[0]
    progress.clear()
    assert drawn(stream, width) == []


def test_a_file_that_takes_long_is_not_drawn_again_and_again(monkeypatch: pytest.MonkeyPatch) -> None:
    now = [0.0]
    monkeypatch.setattr("sdfcheck.cli.parts.progress.time.monotonic", lambda: now[0])
    stream = Terminal()
    progress = Progress(stream, 80)
    now[0] = 1.5
    progress(1, 9, Path("a.sdf"))
    before = stream.getvalue()
    now[0] = 1.55
    progress(2, 9, Path("b.sdf"))
    assert stream.getvalue() == before
    progress.clear()
