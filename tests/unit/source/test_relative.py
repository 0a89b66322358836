from __future__ import annotations

import os

import pytest

from sdfcheck.source.text import relative_path


def test_a_path_from_a_folder() -> None:
    assert relative_path("/a/b/c", "/a/d") == os.path.join("..", "b", "c")


def test_no_way_leads_to_another_drive(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> str:
        raise ValueError("path is on mount 'D:', start on mount 'C:'")

    monkeypatch.setattr(os.path, "relpath", refuse)
    assert relative_path("/d/robot.sdf", "/c") == os.path.abspath("/d/robot.sdf")
