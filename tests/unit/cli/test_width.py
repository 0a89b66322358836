"""The width of the output on a terminal: nothing wraps, and marks are below the text that they mark."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from unicodedata import normalize

import pytest

from sdfcheck.cli.convert.command import COMMANDS as CONVERSIONS
from sdfcheck.cli.main import COMMANDS, main
from sdfcheck.release import HOME
from tests.unit.cli.terminals import Terminal, cells, screen

PATROL = Path(__file__).parents[3] / "fixtures" / "robots" / "with_mistakes" / "patrol_bot.sdf"
WIDTHS = (80, 100, 160)
LINES = [[name] for name in COMMANDS if name != "convert"] + [["convert", name] for name in CONVERSIONS]
NAMES = ("機械腕の土台と手首", "🤖🦾 arm 👩‍🔧", "e\u0301le\u0301vateur\u0300", "plain")
"""Wide, wider than one character, combining, and neither."""


Run = Callable[..., list[str]]
"""Runs a command line; gives the rows of the screen that are not empty."""


@pytest.fixture(params=WIDTHS)
def width(request: pytest.FixtureRequest) -> int:
    chosen: int = request.param
    return chosen


@pytest.fixture
def run(width: int, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Run:
    monkeypatch.chdir(tmp_path)
    for name in ("NO_COLOR", "FORCE_COLOR", "CI"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("TERM", "xterm-kitty")
    monkeypatch.setenv("COLUMNS", str(width))

    def run(*arguments: str, aside: bool = False) -> list[str]:
        out, err = Terminal(), Terminal()
        monkeypatch.setattr("sys.stdout", out)
        monkeypatch.setattr("sys.stderr", err)
        main(arguments)
        return shown((err if aside else out).getvalue(), width)

    return run


def shown(text: str, width: int) -> list[str]:
    """The rows of a screen after a text, in which no line may be longer than a row."""
    lines = text.rstrip("\n").split("\n")
    wrapped = [line for line in lines if any(screen(line, width, 9)[1:])]
    assert wrapped == []
    rows = screen("\n".join(lines), width, len(lines) + 9)
    return rows[: len(lines)]


def as_shown(text: str) -> str:
    """A text as the screen has it: composed, without joiners."""
    return normalize("NFC", text).replace("\u200d", "")


def marked(rows: list[str], width: int) -> Iterator[str]:
    """The text above each `^^^`."""
    for number, row in enumerate(rows):
        for strokes in re.finditer(r"\^+", row) if re.match(r" *\| ", row) else ():
            below = cells(row, width)
            columns = [column for column, cell in enumerate(below) if cell == "^"]
            assert len(columns) == len(strokes[0])
            above = cells(rows[number - 1], width)
            yield as_shown("".join(above[column] for column in columns))


def robot(name: str) -> str:
    links = "".join(f'<link name="{name} {number}"/>' for number in range(4))
    return (
        f'<sdf version="1.12"><model name="{name}">{links}\n'
        f'  <link name="{name} a"><pose relative_to="{name} q">0 0 0 0 0 0</pose></link>'
        f"<!-- {name * 20} --></model></sdf>\n"
    )


@pytest.mark.parametrize("name", NAMES)
def test_reports_fit_and_mark_the_place(name: str, run: Run, width: int) -> None:
    Path("a.sdf").write_text(robot(name), encoding="utf-8")
    rows = run("lint", "--isolated", "--select", "FRM001", "a.sdf")
    assert rows[0].startswith("error[FRM001]: `relative_to` names")
    assert list(marked(rows, width)) == [as_shown(f"{name} q")]


@pytest.mark.parametrize("name", NAMES)
def test_frames_are_cut_around_the_place(name: str, run: Run, width: int) -> None:
    text = robot(name).replace("\n", " ").replace("<link", f"<!-- {name * 9} --><link", 1)
    Path("a.sdf").write_text(text, encoding="utf-8")
    rows = run("lint", "--isolated", "--select", "FRM001", "a.sdf")
    (code,) = (row for row in rows if row.startswith("1 | "))
    assert code.startswith("1 | …")
    assert code.endswith("…")
    assert list(marked(rows, width)) == [as_shown(f"{name} q")]


@pytest.mark.parametrize("name", NAMES)
def test_labels_go_on_below_where_they_do_not_fit(name: str, run: Run, width: int) -> None:
    far = "x" * (width - 60)
    Path("a.sdf").write_text(
        f'<sdf version="1.12"><model name="m">\n<link name="{far}{name}"/>\n<link name="b"/>\n'
        f'<joint name="{far}{name}" type="fixed"><parent>b</parent><child>{far}{name}</child></joint></model></sdf>',
        encoding="utf-8",
    )
    rows = run("lint", "--isolated", "--select", "NAM", "a.sdf")
    assert any(row.startswith("error[NAM") for row in rows)
    assert len(list(marked(rows, width))) == 1


@pytest.mark.parametrize("name", NAMES)
def test_overviews_and_closing_lines_fit(name: str, run: Run) -> None:
    text = PATROL.read_text(encoding="utf-8").replace("patrol_bot", name).replace("hull", f"{name}hull")
    Path("a.sdf").write_text(text, encoding="utf-8")
    rows = run("lint", "--isolated", "a.sdf")
    assert any("by rule" in row for row in rows)
    rows = run("lint", "--isolated", "--statistics", "a.sdf")
    assert rows[0].split() == ["count", "severity", "rule", "name", "fix"]
    assert rows[-1].endswith(").")


def test_missing_packages_fit(run: Run) -> None:
    includes = "".join(
        f"<include><uri>model://nowhere_to_be_found_{number}</uri></include>" for number in range(9)
    )
    Path("a.sdf").write_text(f'<sdf version="1.12"><world name="w">{includes}</world></sdf>')
    rows = run("lint", "--isolated", "a.sdf")
    assert rows[0] == "Not found on this computer, so not checked:"
    assert any("--model-path" in row for row in rows)


def test_rules_fit(run: Run, width: int) -> None:
    rows = run("rules")
    assert rows[0].split() == ["rule", "name", "severity", "fix"]
    assert not any(row.endswith("…") for row in rows)
    assert any(len(row) > width - 12 for row in rows)
    assert run("rule", "NS003")[0].strip()


@pytest.mark.parametrize("line", LINES, ids=" ".join)
def test_help_fits(line: list[str], run: Run) -> None:
    rows = run(*line, "--help")
    assert rows[0].startswith("Usage: sdfcheck")


@pytest.mark.parametrize("name", NAMES)
def test_losses_fit(name: str, run: Run) -> None:
    sensors = "".join(
        f'<sensor name="{name}{number}" type="altimeter"><pose>0 0 {number} 0 0 0</pose></sensor>'
        for number in range(9)
    )
    Path("a.sdf").write_text(
        f'<sdf version="1.12"><world name="w"><model name="m"><link name="{name}">{sensors}<light name="s" '
        'type="point"><cast_shadows>1</cast_shadows></light></link></model><model name="other">'
        '<link name="l"/></model></world></sdf>',
        encoding="utf-8",
    )
    rows = run(
        *("convert", "sdf-to-urdf", "--isolated", "--model", "m", "--min-severity", "info", "-o", "m.urdf"),
        "a.sdf",
    )
    assert any("[CNV" in row for row in rows)
    rows = run(
        *("convert", "sdf-to-urdf", "--isolated", "--model", "m", "--min-severity", "info", "-o", "m.urdf"),
        *("--losses", "all", "a.sdf"),
    )
    assert any("CNV" in row for row in rows)


def test_codes_lead_to_the_pages_of_rules(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TERM", "xterm-kitty")
    for name in ("NO_COLOR", "FORCE_COLOR", "CI"):
        monkeypatch.delenv(name, raising=False)
    Path("a.sdf").write_text(robot("plain"))
    page = f"{HOME}/latest/rules/unknown-frame/\x1b\\"

    def written(*arguments: str) -> str:
        out = Terminal()
        monkeypatch.setattr("sys.stdout", out)
        main(arguments)
        return out.getvalue()

    for options in ((), ("--output-format", "concise"), ("--statistics",)):
        line = ("lint", "--isolated", "--select", "FRM001", "a.sdf", *options)
        assert page in written(*line)
        assert "\x1b]8" not in written(*line, "--color", "never")
        main((*line, "-o", "report.txt"))
    assert "\x1b" not in Path("report.txt").read_text()
    assert page in written("rules", "FRM")
    monkeypatch.setenv("NO_COLOR", "1")
    assert "\x1b" not in written("lint", "--isolated", "a.sdf")


def test_the_keys_of_configurations(run: Run) -> None:
    assert any(row.startswith("per-file-ignores") for row in run("config"))
