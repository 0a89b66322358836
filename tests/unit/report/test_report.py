"""Formats as a whole: names, loading, paths, the closing line, statistics, one-line text."""

from __future__ import annotations

import subprocess
import sys
from importlib import import_module
from pathlib import Path

import pytest

from sdfcheck.files.discover import FAULTY
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.run import Run
from sdfcheck.report import OutputFormat, render
from sdfcheck.report import digest as statistics
from sdfcheck.report.paths import Paths
from sdfcheck.report.summary import View, closing_line
from tests.unit.report.runs import diagnostic, facts, fixed, marked, run

ERROR = diagnostic("«a»")
WARNING = diagnostic("«a»", code="SCH902", name="odd-thing", severity=Severity.WARNING)
INFO = diagnostic("«a»", code="STY903", name="dull-thing", severity=Severity.INFO)


@pytest.mark.parametrize("format", OutputFormat)
def test_every_format_renders_any_run_alike_each_time(format: OutputFormat) -> None:
    assert import_module(f"sdfcheck.report.formats.{format.value}").__doc__
    for sample in (run(), run(fixed(ERROR, "b"), WARNING, INFO, rules=(facts(),)), Run((), ())):
        text = render(format, sample)
        assert text == render(format, sample)
        assert text == "" or (text.endswith("\n") and not text.endswith("\n\n"))


@pytest.mark.parametrize("format", [kind for kind in OutputFormat if not kind.is_text])
def test_machines_get_no_colors_and_control_characters_only_escaped(format: OutputFormat) -> None:
    sample = run(diagnostic("<a>«\x1b[0m»", message="\x1b[31m\x9b red", path="\x1b.sdf"))
    text = render(format, sample, color=True)
    assert "\x1b" not in text
    assert "\x9b" not in text


@pytest.mark.parametrize("format", ["concise", "full"])
def test_text_formats_load_nothing_heavy(format: str) -> None:
    code = (
        "import sys; from pathlib import Path; before = set(sys.modules)\n"
        "from sdfcheck.report import OutputFormat, render\n"
        "assert 'sdfcheck.report.paths' not in sys.modules\n"
        "from sdfcheck.lint.diagnostic import Diagnostic, Severity\n"
        "from sdfcheck.lint.run import Run\n"
        "from sdfcheck.source.text import Source\n"
        "span = Source(Path('a.sdf'), '<a/>').span(1, 2)\n"
        "run = Run((Diagnostic('A001', 'a', Severity.ERROR, 'm', span),), (Path('a.sdf'),))\n"
        f"render(OutputFormat('{format}'), run)\n"
        "print(*sorted(set(sys.modules) - before))"
    )
    command = [sys.executable, "-S", "-c", code]
    root = Path(__file__).parents[3]
    loaded = subprocess.run(command, cwd=root, capture_output=True, text=True, check=True).stdout.split()
    heavy = {"json", "rich", "textwrap", "difflib", "dataclasses", "inspect", "unicodedata", "lxml"}
    assert f"sdfcheck.report.formats.{format}" in loaded
    assert not heavy & set(loaded)


def test_a_clean_run_loads_only_the_closing_line() -> None:
    code = (
        "import sys; from pathlib import Path\n"
        "from sdfcheck.lint.run import Run\n"
        "from sdfcheck.report import OutputFormat, render\n"
        "render(OutputFormat.FULL, Run((), (Path('a.sdf'),)))\n"
        "print(*(name for name in sys.modules if name.startswith('sdfcheck.report.')))"
    )
    root = Path(__file__).parents[3]
    command = [sys.executable, "-S", "-c", code]
    loaded = subprocess.run(command, cwd=root, capture_output=True, text=True, check=True).stdout.split()
    modules = ["sdfcheck.report.formats", "sdfcheck.report.formats.full", "sdfcheck.report.summary"]
    assert sorted(loaded) == modules


def test_paths_below_the_folder_are_relative_and_others_as_given(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = tmp_path / "robot"
    here.mkdir()
    monkeypatch.chdir(here)
    paths = Paths()
    assert paths(here / "models" / "arm.sdf") == "models/arm.sdf"
    assert paths(Path("models/../arm.sdf")) == "arm.sdf"
    assert paths(Path("../arm.sdf")) == "../arm.sdf"
    assert paths(tmp_path / "robots.sdf") == (tmp_path / "robots.sdf").as_posix()
    assert paths(Path("bad\udcff.sdf")) == "bad?.sdf"
    span, _ = marked("\n <«a»/>", str(here / "arm.sdf"))
    assert paths.place(span) == "arm.sdf:2:3"


def test_paths_count_from_the_checkout_of_a_ci_service(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "robot").mkdir()
    monkeypatch.chdir(tmp_path / "robot")
    assert Paths("GITHUB_WORKSPACE")(Path("arm.sdf")) == "arm.sdf"
    monkeypatch.setenv("GITHUB_WORKSPACE", str(tmp_path))
    assert Paths("GITHUB_WORKSPACE")(Path("arm.sdf")) == "robot/arm.sdf"
    assert "file=robot/arm.sdf," in render(OutputFormat.GITHUB, run(ERROR))
    assert '"uri": "robot/arm.sdf"' in render(OutputFormat.SARIF, run(ERROR))
    assert render(OutputFormat.CONCISE, run(ERROR)).startswith("arm.sdf:1:1:")


SAFE, UNSAFE = fixed(ERROR, "b"), fixed(ERROR, "b", safe=False)


@pytest.mark.parametrize(
    ("sample", "expected"),
    [
        (run(), "All clear: 1 file, no findings."),
        (run(files=12), "All clear: 12 files, no findings."),
        (run(files=2, suppressed=3), "All clear: 2 files, no findings (3 suppressed)."),
        (
            run(suppressed=1, skipped=((Path("b.sdf"), "template"),)),
            "All clear: 1 file, no findings (1 suppressed, 1 file skipped).",
        ),
        (Run((), ()), "No files to lint."),
        (Run((), (), skipped=((Path("b.sdf"), "empty"),) * 2), "No files to lint (2 files skipped)."),
        (run(ERROR), "Found 1 error in 1 file."),
        (run(ERROR, suppressed=4, files=2), "Found 1 error in 2 files."),
        (
            run(ERROR, skipped=((Path("test/bad.sdf"), FAULTY), (Path("b.sdf"), "template"))),
            "Found 1 error in 1 file (1 test of faulty files left out).",
        ),
        (run(WARNING, ERROR, WARNING, files=3), "Found 1 error and 2 warnings in 3 files."),
        (run(ERROR, WARNING, INFO), "Found 1 error, 1 warning and 1 info in 1 file."),
        (run(INFO, INFO), "Found 2 infos in 1 file."),
        (run(SAFE, ERROR), "Found 2 errors in 1 file (1 fixable with --fix)."),
        (
            run(SAFE, UNSAFE, UNSAFE),
            "Found 3 errors in 1 file (1 fixable with --fix, 2 more with --unsafe-fixes).",
        ),
        (run(UNSAFE), "Found 1 error in 1 file (1 fixable with --fix --unsafe-fixes)."),
        (run(ERROR, fixed=1), "Fixed 1 of 2 findings. Found 1 error in 1 file."),
        (run(fixed=7), "Fixed 7 findings. All clear: 1 file, no findings."),
    ],
)
def test_closing_line(sample: Run, expected: str) -> None:
    assert closing_line(sample) == expected


def test_concise() -> None:
    second = diagnostic("\n «a»", path="world.sdf", severity=Severity.WARNING)
    sample = run(SAFE, UNSAFE, second)
    assert render(OutputFormat.CONCISE, sample).splitlines()[:-1] == [
        "arm.sdf:1:1: error: name `a` is taken [NAM901] (safe fix)",
        "arm.sdf:1:1: error: name `a` is taken [NAM901] (unsafe fix)",
        "world.sdf:2:2: warning: name `a` is taken [NAM901]",
    ]
    colored = render(OutputFormat.CONCISE, run(ERROR), color=True)
    assert colored.startswith("\x1b[1marm.sdf:1:1\x1b[0m: \x1b[1;31merror\x1b[0m: name")


def repeated(found: Diagnostic, times: int) -> tuple[Diagnostic, ...]:
    return (found,) * times


def test_statistics_are_of_what_is_shown() -> None:
    shown = statistics.render(run(ERROR, *repeated(INFO, 2)), view=View(Severity.WARNING))
    assert shown.startswith("1  error")
    assert "STY903" not in shown


def test_statistics() -> None:
    sample = run(
        *repeated(INFO, 2),
        *repeated(WARNING, 12),
        *repeated(ERROR._replace(severity=Severity.WARNING), 1),
        fixed(ERROR, "b"),
        fixed(ERROR._replace(code="SCH0004", name="other"), "b", safe=False),
    )
    assert statistics.render(sample) == (
        "12  warning  SCH902   odd-thing\n"
        " 2  info     STY903   dull-thing\n"
        " 1  error    NAM901   taken-name  safe fix\n"
        " 1  warning  NAM901   taken-name\n"
        " 1  error    SCH0004  other       unsafe fix\n"
        "\n"
        "Found 2 errors, 13 warnings and 2 infos in 1 file "
        "(1 fixable with --fix, 1 more with --unsafe-fixes).\n"
    )
    assert statistics.render(run()) == "All clear: 1 file, no findings.\n"
