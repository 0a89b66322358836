"""Guessing what names were meant to be ends somewhere."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

JOINT = '<joint name="j{0}" type="fixed"><parent link="l{0}"/><child link="x{0}"/></joint>'
VISUAL = '<visual><geometry><sphere radius="1"/></geometry><material name="m{0}"/></visual>'
MATERIAL = '<material name="n{0}"><color rgba="1 1 1 1"/></material>'


@pytest.mark.parametrize(
    "part", ['<link name="l{0}"/>' + JOINT, f'<link name="l{{0}}">{VISUAL}</link>{MATERIAL}']
)
def test_a_robot_full_of_unknown_names(part: str, tmp_path: Path) -> None:
    path = tmp_path / "r.urdf"
    path.write_text('<robot name="r">' + "".join(map(part.format, range(3000))) + "</robot>")
    reported = [d for d in sdfcheck.lint(path, isolated=True).diagnostics if d.code in {"JNT001", "URD006"}]
    assert len(reported) == 3000
