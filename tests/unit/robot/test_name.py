"""The words for sides in names."""

from __future__ import annotations

import pytest

from sdfcheck.robot.naming.name import counts_on, mirrored


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


@pytest.mark.parametrize(
    ("name", "others", "counts"),
    [
        ("LFJ4", ("RFJ4", "MFJ4", "FFJ4"), True),
        ("LFJ4", ("RFJ4", "LHJ4", "RHJ4"), False),
        ("lf_hip", ("rf_hip", "mf_hip"), True),
        ("left_hip", ("right_hip", "meft_hip"), False),
    ],
)
def test_little_and_ring_fingers_are_no_sides(name: str, others: tuple[str, ...], *, counts: bool) -> None:
    assert counts_on(name, mirrored(name), others) is counts
