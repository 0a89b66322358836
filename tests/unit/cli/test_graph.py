"""``sdfcheck graph``."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from sdfcheck.cli.main import main

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"


@pytest.mark.parametrize("kind", ["frames", "poses", "joints"])
@pytest.mark.parametrize("form", ["text", "dot", "mermaid", "svg"])
@pytest.mark.parametrize(
    "file", ["two_link_arm/model.sdf", "workcell/workcell.world", "desk_arm/desk_arm.urdf"]
)
def test_every_graph_of_every_kind_of_file(
    kind: str, form: str, file: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["graph", kind, str(ROBOTS / file), "--output-format", form, "--isolated"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    assert out.startswith({"dot": "digraph ", "mermaid": "flowchart TD\n", "svg": "<svg ", "text": ""}[form])
    assert len(out.splitlines()) > 2


def test_a_tree(capsys: pytest.CaptureFixture[str]) -> None:
    main(["graph", "joints", str(ROBOTS / "two_link_arm" / "model.sdf"), "--isolated"])
    assert capsys.readouterr().out.splitlines() == [
        "world",
        "└─ anchor (fixed) → link base",
        "   └─ shoulder (revolute) → link upper",
        "      └─ elbow (revolute) → link fore",
    ]


def test_colors_are_for_people(capsys: pytest.CaptureFixture[str]) -> None:
    file = str(ROBOTS / "two_link_arm" / "model.sdf")
    main(["graph", "joints", file, "--isolated", "--color", "always"])
    assert "\x1b[" in capsys.readouterr().out
    main(["graph", "joints", file, "--isolated", "--output-format", "dot", "--color", "always"])
    assert "\x1b[" not in capsys.readouterr().out


def test_names_cannot_move_the_cursor(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "model.sdf"
    file.write_text(
        '<sdf version="1.12"><model name="m"><link name="a&#x9b;2J"/></model></sdf>', encoding="utf-8"
    )
    main(["graph", "joints", str(file), "--isolated"])
    assert capsys.readouterr().out == "link a<U+009B>2J\n"


def test_xacro_is_expanded(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "robot.urdf.xacro"
    file.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:property name="n" value="base"/>'
        '<link name="${n}_link"/></robot>'
    )
    assert main(["graph", "joints", str(file), "--isolated"]) == 0
    assert capsys.readouterr().out == "link base_link\n"


@pytest.mark.parametrize(
    ("content", "says"),
    [(None, "no such file"), ("hello", "looks like"), ("<html/>", "not like a robot or world")],
)
def test_files_without_a_robot(
    content: str | None, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "model.sdf"
    if content is not None:
        file.write_text(content)
    assert main(["graph", "joints", str(file)]) == 2
    assert says in capsys.readouterr().err


def test_a_file_in_place_of_the_graph_gets_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    file = ROBOTS / "diff_drive" / "model.sdf"
    assert main(["graph", str(file)]) == 2
    assert f"which graph of it? Try `sdfcheck graph joints {file}`" in capsys.readouterr().err


def test_a_joint_may_have_the_name_of_a_link(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    joint = '<joint name="{}" type="fixed"><parent link="{}"/><child link="{}"/></joint>'
    links = '<link name="base"/><link name="hand"/><link name="jaw"/>'
    robot = f'<robot name="r">{links}{joint.format("j", "base", "hand")}{joint.format("hand", "hand", "jaw")}</robot>'
    (tmp_path / "r.urdf").write_text(robot)
    assert main(["graph", "joints", str(tmp_path / "r.urdf")]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "link base",
        "└─ j (fixed) → link hand",
        "   └─ hand (fixed) → link jaw",
    ]


@pytest.mark.skipif(not Path("/dev/fd").is_dir(), reason="this system has no /dev/fd")
def test_a_pipe_of_the_shell_is_read(capsys: pytest.CaptureFixture[str]) -> None:
    reading, writing = os.pipe()
    os.write(writing, b'<robot name="r"><link name="base"/></robot>')
    os.close(writing)
    try:
        assert main(["graph", "joints", f"/dev/fd/{reading}"]) == 0
    finally:
        os.close(reading)
    assert capsys.readouterr().out == "link base\n"
