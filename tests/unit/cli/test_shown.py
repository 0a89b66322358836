"""How much ``sdfcheck lint`` shows, and which exit code it earns."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.main import main

INCLUDING = (
    '<sdf version="1.12"><world name="w"><include><uri>model://nowhere_at_all</uri></include></world></sdf>'
)
REPEATED = '<sdf version="1.12"><model name="m"><link name="l">{}</link></model></sdf>'


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def lint(capsys: pytest.CaptureFixture[str], text: str, *options: str) -> tuple[int, str]:
    Path("some.sdf").write_text(text, encoding="utf-8")
    code = main(["lint", "--isolated", "some.sdf", *options])
    return code, capsys.readouterr().out


def test_files_not_on_this_computer_fail_no_run_unless_asked(capsys: pytest.CaptureFixture[str]) -> None:
    code, out = lint(capsys, INCLUDING)
    assert code == 0
    assert "1 model (needed 1 time): `nowhere_at_all`" in out
    assert lint(capsys, INCLUDING, "--fail-on-missing")[0] == 1
    assert lint(capsys, INCLUDING, "--fail-on-missing", "--exit-zero")[0] == 0
    assert '"RES002"' in lint(capsys, INCLUDING, "--output-format", "json")[1]
    code, out = lint(capsys, INCLUDING, "--no-fold")
    assert code == 0
    assert "warning[RES002]" in out


def test_repeated_findings_are_folded_unless_asked(capsys: pytest.CaptureFixture[str]) -> None:
    odd = REPEATED.format("".join(f"<odd{number}/>" for number in range(6)))
    code, out = lint(capsys, odd)
    assert code == 1
    assert out.count("[NS002]") == 1
    assert "5 more in this file: 1:" in out
    assert lint(capsys, odd, "--no-fold")[1].count("[NS002]") == 6
    assert lint(capsys, odd, "--output-format", "jsonl")[1].count("NS002") == 6
    assert lint(capsys, odd, "--no-fold", "--max-diagnostics", "2")[1].count("[NS002]") == 2


def test_infos_are_shown_where_asked_and_where_they_fail_the_run(capsys: pytest.CaptureFixture[str]) -> None:
    dull = '<sdf version="1.12" xmlns:a="b"><model name="m"><link name="l"/></model></sdf>'
    code, out = lint(capsys, dull)
    assert (code, "[NS007]" in out) == (0, False)
    code, out = lint(capsys, dull, "--min-severity", "info")
    assert (code, "[NS007]" in out) == (0, True)
    code, out = lint(capsys, dull, "--fail-on", "info")
    assert (code, "[NS007]" in out) == (1, True)
