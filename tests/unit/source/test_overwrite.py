import fcntl
import os
import shutil
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from sdfcheck.files.overwrite import Refused, overwrite
from sdfcheck.files.regular import noting, read_regular
from tests.posix import IS_ROOT, make_pipe


def test_the_mode_stays(tmp_path: Path) -> None:
    path = tmp_path / "a.sdf"
    path.write_bytes(b"old")
    path.chmod(0o741)
    overwrite(path, b"new")
    assert path.read_bytes() == b"new"
    assert stat.S_IMODE(path.stat().st_mode) == 0o741
    assert os.listdir(tmp_path) == ["a.sdf"]


def test_a_new_file_gets_an_ordinary_mode(tmp_path: Path) -> None:
    overwrite(tmp_path / "a.sdf", b"new")
    (tmp_path / "b.sdf").write_bytes(b"")
    assert (tmp_path / "a.sdf").stat().st_mode == (tmp_path / "b.sdf").stat().st_mode


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "real" / "a.sdf").write_bytes(b"old")
    link = tmp_path / "a.sdf"
    link.symlink_to("real/a.sdf")
    overwrite(link, b"new")
    assert link.is_symlink()
    assert (tmp_path / "real" / "a.sdf").read_bytes() == b"new"


def test_a_failure_leaves_the_file_and_nothing_else(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "a.sdf"
    path.write_bytes(b"old")

    def fail(*_: object) -> None:
        raise OSError(28, "no space")

    monkeypatch.setattr(os, "replace", fail)
    with pytest.raises(OSError, match="no space"):
        overwrite(path, b"new")
    assert path.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["a.sdf"]


@pytest.mark.skipif(not IS_ROOT, reason="only root gives files away")
def test_owner_and_group_stay(tmp_path: Path) -> None:
    path = tmp_path / "a.sdf"
    path.write_bytes(b"old")
    shutil.chown(path, 1234, 4321)
    path.chmod(0o4755)
    overwrite(path, b"new")
    status = path.stat()
    assert path.read_bytes() == b"new"
    assert (status.st_uid, status.st_gid, stat.S_IMODE(status.st_mode)) == (1234, 4321, 0o4755)


def test_a_file_whose_owner_cannot_be_kept_is_left_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.sdf"
    path.write_bytes(b"old")

    def refuse(*_: object) -> None:
        raise PermissionError(1, "Operation not permitted")

    known = os.stat

    def of_another(what: object, **options: object) -> os.stat_result:
        status = known(what, **options)  # type: ignore[arg-type]
        return os.stat_result((*status[:4], status.st_uid + (what == path), *status[5:]))

    monkeypatch.setattr(os, "chown", refuse)
    monkeypatch.setattr(os, "stat", of_another)
    with pytest.raises(OSError, match="owner and group cannot be kept"):
        overwrite(path, b"new")
    assert path.read_bytes() == b"old"
    assert os.listdir(tmp_path) == ["a.sdf"]


@pytest.mark.parametrize("by_link", [False, True], ids=["itself", "by a link"])
@pytest.mark.parametrize("kind", ["pipe", "device", "folder"])
def test_pipes_devices_and_folders_are_not_written_to(tmp_path: Path, kind: str, *, by_link: bool) -> None:
    place = tmp_path / "odd" if kind != "device" else Path("/dev/zero")
    if kind == "pipe":
        make_pipe(place)
    elif kind == "folder":
        place.mkdir()
    named = tmp_path / "link" if by_link else place
    if by_link:
        named.symlink_to(place)
    with pytest.raises(Refused, match="is not a file"):
        overwrite(named, b"new")
    assert named.is_symlink() == by_link


def test_the_null_device_takes_everything() -> None:
    overwrite(Path(os.devnull), b"new")
    assert stat.S_ISCHR(os.stat(os.devnull).st_mode)


def test_a_link_that_leads_out_is_not_followed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "repo" / ".git").mkdir(parents=True)
    (tmp_path / "repo" / "below").mkdir()
    (tmp_path / "out").mkdir()
    (tmp_path / "out" / "a.sdf").write_bytes(b"old")
    (tmp_path / "repo" / "a.sdf").symlink_to("../out/a.sdf")
    (tmp_path / "repo" / "results").symlink_to("../out")
    for name in ("a.sdf", "results/a.sdf", "results/new.sdf"):
        with pytest.raises(Refused, match=r"leads out of .*repo by a link"):
            overwrite(tmp_path / "repo" / name, b"new")
    (tmp_path / "repo" / "inside.sdf").symlink_to("below/b.sdf")
    overwrite(tmp_path / "repo" / "inside.sdf", b"new")
    assert (tmp_path / "repo" / "below" / "b.sdf").read_bytes() == b"new"
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["a.sdf"]
    monkeypatch.chdir(tmp_path / "out")
    (tmp_path / "out" / "b.sdf").symlink_to("../elsewhere")
    with pytest.raises(Refused, match="leads out"):
        overwrite(Path("b.sdf"), b"new")
    assert not (tmp_path / "elsewhere").exists()


def test_inputs_are_kept(tmp_path: Path) -> None:
    path, other = tmp_path / "a.sdf", tmp_path / "b.sdf"
    path.write_bytes(b"old")
    os.link(path, other)
    with noting():
        assert read_regular(path) == b"old"
        with pytest.raises(Refused, match="is an input"):
            overwrite(other, b"new")
        overwrite(path, b"new", instead=True)
    overwrite(other, b"newer")
    assert (path.read_bytes(), other.read_bytes()) == (b"new", b"newer")


_KILLED = """
import os, signal, sys
from pathlib import Path
from sdfcheck.files.overwrite import overwrite
os.fsync = lambda handle: os.kill(os.getpid(), signal.SIGKILL)
overwrite(Path(sys.argv[1]), b"new")
"""


def test_leftovers_of_a_killed_run_are_removed(tmp_path: Path) -> None:
    path = tmp_path / "a.sdf"
    path.write_bytes(b"old")
    subprocess.run([sys.executable, "-c", _KILLED, str(path)], check=False)
    assert path.read_bytes() == b"old"
    assert len(os.listdir(tmp_path)) == 2
    overwrite(path, b"newer")
    assert os.listdir(tmp_path) == ["a.sdf"]


def test_files_of_another_run_are_left_alone(tmp_path: Path) -> None:
    theirs = tmp_path / f".sdfcheck-{'0' * 16}"
    with theirs.open("wb") as stream:
        stream.write(b"theirs")
        stream.flush()
        fcntl.flock(stream, fcntl.LOCK_EX)
        overwrite(tmp_path / "a.sdf", b"ours")
        assert theirs.exists()
    (tmp_path / ".sdfcheck.toml").write_text("")
    (tmp_path / f".sdfcheck-{'1' * 16}").mkdir()
    overwrite(tmp_path / "a.sdf", b"ours")
    assert sorted(os.listdir(tmp_path)) == [f".sdfcheck-{'1' * 16}", ".sdfcheck.toml", "a.sdf"]


def test_an_open_file_is_written_on(tmp_path: Path) -> None:
    path = tmp_path / "log"
    path.write_bytes(b"before ")
    inode = path.stat().st_ino
    with path.open("ab") as stream:
        link = tmp_path / "link"
        link.symlink_to(f"/dev/fd/{stream.fileno()}")
        overwrite(Path(f"/dev/fd/{stream.fileno()}"), b"one ")
        overwrite(link, b"two")
    assert path.read_bytes() == b"before one two"
    assert path.stat().st_ino == inode
