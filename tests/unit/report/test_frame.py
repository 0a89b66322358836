from __future__ import annotations

from pathlib import Path
from textwrap import dedent

import pytest

from sdfcheck.lint.diagnostic import Label
from sdfcheck.source.text import Source
from tests.unit.report.runs import diagnostic, shown


def test_label_on_an_earlier_line() -> None:
    text = "<sdf>\n" * 6 + '  <model {xmlns:p}="q">\n' + "\n" * 4 + "    <«p»:x>y</p:x>\n"
    assert shown(diagnostic(text, "declared here")) == (
        "  --> arm.sdf:12:6\n"
        "   |\n"
        ' 7 |   <model xmlns:p="q">\n'
        "   |          ------- declared here\n"
        "   :\n"
        "12 |     <p:x>y</p:x>\n"
        "   |      ^"
    )


@pytest.mark.parametrize(
    ("text", "labels", "expected"),
    [
        pytest.param(
            '<a «x="1"» {x="2"}/>',
            ["again"],
            """
             --> arm.sdf:1:4
              |
            1 | <a x="1" x="2"/>
              |    ^^^^^ ----- again
            """,
            id="label after",
        ),
        pytest.param(
            '<a {x="1"} «x="2"»/>',
            ["first"],
            """
             --> arm.sdf:1:10
              |
            1 | <a x="1" x="2"/>
              |    ----- first
              |          ^^^^^
            """,
            id="label before",
        ),
        pytest.param(
            "<a>«{b}» {c}</a>",
            ["inner", "outer"],
            """
             --> arm.sdf:1:4
              |
            1 | <a>b c</a>
              |    ^
              |    - inner
              |      - outer
            """,
            id="two labels on one line",
        ),
        pytest.param(
            "{a}\nb\n«c»\n\n\n{d}",
            ["above", "below"],
            """
             --> arm.sdf:3:1
              |
            1 | a
              | - above
            2 | b
            3 | c
              | ^
              :
            6 | d
              | - below
            """,
            id="one skipped line is shown, more are not",
        ),
        pytest.param(
            "\t<a\tb='«c»'/>",
            [],
            """
             --> arm.sdf:1:8
              |
            1 |     <a  b='c'/>
              |            ^
            """,
            id="tabs",
        ),
        pytest.param(
            "<a n='🤖é'>«b»</a>",
            [],
            """
             --> arm.sdf:1:11
              |
            1 | <a n='🤖é'>b</a>
              |            ^
            """,
            id="wide character",
        ),
        pytest.param(
            "<a n='e\u0301'>«b»</a>",
            [],
            """
             --> arm.sdf:1:11
              |
            1 | <a n='e\u0301'>b</a>
              |          ^
            """,
            id="combining character",
        ),
        pytest.param(
            "<a>\r\n  «b»\r\n</a>\r\n",
            [],
            """
             --> arm.sdf:2:3
              |
            2 |   b
              |   ^
            """,
            id="CRLF",
        ),
        pytest.param(
            "<a>\n  <b>«text  \n  more\n</b>»\n</a>",
            [],
            """
             --> arm.sdf:2:6
              |
            2 |   <b>text
              |      ^^^^
            """,
            id="several lines",
        ),
        pytest.param(
            "<a>«\r\n  more»\r\n</a>",
            [],
            """
             --> arm.sdf:1:4
              |
            1 | <a>
              |    ^
            """,
            id="several lines from a line end on",
        ),
        pytest.param(
            "<a>\n</a«»",
            [],
            """
             --> arm.sdf:2:4
              |
            2 | </a
              |    ^
            """,
            id="end of file",
        ),
        pytest.param(
            "<a/>\n«»",
            [],
            """
             --> arm.sdf:2:1
              |
            2 |
              | ^
            """,
            id="end of file after a line end",
        ),
        pytest.param(
            "«»",
            [],
            """
             --> arm.sdf:1:1
              |
            1 |
              | ^
            """,
            id="empty file",
        ),
    ],
)
def test_frames(text: str, labels: list[str], expected: str) -> None:
    assert shown(diagnostic(text, *labels)) == dedent(expected).strip("\n")


def test_long_lines_are_clipped_around_each_place() -> None:
    code, mark, far, there = shown(
        diagnostic("x" * 1000 + "«bad»" + "y" * 1000 + "{z}" + "w" * 10, "far")
    ).splitlines()[2:]
    assert code == "1 | …" + "x" * 30 + "bad" + "y" * 87 + "…"
    assert mark == "  | " + " " * 31 + "^^^"
    assert far == "1 | …" + "y" * 109 + "z" + "w" * 10
    assert there == "  | " + " " * 110 + "- far"


def test_a_mark_longer_than_the_view_runs_on_below_the_ellipsis() -> None:
    code, mark = shown(diagnostic("<a «" + "b" * 500 + "»>")).splitlines()[2:]
    assert code == "1 | <a " + "b" * 117 + "…"
    assert mark == "  |    " + "^" * 118


def test_a_label_in_a_file_that_is_not_shown_is_beside_its_place() -> None:
    other = Source(Path("bridge.yaml"), "topic: scan\n", is_foreign=True)
    found = diagnostic('<a «x="1"»/>', labels=(Label(other.span(7, 11), "taken here"),))
    assert shown(found).splitlines()[-1] == " ::: bridge.yaml:1:8: taken here"
