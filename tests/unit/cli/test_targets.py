"""``sdfcheck targets``."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from sdfcheck.cli.main import main

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"
SOUND = str(ROBOTS / "two_link_arm" / "model.sdf")
BROKEN = str(ROBOTS / "with_mistakes" / "crane.urdf")


def test_a_sound_file(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["targets", SOUND, "--isolated"]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "drake    accept",
        "gazebo   accept",
        "mujoco   not read: it does not know SDFormat",
        "urdfdom  not read: it does not know SDFormat",
    ]


def test_reasons(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["targets", BROKEN, "--isolated"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert "drake    reject" in lines
    assert any(
        "reject 5:" in line and "mass -20 is negative [INR001] (refuses a negative mass)" in line
        for line in lines
    )
    assert any(line.strip().startswith("and ") for line in lines)


@pytest.mark.parametrize(
    ("file", "consumer", "code"),
    [(SOUND, "gazebo", 0), (SOUND, "urdfdom", 1), (BROKEN, "urdfdom", 1)],
)
def test_one_consumer_decides(
    file: str, consumer: str, code: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["targets", file, "--isolated", "--target", consumer]) == code
    assert capsys.readouterr().out.startswith(consumer)


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["targets", BROKEN, "--isolated", "--output-format", "json"]) == 0
    output = json.loads(capsys.readouterr().out)
    assert [row["consumer"] for row in output["consumers"]] == ["drake", "gazebo", "mujoco", "urdfdom"]
    reason = output["consumers"][1]["reasons"][0]
    assert (reason["code"], reason["verdict"], reason["line"]) == ("INR001", "reject", 5)


def test_impossible_requests(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["targets", str(tmp_path / "none.sdf")]) == 2
    assert "no such file" in capsys.readouterr().err


def test_xacro_elements_left_in_urdf(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Simulators ignore it; a file for xacro is refused."""
    text = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="a"/><xacro:grey/></robot>'
    for name, verdict in (("r.urdf", "warn"), ("r.urdf.xacro", "reject")):
        (tmp_path / name).write_text(text)
        main(["targets", str(tmp_path / name), "--isolated", "--output-format", "json"])
        answer = json.loads(capsys.readouterr().out)
        assert {row["consumer"]: row["verdict"] for row in answer["consumers"]}["urdfdom"] == verdict
