"""The reports of the rules about ros2_control in whole robots, and the absence of them."""

from __future__ import annotations

import pytest

import sdfcheck
from sdfcheck.robot.graph import ControlComponent

LINKS = "".join(f'<link name="{name}"/>' for name in "abcd")
LIMIT = '<limit lower="-1" upper="1" effort="5" velocity="2"/>'
ROBOT = (
    f'<robot name="r">{LINKS}'
    f'<joint name="j" type="revolute"><parent link="a"/><child link="b"/>{LIMIT}</joint>'
    f'<joint name="k" type="revolute"><parent link="b"/><child link="c"/>{LIMIT}<mimic joint="j"/></joint>'
    '<joint name="f" type="fixed"><parent link="c"/><child link="d"/></joint>{}</robot>'
)
COMMAND = '<command_interface name="position"/>'
STATE = '<state_interface name="position"/>'
HARDWARE = "<hardware><plugin>a/B</plugin></hardware>"


def codes(text: str, *select: str) -> list[str]:
    found = sdfcheck.lint(ROBOT.replace("{}", text), isolated=True, select=select or ["R2C"]).diagnostics
    return [diagnostic.code for diagnostic in found]


def block(inside: str, name: str = "c", type: str = "system") -> str:
    return f'<ros2_control name="{name}" type="{type}">{HARDWARE}{inside}</ros2_control>'


def joint(name: str, inside: str = "", more: str = "") -> str:
    return f'<joint name="{name}"{more}>{inside or STATE}</joint>'


@pytest.mark.parametrize(
    ("text", "found"),
    [
        (block(joint("j") + joint("k")), []),
        (block(joint("j", COMMAND)) + block(joint("j", STATE), "d"), []),
        (block(joint("j", STATE + COMMAND)) + block(joint("j", STATE + COMMAND), "d"), ["R2C014"]),
        (block(joint("j")) + block(joint("k"), "d"), ["R2C016"]),
        (block(joint("j") + joint("k", COMMAND)), ["R2C015"]),
        (block(joint("j") + joint("k", COMMAND, ' mimic="FALSE"')), []),
        (block(joint("f")), ["R2C011"]),
        (block(joint("${prefix}f", COMMAND)), []),
        (block('<gpio name="io"><command_interface name="any_name_at_all"/></gpio>'), []),
        (
            block(
                joint("j", '<command_interface name="position"><limits enable="yes"/></command_interface>')
            ),
            ["R2C019"],
        ),
        (block(joint("j", '<state_interface name="volts"><param name="x"/></state_interface>')), []),
        (block(joint("j") + "<vendor:thing/>"), ["R2C005"]),
        ('<ros2_control name="c" type="system"/>', ["R2C007"]),
        (block("", type="${type}"), []),
    ],
)
def test_blocks(text: str, found: list[str]) -> None:
    quiet = ["R2C030", "R2C031", "R2C032"]
    shown = sdfcheck.lint(ROBOT.replace("{}", text), isolated=True, select=["R2C"], ignore=quiet).diagnostics
    assert [diagnostic.code for diagnostic in shown] == found


def test_a_missing_joint_is_reported_once() -> None:
    assert codes(block(joint("jj")), "R2C", "URD012") == ["URD012"]


def test_the_robot_knows_its_blocks() -> None:
    robot = sdfcheck.parse(ROBOT.replace("{}", block(joint("j", COMMAND) + joint("k")))).models[0]
    (found,) = robot.ros2_control
    assert [each.name for each in found.components] == ["j", "k"]
    lift = found.joints["j"]
    assert lift.joint is robot.joints_by_name["j"]
    assert [each.is_command for each in lift.interfaces] == [True]
    assert found.joints["k"].mimic is not None


def test_a_simulated_sensor_is_that_of_a_sensor_not_of_a_joint() -> None:
    simulated = '<gazebo reference="a"><sensor name="j" type="imu"/></gazebo>'
    text = ROBOT.replace("{}", block(joint("j") + '<sensor name="j"/>') + simulated)
    of_joint, of_sensor = sdfcheck.parse(text).each(ControlComponent)
    assert of_joint.sensor is None
    assert of_sensor.sensor is not None
