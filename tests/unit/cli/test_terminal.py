import io
from pathlib import Path

import pytest

from sdfcheck.cli.parts.terminal import Progress, emit, wants_color


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_terminals_are_coloured_unless_they_cannot_be() -> None:
    assert wants_color("auto", Terminal(), {})
    assert not wants_color("auto", Terminal(), {"TERM": "dumb"})
    assert not wants_color("auto", Terminal(), {"NO_COLOR": "1"})
    assert wants_color("auto", Terminal(), {"NO_COLOR": ""})
    assert not wants_color("auto", io.StringIO(), {})


def test_short_runs_show_no_progress(monkeypatch: pytest.MonkeyPatch) -> None:
    times = iter([0.0, 0.5, 1.2, 1.25, 1.4])
    monkeypatch.setattr("time.monotonic", lambda: next(times))
    stream = Terminal()
    progress = Progress(stream)
    progress(0, 9, Path("a.sdf"))
    progress.clear()
    assert stream.getvalue() == ""
    for done in (1, 2, 3):
        progress(done, 9, Path("b.sdf"))
    assert stream.getvalue() == "\r\x1b[K[1/9] b.sdf\r\x1b[K[3/9] b.sdf"
    progress.clear()
    assert stream.getvalue().endswith("\r\x1b[K")


def test_pipes_get_utf8_whatever_the_locale(monkeypatch: pytest.MonkeyPatch) -> None:
    raw = io.BytesIO()
    monkeypatch.setattr("sys.stdout", io.TextIOWrapper(raw, encoding="ascii"))
    emit("ä \udcff\n")
    assert raw.getvalue() == "ä \\udcff\n".encode()


def test_terminals_get_what_they_can_show(monkeypatch: pytest.MonkeyPatch) -> None:
    class Ascii(Terminal):
        encoding = "ascii"

    stream = Ascii()
    monkeypatch.setattr("sys.stdout", stream)
    emit("ä\n")
    assert stream.getvalue() == "\\xe4\n"
