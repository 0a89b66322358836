"""Hyphens in comments, as the full scan finds them."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import etree

from sdfcheck.source.problems import CommentHyphens
from sdfcheck.source.scanner.full_scan import scan
from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.text import Source


def scanned(text: str) -> Scan:
    return scan(Source(Path("example.sdf"), text))


@pytest.mark.parametrize(
    ("comment", "runs"),
    [
        ("<!-- a--b -->", ["--"]),
        ("<!------>", ["--"]),
        ("<!-- a --->", ["-"]),
        ("<!-- -- ---- -->", ["--", "----"]),
        ("<!-- a <!-- b -->", ["--"]),
    ],
)
def test_hyphens_in_comments(comment: str, runs: list[str]) -> None:
    result = scanned(f"<a>{comment}</a>")
    (problem,) = result.problems
    assert isinstance(problem, CommentHyphens)
    assert [run.text for run in problem.runs] == runs
    assert etree.fromstring(result.wellformed.encode()).tag == "a"


@pytest.mark.parametrize("comment", ["<!---->", "<!-- - -->", "<!-- a - b -->", "<!-- < > & ]]> -->"])
def test_sound_comments(comment: str) -> None:
    assert scanned(f"<a>{comment}</a>").problems == []
