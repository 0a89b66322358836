"""The verdicts on a robot with one part that is misspelled, or one value that not everybody reads."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.parts.descriptions import SearchContext
from sdfcheck.cli.targets import verdicts
from sdfcheck.consumers.reaction import Consumer, Verdict
from sdfcheck.lint.config.configuration import Configuration

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
BOX = '<collision><geometry><box size="1 1 1"/></geometry></collision>'
ROBOT = (
    f'<robot name="r"><link name="a">{INERTIAL}</link><link name="b">{INERTIAL}{BOX}</link>'
    '<joint name="j" type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>'
    '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>'
)
ALONE = f'<robot name="r"><link name="a">{INERTIAL}</link></robot>'

ON_WORLD = ROBOT.replace(
    "<joint",
    '<link name="world"/><joint name="f" type="fixed"><parent link="world"/><child link="a"/></joint><joint',
    1,
)
LEGS = ON_WORLD.replace('"fixed"', '"continuous"').replace('<parent link="a"/>', '<parent link="world"/>')


def refusing(text: str, folder: Path, name: str = "robot.urdf") -> set[str]:
    """The consumers that are said to refuse a robot."""
    path = folder / name
    path.write_text(text)
    rows = verdicts(path, tuple(Consumer), SearchContext(Configuration(isolated=True)))
    return {row.consumer.value for row in rows if row.verdict is Verdict.REJECT}


@pytest.mark.parametrize(
    ("robot", "old", "new", "expected"),
    [
        (ALONE, "<inertia ", "<inertai ", "mujoco pybullet"),
        (
            ROBOT,
            'type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/>',
            'type="fixed"><parent link="a"/><child link="b"/><axis xyz="1e400"/>',
            "isaac mujoco",
        ),
        (
            ROBOT,
            'type="revolute"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/><limit lower="-1"',
            'type="fixed"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/><limit lower="low"',
            "gazebo isaac pinocchio ros urdfdom",
        ),
        (ALONE, "<mass ", "<masss ", "gazebo mujoco pybullet"),
        (ALONE, ' name="a"', "", "drake gazebo isaac mujoco pybullet"),
        (ROBOT, ' name="a"', ' name=""', "drake gazebo isaac mujoco pinocchio pybullet ros urdfdom"),
        (ROBOT, "<limit ", "<limits ", "gazebo pinocchio pybullet ros urdfdom"),
        (ROBOT, "effort=", "efort=", "gazebo pinocchio ros urdfdom"),
        (ROBOT, '<box size="1 1 1"/>', '<box size="1 1 1"/><box size="1 1 2"/>', "mujoco"),
        (ROBOT, 'upper="1"', 'upper="inf"', "drake gazebo pinocchio ros urdfdom"),
        (ROBOT, 'upper="1"', 'upper="1e400"', "drake gazebo mujoco pinocchio ros urdfdom"),
        (ROBOT, 'upper="1"', 'upper="1 "', "gazebo pinocchio ros urdfdom"),
        (ROBOT, 'upper="1"', 'upper="0x10"', "gazebo isaac pinocchio ros urdfdom"),
        (ROBOT, '<box size="1 1 1"/>', '<cylinder length="0,2" radius="1"/>', "drake isaac mujoco"),
        (ROBOT, '<box size="1 1 1"/>', '<cylinder length="2,0" radius="1"/>', "isaac mujoco"),
        (ALONE, '<link name="a">', '<link name="a"id="1">', "isaac"),
        (ALONE, "</link>", "< /link>", "isaac ros urdfdom"),
        (ALONE, "<mass ", "< mass ", "isaac"),
        (ALONE, "<mass ", "<!- x --><mass ", "isaac"),
        (
            ALONE,
            "<mass ",
            "<!- <a> </a> --><mass ",
            "drake gazebo isaac mujoco pinocchio pybullet ros urdfdom",
        ),
        (
            ALONE,
            "</robot>",
            '</robot><?xml version="1.0"?><a/>',
            "drake gazebo isaac mujoco pinocchio pybullet",
        ),
        (ALONE, "</link>", "</link><!-- a -- b -->", "isaac"),
        (ALONE, "<robot ", "<!DOCTYPE robot><robot ", ""),
        (ALONE, "<robot ", '<!DOCTYPE robot [<!ENTITY a "b">]><robot ', "gazebo ros urdfdom"),
        (ALONE, "<robot ", '<robot xmlns="http://example.org" ', "isaac"),
        (ROBOT, "<collision>", '<collision name="b::c">', "gazebo"),
        (ON_WORLD, 'mass value="1"', 'mass value="heavy"', "drake gazebo isaac mujoco"),
        (LEGS, 'mass value="1"', 'mass value="heavy"', "drake isaac mujoco"),
        (LEGS, INERTIAL, "", "mujoco"),
        (ALONE, '"0"', '"inf"', "drake"),
        (ALONE, 'mass value="1"', 'mass value="-1"', "gazebo"),
        (LEGS, 'mass value="1"', 'mass value="-1"', "mujoco"),
        (LEGS, 'mass value="1"', 'mass value="1e-9"', ""),
        (
            ALONE,
            "</link>",
            '<visual><geometry><mesh filename="${m}.stl"/></geometry></visual></link>',
            "drake pybullet",
        ),
        (
            ROBOT,
            "</robot>",
            ROBOT[ROBOT.index("<joint") :],
            "drake gazebo isaac mujoco pinocchio pybullet ros urdfdom",
        ),
    ],
)
def test_verdicts_follow_the_consumers(robot: str, old: str, new: str, expected: str, tmp_path: Path) -> None:
    assert refusing(robot.replace(old, new, 1), tmp_path) == set(expected.split())


def test_xacro_refuses_more_than_tinyxml2(tmp_path: Path) -> None:
    crowded = ALONE.replace('<link name="a">', '<link name="a"id="1">')
    assert refusing(crowded, tmp_path, "robot.urdf.xacro") == {one.value for one in Consumer}


LIMITED = '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
LINKAGE = (
    f'<robot name="r"><link name="a">{INERTIAL}</link><link name="b">{INERTIAL}</link><link name="c"/>'
    f'<joint name="j" type="revolute"><parent link="a"/><child link="b"/>{LIMITED}'
    f'<joint name="k" type="fixed"><parent link="a"/><child link="c"/></joint>'
    f'<joint name="l" type="revolute"><parent link="b"/><child link="c"/>{LIMITED}</robot>'
)


CHAIN = (
    f'<robot name="r"><link name="world"/><link name="base">{INERTIAL}</link><link name="arm">{INERTIAL}</link>'
    f'<link name="hand">{INERTIAL}</link><link name="tool"/>'
    '<joint name="w" type="fixed"><parent link="world"/><child link="base"/></joint>'
    f'<joint name="j" type="revolute"><parent link="base"/><child link="arm"/>{LIMITED}'
    f'<joint name="k" type="revolute"><parent link="base"/><child link="hand"/>{LIMITED}'
    '<joint name="f" type="fixed"><parent link="arm"/><child link="tool"/></joint></robot>'
)
MIMICKED = CHAIN.replace(
    '<parent link="base"/><child link="hand"/>', '<parent link="base"/><child link="hand"/><mimic joint="j"/>'
)


@pytest.mark.parametrize(
    ("robot", "old", "new", "expected"),
    [
        (CHAIN, f'"arm">{INERTIAL}', f'"arm">{INERTIAL.replace("mass", "masss")}', "gazebo mujoco pybullet"),
        (CHAIN, f'"arm">{INERTIAL}', f'"arm">{INERTIAL.replace("1", "1kg", 1)}', "gazebo isaac mujoco"),
        (CHAIN, f'"hand">{INERTIAL}', f'"hand">{INERTIAL.replace("1", "1kg", 1)}', "isaac mujoco"),
        (CHAIN, 'ixx="1"', 'ixx="inf"', "drake"),
        (CHAIN, 'ixx="1"', 'ixx="9 "', "mujoco"),
        (
            MIMICKED,
            '"j" type="revolute"',
            '"j" type=""',
            "drake gazebo isaac mujoco pinocchio pybullet ros urdfdom",
        ),
    ],
)
def test_libsdformat_drops_links_that_others_need(
    robot: str, old: str, new: str, expected: str, tmp_path: Path
) -> None:
    assert refusing(robot.replace(old, new, 1), tmp_path) == set(expected.split())


def test_libsdformat_does_not_meet_a_loop_at_a_link_that_it_drops(tmp_path: Path) -> None:
    assert "gazebo" not in refusing(LINKAGE, tmp_path)
    assert "gazebo" in refusing(
        LINKAGE.replace('<link name="c"/>', f'<link name="c">{INERTIAL}</link>'), tmp_path
    )
    assert "gazebo" in refusing(LINKAGE.replace('"l" type="revolute"', '"l" type="fixed"'), tmp_path)


def test_drake_takes_one_number_as_the_scale_of_a_mesh(tmp_path: Path) -> None:
    (tmp_path / "m.obj").write_text("")
    mesh = '<visual><geometry><mesh filename="m.obj" scale="{}"/></geometry></visual>'
    robot = f'<robot name="r"><link name="l">{mesh}</link></robot>'
    assert "drake" not in refusing(robot.format("0.001"), tmp_path)
    assert "isaac" in refusing(robot.format("0.001"), tmp_path)
    assert "drake" in refusing(robot.format("1 1"), tmp_path)


@pytest.mark.parametrize(("end", "expected"), [("wheel", True), ("base", False)])
def test_a_joint_to_a_link_of_a_call_without_prefix_is_refused(
    end: str, expected: bool, tmp_path: Path
) -> None:
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="side" params="n">'
        f'<link name="${{n}}">{INERTIAL}</link></xacro:macro><link name="base">{INERTIAL}</link>'
        f'<link name="top">{INERTIAL}</link><side n="wheel"/>'
        f'<joint name="j" type="fixed"><parent link="{end}"/><child link="top"/></joint></robot>'
    )
    assert ("urdfdom" in refusing(text, tmp_path, "robot.urdf.xacro")) is expected


def test_a_consumer_that_is_asked_for_refuses_what_the_others_take(tmp_path: Path) -> None:
    text = f'<robot name="r"><link name="l">{INERTIAL}</link><gz:note/></robot>'
    assert refusing(text, tmp_path) == {"isaac"}
    assert refusing(text.replace("<robot", '<robot xmlns:gz="urn:gz"'), tmp_path) == set()


def test_a_branch_that_is_not_taken_has_no_reactions(tmp_path: Path) -> None:
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:property name="n" value="1"/>'
        f'<link name="b">{INERTIAL}</link><xacro:if value="${{n == 2}}"><link name="a">'
        f'{INERTIAL.replace("mass ", "mas ")}</link><joint name="j" type="fixed"><parent link="b"/>'
        '<child link="a"/></joint></xacro:if></robot>'
    )
    assert refusing(text, tmp_path, "robot.urdf.xacro") == set()
    assert "pybullet" in refusing(text.replace("n == 2", "n == 1"), tmp_path, "robot.urdf.xacro")
