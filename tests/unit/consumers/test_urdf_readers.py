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


def refusing(text: str, folder: Path) -> set[str]:
    """The consumers that are said to refuse a robot."""
    path = folder / "robot.urdf"
    path.write_text(text)
    rows = verdicts(path, tuple(Consumer), SearchContext(Configuration(isolated=True)))
    return {row.consumer.value for row in rows if row.verdict is Verdict.REJECT}


@pytest.mark.parametrize(
    ("robot", "old", "new", "expected"),
    [
        (ALONE, "<inertia ", "<inertai ", "mujoco pybullet"),
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
        (ROBOT, "<collision>", '<collision name="b::c">', "gazebo"),
        (ON_WORLD, 'mass value="1"', 'mass value="heavy"', "drake gazebo isaac mujoco"),
        (LEGS, 'mass value="1"', 'mass value="heavy"', "drake isaac mujoco"),
        (LEGS, INERTIAL, "", "mujoco"),
        (ALONE, '"0"', '"inf"', "drake"),
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
