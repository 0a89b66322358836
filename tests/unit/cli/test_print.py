"""``sdfcheck print``."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.main import main

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"


@pytest.mark.parametrize(
    "name",
    ["two_link_arm/model.sdf", "workcell/workcell.world", "desk_arm/desk_arm.urdf", "rover/rover.urdf.xacro"],
)
@pytest.mark.parametrize(
    "options", [(), ("--precision", "5", "--snap-to-degrees", "0.1"), ("--expand-includes",)]
)
def test_printing_twice_is_printing_once(
    name: str, options: tuple[str, ...], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["print", str(ROBOTS / name), "--isolated", *options]) == 0
    once = capsys.readouterr().out
    assert "xacro:" not in once
    again = tmp_path / Path(name).name.removesuffix(".xacro")
    again.write_text(once, encoding="utf-8")
    assert main(["print", str(again), "--isolated", *options]) == 0
    assert capsys.readouterr().out == once


def test_an_included_model_is_written_out(capsys: pytest.CaptureFixture[str]) -> None:
    file = str(ROBOTS / "workcell" / "workcell.world")
    assert main(["print", file, "--isolated", "--expand-includes", "--degrees"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert "<include>" not in out
    assert 'degrees="true"' in out


def test_the_rest_is_reported(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "w.sdf"
    file.write_text(
        '<sdf version="1.9"><world name="w"><include><uri>model://x</uri></include></world></sdf>',
        encoding="utf-8",
    )
    assert main(["print", str(file), "--isolated", "--expand-includes"]) == 0
    assert "the include stays: `model://x` brings nothing" in capsys.readouterr().err


def test_features_that_the_version_lacks(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["print", str(ROBOTS / "two_link_arm" / "model.sdf"), "--isolated", "--degrees"]) == 2
    assert "1.6 has no poses in degrees" in capsys.readouterr().err
