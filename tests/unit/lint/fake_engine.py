"""An engine of two rules for tests of what is around it: ``!`` and ``?`` in a text are flaws."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import pytest

from sdfcheck.files.library import Library
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.one_file import FileResult
from sdfcheck.lint.rulebook.pack import PackError
from sdfcheck.lint.rulebook.packs import RuleIndex
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.select import ActiveRules
from sdfcheck.lint.suppress.suppression import Comment
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source

RULES = (
    RuleFacts("AAA001", "loud-flaw", "AAA", Severity.ERROR, "A flaw is loud.", "", True, (), (), {}, ""),
    RuleFacts(
        "BBB001",
        "odd-flaw",
        "BBB",
        Severity.WARNING,
        "A flaw is odd.",
        "",
        True,
        (),
        (),
        {"drake": {"sdf": "reject: aborts"}},
        "",
    ),
    RuleFacts("CCC001", "style-flaw", "CCC", Severity.INFO, "Not nice.", "safe", False, (), (), {}, ""),
)
_MARKS = {"!": RULES[0], "?": RULES[1], "~": RULES[2]}


class Dispatch:
    def __init__(self, index: RuleIndex, active: ActiveRules, pause: Callable[[], None]) -> None:
        self.active = active


class Seen(NamedTuple):
    """The files that the engine was given."""

    data: bytes
    path: Path
    kind: Kind | None


def load_index(plugins: Sequence[str | Path] = ()) -> RuleIndex:
    if plugins:
        raise PackError("not there", str(plugins[0]))
    return RuleIndex(RULES)


def install(monkeypatch: pytest.MonkeyPatch) -> list[Seen]:
    """Put the engine in place of the real one; the list fills with what it is given."""
    seen: list[Seen] = []

    def lint_source(
        data: bytes, path: Path, kind: Kind | None, dispatch: Dispatch, library: Library, xacro: object
    ) -> FileResult:
        seen.append(Seen(data, path, kind))
        source = Source(path, data.decode())
        if "crash" in source.text:
            raise ValueError("no\nluck")
        return FileResult(_diagnostics(source, dispatch.active), _comments(source))

    monkeypatch.setattr("sdfcheck.lint.one_file.lint_source", lint_source)
    monkeypatch.setattr("sdfcheck.lint.engine.Dispatch", Dispatch)
    monkeypatch.setattr("sdfcheck.lint.rulebook.packs.load_index", load_index)
    return seen


def _diagnostics(source: Source, active: ActiveRules) -> list[Diagnostic]:
    found = []
    for match in re.finditer(r"(?<!<)[!?~]", source.text):
        facts = _MARKS[match[0]]
        if facts.code in active.codes:
            severity = active.severities.get(facts.code, facts.severity)
            span = source.span(*match.span())
            found.append(Diagnostic(facts.code, facts.name, severity, f"it is {match[0]}", span))
    return found


def _comments(source: Source) -> list[Comment]:
    return [
        Comment(source.span(*match.span()), source.span(match.end(), len(source.text)))
        for match in re.finditer(r"<!--.*?-->", source.text)
    ]
