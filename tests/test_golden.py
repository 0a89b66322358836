"""The output for whole folders of ``fixtures/``; ``make golden`` writes it again."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.main import main

FIXTURES = Path(__file__).parents[1] / "fixtures"
FOLDERS = [FIXTURES / "robots", *sorted(path for path in (FIXTURES / "lint").iterdir() if path.is_dir())]
CONFIGURATION = "sdfcheck.toml"
EXPECTED = "expected.txt"


def lint(capsys: pytest.CaptureFixture[str]) -> str:
    """The concise report on the current folder."""
    configured = ["--config", CONFIGURATION] if Path(CONFIGURATION).exists() else ["--isolated"]
    shown = ["--output-format", "concise", "--no-fold", "--min-severity", "info", "--color", "never"]
    code = main(["lint", *configured, "--exit-zero", *shown])
    out, err = capsys.readouterr()
    assert code == 0, err
    return out


@pytest.mark.parametrize("folder", FOLDERS, ids=lambda folder: folder.name)
def test_the_report_is_as_expected(
    folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    request: pytest.FixtureRequest,
) -> None:
    monkeypatch.chdir(folder)
    report = lint(capsys)
    expected = folder / EXPECTED
    if request.config.getoption("--golden"):
        expected.write_text(report, encoding="utf-8")
    assert report == expected.read_text(encoding="utf-8")
