"""How joints displace what they carry."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.motion.kinematics import degrees_of_freedom, motions
from sdfcheck.robot.motion.rotations import about_axis
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
