"""No command writes over what it has read, and no two results go to one place."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.main import main

WORLD = '<sdf version="1.9"><world name="w"><include><uri>part.sdf</uri></include></world></sdf>'
PART = '<sdf version="1.9"><model name="m"><link name="a"/></model></sdf>'
ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="part.xacro"/></robot>'
PART_OF_ROBOT = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="a"/></robot>'
KNOWN = '{"version": 1, "findings": {}}'

ON_WORLDS = (
    "lint -o {}",
    "lint --output-format json={}",
    "lint --fix --output-format html={}",
    "lint --write-baseline --baseline {}",
    "print -o {}",
    "print --expand-includes -o {}",
    "convert sdf-to-urdf -o {}",
    "convert sdf-to-sdf --sdf-version 1.8 -o {}",
    "convert sdf-to-sdf --sdf-version 1.8 --report {}",
    "convert sdf-to-sdf --sdf-version 1.8 --output-format json={}",
    "view -o {}",
    "graph frames -o {}",
    "graph joints --output-format svg -o {}",
    "targets -o {}",
    "inertia -o {}",
    "diff world.sdf -o {}",
)
ON_XACRO = (
    "lint --isolated -o {}",
    "expand --isolated -o {}",
    "print --isolated -o {}",
    "convert urdf-to-sdf --isolated -o {}",
    "convert urdf-to-sdf --isolated --report {}",
)


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    for name, text in {
        "world.sdf": WORLD,
        "part.sdf": PART,
        "robot.urdf.xacro": ROBOT,
        "part.xacro": PART_OF_ROBOT,
        "sdfcheck.toml": 'extend = "more.toml"\n',
        "more.toml": 'fail-on = "error"\n',
        "known.json": KNOWN,
    }.items():
        (tmp_path / name).write_text(text)
    return tmp_path


def contents(folder: Path) -> dict[str, str]:
    return {path.name: path.read_text() for path in sorted(folder.iterdir())}


@pytest.mark.parametrize("place", ["world.sdf", "part.sdf", "sdfcheck.toml", "more.toml"])
@pytest.mark.parametrize("command", ON_WORLDS)
def test_inputs_stay(folder: Path, command: str, place: str, capsys: pytest.CaptureFixture[str]) -> None:
    if command.startswith("convert sdf-to-sdf") and " -o" in command and place == "world.sdf":
        pytest.skip("a file may be moved to another version in place")
    before = contents(folder)
    assert main([*command.format(place).split(), "world.sdf"]) == 2
    assert capsys.readouterr().err.splitlines()[-1] == (
        f"error: {place} is an input and would be overwritten; name another file"
    )
    assert contents(folder) == before


@pytest.mark.parametrize("command", ON_XACRO)
def test_inputs_of_xacro_stay(folder: Path, command: str, capsys: pytest.CaptureFixture[str]) -> None:
    before = contents(folder)
    assert main([*command.format("part.xacro").split(), "robot.urdf.xacro"]) == 2
    assert "part.xacro is an input" in capsys.readouterr().err
    assert contents(folder) == before


def test_inputs_of_other_processes_stay(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (folder / "worlds").mkdir()
    for number in range(70):
        (folder / "worlds" / f"{number}.sdf").write_text(WORLD.replace("part", "../part"))
    assert main(["lint", "worlds", "--jobs", "2", "-o", "part.sdf"]) == 2
    assert "part.sdf is an input" in capsys.readouterr().err
    assert (folder / "part.sdf").read_text() == PART


@pytest.mark.parametrize(
    "command",
    [
        "convert sdf-to-sdf --sdf-version 1.8 -o out --report out",
        "convert sdf-to-sdf --sdf-version 1.8 -o out --report ./out",
        "convert sdf-to-sdf --sdf-version 1.8 -o out --output-format json=out",
        "convert sdf-to-sdf --sdf-version 1.8 --report out --output-format json=out",
        "lint --output-format json=out --output-format sarif=./out",
        "lint --output-format json=out --baseline out --write-baseline",
    ],
)
def test_two_results_do_not_go_to_one_place(
    folder: Path, command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*command.split(), "world.sdf"]) == 2
    assert "out" in capsys.readouterr().err
    assert not (folder / "out").exists()


def test_a_link_in_a_walk_that_leads_out_is_not_fixed(folder: Path, tmp_path: Path) -> None:
    repository, other = tmp_path / "repository", tmp_path / "other"
    (repository / ".git").mkdir(parents=True)
    other.mkdir()
    text = '<sdf version="1.9"><world name="w"><drake:a/></world></sdf>'
    (other / "a.sdf").write_text(text)
    (repository / "a.sdf").symlink_to("../other/a.sdf")
    main(["lint", "--isolated", "--fix", "--unsafe-fixes", str(repository)])
    main(["lint", "--isolated", "--add-ignore", str(repository)])
    assert main(["lint", "--isolated", "--fix", "--unsafe-fixes", str(repository / "a.sdf")]) == 2
    assert (other / "a.sdf").read_text() == text


def test_a_baseline_of_what_cannot_be_read_is_no_success(folder: Path) -> None:
    (folder / "broken.urdf").write_bytes(b"\0\1\2\3")
    assert main(["lint", "broken.urdf", "world.sdf", "--baseline", "new.json", "--write-baseline"]) == 2
