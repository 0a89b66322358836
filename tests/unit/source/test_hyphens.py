"""Comments with too many hyphens are spaced out; what is doubtful is left to the full scan."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.source.document import read
from sdfcheck.source.scanner.tokens import without_hyphens
from sdfcheck.source.text import Source


@pytest.mark.parametrize(
    ("text", "spaced", "runs"),
    [
        ("<a><!-- x --y --></a>", "<a><!-- x - -y --></a>", [["--"]]),
        ("<a><!-- --- --><!-- fine - --><!-- -- -- --></a>",
         "<a><!-- - - - --><!-- fine - --><!-- - - - - --></a>", [["---"], ["--", "--"]]),
        ("<a><!-- x ---></a>", "<a><!-- x - --></a>", [["-"]]),
    ],
)  # fmt: skip
def test_runs_of_hyphens_are_spaced_out(text: str, spaced: str, runs: list[list[str]]) -> None:
    fixed_file = without_hyphens(Source(Path("a.sdf"), text))
    assert fixed_file is not None
    assert fixed_file[0] == spaced
    assert [[run.text for run in problem.runs] for problem in fixed_file[1]] == runs


@pytest.mark.parametrize(
    "text",
    [
        "<a><!-- fine --></a>",
        "<a><!-- a -- <!-- b --></a>",
        "<a><!-- a -- b</a>",
        "<a><![CDATA[<!-- -- -->]]></a>",
    ],
)
def test_a_sound_or_doubtful_value_is_left_alone(text: str) -> None:
    assert without_hyphens(Source(Path("a.sdf"), text)) is None


def test_a_document_is_read_around_its_hyphens() -> None:
    document = read(b'<sdf version="1.9"><!-- a -- b --><p:x/><model name="m"/></sdf>', Path("a.sdf"))
    assert document.root is not None
    assert [child.name for child in document.root.children()] == ["p:x", "model"]
    assert [problem.span.text for problem in document.problems] == ["--"]
    model = document.root.find("model")
    assert model is not None
    assert model.span.begin == (1, 42)
    assert not document.is_wellformed
