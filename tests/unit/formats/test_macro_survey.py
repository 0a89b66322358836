"""URDF in bodies of macros that no expansion shows."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'
INERTIA = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
SHAPE = '<geometry><sphere radius="1"/></geometry>'


def codes(body: str, tmp_path: Path, *, params: str = "") -> list[tuple[str, str]]:
    """The code and the text at the place of each diagnostic of a library with one macro."""
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    path = tmp_path / "library.xacro"
    path.write_text(f'{HEAD}<xacro:macro name="m" params="{params}">{body}</xacro:macro></robot>')
    run = sdfcheck.lint(path, isolated=True, ignore=["XAC009"])
    return [(diagnostic.code, diagnostic.span.text) for diagnostic in run.diagnostics]


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (f'<link name="a"><visul>{SHAPE}</visul></link>', ("URD001", "visul")),
        ('<link name="a"><mass value="1"/></link>', ("URD001", "mass")),
        ('<link name="a"><xacro:if value="1"><visul/></xacro:if></link>', ("URD001", "visul")),
        ('<joint name="a" typ="fixed"/>', ("URD002", "typ")),
        ('<link name="a"><inertial><mass value="1kg"/></inertial></link>', ("SCH011", "1kg")),
        ('<joint name="${n}" type="revolut"><parent link="${n}_p"/></joint>', ("SCH015", "revolut")),
        ('<inertial><orign/><mass value="1"/></inertial>', ("URD001", "orign")),
        (
            '<joint name="${n}" type="fixed"><xacro:insert_block name="origin"/><parent link="a"/></joint>',
            ("SCH004", "joint"),
        ),
        (f'<link name="a"><inertial><mass value="-1"/>{INERTIA}</inertial></link>', ("INR001", "-1")),
        (f'<link name="a"><visual>{SHAPE}<origin xyz="0 0"/></visual></link>', ("SCH013", "0 0")),
        (f'<link name="a"><visual>{SHAPE}<origin rpy="90 0 0"/></visual></link>', ("FRM006", "90")),
        ('<joint name="${n}" type="continuous"><axis xyz="0 0 0"/></joint>', ("JNT006", "0 0 0")),
    ],
)
def test_the_result_is_checked(body: str, expected: tuple[str, str], tmp_path: Path) -> None:
    assert expected in codes(body, tmp_path, params="n")


@pytest.mark.parametrize(
    "body",
    [
        '<link name="${n}"><visual><xacro:insert_block name="shape"/></visual></link>',
        '<link name="a"><inertial><xacro:weight/></inertial></link>',
        f'<visual><xacro:if value="1">{SHAPE}</xacro:if><xacro:unless value="1">{SHAPE}</xacro:unless></visual>',
        '<joint name="${n}"><command_interface name="position"/><param name="p">1</param></joint>',
        "<material>Gazebo/Red</material><mu1>1</mu1><mu2>1</mu2>",
        f'<link name="a"><visual>{SHAPE}<origin xyz="0 0 ${{n}}" rpy="${{[0, n, 0]}}"/></visual></link>',
        '<mass value="${n}"/>',
        f'<link name="a"><visual>{SHAPE}<origin rpy="${{n}} 0 90"/></visual></link>',
        '<joint name="j" type="${n}"><parent link="a"/><child link="b"/><axis xyz="0 0 0"/></joint>',
    ],
)
def test_content_that_xacro_inserts_is_not_judged(body: str, tmp_path: Path) -> None:
    calls = '<xacro:macro name="weight"><mass value="1"/></xacro:macro>'
    assert not codes(body + calls, tmp_path, params="n *shape")


def test_expanded_text_is_checked_there_alone(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf.xacro"
    macro = '<xacro:macro name="m" params="n"><link name="${n}" tpye="x"/></xacro:macro>'
    path.write_text(
        f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{macro}<xacro:m n="a"/></robot>'
    )
    found = [d for d in sdfcheck.lint(path, isolated=True).diagnostics if d.code == "URD002"]
    assert len(found) == 1


def test_a_library_is_reported_once(tmp_path: Path) -> None:
    macro = '<xacro:macro name="m" params="n"><link name="${n}" tpye="x"/></xacro:macro>'
    (tmp_path / "library.xacro").write_text(f"{HEAD}{macro}</robot>")
    (tmp_path / "robot.urdf.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:include filename="library.xacro"/><xacro:m n="a"/></robot>'
    )
    found = [d for d in sdfcheck.lint(tmp_path, isolated=True).diagnostics if d.code == "URD002"]
    assert [d.span.source.path.name for d in found] == ["library.xacro"]
    assert not found[0].origins
