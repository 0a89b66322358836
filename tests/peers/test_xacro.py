"""xacro files expand to the same text with sdfcheck and with xacro itself."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from tests.peers.findings import SHARED
from tests.peers.xacro_itself import compare, xacro_files

pytestmark = pytest.mark.peers

FOLDERS = [Path(__file__).parents[2] / "fixtures", SHARED / "corpus"]
LEAST = 60


def test_expansions_are_those_of_xacro() -> None:
    compared = list(compare(xacro_files(folder for folder in FOLDERS if folder.is_dir())))
    wrong = [f"{one.path}: {one.verdict}: {one.our_reason}" for one in compared if one.is_wrong]
    assert wrong == []
    same = Counter(one.verdict for one in compared)["same"]
    assert same >= (LEAST if SHARED.is_dir() else 3)


def test_more_is_refused_than_xacro_refuses(tmp_path: Path) -> None:
    """Else the comparison above would see nothing."""
    (tmp_path / ".git").mkdir()
    (tmp_path / "r.xacro").write_text(
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><a b="${python.type(1)}"/></robot>'
    )
    (one,) = compare(xacro_files([tmp_path]))
    assert one.verdict == "only sdfcheck fails"
    assert one.is_wrong
