"""The options of every command that reads a description: arguments, places, variables."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from sdfcheck.cli.main import main

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
BODY = (
    '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
    '<visual><geometry><box size="$(arg width) 1 1"/></geometry></visual>'
)
ROBOT = f'<robot name="r" {XACRO}><xacro:arg name="width" default="1"/><link name="a">{BODY}</link></robot>'

COMMANDS = {
    "lint": ["lint"],
    "expand": ["expand"],
    "graph": ["graph", "joints"],
    "inertia": ["inertia"],
    "targets": ["targets"],
    "print": ["print"],
    "convert": ["convert", "urdf-to-sdf"],
}

Capture = pytest.CaptureFixture[str]


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    file = tmp_path / "robot.urdf.xacro"
    file.write_text(ROBOT)
    return file


@pytest.fixture(params=COMMANDS, ids=str)
def command(request: pytest.FixtureRequest) -> list[str]:
    return [*COMMANDS[request.param], "--isolated"]


def test_an_argument_is_taken(command: list[str], robot: Path, capsys: Capture) -> None:
    assert main([*command, str(robot), "width:=2"]) == 0
    out, err = capsys.readouterr()
    assert "argument" not in err
    if command[0] in {"expand", "print", "convert"}:
        assert "2 1 1" in out


def test_a_misspelt_argument_is_refused(command: list[str], robot: Path, capsys: Capture) -> None:
    assert main([*command, str(robot), "widht:=2"]) == 2
    assert "no file takes the argument `widht`; did you mean `width`?" in capsys.readouterr().err


def test_an_argument_that_nothing_is_like_is_a_warning(robot: Path, capsys: Capture) -> None:
    assert main(["expand", "--isolated", str(robot), "color:=2"]) == 0
    assert "warning: no file takes the argument `color`" in capsys.readouterr().err


def test_arguments_of_an_unknown_file_are_not_checked(tmp_path: Path, capsys: Capture) -> None:
    file = tmp_path / "robot.urdf.xacro"
    file.write_text(
        ROBOT.replace("<link", '<xacro:include filename="$(find nowhere_near)/a.xacro"/><link', 1)
    )
    main(["lint", "--isolated", str(file), "color:=2"])
    assert "color" not in capsys.readouterr().err


@pytest.mark.parametrize("option", [["--package", "p="], ["--package-path", ""], ["--model-path", ""]])
def test_a_folder_that_is_not_there_is_refused(
    command: list[str], option: list[str], robot: Path, capsys: Capture
) -> None:
    assert main([*command, str(robot), option[0], f"{option[1]}{robot.parent / 'nowhere'}"]) == 2
    assert f"{option[0]}: no such folder: " in capsys.readouterr().err
    assert main([*command, str(robot), option[0], f"{option[1]}{robot}"]) == 2
    assert f"{option[0]}: not a folder: " in capsys.readouterr().err


def test_two_robots_take_the_arguments_of_both(tmp_path: Path, robot: Path, capsys: Capture) -> None:
    other = tmp_path / "other.urdf.xacro"
    other.write_text(ROBOT.replace("width", "depth"))
    assert main(["diff", "--isolated", str(robot), str(other), "width:=2", "depth:=2"]) == 0
    assert main(["diff", "--isolated", str(robot), str(other), "width:=3"]) == 1
    assert main(["diff", "--isolated", str(robot), str(other), "widht:=3"]) == 2


def test_a_variable_is_passed_on_if_asked_for(
    command: list[str], robot: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    robot.write_text(ROBOT.replace("$(arg width)", "$(env ROBOT_WIDTH)"))
    monkeypatch.setenv("ROBOT_WIDTH", "3")
    assert main([*command, str(robot)]) in ({0} if command[0] == "targets" else {1, 2})
    if command[0] in {"lint", "expand", "convert"}:
        out, err = capsys.readouterr()
        assert "`ROBOT_WIDTH` is set, but not passed on" in out + err
        assert "--env ROBOT_WIDTH" in out + err
    assert main([*command, str(robot), "--env", "ROBOT_WIDTH"]) == 0


def test_the_configuration_names_variables(
    robot: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    robot.write_text(ROBOT.replace("$(arg width)", "$(env ROBOT_WIDTH)"))
    (robot.parent / "sdfcheck.toml").write_text('env = ["ROBOT_WIDTH"]')
    monkeypatch.setenv("ROBOT_WIDTH", "3")
    assert main(["expand", str(robot)]) == 2
    assert "`env` reads environment variables, which needs your consent" in capsys.readouterr().err
    assert main(["lint", "--trust-config", str(robot)]) == 0
    assert main(["expand", "--trust-config", str(robot)]) == 0
    assert "3 1 1" in capsys.readouterr().out


def test_all_missing_arguments_are_named(tmp_path: Path, capsys: Capture) -> None:
    file = tmp_path / "robot.urdf.xacro"
    file.write_text(
        f'<robot name="$(arg name)" {XACRO}><xacro:property name="w" value="$(arg width)"/>'
        '<xacro:property name="u" value="$(arg unread)"/><link name="$(arg prefix)${w}"/>'
        '<xacro:if value="0"><link name="$(arg other)"/></xacro:if></robot>'
    )
    assert main(["expand", "--isolated", str(file)]) == 1
    err = capsys.readouterr().err
    assert [name for name in ("name", "width", "unread", "prefix", "other") if f"`{name}` has no" in err] == [
        "name",
        "width",
        "prefix",
    ]
    assert main(["graph", "joints", "--isolated", str(file)]) == 2
    assert "arguments without a value: `name:=…`, `width:=…`, `prefix:=…`" in capsys.readouterr().err


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A workspace with one package of its own, and one elsewhere and installed that it uses."""
    for variable in ("AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH"):
        monkeypatch.delenv(variable, raising=False)
    folders = {"src/arm": "arm", "other/grip": "grip", "install/hand/share/hand": "hand"}
    for folder, name in folders.items():
        (tmp_path / folder).mkdir(parents=True)
        (tmp_path / folder / "package.xml").write_text(f"<package><name>{name}</name></package>")
        (tmp_path / folder / "part.xacro").write_text(f'<robot {XACRO}><link name="{name}"/></robot>')
    return tmp_path


def uses(workspace: Path, package: str) -> Path:
    file = workspace / "src" / "arm" / "arm.urdf.xacro"
    include = f'<xacro:include filename="$(find {package})/part.xacro"/>'
    file.write_text(f'<robot name="arm" {XACRO}>{include}</robot>')
    return file


@pytest.mark.parametrize("below", [".", "src", "src/arm", "other"])
@pytest.mark.parametrize("how", ["--package", "--package-path", "AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH"])
def test_relative_places_hold_from_everywhere(
    workspace: Path, below: str, how: str, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    (workspace / "sourced" / "share").mkdir(parents=True)
    (workspace / "sourced" / "share" / "grip").symlink_to(workspace / "other" / "grip")
    monkeypatch.chdir(workspace / below)
    place = os.path.relpath(workspace / ("sourced" if how == "AMENT_PREFIX_PATH" else "other"))
    options = []
    if how.startswith("--"):
        options = [how, place if how == "--package-path" else f"grip={place}/grip"]
    else:
        monkeypatch.setenv(how, place)
    file = os.path.relpath(uses(workspace, "grip"))
    assert main(["expand", "--isolated", file, *options]) == 0
    assert '<link name="grip"/>' in capsys.readouterr().out
    assert main(["lint", "--isolated", file, *options]) == 0


def test_a_package_that_the_workspace_has_installed_is_found(workspace: Path, capsys: Capture) -> None:
    assert main(["expand", "--isolated", str(uses(workspace, "hand"))]) == 0
    assert '<link name="hand"/>' in capsys.readouterr().out
    assert main(["lint", "--isolated", str(uses(workspace, "hand"))]) == 0


@pytest.mark.parametrize("link", ["install", "install/hand", "install/hand/share/hand/part.xacro"])
def test_an_installed_package_does_not_lead_out_of_the_workspace(
    workspace: Path, link: str, tmp_path_factory: pytest.TempPathFactory, capsys: Capture
) -> None:
    outside = tmp_path_factory.mktemp("outside") / "there"
    (workspace / link).rename(outside)
    (workspace / link).parent.mkdir(exist_ok=True, parents=True)
    (workspace / link).symlink_to(outside)
    assert main(["expand", "--isolated", str(uses(workspace, "hand"))]) == 1
    assert "hand" not in capsys.readouterr().out


def test_sets_of_arguments_are_for_the_files_of_a_folder(tmp_path: Path, capsys: Capture) -> None:
    (tmp_path / "robots").mkdir()
    (tmp_path / "sdfcheck.toml").write_text(
        '[xacro]\n"robots/*.xacro" = [{width = 1}, {width = -1}]\n"robots/small*.xacro" = {width = 0.1}\n'
    )
    for name in ("big", "small"):
        (tmp_path / "robots" / f"{name}.xacro").write_text(ROBOT.replace(' default="1"', ' default=""'))
    assert main(["lint", "--output-format", "concise", str(tmp_path)]) == 1
    out = capsys.readouterr().out
    assert "big.xacro" in out
    assert "small.xacro" not in out


def test_arguments_of_the_command_line_go_before_those_of_the_configuration(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    link = '<link name="$(arg side)_${1.0*$(arg size)}"/>'
    Path("a.urdf.xacro").write_text(
        f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{link}</robot>'
    )
    Path("sdfcheck.toml").write_text(
        '[xacro]\n"*.xacro" = [{size = "2", side = "a"}, {size = "x", side = "b"}]'
    )
    line = ["lint", "a.urdf.xacro", "--output-format", "concise"]
    assert main([*line, "side:=right"]) == 1
    named = capsys.readouterr().out
    assert "property `x` is not defined" in named
    assert "XAC001" not in named
    assert main([*line, "size:=3"]) == 0
