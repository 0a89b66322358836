import os
import stat
from pathlib import Path

import pytest

from sdfcheck.files.overwrite import overwrite


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
