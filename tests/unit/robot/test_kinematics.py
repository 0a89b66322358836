"""How joints displace what they carry."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.mechanism import degrees_of_freedom, motions, with_followers
from sdfcheck.robot.motion.poses import about_axis
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import read

PATH = Path("r.urdf")

ROBOT = (
    '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="{}"><parent link="a"/>'
    '<child link="b"/><axis xyz="0 0 1"/></joint></robot>'
)


@pytest.mark.parametrize(
    ("kind", "positions", "shift", "turn"),
    [
        ("fixed", [], 0.0, 0.0),
        ("prismatic", [2.0], 2.0, 0.0),
        ("continuous", [0.5], 0.0, 0.5),
        ("planar", [3.0, 4.0, 0.5], 5.0, 0.5),
        ("floating", [1.0, 2.0, 2.0, 0.0, 0.0, 0.5], 3.0, 0.5),
    ],
)
def test_motions(kind: str, positions: list[float], shift: float, turn: float) -> None:
    document = read(ROBOT.format(kind).encode(), PATH)
    joint = mechanism_of(root_of(document).models[0]).joints["j"]
    assert degrees_of_freedom(joint) == len(positions)
    (moved,) = motions(joint, np.array([positions]))
    assert np.linalg.norm(moved[:3, 3]) == pytest.approx(shift)
    assert np.allclose(moved[:3, :3], about_axis(np.array([0.0, 0.0, 1.0]), np.array([turn]))[0])


def test_a_planar_joint_moves_across_its_axis() -> None:
    document = read(ROBOT.format("planar").encode(), PATH)
    joint = mechanism_of(root_of(document).models[0]).joints["j"]
    (moved,) = motions(joint, np.array([[3.0, 4.0, 0.0]]))
    assert moved[2, 3] == 0


@pytest.mark.parametrize(
    ("mimics", "expected"),
    [
        ({"b": ("a", 2)}, {"a": 1, "b": 2, "c": 3}),
        ({"b": ("a", 2), "c": ("b", 3)}, {"a": 1, "b": 2, "c": 6}),
        ({"a": ("b", 2), "b": ("c", 3)}, {"a": 18, "b": 9, "c": 3}),
        ({"a": ("a", 2)}, {"a": 1, "b": 2, "c": 3}),
        ({"a": ("b", 2), "b": ("c", 3), "c": ("b", 4)}, {"a": 1, "b": 2, "c": 3}),
        ({"a": ("lost", 2)}, {"a": 1, "b": 2, "c": 3}),
    ],
)
def test_followers_and_rings_of_them(mimics: dict[str, tuple[str, int]], expected: dict[str, float]) -> None:
    joints = "".join(
        f'<link name="{name}"/><joint name="{name}" type="continuous"><parent link="base"/><child link="{name}"/>'
        + (f'<mimic joint="{mimics[name][0]}" multiplier="{mimics[name][1]}"/>' if name in mimics else "")
        + "</joint>"
        for name in "abc"
    )
    document = read(f'<robot name="r"><link name="base"/>{joints}</robot>'.encode(), PATH)
    robot = mechanism_of(root_of(document).models[0])
    given = {name: np.array([[float(number)]]) for number, name in enumerate("abc", 1)}
    once = with_followers(robot, given)
    assert {name: float(value[0, 0]) for name, value in once.items()} == expected
    assert with_followers(robot, once) == once
