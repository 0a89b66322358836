"""``--changed-since`` lints what changed, and everything that a change can affect."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from tests.unit.cli.test_checkouts import git

FILES = {
    "urdf/arm.xacro": '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'
    '<xacro:macro name="arm" params="n"><link name="${n}"/></xacro:macro></robot>\n',
    "urdf/parts.gazebo": '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'
    '<xacro:include filename="arm.xacro"/></robot>\n',
    "urdf/robot.urdf.xacro": '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    '<xacro:include filename="parts.gazebo"/><xacro:arm n="a"/></robot>\n',
    "urdf/alone.urdf": '<robot name="o"><link name="l"/></robot>\n',
    "urdf/farm.xacro.urdf": '<robot name="f"><link name="l"/></robot>\n',
    "models/box/model.sdf": '<sdf version="1.9"><model name="box"><link name="l"/></model></sdf>\n',
    "models/box/model.config": '<model><name>box</name><sdf version="1.9">model.sdf</sdf></model>\n',
    "models/tree/model.sdf": '<sdf version="1.9"><model name="tree"><link name="l"/></model></sdf>\n',
    "worlds/yard.sdf": '<sdf version="1.9"><world name="w"><include><uri>model://box</uri></include></world></sdf>\n',
}


@pytest.fixture
def clone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name, text in FILES.items():
        file = tmp_path / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    git(tmp_path, "init", "-q", "-b", "main")
    git(tmp_path, "add", ".")
    git(tmp_path, "commit", "-qm", "m")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def change(clone: Path, name: str) -> None:
    with (clone / name).open("a") as file:
        file.write("<!-- changed -->\n")


def looked_at(capsys: pytest.CaptureFixture[str], *words: str) -> list[str]:
    assert main(["lint", "--show-files", "--quiet", *words]) == 0
    return capsys.readouterr().out.split()


def test_nothing_changed(clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert looked_at(capsys, "--changed-since", "HEAD") == []
    assert main(["lint", "--changed-since", "HEAD"]) == 0


@pytest.mark.parametrize(
    ("new", "text", "below"),
    [
        ("bringup/robot.launch.py", "", ""),
        ("bringup/launch/robot.py", "", ""),
        ("bringup/robot.launch", "", ""),
        ("config/bridge.yaml", "- gz_type_name: gz.msgs.Image", ""),
        ("config/nav2.yml", "robot_base_frame: base_link", ""),
        ("urdf/kinematics.yaml", "arm: {}", "urdf/"),
        ("models/CMakeLists.txt", "", "models/"),
    ],
)
def test_descriptions_are_read_with_files_beside_them(
    clone: Path, capsys: pytest.CaptureFixture[str], new: str, text: str, below: str
) -> None:
    everything = looked_at(capsys)
    (clone / new).parent.mkdir(parents=True, exist_ok=True)
    (clone / new).write_text(f"{text}\n")
    expected = [file for file in everything if file.startswith(below)]
    assert expected
    assert looked_at(capsys, "--changed-since", "HEAD") == expected


@pytest.mark.parametrize(
    ("changed", "affected"),
    [
        ("urdf/alone.urdf", ["urdf/alone.urdf"]),
        ("urdf/arm.xacro", ["urdf/arm.xacro", "urdf/robot.urdf.xacro"]),  # through parts.gazebo
        ("models/box/model.sdf", ["models/box/model.config", "models/box/model.sdf", "worlds/yard.sdf"]),
        ("worlds/yard.sdf", ["worlds/yard.sdf"]),
    ],
)
def test_a_file_that_names_a_changed_one_is_affected(
    clone: Path, capsys: pytest.CaptureFixture[str], changed: str, affected: list[str]
) -> None:
    change(clone, changed)
    assert looked_at(capsys, "--changed-since", "HEAD") == affected


def test_settings_and_packages_affect_everything_below_them(
    clone: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (clone / "urdf" / "package.xml").write_text("<package><name>urdf</name></package>\n")
    assert [Path(name).parent.name for name in looked_at(capsys, "--changed-since", "HEAD")] == ["urdf"] * 4


def test_a_deleted_file_affects_those_that_name_it(clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (clone / "urdf" / "parts.gazebo").unlink()
    assert looked_at(capsys, "--changed-since", "HEAD") == ["urdf/robot.urdf.xacro"]


def test_a_deleted_model_affects_the_worlds_that_name_its_folder(
    clone: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (clone / "models" / "box" / "model.sdf").unlink()
    (clone / "models" / "box" / "model.config").unlink()
    assert looked_at(capsys, "--changed-since", "HEAD") == ["worlds/yard.sdf"]


@pytest.mark.parametrize("name", ["${side}m.xacro", "$(arg kind).xacro", "*.xacro"])
def test_a_name_with_an_expression_may_be_that_of_a_changed_file(
    clone: Path, capsys: pytest.CaptureFixture[str], name: str
) -> None:
    robot = clone / "urdf" / "robot.urdf.xacro"
    robot.write_text(FILES["urdf/robot.urdf.xacro"].replace("parts.gazebo", name))
    (clone / "urdf" / "parts.gazebo").unlink()
    git(clone, "add", "-A")
    git(clone, "commit", "-qm", "n")
    change(clone, "urdf/arm.xacro")
    assert looked_at(capsys, "--changed-since", "HEAD") == ["urdf/arm.xacro", "urdf/robot.urdf.xacro"]


def test_a_branch_is_compared_with_where_it_began(clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    git(clone, "checkout", "-q", "-b", "topic")
    change(clone, "urdf/alone.urdf")
    git(clone, "commit", "-qam", "t")
    git(clone, "checkout", "-q", "main")
    change(clone, "models/tree/model.sdf")
    git(clone, "commit", "-qam", "u")
    git(clone, "checkout", "-q", "topic")
    assert looked_at(capsys, "--changed-since", "main") == ["urdf/alone.urdf"]
    assert looked_at(capsys, "--changed-since", "main", "models") == []


@pytest.mark.parametrize("reference", ["nowhere", "--upload-pack=touch x", "HEAD:urdf"])
def test_an_unknown_reference_is_an_error(
    clone: Path, capsys: pytest.CaptureFixture[str], reference: str
) -> None:
    assert main(["lint", f"--changed-since={reference}"]) == 2
    assert "names no commit" in capsys.readouterr().err


def test_a_folder_without_git_is_an_error(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["lint", "--changed-since", "HEAD"]) == 2
    assert "is in no git repository" in capsys.readouterr().err


def test_no_program_of_the_repository_runs(clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (clone / ".gitattributes").write_text("*.urdf filter=own diff=own\n")
    for key in ("filter.own.clean", "diff.own.textconv", "diff.own.command", "diff.external"):
        git(clone, "config", key, f"touch {clone}/ran")
    git(clone, "config", "filter.own.required", "true")
    change(clone, "urdf/alone.urdf")
    # As old as the index: git has to look into the file to know whether it has changed.
    index = (clone / ".git" / "index").stat()
    os.utime(clone / "urdf" / "farm.xacro.urdf", ns=(index.st_mtime_ns, index.st_mtime_ns))
    assert "urdf/alone.urdf" in looked_at(capsys, "--changed-since", "HEAD")
    assert not (clone / "ran").exists()
