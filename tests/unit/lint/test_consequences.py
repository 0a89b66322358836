"""One mistake is one finding: what follows from it is not reported beside it."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.lint.diagnostic import Severity

MASS = '<inertial><mass value="0.5"/><inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.002"/></inertial>'
LIMIT = '<axis xyz="0 1 0"/><limit lower="{}" upper="{}" effort="1" velocity="1"/>'
WHEEL = (
    f'<link name="wheel">{MASS}<collision><geometry><cylinder radius="0.1" length="0.05"/></geometry></collision>'
    '</link><joint name="turns" type="continuous"><origin xyz="0 0.2 0" rpy="-1.5707963 0 0"/><parent link="base"/>'
    '<child link="wheel"/><axis xyz="0 0 1"/></joint>'
)
ROBOT = (
    '<robot name="r"><material name="grey"><color rgba="0.5 0.5 0.5 1"/></material><link name="foot"/>'
    f'<link name="base">{MASS}<visual><geometry><box size="0.2 0.2 0.2"/></geometry><material name="grey"/></visual>'
    '</link><joint name="stands" type="fixed"><parent link="foot"/><child link="base"/></joint>'
    f'{WHEEL}<link name="arm">{MASS}</link><joint name="lifts" type="revolute"><parent link="base"/>'
    f'<child link="arm"/>{LIMIT.format(-1, 1)}</joint><link name="hand">{MASS}</link>'
    '<joint name="opens" type="prismatic"><parent link="arm"/><child link="hand"/>'
    f'{LIMIT.format(0, 0.04)}<mimic joint="lifts" multiplier="0.02" offset="0.02"/></joint>'
    '<gazebo reference="wheel"><mu1>1</mu1></gazebo></robot>'
)
SYSTEM = '<plugin filename="gz-sim-{}-system" name="gz::sim::systems::{}"/>'
INERTIAL = (
    "<inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial>"
)
BALL = '<collision name="c"><geometry><sphere><radius>0.15</radius></sphere></geometry></collision>'
WORLD = (
    f'<sdf version="1.10"><world name="w"><frame name="gate"/>{SYSTEM.format("physics", "Physics")}'
    f'{SYSTEM.format("imu", "Imu")}<model name="m" canonical_link="base"><pose relative_to="gate"/>'
    f'<link name="base">{INERTIAL}<sensor name="s" type="imu"/></link>'
    f'<link name="arm"><pose relative_to="lifts"/>{INERTIAL}</link><joint name="lifts" type="revolute">'
    '<pose relative_to="base"/><parent>base</parent><child>arm</child>'
    '<axis><xyz expressed_in="base">0 1 0</xyz></axis></joint><plugin filename="gz-sim-joint-controller-system" '
    'name="gz::sim::systems::JointController"><joint_name>lifts</joint_name></plugin></model></world></sdf>'
)


def codes(text: str, path: Path) -> list[str]:
    """The rules that have errors and warnings about a text."""
    path.write_text(text)
    return [each.code for each in sdfcheck.lint(path).diagnostics if each.severity is not Severity.INFO]


@pytest.mark.parametrize(("text", "name"), [(ROBOT, "r.urdf"), (WORLD, "w.sdf")])
def test_nothing_is_wrong(text: str, name: str, tmp_path: Path) -> None:
    assert codes(text, tmp_path / name) == []


@pytest.mark.parametrize(
    ("right", "wrong", "code"),
    [
        ('iyz="0"', 'iy="0"', "URD002"),
        ('<parent link="foot"/>', '<parent link=" "/>', "SCH005"),
        ('<parent link="foot"/>', '<parent link="feet"/>', "JNT001"),
        ('<joint name="stands" type="fixed">', '<joint name="stands" type="fix">', "SCH015"),
        ('offset="0.02"', 'offset="0,02"', "SCH011"),
        ('<axis xyz="0 0 1"/>', '<axiss xyz="0 0 1"/>', "URD001"),
        ('<axis xyz="0 0 1"/>', '<axis xy="0 0 1"/>', "URD002"),
        ('reference="wheel"', 'referenc="wheel"', "URD002"),
        ('value="0.5"', 'value="inf"', "SCH011"),
        ('value="0.5"', 'valu="0.5"', "URD002"),
        ('<mass value="0.5"/>', '<mas value="0.5"/>', "URD001"),
        ('<mass value="0.5"/>', "", "URD010"),
        ('name="lifts" type', 'name="lift" type', "JNT009"),
        ('name="lifts" type', 'nam="lifts" type', "URD002"),
    ],
)
def test_a_robot(right: str, wrong: str, code: str, tmp_path: Path) -> None:
    assert right in ROBOT
    assert codes(ROBOT.replace(right, wrong, 1), tmp_path / "r.urdf") == [code]


def test_a_material(tmp_path: Path) -> None:
    text = ROBOT.replace("<material", "<materia", 1).replace("</material>", "</materia>", 1)
    assert codes(text, tmp_path / "r.urdf") == ["URD001"]


@pytest.mark.parametrize(
    ("right", "wrong", "code"),
    [
        ('<link name="base">', "<link>", "SCH005"),
        ('<link name="base">', '<link names="base">', "NS001"),
        ('<link name="arm">', '<link name=" ">', "NAM006"),
        ('<frame name="gate"/>', "<frame/>", "SCH005"),
        ('<joint name="lifts"', "<joint", "SCH005"),
        ('<link name="base">', '<link name="bass">', "JNT001"),
        ('<link name="base">', '<link name="world">', "NAM003"),
        ("<parent>base</parent><child>arm</child>", "", "SCH004"),
        ('version="1.10"', 'versoin="1.10"', "NS001"),
        ('<axis><xyz expressed_in="base">0 1 0</xyz></axis>', "<axsi><xyz>0 1 0</xyz></axsi>", "NS002"),
        ('<link name="base">', '<link name="base"><collision name="c"><geometri/></collision>', "NS002"),
        ("gz-sim-imu-system", "gz-sim-imusystem", "RES015"),
        ('filename="gz-sim-imu-system"', 'filenam="gz-sim-imu-system"', "NS001"),
        ('filename="gz-sim-physics-system"', 'filenam="gz-sim-physics-system"', "NS001"),
        ('name="lifts" type', 'name="lift" type', "FRM001"),
        ('<pose relative_to="base"/>', '<poses relative_to="base"/>', "NS002"),
        ('<pose relative_to="base"/>', '<pose relative_too="base"/>', "NS001"),
        (
            f"{INERTIAL}</link>",
            f"{INERTIAL.replace('<mass>', '<pose>9 0 0</pose><mass>')}{BALL}</link>",
            "SCH013",
        ),
        (
            "<model",
            f'<model name="floor"><statik>true</statik><link name="l">{BALL}</link></model><model',
            "NS002",
        ),
        ("<model", f'<model name="floor"><static/><link name="l">{BALL}</link></model><model', "SCH011"),
        ("<child>arm</child>", "<child>arm</child><2nd>1</2nd>", "XML001"),
    ],
)
def test_a_world(right: str, wrong: str, code: str, tmp_path: Path) -> None:
    assert right in WORLD
    assert codes(WORLD.replace(right, wrong, 1), tmp_path / "w.sdf") == [code]


@pytest.mark.parametrize("name", ["joint", "link", "inertial", "mass"])
def test_a_misspelled_element(name: str, tmp_path: Path) -> None:
    head, _, rest = ROBOT.rpartition(f"<{name} ") if name != "inertial" else ROBOT.rpartition("<inertial>")
    end = "" if name == "mass" else f"</{name}>"
    rest = rest.replace(end, end[:-1] + "s>", 1) if end else rest
    text = f"{head}<{name}s{'>' if name == 'inertial' else ' '}{rest}"
    assert codes(text, tmp_path / "r.urdf") == ["URD001"]


@pytest.mark.parametrize("name", ["arm", "base"])
def test_a_link_that_is_there_twice(name: str, tmp_path: Path) -> None:
    link = WORLD[WORLD.index(f'<link name="{name}">') :].partition("</link>")[0] + "</link>"
    text = WORLD.replace(link, link.replace('type="imu"/>', 'type="imu"><topic>t</topic></sensor>') * 2)
    assert codes(text, tmp_path / "w.sdf") == ["NAM001"]


@pytest.mark.parametrize(("text", "name"), [(ROBOT, "r.urdf"), (WORLD, "w.sdf")])
def test_a_joint_that_is_there_twice(text: str, name: str, tmp_path: Path) -> None:
    joint = text[text.index('<joint name="lifts"') :].partition("</joint>")[0] + "</joint>"
    assert codes(text.replace(joint, joint * 2), tmp_path / name) == ["NAM001"]


def test_a_place_that_other_values_of_arguments_reach_again(tmp_path: Path) -> None:
    joint = '<link name="{0}"/><joint name="{0}_joint" type="fixed"><parent link="arm"/><child link="{0}"/></joint>'
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="tool" default="true"/>'
        f'<xacro:if value="$(arg tool)">{joint.format("tool")}</xacro:if>{joint.format("tip")}</robot>'
    )
    path = tmp_path / "r.urdf.xacro"
    path.write_text(text)
    found = [each for each in sdfcheck.lint(path).diagnostics if each.code == "JNT001"]
    assert [each.message[:34] for each in found] == ["parent `arm` of joint `tool_joint`"]


def test_a_misspelled_parameter(tmp_path: Path) -> None:
    macro = '<xacro:macro name="m" params="side"><link name="${{{}}}"/></xacro:macro><xacro:m side="a"/>'
    text = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{macro}</robot>'
    assert codes(text.format("side"), tmp_path / "r.urdf.xacro") == []
    assert codes(text.format("sidee"), tmp_path / "r.urdf.xacro") == ["XAC004"]
    assert codes(text.format("other"), tmp_path / "r.urdf.xacro") == ["XAC009", "XAC004"]


def test_it_does_what_follows_from_it(tmp_path: Path) -> None:
    path = tmp_path / "r.urdf"
    head, _, rest = ROBOT.rpartition("<inertial>")
    path.write_text(f"{head}<inertia>{rest.replace('</inertial>', '</inertia>', 1)}")
    (found,) = (each for each in sdfcheck.lint(path).diagnostics if each.code == "URD001")
    assert dict(found.affects)["gazebo"].words == "drops the link and those below it"
    assert "URD014" in {each.code for each in sdfcheck.lint(path, select=("URD014",)).diagnostics}


def test_a_name_that_nothing_has_is_corrected_everywhere(tmp_path: Path) -> None:
    path = tmp_path / "w.sdf"
    path.write_text(WORLD.replace('<link name="base">', '<link name="bass">'))
    (found,) = (each for each in sdfcheck.lint(path).diagnostics if each.code == "JNT001")
    assert [label.text for label in found.labels] == ["named here, too"] * 3
    assert found.fix is not None
    assert {(edit.span.text, edit.text) for edit in found.fix.edits} == {("base", "bass")}
    assert len(found.fix.edits) == 4
