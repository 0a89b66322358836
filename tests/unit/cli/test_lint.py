import io
import json
import sys
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from tests.unit.lint.fake_engine import Seen, install

SDF = '<sdf version="1.9">{}</sdf>'


class Outcome:
    """The exit code and what was written."""

    def __init__(self, code: int, out: str, err: str) -> None:
        self.code, self.out, self.err = code, out, err


class Shell:
    """Runs command lines in a folder of its own."""

    def __init__(self, capsys: pytest.CaptureFixture[str]) -> None:
        self._capsys = capsys

    def __call__(self, *arguments: str) -> Outcome:
        code = main(arguments)
        out, err = self._capsys.readouterr()
        return Outcome(code, out, err)

    def lint(self, *arguments: str) -> Outcome:
        return self("lint", *arguments)


@pytest.fixture
def shell(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path, seen: list[Seen]
) -> Shell:
    monkeypatch.chdir(tmp_path)
    for variable in ("NO_COLOR", "FORCE_COLOR", "SDFCHECK_DEBUG"):
        monkeypatch.delenv(variable, raising=False)
    Path("good.sdf").write_text(SDF.format(""))
    Path("odd.sdf").write_text(SDF.format("?"))
    Path("loud.sdf").write_text(SDF.format("!"))
    return Shell(capsys)


@pytest.fixture
def seen(monkeypatch: pytest.MonkeyPatch) -> list[Seen]:
    return install(monkeypatch)


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ("good.sdf", 0),
        ("odd.sdf", 1),
        ("loud.sdf", 1),
        (".", 1),
        ("", 1),
        ("odd.sdf --fail-on error", 0),
        ("loud.sdf --fail-on error", 1),
        ("odd.sdf --max-warnings 1", 0),
        ("odd.sdf --max-warnings 0", 1),
        ("loud.sdf --max-warnings 9", 1),
        ("odd.sdf --fail-on error --max-warnings 0", 1),
        (". --exit-zero", 0),
        ("odd.sdf --ignore BBB", 0),
        ("odd.sdf --select AAA,CCC", 0),
        ("odd.sdf --select AAA --select odd-flaw", 1),
        ("odd.sdf --target gazebo", 0),
        ("gone.sdf", 2),
        ("good.sdf --select XYZ", 2),
        ("good.sdf --target gazbo", 2),
        ("good.sdf --output-format pretty", 2),
        ("good.sdf --fail-on fatal", 2),
        ("good.sdf --no-such-option", 2),
        ("good.sdf --config gone.toml", 2),
        ("good.sdf --isolated --config gone.toml", 2),
        ("good.sdf --stdin-filename x.sdf", 2),
        ("good.sdf --output-format json --output-format sarif", 2),
        ("good.sdf --output-file gone/report.txt", 2),
    ],
)
def test_exit_codes(shell: Shell, arguments: str, code: int) -> None:
    outcome = shell.lint(*arguments.split())
    assert outcome.code == code
    if code == 2:
        assert not outcome.out
        assert outcome.err.rstrip().splitlines()[-1].lower().startswith("error: ")


def test_a_missing_path_is_one_line(shell: Shell) -> None:
    assert shell.lint("gone.sdf").err == "error: no such file or folder: gone.sdf\n"
    hint = "an argument of xacro is written `side:=left`"
    assert shell.lint("side=left").err == f"error: no such file or folder: side=left; {hint}\n"


def test_a_missing_folder_of_the_configuration_is_a_warning(shell: Shell) -> None:
    Path("sdfcheck.toml").write_text('model-paths = ["."]\npackage-paths = ["gone"]\n')
    outcome = shell("lint", "good.sdf")
    assert (outcome.code, outcome.err) == (0, "warning: sdfcheck.toml:2: no such folder: gone\n")


def test_a_near_miss_is_suggested(shell: Shell) -> None:
    assert "did you mean `odd-flaw`?" in shell.lint("--select", "od-flaw", ".").err
    assert "did you mean `concise`?" in shell.lint("--output-format", "concice", ".").err
    assert "did you mean `lint`?" in shell("lnt", ".").err


def test_stdout_holds_the_report_only(shell: Shell) -> None:
    Path("mol.sdf").write_text("x\n\n\n  1  0  V2000\n")
    outcome = shell.lint("odd.sdf", "mol.sdf", "--output-format", "json")
    assert json.loads(outcome.out)["diagnostics"][0]["code"] == "BBB001"
    notice, summary = outcome.err.splitlines()
    assert notice == "note: mol.sdf: looks like a chemical structure-data file, not linted"
    assert summary.startswith("Found 1 warning in 1 file")
    assert shell.lint("odd.sdf", "mol.sdf", "--output-format", "json", "--quiet").err == ""


def test_reports_for_people_sum_up_themselves(shell: Shell) -> None:
    outcome = shell.lint("odd.sdf", "--output-format", "concise")
    assert outcome.out.splitlines()[0] == "odd.sdf:1:20: warning: it is ? [BBB001]"
    assert outcome.err == ""


def test_a_failure_outlives_quiet_and_exit_zero(shell: Shell) -> None:
    Path("raw.sdf").write_bytes(b"\0\1\2")
    outcome = shell.lint("raw.sdf", "loud.sdf", "--quiet", "--exit-zero")
    assert outcome.code == 2
    assert "AAA001" in outcome.out
    assert outcome.err == "error: raw.sdf: looks like binary content, not linted\n"


def test_an_empty_folder_is_worth_a_warning(shell: Shell) -> None:
    Path("empty").mkdir()
    outcome = shell.lint("empty")
    assert outcome.code == 0
    assert outcome.err == "warning: no SDFormat, URDF, xacro or model.config file in empty\n"


def test_several_reports_at_once(shell: Shell) -> None:
    outcome = shell.lint("odd.sdf", "--output-format", "concise", "--output-format", "json=out.json")
    assert "[BBB001]" in outcome.out
    assert json.loads(Path("out.json").read_text())["diagnostics"]
    outcome = shell.lint("odd.sdf", "--output-format", "jsonl", "--output-file", "out.jsonl")
    assert outcome.out == ""
    assert json.loads(Path("out.jsonl").read_text())["code"] == "BBB001"


def test_statistics_replace_the_report_on_stdout(shell: Shell) -> None:
    outcome = shell.lint(".", "--statistics", "--output-format", "json=out.json", "--output-format", "full")
    assert "it is" not in outcome.out
    assert "odd-flaw" in outcome.out
    assert len(json.loads(Path("out.json").read_text())["diagnostics"]) == 2


def test_the_configuration_of_the_current_folder_settles_the_run(shell: Shell) -> None:
    Path("sdfcheck.toml").write_text('fail-on = "error"\noutput-format = ["concise"]')
    outcome = shell.lint("odd.sdf")
    assert outcome.code == 0
    assert "odd.sdf:1:20: warning" in outcome.out
    assert shell.lint("odd.sdf", "--isolated").code == 1
    assert shell.lint("odd.sdf", "--fail-on", "warning", "--output-format", "full").code == 1


def test_stdin_is_read_for_a_dash(shell: Shell, monkeypatch: pytest.MonkeyPatch, seen: list[Seen]) -> None:
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"<robot>!</robot>")))
    outcome = shell.lint("-", "--stdin-filename", "sub/x.urdf", "--output-format", "concise")
    assert outcome.out.startswith("sub/x.urdf:1:8: error")
    assert [entry.data for entry in seen] == [b"<robot>!</robot>"]


def test_files_are_listed_without_being_linted(shell: Shell, seen: list[Seen]) -> None:
    Path("mol.sdf").write_text("x\n\n\n  1  0  V2000\n")
    outcome = shell.lint("--show-files")
    assert outcome.out == "good.sdf\nloud.sdf\nodd.sdf\n"
    assert outcome.err == "skipped: mol.sdf: looks like a chemical structure-data file\n"
    assert outcome.code == 0
    assert not seen


def test_settings_are_shown_for_the_first_path(shell: Shell) -> None:
    Path("sub").mkdir()
    Path("sub/sdfcheck.toml").write_text('ignore = ["BBB"]')
    for path in ("sub", "sub/x.sdf"):
        Path("sub/x.sdf").touch()
        outcome = shell.lint(path, "--show-settings")
        assert outcome.out.splitlines()[0] == "# from sub/sdfcheck.toml"
        assert 'ignore = ["BBB"]' in outcome.out
    assert shell.lint("--show-settings").out.startswith("# no configuration file\n")
    assert shell.lint("gone", "--show-settings").code == 2


def test_settings_are_shown_with_where_they_are_set(shell: Shell) -> None:
    Path("base.toml").write_text('target = ["drake"]\nignore = ["BBB"]\n\n[severity]\nNS = "off"\n')
    Path("sdfcheck.toml").write_text('extend = "base.toml"\nfail-on = "error"\n')
    lines = shell.lint("--show-settings", "--ignore", "CCC", "--target", "gazebo").out.splitlines()
    failing = shell.lint("--show-settings", "--fail-on", "info", "--output-format", "json").out.splitlines()
    assert {'fail-on = "info"  # --fail-on', 'output-format = ["json"]  # --output-format'} <= set(failing)
    assert lines[:2] == ["# from sdfcheck.toml", "# from base.toml"]
    assert 'target = ["gazebo"]  # --target' in lines
    assert 'ignore = ["BBB", "CCC"]  # base.toml:2, --ignore' in lines
    assert 'fail-on = "error"  # sdfcheck.toml:2' in lines
    assert "[severity]  # base.toml:4" in lines
    assert "exclude = []" in lines


@pytest.mark.parametrize(
    ("option", "environment", "colored"),
    [
        ("auto", {}, False),
        ("auto", {"FORCE_COLOR": "1"}, True),
        ("auto", {"FORCE_COLOR": "1", "NO_COLOR": "1"}, False),
        ("always", {"NO_COLOR": "1"}, True),
        ("never", {"FORCE_COLOR": "1"}, False),
    ],
)
def test_colors(
    shell: Shell, monkeypatch: pytest.MonkeyPatch, option: str, environment: dict[str, str], colored: bool
) -> None:
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    assert ("\x1b[" in shell.lint("odd.sdf", "--color", option).out) is colored


def test_a_bug_is_one_line_and_says_how_to_report_it(shell: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    Path("crash.sdf").write_text(SDF.format("crash"))
    outcome = shell.lint("crash.sdf")
    assert outcome.code == 2
    assert outcome.err.startswith("error: crash.sdf: internal error: ValueError: no luck (this is a bug")
    assert outcome.err.splitlines()[1:] == []
    assert "odd.sdf" in shell.lint("crash.sdf", "odd.sdf").out
    monkeypatch.setenv("SDFCHECK_DEBUG", "1")
    with pytest.raises(Exception, match="no\nluck"):
        shell.lint("crash.sdf")


def test_an_interrupt_ends_with_130(shell: Shell, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(*arguments: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("sdfcheck.lint.one_file.lint_source", interrupted)
    outcome = shell.lint("good.sdf")
    assert outcome.code == 130
    assert "Traceback" not in outcome.err


def test_a_file_that_no_report_goes_to_is_refused(shell: Shell) -> None:
    Path("a.sdf").write_text('<sdf version="1.12"/>')
    outcome = shell.lint("a.sdf", "--output-format", "json=one.json", "--output-file", "two.json")
    assert outcome.code == 2
    assert "each --output-format names its own file, so that nothing goes to two.json" in outcome.err
    assert not Path("one.json").exists()


def test_the_closing_line_counts_what_the_reports_count(shell: Shell) -> None:
    link = (
        '<link name="l"><visual><geometry><mesh filename="package://far/m.stl"/></geometry></visual></link>'
    )
    Path("a.urdf").write_text(f'<robot name="r">{link}</robot>')
    outcome = shell.lint("a.urdf", "--output-format", "markdown=a.md")
    assert "warning" not in outcome.err, outcome.err


def test_names_of_findings_of_simulations_are_known(shell: Shell) -> None:
    Path("a.urdf").write_text(
        '<robot name="r"><!-- sdfcheck:ignore[SIM008] held by a brake --><link name="l"/></robot>'
    )
    Path("sdfcheck.toml").write_text('ignore = ["weak-joint"]')
    assert shell.lint("a.urdf").code == 0
    outcome = shell.lint("a.urdf", "--select", "SIM008")
    assert outcome.code == 2
    assert "`sdfcheck simulate` finds `SIM008`, and no rule does" in outcome.err
