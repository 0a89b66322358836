"""The words for sides in names."""

from __future__ import annotations

import pytest

from sdfcheck.robot.naming.name import mirrored


@pytest.mark.parametrize(
    ("name", "other"),
    [
        ("left_wheel", "right_wheel"),
        ("front_left_wheel", "front_right_wheel"),
        ("FL_hip", "FR_hip"),
        ("LKnee", "RKnee"),
        ("Right_Arm", "Left_Arm"),
        ("arm_l", "arm_l"),
        ("base", "base"),
        ("right_left_finger", "right_left_finger"),
        ("l_r_bar", "l_r_bar"),
        ("r_r_bar", "l_l_bar"),
        ("l_arm_r", "r_arm_r"),
    ],
)
def test_the_name_on_the_other_side(name: str, other: str) -> None:
    assert mirrored(name) == other
