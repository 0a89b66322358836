"""``sdfcheck expand``."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.main import main

ROBOT = (
    '<robot name="$(arg name)" xmlns:xacro="x"><xacro:include filename="$(find arm)/arm.xacro"/>\n'
    "<xacro:arm/></robot>"
)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "arm.xacro").write_text(
        '<robot xmlns:xacro="x"><xacro:macro name="arm" params=""><link name="arm"/></xacro:macro></robot>'
    )
    (tmp_path / "r.xacro").write_text(ROBOT)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_expansion_goes_to_stdout(folder: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["expand", "r.xacro", "name:=r2", "--package", "arm=parts"]) == 0
    out, err = capfd.readouterr()
    assert '<robot name="r2">' in out
    assert '<link name="arm"/>' in out
    assert err == ""


def test_comments_on_request(folder: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["expand", "--annotate", "r.xacro", "name:=r2", "--package", "arm=parts"]) == 0
    assert "<!-- parts/arm.xacro:1; in macro `arm`: r.xacro:2 -->" in capfd.readouterr().out


def test_packages_and_arguments_of_the_configuration(folder: Path, capfd: pytest.CaptureFixture[str]) -> None:
    (folder / "sdfcheck.toml").write_text('[packages]\narm = "parts"\n[xacro]\n"r.xacro" = { name = "r3" }\n')
    assert main(["expand", "r.xacro"]) == 0
    assert '<robot name="r3">' in capfd.readouterr().out


def test_a_failure_is_reported_with_its_place(folder: Path, capfd: pytest.CaptureFixture[str]) -> None:
    assert main(["expand", "r.xacro", "name:=r"]) == 1
    out, err = capfd.readouterr()
    assert out == ""
    assert err.startswith("r.xacro:1:75: warning[")
    assert "package `arm` is not found" in err


def test_the_file_explains_a_failure_as_lint_does(folder: Path, capfd: pytest.CaptureFixture[str]) -> None:
    (folder / "bare.xacro").write_text('<robot name="r" xmlns:xacro="x"><xacro:arg name="n"/></robot>')
    assert main(["expand", "bare.xacro"]) == 1
    assert "error[XAC011]: `xacro:arg` has no `default`" in capfd.readouterr().err
    (folder / "bare.xacro").write_text('<robot name="r"><link')
    assert main(["expand", "bare.xacro"]) == 1
    assert capfd.readouterr().err.count("error[") == 1


@pytest.mark.parametrize(
    "arguments", [["none.xacro"], ["r.xacro", "name=r"], ["r.xacro", "--package", "arm"]]
)
def test_wrong_usage(folder: Path, arguments: list[str]) -> None:
    assert main(["expand", *arguments]) == 2
