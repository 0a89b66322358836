"""One mistake gives one diagnostic: its consequences are not reported as well."""

from __future__ import annotations

import pytest

import sdfcheck

SPHERE = "<geometry><sphere><radius>1</radius></sphere></geometry>"
MOMENTS = "<inertia><ixx>1</ixx><iyy>1</iyy><IZZ>9</IZZ></inertia>"
MASS = "<inertial><mass>1</mass></inertial>"


def joint(child: str, kind: str = "fixed", inside: str = "") -> str:
    ends = f"<parent>base</parent><child>{child}</child>"
    return f'<joint name="to_{child}" type="{kind}">{ends}{inside}</joint>'


def reported(text: str) -> list[tuple[str, str, str]]:
    """The code, severity and text of what is more than information."""
    run = sdfcheck.lint(text, isolated=True, name="robot")
    shown = [each for each in run.diagnostics if each.severity is not sdfcheck.Severity.INFO]
    return [(each.code, each.severity.value, each.span.text) for each in shown]


@pytest.mark.parametrize(
    ("inside", "expected"),
    [
        (f'<link nmae="arm">{MASS}</link>{joint("arm")}', ("NS001", "error", "nmae")),
        (f'<Link name="arm">{MASS}</Link>{joint("arm")}', ("NS002", "error", "Link")),
        (f"<link>{MASS}</link>{joint('arm')}", ("SCH005", "error", "link")),
        (f'<link name="base">{MASS}</link>{joint("arm")}', ("NAM001", "error", "base")),
        (f'<visual name="v">{SPHERE}</visual>', ("SCH003", "error", "visual")),
        (
            f"<link name='arm'>{MASS}<visual name='v'><geomtry/></visual></link>",
            ("NS002", "error", "geomtry"),
        ),
        (
            joint("base_", "revolute", "<axsi/>").replace("base_", "arm") + "<link name='arm'/>",
            ("NS002", "error", "axsi"),
        ),
        (
            f"<link name='arm'><inertial><mass>1</mass>{MOMENTS}</inertial></link>",
            ("NS002", "warning", "IZZ"),
        ),
        (
            f"<link name='arm'><inertail/><visual name='v'>{SPHERE}</visual></link>",
            ("NS002", "warning", "inertail"),
        ),
    ],
)
def test_a_mistake_in_sdf_is_reported_once(inside: str, expected: tuple[str, str, str]) -> None:
    text = f'<sdf version="1.9"><model name="m"><link name="base">{MASS}</link>{inside}</model></sdf>'
    assert reported(text) == [expected]


def test_a_model_that_a_mistake_makes_static_needs_no_mass() -> None:
    link = f'<link name="l"><visual name="v">{SPHERE}</visual></link>'
    text = f'<sdf version="1.9"><model name="m"><static>ture</static>{link}</model></sdf>'
    assert reported(text) == [("SCH011", "error", "ture")]


def test_a_misspelled_version_attribute_is_reported() -> None:
    text = f'<sdf versiun="1.9"><model name="m"><link name="base">{MASS}</link></model></sdf>'
    assert reported(text) == [("NS001", "error", "versiun")]


def test_a_name_that_is_missed_twice_is_reported_once() -> None:
    ends = joint("arm") + joint("arm").replace("to_arm", "again")
    text = f'<sdf version="1.9"><model name="m"><link name="base">{MASS}</link>{ends}</model></sdf>'
    assert reported(text) == [("JNT001", "error", "arm")]


def test_a_misspelling_beside_a_double_is_reported_too() -> None:
    links = f'<link name="base">{MASS}</link>' * 2 + f'<link name="arm">{MASS}</link>'
    text = f'<sdf version="1.9"><model name="m">{links}{joint("Arm")}</model></sdf>'
    assert [code for code, _, _ in reported(text)] == ["NAM001", "JNT001"]


BACK = '<joint name="k" type="fixed"><parent link="arm"/><child link="base"/></joint>'
ENDS = '<parent link="base"/><child link="arm"/>'


@pytest.mark.parametrize(
    ("inside", "expected"),
    [
        (f'<LINK name="arm"/><joint name="j" type="fixed">{ENDS}</joint>', ("URD001", "error", "LINK")),
        (f'<link name="base"/><joint name="j" type="fixed">{ENDS}</joint>', ("NAM001", "error", "base")),
        (
            f'<link name="arm"/><joint name="j" type="fixed">{ENDS}</joint>{BACK}',
            ("JNT008", "error", "base"),
        ),
        (
            '<link name="arm"/><joint name="j" type="fixed"><parent>base</parent><child link="arm"/></joint>',
            ("SCH005", "error", "parent"),
        ),
    ],
)
def test_a_mistake_in_urdf_is_reported_once(inside: str, expected: tuple[str, str, str]) -> None:
    assert reported(f'<robot name="r"><link name="base"/>{inside}</robot>') == [expected]
