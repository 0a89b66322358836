"""Names that are defined where nobody can look, and names that are misspelled."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.formats.near_names import misspelling_of

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


@pytest.mark.parametrize(
    ("name", "other", "same"),
    [
        ("wheel_macor", "wheel_macro", True),
        ("wheelmacro", "wheel_macro", True),
        ("Wheel_Macro", "wheel_macro", True),
        ("left_weel_joint", "left_wheel_joint", True),
        ("control_wheel", "control_head", False),
        ("control_imu", "control_arm", False),
        ("arm_1", "arm_2", False),
        ("arm_x", "arm_y", False),
        ("sensor_d435i", "sensor_d435", False),
        ("sensor_d415", "sensor_d435", False),
        ("scanner", "scanner_mount", False),
        ("base_z_offset", "shell_z_offset", False),
    ],
)
def test_a_misspelling_is_one_in_each_word(name: str, other: str, same: bool) -> None:
    assert (misspelling_of(name, [other]) == other) is same


def codes(folder: Path, name: str) -> list[str]:
    run = sdfcheck.lint(folder / name, isolated=True, ignore=["XAC005", "XAC007", "XAC009", "URD013"])
    return [diagnostic.code for diagnostic in run.diagnostics]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    return tmp_path


def test_names_that_an_unknown_package_may_define_are_not_missing(folder: Path) -> None:
    text = (
        f'<robot name="r" {XACRO}><xacro:include filename="$(find nowhere_near)/m.xacro"/>'
        '<xacro:macro name="scanner_mount" params="side"><link name="${{side}}"/></xacro:macro>'
        '<xacro:macro name="{}" params=""><xacro:{}/></xacro:macro></robot>'
    )
    (folder / "a.xacro").write_text(text.format("head", "scanner"))
    assert codes(folder, "a.xacro") == []
    (folder / "a.xacro").write_text(text.format("head", 'scaner_mount side="left"'))
    assert codes(folder, "a.xacro") == ["XAC003"]
    (folder / "a.xacro").write_text(text.format("scan_mount", "scanmount"))
    assert codes(folder, "a.xacro") == []


def test_an_included_robot_may_use_what_the_includer_has(folder: Path) -> None:
    link = '<link name="base"><visual><geometry><sphere radius="${SIZE}"/></geometry></visual></link>'
    (folder / "part.xacro").write_text(f'<robot name="part" {XACRO}>{link}</robot>')
    assert codes(folder, "part.xacro") == ["XAC004"]
    # Not even the whole project knows where SIZE comes from.
    whole = (
        '<xacro:include filename="$(find nowhere_near)/sizes.xacro"/><xacro:include filename="part.xacro"/>'
    )
    (folder / "whole.xacro").write_text(f'<robot name="whole" {XACRO}>{whole}</robot>')
    assert codes(folder, "part.xacro") == []


def test_the_file_to_include_is_named_in_a_part_that_an_expansion_read(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (folder / "utils.xacro").write_text(
        f'<robot {XACRO}><xacro:macro name="bar" params=""><link name="b"/></xacro:macro></robot>'
    )
    (folder / "arm.xacro").write_text(
        f'<robot {XACRO}>\n<xacro:macro name="arm" params="">\n<xacro:bar/></xacro:macro></robot>'
    )
    (folder / "r.urdf.xacro").write_text(
        f'<robot name="r" {XACRO}><xacro:include filename="arm.xacro"/><xacro:arm/></robot>'
    )
    monkeypatch.chdir(folder)
    (found,) = sdfcheck.lint(Path("r.urdf.xacro"), isolated=True, select=["XAC003"]).diagnostics
    assert found.message == "macro `bar` is not defined here: `utils.xacro` defines it, and is not included"
    assert [(each.span.source.path.name, each.span.begin.line) for each in found.labels] == [("arm.xacro", 1)]


_BOAT = '<xacro:arg name="ns" default="boat"/><xacro:property name="ns" value="$(arg ns)"/><link name="${ns}/hull"/>'


@pytest.mark.parametrize(
    ("content", "expected"),
    [
        ('<gazebo><plugin name="p" filename="p.so"><bodyName>boat/hull</bodyName></plugin></gazebo>', True),
        ('<gazebo><plugin name="p" filename="p.so"><bodyName>hull</bodyName></plugin></gazebo>', False),
        ('<xacro:if value="${ns == \'boat\'}"><gazebo reference="boat/hull"/></xacro:if>', False),
        ('<xacro:macro name="hook" params="parent"/><xacro:hook parent="boat/hull"/>', True),
        (
            '<xacro:macro name="m" params="n"><link name="${ns}/${n}"/><gazebo reference="${n}"/></xacro:macro>',
            True,
        ),
        (
            '<xacro:macro name="m" params="ns"><link name="${ns}/a"/></xacro:macro><gazebo reference="a"/>',
            False,
        ),
        ('<link name="boat/hull"/><gazebo reference="boat/hull"/>', False),
    ],
)
def test_a_name_that_the_default_of_an_argument_makes(folder: Path, content: str, *, expected: bool) -> None:
    robot = f'<robot name="r" {XACRO}>{{}}</robot>'
    (folder / "part.xacro").write_text(robot.format(content))
    (folder / "boat.urdf.xacro").write_text(robot.format(_BOAT + '<xacro:include filename="part.xacro"/>'))
    run = sdfcheck.lint(folder / "part.xacro", isolated=True, select=["XAC029"])
    assert bool(run.diagnostics) is expected
