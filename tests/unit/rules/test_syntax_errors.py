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


@pytest.mark.parametrize(
    ("rest", "gazebo", "urdfdom"),
    [
        ("text", True, False),
        ("text <!-- c -->", False, False),
        ("text <x/>", False, False),
        ("text <x>", True, False),
    ],
)
def test_a_text_after_the_root_matters_at_the_end_of_the_file(rest: str, gazebo: bool, urdfdom: bool) -> None:
    text = f'<robot name="r"><link name="a"/></robot>\n{rest}'
    (found,) = sdfcheck.lint(text, isolated=True, select=["XML008"]).diagnostics
    refused = {name: reaction.is_refusal for name, reaction in dict(found.affects).items()}
    assert (refused["gazebo"], refused["urdfdom"]) == (gazebo, urdfdom)


def test_an_element_in_an_address_is_one_mistake() -> None:
    text = '<sdf version="1.9"><world name="w"><include><uri>file://<urdf></uri></include></world></sdf>'
    assert [each.code for each in sdfcheck.lint(text, isolated=True).diagnostics] == ["XML001"]


def test_the_name_of_an_element_in_another_place_is_no_misspelling() -> None:
    text = '<sdf version="1.9"><world name="w"><static>true</static></world></sdf>'
    (found,) = sdfcheck.lint(text, isolated=True, select=["SCH003"]).diagnostics
    assert "`model`" in found.message
    assert "did you mean" not in found.message
