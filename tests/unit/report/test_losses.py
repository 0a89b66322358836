"""Losses by file and code."""

from __future__ import annotations

from pathlib import Path

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.report.colors import painter
from sdfcheck.report.formats.concise import by_file_and_code
from sdfcheck.report.paths import Paths
from sdfcheck.source.text import Source


def test_a_place_is_said_once() -> None:
    source = Source(Path("m.xacro"), "a\nb\nc")

    def lines(*starts: int) -> list[str]:
        found = (Diagnostic("C1", "c", Severity.ERROR, "m", source.span(at, at + 1)) for at in starts)
        return list(by_file_and_code(found, Paths(), painter(False)))

    first = "m.xacro:1:1: error: m [C1]"
    assert lines(0) == [first]
    assert lines(0, 0) == [f"{first} and 1 more there"]
    assert lines(0, 0, 2, 2, 4) == [f"{first} and 4 more, at 2:1, 3:1"]
