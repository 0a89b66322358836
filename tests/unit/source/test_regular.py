import os
from pathlib import Path

import pytest

from sdfcheck.files.regular import Configured, Unfit, oddity, read_named, read_regular
from tests.posix import make_pipe


def test_a_file_is_read(tmp_path: Path) -> None:
    path = tmp_path / "a.sdf"
    path.write_bytes(b"text")
    (tmp_path / "link").symlink_to("a.sdf")
    assert read_regular(path) == read_regular(tmp_path / "link") == b"text"
    assert read_regular(path, limit=4) == b"text"


def test_a_large_file_is_not(tmp_path: Path) -> None:
    path = tmp_path / "a.sdf"
    path.write_bytes(b"texts")
    with pytest.raises(Unfit, match="larger than"):
        read_regular(path, limit=4)


def test_only_a_limit_of_the_configuration_names_its_setting(tmp_path: Path) -> None:
    path = tmp_path / "a.sdf"
    path.write_bytes(b"texts")
    for limit, words in (
        (4, "larger than 4 bytes"),
        (Configured(4), "larger than 4 bytes (`max-file-size` in"),
    ):
        with pytest.raises(Unfit) as refused:
            read_regular(path, limit)
        assert str(refused.value.strerror).startswith(words)
        assert ("max-file-size" in str(refused.value)) is isinstance(limit, Configured)


@pytest.mark.parametrize("by_link", [False, True], ids=["itself", "by a link"])
def test_pipes_devices_and_folders_are_not(tmp_path: Path, *, by_link: bool) -> None:
    pipe = tmp_path / "pipe"
    make_pipe(pipe)
    for number, (path, kind) in enumerate([(pipe, "a pipe"), (Path("/dev/zero"), "a device")]):
        named = path
        if by_link:
            named = tmp_path / f"link{number}"
            named.symlink_to(path)
        assert oddity(named) == f"{kind}, not a file"
        with pytest.raises(Unfit, match=f"{kind}, not a file"):
            read_regular(named)
    with pytest.raises(Unfit, match="a folder, not a file"):
        read_regular(tmp_path)


def test_links_may_lead_nowhere(tmp_path: Path) -> None:
    (tmp_path / "loop").symlink_to("loop")
    (tmp_path / "gone").symlink_to("nothing")
    assert oddity(tmp_path / "loop") == "a loop of links"
    assert oddity(tmp_path / "gone") == "a link that leads nowhere"
    for name in ("loop", "gone"):
        with pytest.raises(OSError, match=name):
            read_regular(tmp_path / name)


def test_a_pipe_that_was_given_is_read() -> None:
    theirs, ours = os.pipe()
    os.write(ours, b"text")
    os.close(ours)
    try:
        assert read_named(Path(f"/dev/fd/{theirs}")) == b"text"
    finally:
        os.close(theirs)


def test_but_not_without_end() -> None:
    theirs, ours = os.pipe()
    os.write(ours, b"text" * 10)
    try:
        with pytest.raises(Unfit, match="larger than"):
            read_named(Path(f"/dev/fd/{theirs}"), limit=4)
    finally:
        os.close(theirs)
        os.close(ours)
