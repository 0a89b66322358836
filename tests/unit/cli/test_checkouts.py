"""Whatever state a clone is in, its robots are linted, and each once."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.cli.main import main
from sdfcheck.lint.diagnostic import Severity

ROBOT = '<robot name="r"><link name="a"/></robot>\n'

Shown = Callable[..., list[str]]


def git(folder: Path, *words: str) -> None:
    settings = ["-c", "user.name=n", "-c", "user.email=e@example.org", "-c", "protocol.file.allow=always"]
    environment = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    subprocess.run(["git", *settings, *words], cwd=folder, check=True, capture_output=True, env=environment)


def repository(folder: Path, *names: str) -> Path:
    for name in names:
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(ROBOT)
    git(folder, "init", "-q", "-b", "main")
    git(folder, "add", ".")
    git(folder, "commit", "-qm", "m")
    return folder


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    """A repository with a robot, and a submodule with another."""
    library = repository(tmp_path / "library", "part.urdf")
    robot = repository(tmp_path / "robot", "robot.urdf", "below/arm.urdf")
    git(robot, "submodule", "add", "-q", str(library), "library")
    git(robot, "commit", "-qam", "s")
    return robot


@pytest.fixture
def shown(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Shown:
    """The files that a command line in a folder looks at."""

    def show(folder: Path, *words: str) -> list[str]:
        monkeypatch.chdir(folder)
        assert main(["lint", *(words or ["."]), "--min-severity", "error"]) == 0
        capsys.readouterr()
        assert main(["lint", "--show-files", *(words or ["."])]) == 0
        return capsys.readouterr().out.split()

    return show


def test_a_submodule_that_is_checked_out(robot: Path, shown: Shown) -> None:
    assert shown(robot) == ["below/arm.urdf", "library/part.urdf", "robot.urdf"]


def test_a_submodule_that_is_not(robot: Path, tmp_path: Path, shown: Shown) -> None:
    clone = tmp_path / "clone"
    git(tmp_path, "clone", "-q", str(robot), str(clone))
    assert shown(clone) == ["below/arm.urdf", "robot.urdf"]
    (clone / "library" / "left.urdf").write_text(ROBOT)
    assert shown(clone) == ["below/arm.urdf", "library/left.urdf", "robot.urdf"]
    assert shown(clone / "library") == ["left.urdf"]
    shutil.rmtree(clone / "library")
    assert shown(clone) == ["below/arm.urdf", "robot.urdf"]


def test_a_submodule_whose_repository_is_gone(robot: Path, shown: Shown) -> None:
    shutil.rmtree(robot / ".git" / "modules")
    assert shown(robot) == ["below/arm.urdf", "library/part.urdf", "robot.urdf"]
    (robot / "library" / ".git").unlink()
    (robot / "library" / ".git").mkdir()
    assert shown(robot) == ["below/arm.urdf", "library/part.urdf", "robot.urdf"]


def test_a_submodule_that_became_a_link_or_a_file(robot: Path, tmp_path: Path, shown: Shown) -> None:
    shutil.rmtree(robot / "library")
    (robot / "library").symlink_to("..")
    assert shown(robot) == ["below/arm.urdf", "robot.urdf"]
    (robot / "library").unlink()
    (robot / "library").write_text("no folder")
    assert shown(robot) == ["below/arm.urdf", "robot.urdf"]


def test_a_bare_repository_holds_files_like_any_folder(robot: Path, tmp_path: Path, shown: Shown) -> None:
    git(tmp_path, "clone", "-q", "--bare", str(robot), "bare")
    (tmp_path / "bare" / "left.urdf").write_text(ROBOT)
    assert shown(tmp_path / "bare") == ["left.urdf"]
    (robot / "inner").mkdir()
    git(robot, "clone", "-q", "--bare", str(robot), "inner/bare")
    assert shown(robot) == ["below/arm.urdf", "library/part.urdf", "robot.urdf"]


def test_work_trees(robot: Path, tmp_path: Path, shown: Shown) -> None:
    git(robot, "worktree", "add", "-q", str(tmp_path / "other"), "-b", "other")
    assert shown(tmp_path / "other") == ["below/arm.urdf", "robot.urdf"]
    git(robot, "worktree", "add", "-q", "inside", "-b", "inside")
    assert shown(robot) == [
        *("below/arm.urdf", "inside/below/arm.urdf", "inside/robot.urdf", "library/part.urdf", "robot.urdf")
    ]
    shutil.rmtree(robot / ".git")
    assert shown(tmp_path / "other") == ["below/arm.urdf", "robot.urdf"]


def test_a_sparse_checkout(tmp_path: Path, shown: Shown) -> None:
    folder = repository(tmp_path / "r", "a/a.urdf", "b/b.urdf", "top.urdf")
    git(folder, "sparse-checkout", "set", "--cone", "--sparse-index", "a")
    assert shown(folder) == ["a/a.urdf", "top.urdf"]


def test_repositories_in_repositories(tmp_path: Path, shown: Shown) -> None:
    folder = repository(tmp_path / "r", "top.urdf")
    at = folder
    for number in range(8):
        at = at / f"r{number}"
        at.mkdir()
        repository(at, "inner.urdf")
    (at / ".gitignore").write_text("out/\n")
    (at / "out").mkdir()
    (at / "out" / "ignored.urdf").write_text(ROBOT)
    assert len(shown(folder)) == 9
    (folder / "empty").mkdir()
    git(folder / "empty", "init", "-q")
    assert len(shown(folder)) == 9


@pytest.mark.parametrize("name", ["GIT_DIR", "GIT_WORK_TREE", "GIT_COMMON_DIR", "GIT_INDEX_FILE"])
def test_variables_that_point_at_another_repository(
    robot: Path, tmp_path: Path, name: str, shown: Shown, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = repository(tmp_path / "other", "other.urdf")
    monkeypatch.setenv(name, str(other if name == "GIT_WORK_TREE" else other / ".git"))
    assert shown(robot) == ["below/arm.urdf", "library/part.urdf", "robot.urdf"]


def test_no_git_on_the_computer(robot: Path, shown: Shown, monkeypatch: pytest.MonkeyPatch) -> None:
    (robot / ".gitignore").write_text("below/\n")
    monkeypatch.setenv("PATH", "")
    assert shown(robot) == ["library/part.urdf", "robot.urdf"]


def test_files_inside_the_folder_of_git(robot: Path, shown: Shown) -> None:
    (robot / ".git" / "left.urdf").write_text(ROBOT)
    assert shown(robot) == ["below/arm.urdf", "library/part.urdf", "robot.urdf"]
    assert shown(robot, ".git/left.urdf") == [".git/left.urdf"]
    assert shown(robot / ".git", ".") == ["left.urdf"]


@pytest.mark.parametrize("content", [b"", b"gitdir: nowhere\n", b"\xff\0", b"gitdir: .\n"])
def test_a_file_that_leads_to_no_repository(tmp_path: Path, content: bytes, shown: Shown) -> None:
    (tmp_path / ".git").write_bytes(content)
    (tmp_path / "a.urdf").write_text(ROBOT)
    assert shown(tmp_path) == ["a.urdf"]


def test_deep_folders(tmp_path: Path, shown: Shown, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "a.urdf").write_text(ROBOT)
    monkeypatch.chdir(tmp_path)
    depth = 0
    try:
        while depth < 1100:
            os.mkdir("d")
            os.chdir("d")
            depth += 1
        Path("deep.urdf").write_text(ROBOT)
        found = shown(tmp_path)
        assert [Path(path).name for path in found] == ["a.urdf", "deep.urdf"]
        git(tmp_path, "init", "-q")
        assert len(shown(tmp_path)) >= 1
    finally:
        os.chdir(tmp_path)
        for _ in range(depth):
            os.rename("d", "gone")
            if os.path.isdir("gone/d"):
                os.rename("gone/d", "d")
            shutil.rmtree("gone")


def test_ignored_files_are_on_other_computers(tmp_path: Path) -> None:
    folder = tmp_path / "p"
    (folder / "meshes").mkdir(parents=True)
    (folder / "meshes" / "arm.dae").touch()
    (folder / "package.xml").write_text("<package><name>p</name></package>")
    (folder / ".gitignore").write_text("made/\n*.stl\n!meshes/kept.stl\n")
    mesh = '<visual><geometry><mesh filename="package://p/{}"/></geometry></visual>'
    meshes = "".join(map(mesh.format, ("meshes/a.stl", "meshes/b.dae", "meshes/kept.stl", "made/deep/c.dae")))
    (folder / "arm.urdf").write_text(f'<robot name="r"><link name="a">{meshes}</link></robot>')
    xacro = 'name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"'
    include = '<xacro:include filename="$(find p)/made/b.urdf"/><xacro:include filename="c.urdf"/>'
    (folder / "all.urdf.xacro").write_text(f'<robot {xacro}>{include}<link name="a"/></robot>')
    repository(folder, "other.urdf")
    found = [each for each in sdfcheck.lint(folder).diagnostics if each.severity is not Severity.INFO]
    assert [(each.code, each.span.text, each.missing is not None) for each in found] == [
        ("XAC001", "$(find p)/made/b.urdf", True),
        ("XAC001", "c.urdf", False),
        ("RES001", "package://p/meshes/a.stl", True),
        ("RES001", "package://p/meshes/b.dae", False),
        ("RES001", "package://p/meshes/kept.stl", False),
        ("RES001", "package://p/made/deep/c.dae", True),
    ]
