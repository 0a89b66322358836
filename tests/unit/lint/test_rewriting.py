"""Elements of the other format are written otherwise by a fix, but for what that would lose or change."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

SDF = '<sdf version="1.12"><model name="m">{}</model></sdf>'
JOINT = '<link name="a"/><link name="b"/><joint name="j" type="fixed"><parent>a</parent><child>b</child>{}</joint>'
LINK = '<link name="a"><visual name="v">{}</visual></link>'
BOX = "<geometry><box><size>1 1 1</size></box></geometry>"
URDF = f'<robot name="r">{LINK}</robot>'
SPHERE = '<geometry><sphere radius="1"/></geometry>'


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (SDF.format(JOINT.format('<origin xyz="0 0 1"/>')), "NS002"),
        (SDF.format(LINK.format(BOX + '<origin xyz="0 &#48; 1"/>')), "NS002"),
        (SDF.format(LINK.format(f"{BOX}<origin><!-- up --></origin>")), "NS002"),
        (SDF.format(LINK.format('<geometry><box size="1 1 1"><!-- a crate --></box></geometry>')), "SCH004"),
        (SDF.format(LINK.format(BOX + '<material><ambient/><color rgba="1 0 0 1"/></material>')), "SCH003"),
        (SDF.format('<link name="a"><inertial><mass value="&#50;"/></inertial></link>'), "SCH011"),
        (URDF.format(SPHERE + "<pose>1 2 3</pose>"), "URD001"),
        (URDF.format(SPHERE + "<pose>0 0 1 0 0 0<!-- up --></pose>"), "URD001"),
        (URDF.format("<geometry><box><size>1 1 1</size><size>2 2 2</size></box></geometry>"), "SCH005"),
        (URDF.format("<geometry><box><size>1 1 1</size><!-- a crate --></box></geometry>"), "SCH005"),
        (URDF.format("<geometry><box><size>1 1 1</size><p:x/></box></geometry>"), "SCH005"),
    ],
)
def test_nothing_is_lost(tmp_path: Path, text: str, code: str) -> None:
    file = tmp_path / ("r.urdf" if "<robot" in text else "m.sdf")
    file.write_text(text)
    found = sdfcheck.lint(file, isolated=True, select=[code]).diagnostics
    assert found
    assert all(each.fix is None for each in found)


def test_expressions_of_xacro_are_kept(tmp_path: Path) -> None:
    xacro = '<xacro:property name="h" value="1"/>'
    pose = "<pose>${h + 1} 0 0 0</pose>"
    file = tmp_path / "r.urdf.xacro"
    head = 'xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">'
    file.write_text(URDF.format(SPHERE + pose).replace('name="r">', head + xacro))
    (found,) = sdfcheck.lint(file, isolated=True, select=["URD001"]).diagnostics
    assert found.fix is None
