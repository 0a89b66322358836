import os
import subprocess
from collections.abc import Sequence
from pathlib import Path

import pytest

from sdfcheck.files import git
from sdfcheck.files.discover import DiscoveredFile, discover
from sdfcheck.source.errors import WrongUsage
from tests.posix import make_pipe


def plant(root: Path, *names: str) -> None:
    for name in names:
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("<sdf/>")


def names(root: Path, paths: Sequence[Path] | None = None, **options: bool) -> list[str]:
    found = discover(paths or [root], **options)  # type: ignore[arg-type]
    return [file.path.relative_to(root).as_posix() for file in found.files]


def make_repository(root: Path) -> None:
    root.mkdir(exist_ok=True)
    subprocess.run(["git", "init", "-q", root], check=True)


@pytest.fixture(params=["git", "no git", "no repository"])
def tree(request: pytest.FixtureRequest, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder whose ignore files git reads, or our own parser: both must agree."""
    root = tmp_path / "tree"
    if request.param == "no repository":
        root.mkdir()
    else:
        make_repository(root)
    if request.param == "no git":
        monkeypatch.setattr(git, "_git", lambda folder, *arguments: None)
    return root


def test_suffixes_count_in_any_case(tree: Path) -> None:
    plant(
        tree,
        "a.sdf",
        "b.URDF",
        "c.world",
        "d/model.config",
        "d/e.urdf.xacro",
        "f.xml",
        "g.sdf.erb",
        "h.config",
        "i.urdf.xml",
    )
    assert names(tree) == ["a.sdf", "b.URDF", "c.world", "d/e.urdf.xacro", "d/model.config", "i.urdf.xml"]


def test_ignore_files_are_read_at_every_level(tree: Path) -> None:
    plant(tree, "a.sdf", "out/b.sdf", "sub/c.sdf", "sub/d.sdf", "sub/deep/c.sdf", "keep.tmp.sdf", "x.tmp.sdf")
    (tree / ".gitignore").write_text("!\n/out/\n*.tmp.sdf\n!keep.tmp.sdf\n")
    (tree / "sub" / ".gitignore").write_text("/c.sdf\n")
    assert names(tree) == ["a.sdf", "keep.tmp.sdf", "sub/d.sdf", "sub/deep/c.sdf"]
    assert "out/b.sdf" in names(tree, respect_gitignore=False)


def test_foreign_folders_are_not_entered(tree: Path) -> None:
    plant(tree, "a.sdf", ".venv/x.sdf", "node_modules/p/x.sdf", "install/share/x.sdf", "log/wood.sdf")
    (tree / "install" / "COLCON_IGNORE").touch()
    assert names(tree) == ["a.sdf", "log/wood.sdf"]
    assert names(tree, [tree / ".venv"]) == [".venv/x.sdf"]


def test_tests_of_faulty_files_are_left_out(tree: Path) -> None:
    plant(
        tree,
        "test/bad.sdf",
        "tests/data/no_name_error.urdf",
        "test/invalid/a.sdf",
        "test/badge.sdf",
        "bad.sdf",
    )
    assert names(tree) == ["bad.sdf", "test/badge.sdf"]
    assert names(tree, [tree / "test"]) == ["test/bad.sdf", "test/badge.sdf", "test/invalid/a.sdf"]
    assert names(tree, [tree / "test" / "bad.sdf"]) == ["test/bad.sdf"]


def test_ignored_folder_is_walked_when_named(tree: Path) -> None:
    plant(tree, "a.sdf", "out/b.sdf", "out/c.tmp.sdf", "out/d.sdf")
    (tree / ".gitignore").write_text("out\n")
    (tree / "out" / ".gitignore").write_text("*.tmp.sdf\n")
    assert names(tree, [tree / "out"]) == ["out/b.sdf", "out/d.sdf"]


@pytest.mark.skipif(not hasattr(os, "symlink"), reason="needs symbolic links")
def test_links_to_folders_are_not_followed(tree: Path) -> None:
    plant(tree, "a/b.sdf")
    (tree / "a" / "loop").symlink_to(tree / "a", target_is_directory=True)
    (tree / "c.sdf").symlink_to(tree / "a" / "b.sdf")
    assert names(tree) == ["a/b.sdf", "c.sdf"]


def test_subfolder_obeys_the_ignore_files_above(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    make_repository(tmp_path)
    plant(tmp_path, "sub/a.sdf", "sub/x.tmp.sdf")
    (tmp_path / ".gitignore").write_text("*.tmp.sdf\n")
    assert names(tmp_path, [tmp_path / "sub"]) == ["sub/a.sdf"]
    monkeypatch.setattr(git, "_git", lambda folder, *arguments: None)
    assert names(tmp_path, [tmp_path / "sub"]) == ["sub/a.sdf"]


def test_repositories_in_a_repository_are_entered(tmp_path: Path) -> None:
    make_repository(tmp_path)
    make_repository(tmp_path / "inner.robot")
    plant(tmp_path, "a.sdf", "inner.robot/b.sdf", "inner.robot/x.tmp.sdf")
    (tmp_path / "inner.robot" / ".gitignore").write_text("*.tmp.sdf\n")
    assert names(tmp_path) == ["a.sdf", "inner.robot/b.sdf"]


def test_submodules_are_entered(tmp_path: Path) -> None:
    make_repository(tmp_path)
    make_repository(tmp_path / "mod")
    plant(tmp_path, "mod/b.sdf")
    identity = ["-c", "user.name=n", "-c", "user.email=e@example.org"]
    subprocess.run(
        ["git", *identity, "commit", "-qm", "m", "--allow-empty"], cwd=tmp_path / "mod", check=True
    )
    subprocess.run(["git", "add", "mod"], cwd=tmp_path, check=True, capture_output=True)
    assert git.listed(tmp_path) == git.Listing((git.Listed("mod", is_repository=True),))
    assert names(tmp_path) == ["mod/b.sdf"]


def test_deleted_files_that_git_still_lists_are_left_out(tmp_path: Path) -> None:
    make_repository(tmp_path)
    plant(tmp_path, "a.sdf", "b.sdf")
    subprocess.run(["git", "add", "."], cwd=tmp_path, check=True)
    (tmp_path / "b.sdf").unlink()
    assert names(tmp_path) == ["a.sdf"]


def test_hook_environment_does_not_mislead_git(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    make_repository(tmp_path / "here")
    make_repository(tmp_path / "there")
    plant(tmp_path, "here/a.sdf", "there/b.sdf")
    monkeypatch.setenv("GIT_DIR", str(tmp_path / "there" / ".git"))
    assert names(tmp_path / "here") == ["a.sdf"]


def test_each_file_once_and_named_wins(tmp_path: Path) -> None:
    plant(tmp_path, "b.sdf", "a.sdf")
    found = discover([tmp_path, tmp_path / "b.sdf", tmp_path / "." / "b.sdf", tmp_path / "a.sdf", tmp_path])
    assert found.files == (
        DiscoveredFile(tmp_path / "a.sdf", named=True),
        DiscoveredFile(tmp_path / "b.sdf", named=True),
    )


def test_named_files_are_found_whatever_their_suffix(tmp_path: Path) -> None:
    plant(tmp_path, "a.xml")
    assert names(tmp_path, [tmp_path / "a.xml"]) == ["a.xml"]


def test_exclusion_spares_named_files_unless_forced(tmp_path: Path) -> None:
    plant(tmp_path, "a.sdf", "b.sdf")

    def exclude(path: Path) -> bool:
        return path.name == "b.sdf"

    walked = discover([tmp_path], exclude=exclude)
    assert [file.path.name for file in walked.files] == ["a.sdf"]
    assert walked.skipped == ((tmp_path / "b.sdf", "excluded by the configuration"),)
    assert discover([tmp_path / "b.sdf"], exclude=exclude).files
    assert not discover([tmp_path / "b.sdf"], exclude=exclude, force_exclude=True).files


def test_barren_folder_is_reported(tmp_path: Path) -> None:
    found = discover([tmp_path])
    assert found.files == ()
    assert found.empty == (tmp_path,)


def test_missing_path_is_wrong_usage(tmp_path: Path) -> None:
    with pytest.raises(WrongUsage, match=r"no such file or folder: .*gone\.sdf"):
        discover([tmp_path / "gone.sdf"])


def test_a_path_that_is_not_a_file_is_skipped_with_the_reason(tmp_path: Path) -> None:
    plant(tmp_path, "a.sdf")
    make_pipe(tmp_path / "pipe.sdf")
    (tmp_path / "zero.urdf").symlink_to("/dev/zero")
    (tmp_path / "loop.sdf").symlink_to("loop.sdf")
    (tmp_path / "gone.world").symlink_to("nothing.world")
    (tmp_path / "folder.sdf").mkdir()
    (tmp_path / "link.sdf").symlink_to("folder.sdf", target_is_directory=True)
    found = discover([tmp_path])
    assert [file.path.name for file in found.files] == ["a.sdf"]
    assert {path.name: reason for path, reason in found.skipped} == {
        "gone.world": "a link that leads nowhere",
        "loop.sdf": "a loop of links",
        "pipe.sdf": "a pipe, not a file",
        "zero.urdf": "a device, not a file",
    }


def test_so_it_is_where_git_lists_it(tmp_path: Path) -> None:
    make_repository(tmp_path)
    plant(tmp_path, "a.sdf")
    (tmp_path / "loop.sdf").symlink_to("loop.sdf")
    (tmp_path / "zero.urdf").symlink_to("/dev/zero")
    found = discover([tmp_path])
    assert [file.path.name for file in found.files] == ["a.sdf"]
    assert [path.name for path, _ in found.skipped] == ["loop.sdf", "zero.urdf"]


@pytest.mark.parametrize("place", [".gitignore", "sub/.gitignore"])
def test_an_ignore_file_that_is_a_pipe_is_not_read(
    tree: Path, place: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    plant(tree, "a.sdf", "sub/b.sdf")
    make_pipe(tree / place)
    monkeypatch.setattr(git, "TIMEOUT", 0.3)
    assert names(tree) == ["a.sdf", "sub/b.sdf"]


def test_git_runs_no_program_that_a_repository_names(tmp_path: Path) -> None:
    make_repository(tmp_path)
    plant(tmp_path, "a.sdf")
    program = tmp_path / "program"
    program.write_text(f"#!/bin/sh\ntouch {tmp_path}/ran\n")
    program.chmod(0o755)
    subprocess.run(["git", "config", "core.fsmonitor", str(program)], cwd=tmp_path, check=True)
    assert names(tmp_path) == ["a.sdf"]
    assert not (tmp_path / "ran").exists()


def test_folders_that_cannot_be_read_are_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    plant(tmp_path, "a.sdf", "closed/b.sdf", "open/c.sdf")
    known = os.scandir

    def scandir(folder: Path) -> object:
        if folder == tmp_path / "closed":
            raise PermissionError(13, "Permission denied")
        return known(folder)

    monkeypatch.setattr(os, "scandir", scandir)
    found = discover([tmp_path])
    assert [file.path.name for file in found.files] == ["a.sdf", "c.sdf"]
    assert found.unreadable == ((tmp_path / "closed", "cannot be read: Permission denied"),)


def test_so_are_those_that_git_cannot_read(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    make_repository(tmp_path)
    plant(tmp_path, "robots/a.sdf")
    known = git._git

    def complaining(folder: Path, *arguments: str) -> object:
        done = known(folder, *arguments)
        assert done is not None
        lines = [
            b"warning: something else",
            b"warning: could not open directory 'robots/closed/': Permission denied",
            b"warning: could not open directory 'robots/.cache/': Permission denied",
        ]
        return done._replace(complaints=b"\n".join(lines) + b"\n")

    monkeypatch.setattr(git, "_git", complaining)
    closed = tmp_path / "robots" / "closed", "cannot be read: Permission denied"
    for place in (tmp_path, tmp_path / "robots"):
        found = discover([place])
        assert [file.path.name for file in found.files] == ["a.sdf"]
        assert found.unreadable == (closed,)
