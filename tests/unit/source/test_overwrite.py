import os
import shutil
import stat
from pathlib import Path

import pytest

from sdfcheck.files.overwrite import overwrite
from tests.posix import IS_ROOT, make_pipe, open_pipe


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
def test_a_pipe_is_written_to(tmp_path: Path, *, by_link: bool) -> None:
    pipe = tmp_path / "pipe"
    make_pipe(pipe)
    named = tmp_path / "link" if by_link else pipe
    if by_link:
        named.symlink_to("pipe")
    consumer = open_pipe(pipe)
    try:
        overwrite(named, b"new")
        assert os.read(consumer, 100) == b"new"
    finally:
        os.close(consumer)
    assert stat.S_ISFIFO(pipe.stat().st_mode)
    assert named.is_symlink() == by_link


def test_a_device_is_written_to(tmp_path: Path) -> None:
    link = tmp_path / "a.sdf"
    link.symlink_to("/dev/null")
    overwrite(link, b"new")
    assert link.is_symlink()
    assert stat.S_ISCHR(os.stat("/dev/null").st_mode)


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
