from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.lint.suppress.baseline import read
from sdfcheck.source.errors import WrongUsage

ONE = '<sdf version="1.9"><!-- -- --><world name="w"/></sdf>'
TWO = '<sdf version="1.9"><!-- -- --><!-- -- --><world name="w"/></sdf>'


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    Path("worlds").mkdir()
    Path("worlds/a.sdf").write_text(ONE)


def lint(*arguments: str) -> int:
    return main(["lint", "--isolated", "--baseline", "known.json", *arguments])


def test_a_known_finding_is_not_reported(capsys: pytest.CaptureFixture[str]) -> None:
    assert lint("--write-baseline") == 0
    assert capsys.readouterr().err == "known.json holds 1 finding.\n"
    assert read(Path("known.json")) == {("worlds/a.sdf", "XML002"): 1}
    assert lint() == 0
    assert "(1 suppressed)" in capsys.readouterr().out
    assert main(["lint", "--isolated", "--baseline", "../known.json", "worlds"]) == 2


def test_more_than_is_known_is_reported(capsys: pytest.CaptureFixture[str]) -> None:
    lint("--write-baseline")
    Path("worlds/a.sdf").write_text(TWO)
    Path("worlds/b.sdf").write_text(ONE)
    capsys.readouterr()
    assert lint("--output-format", "concise") == 1
    out = capsys.readouterr().out
    assert out.count("worlds/a.sdf") == 2
    assert out.count("worlds/b.sdf") == 1


def test_a_removed_part_is_reported(capsys: pytest.CaptureFixture[str]) -> None:
    lint("--write-baseline")
    Path("worlds/a.sdf").write_text(ONE.replace("<!-- -- -->", ""))
    capsys.readouterr()
    assert lint() == 0
    assert capsys.readouterr().err == "note: 1 finding of known.json is gone; --write-baseline forgets it\n"


@pytest.mark.parametrize(
    "text", ["", "[]", "{}", '{"version": 2, "findings": {}}', '{"version": 1, "findings": 3}']
)
def test_a_file_that_is_not_a_baseline_is_reported(text: str) -> None:
    Path("known.json").write_text(text)
    with pytest.raises(WrongUsage, match="baseline"):
        read(Path("known.json"))


def test_a_missing_baseline_is_said(capsys: pytest.CaptureFixture[str]) -> None:
    assert lint() == 2
    assert "cannot read known.json" in capsys.readouterr().err
    assert main(["lint", "--isolated", "--write-baseline"]) == 2


def test_names_of_files_are_readable_in_a_baseline() -> None:
    Path("worlds/küche.sdf").write_text(ONE)
    lint("--write-baseline")
    assert "worlds/küche.sdf" in Path("known.json").read_text(encoding="utf-8")
