"""``sdfcheck diff``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sdfcheck.cli.main import main

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"
ARM = ROBOTS / "two_link_arm" / "model.sdf"
DESK = ROBOTS / "desk_arm" / "desk_arm.urdf"


@pytest.fixture
def heavier(tmp_path: Path) -> Path:
    file = tmp_path / "model.sdf"
    file.write_text(ARM.read_text(encoding="utf-8").replace("<mass>1.2<", "<mass>1.3<"), encoding="utf-8")
    return file


def test_the_same_robot(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["diff", str(DESK), str(DESK), "--isolated"]) == 0
    assert capsys.readouterr().out == "the same robot: 1 model, 6 links, 5 joints, 3 materials\n"


def test_another_robot(heavier: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["diff", str(ARM), str(heavier), "--isolated"]) == 1
    assert capsys.readouterr().out == "model two_link_arm\n  ~ link `upper`: mass 1.2 → 1.3\n"


def test_the_exit_code_can_be_left_at_zero(heavier: Path) -> None:
    assert main(["diff", str(ARM), str(heavier), "--isolated", "--exit-zero"]) == 0


def test_the_tolerance(heavier: Path) -> None:
    assert main(["diff", str(ARM), str(heavier), "--isolated", "--tolerance", "0.2"]) == 0


def test_json(heavier: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["diff", str(ARM), str(heavier), "--isolated", "--output-format", "json"]) == 1
    report = json.loads(capsys.readouterr().out)
    assert report["equal"] is False
    assert report["models"][0]["changes"] == [
        {"kind": "changed", "part": "link", "name": "upper", "what": "mass", "before": "1.2", "after": "1.3"}
    ]


def test_values_that_cannot_be_compared(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["diff", str(ARM), str(tmp_path / "none.sdf"), "--isolated"]) == 2
    broken = tmp_path / "b.sdf"
    broken.write_text(
        "<sdf version='1.10'><model name='m'><link name='a'><pose relative_to='x'/></link></model></sdf>",
        encoding="utf-8",
    )
    assert main(["diff", str(ARM), str(broken), "--isolated"]) == 2
    assert "'x'" in capsys.readouterr().err


def test_xacro_is_expanded(capsys: pytest.CaptureFixture[str]) -> None:
    rover = str(ROBOTS / "rover" / "rover.urdf.xacro")
    assert main(["diff", rover, rover, "--isolated"]) == 0
