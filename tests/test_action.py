"""The GitHub action: what it installs, and what it runs."""

from __future__ import annotations

import importlib.util
import re
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parents[1]


@pytest.fixture(scope="module")
def action() -> ModuleType:
    spec = importlib.util.spec_from_file_location("action", ROOT / "action.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize(
    ("version", "expected"),
    [
        ("", "here"),
        (" ", "here"),
        ("latest", "sdfcheck"),
        ("1.2.3", "sdfcheck==1.2.3"),
        ("2.0rc1", "sdfcheck==2.0rc1"),
    ],
)
def test_the_version_to_install(action: ModuleType, version: str, expected: str) -> None:
    assert action.requirement({"SDFCHECK_VERSION": version}, Path("here")) == expected


@pytest.mark.parametrize("version", ["1.0 --index-url x", "git+https://example.org/x", "-r x", "1.0; x"])
def test_only_versions_are_versions(action: ModuleType, version: str) -> None:
    with pytest.raises(ValueError, match="is not a version"):
        action.requirement({"SDFCHECK_VERSION": version}, Path("here"))


def test_the_inputs_become_arguments(action: ModuleType) -> None:
    given = {
        "SDFCHECK_PATHS": "models 'my worlds'\nrobot.urdf",
        "SDFCHECK_ARGS": '--fail-on error --ignore "NS003"',
        "SDFCHECK_SARIF": "out.sarif",
    }
    assert action.options(given) == [
        *("lint", "--output-format", "github", "--output-format", "sarif=out.sarif"),
        *("--fail-on", "error", "--ignore", "NS003", "--", "models", "my worlds", "robot.urdf"),
    ]
    assert action.options({}) == ["lint", "--output-format", "github", "--", "."]


def test_nothing_is_a_command_of_a_shell() -> None:
    text = (ROOT / "action.yml").read_text(encoding="utf-8")
    (run,) = re.findall(r"^ +run: (.*)$", text, re.MULTILINE)
    assert run == 'python3 "${GITHUB_ACTION_PATH}/action.py"'
    named = set(re.findall(r"(SDFCHECK_\w+): \$\{\{ inputs\.(\w+) \}\}", text))
    assert {(variable, f"SDFCHECK_{name.upper()}") for variable, name in named} == {(v, v) for v, _ in named}
    used = set(re.findall(r"SDFCHECK_\w+", (ROOT / "action.py").read_text(encoding="utf-8")))
    assert used == {variable for variable, _ in named}


def test_it_runs(
    action: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "a.sdf").write_text('<sdf version="1.9"><!-- -- --><world name="w"/></sdf>')
    output = tmp_path / "output"
    installed: list[str] = []

    def install(what: str, folder: Path) -> list[str]:
        installed.append(what)
        return [sys.executable, "-I", "-m", "sdfcheck"]

    monkeypatch.setattr(action, "install", install)
    monkeypatch.chdir(tmp_path)
    given = {"GITHUB_OUTPUT": str(output), "RUNNER_TEMP": str(tmp_path), "SDFCHECK_SARIF": "out.sarif"}
    assert action.main(given) == 1
    assert installed == [str(ROOT)]
    assert "::warning" in capfd.readouterr().out
    assert output.read_text() == "exit-code=1\n"
    assert (tmp_path / "out.sarif").exists()
    assert action.main({"SDFCHECK_ARGS": "'"}) == 2
    assert "No closing quotation" in capfd.readouterr().out


def test_a_summary_and_a_report(
    action: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "a.sdf").write_text('<sdf version="1.9"><!-- -- --><world name="w"/></sdf>')
    output, summary, report = tmp_path / "output", tmp_path / "summary", tmp_path / "sdfcheck-report.html"
    summary.write_text("# Another step\n")
    report.write_text("of another step")
    monkeypatch.setattr(action, "install", lambda what, folder: [sys.executable, "-I", "-m", "sdfcheck"])
    monkeypatch.chdir(tmp_path)
    given = {
        "GITHUB_OUTPUT": str(output),
        "GITHUB_STEP_SUMMARY": str(summary),
        "RUNNER_TEMP": str(tmp_path),
        "SDFCHECK_REPORT": "sdfcheck-report",
    }
    assert action.main(given) == 1
    lines = summary.read_text().splitlines()
    assert lines[:2] == ["# Another step", "## sdfcheck"]
    assert "Found 1 warning" in lines[3]
    assert output.read_text() == f"exit-code=1\nreport={report}\n"
    assert report.read_text().startswith("<!doctype html>")
    output.unlink()
    assert action.main({**given, "SDFCHECK_PATHS": "missing.sdf"}) == 2
    assert output.read_text() == "exit-code=2\n"
    assert summary.read_text().splitlines() == lines


def test_it_says_that_it_cannot_be_installed(
    action: ModuleType, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    def install(what: str, folder: Path) -> list[str]:
        raise subprocess.CalledProcessError(1, ["pip"])

    monkeypatch.setattr(action, "install", install)
    assert action.main({}) == 2
    assert "::error title=sdfcheck::cannot be installed" in capfd.readouterr().out


def test_it_installs_where_python_has_no_environments(
    action: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    ran: list[list[str]] = []

    def run(command: list[object], **_: object) -> subprocess.CompletedProcess[bytes]:
        ran.append([str(word) for word in command])
        return subprocess.CompletedProcess(ran[-1], int("venv" in ran[-1]))

    monkeypatch.setattr(action.subprocess, "run", run)
    start = action.install("sdfcheck==1.0", tmp_path / "own")
    assert ran[-1][-3:] == ["--target", str(tmp_path / "own"), "sdfcheck==1.0"]
    assert start[:3] == [sys.executable, "-I", "-c"]
    assert str(tmp_path / "own") in start[3]
