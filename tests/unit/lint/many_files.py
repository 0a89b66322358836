"""A folder of files that refer to one another, and what a run says of them."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.lint.run import Run

PART = '<sdf version="1.12"><model name="part"><static>maybe</static><link name="l"/></model></sdf>'
INCLUDE = "<include><uri>../parts/part.sdf</uri></include>"
PREFIX = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    for name in ("parts", "worlds"):
        (tmp_path / name).mkdir()
    (tmp_path / "parts/part.sdf").write_text(PART)
    for number in range(12):
        text = f'<sdf version="1.12"><world name="w{number}" foo="1">{INCLUDE}</world></sdf>'
        (tmp_path / f"worlds/{number:02}.sdf").write_text(text)
    (tmp_path / "worlds/r.xacro").write_text(f'<robot name="r" {PREFIX}><link name="${{x}}"/></robot>')
    (tmp_path / "worlds/a.sdf").write_text("no XML")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def shape(done: Run) -> list[tuple[object, ...]]:
    return [
        (
            d.code,
            d.message,
            str(d.span),
            [str(label.span) for label in d.labels],
            [str(o.span) for o in d.origins],
        )
        for d in done.diagnostics
    ]
