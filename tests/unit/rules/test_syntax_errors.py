"""The messages about tags that are missing, and their places."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

MODEL = '<sdf version="1.12"><model name="m">\n{}\n</model></sdf>'


@pytest.mark.parametrize(
    ("inside", "place", "message"),
    [
        ('  <link name="a">\n    <gravity>1</gravity>\n  ', "  ", "`</link>` is missing here"),
        ("  \n    <gravity>1</gravity>\n  </link>", "  ", "`<link>` is missing here"),
        ("<static>true", "true", "`</static>` is missing after `true`"),
        ("true</static>", "true", "`<static>` is missing before `true`"),
        (f"<static>{'x' * 80}", "x" * 80, f"`</static>` is missing after `{'x' * 60}`"),
    ],
    ids=["end-tag-on-its-line", "start-tag-on-its-line", "end-tag", "start-tag", "long-text"],
)
def test_a_tag_is_missing(inside: str, place: str, message: str) -> None:
    run = sdfcheck.lint(MODEL.format(inside), isolated=True, select=("XML001",))
    assert [(each.span.text, each.message) for each in run.diagnostics] == [(place, message)]


@pytest.mark.parametrize(("end", "severity"), [("-->", "warning"), ("--><xacro:b/>", "error")])
def test_a_call_in_a_comment_makes_no_source_of_xacro(end: str, severity: str, tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    path.write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="a"/>'
        f'<!--link name="b"/>\n<!-- <xacro:b/> {end}</robot>'
    )
    found = sdfcheck.lint(path, isolated=True).diagnostics
    assert [each.severity.value for each in found if each.code == "XML002"] == [severity]
