"""Rotations: the conversions agree with each other, and what cannot be meant is found."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from sdfcheck.robot.motion.rotations import (
    about_axis,
    angle_between,
    from_quaternion,
    from_rpy,
    inverse,
    to_rpy,
    transform,
)
from sdfcheck.robot.rotation_checks import DegreesAsRadians, NonUnitQuaternion, problems, urdf_problems
from sdfcheck.source.document import read

ANGLES = [(0.0, 0.0, 0.0), (0.1, -0.2, 0.3), (3.0, 1.5, -3.0), (-2.0, -1.2, 0.7)]


@pytest.mark.parametrize("angles", ANGLES)
def test_angles_there_and_back(angles: tuple[float, float, float]) -> None:
    assert to_rpy(from_rpy(*angles)) == pytest.approx(angles)


@pytest.mark.parametrize("pitch", [math.pi / 2, -math.pi / 2])
def test_at_the_poles_the_rotation_is_kept(pitch: float) -> None:
    rotation = from_rpy(0.4, pitch, 0.7)
    roll, found, yaw = to_rpy(rotation)
    assert found == pytest.approx(pitch)
    assert yaw == 0.0
    assert angle_between(from_rpy(roll, found, yaw), rotation) < 1e-8


def test_roll_pitch_yaw_turn_about_fixed_axes_in_this_order() -> None:
    roll, pitch, yaw = 0.3, 0.5, 0.7
    expected = about_axis((0, 0, 1), yaw) @ about_axis((0, 1, 0), pitch) @ about_axis((1, 0, 0), roll)
    assert from_rpy(roll, pitch, yaw) == pytest.approx(expected)


def test_quaternions() -> None:
    half = math.sqrt(0.5)
    quarter = from_rpy(0, 0, math.pi / 2)
    assert from_quaternion(0, 0, half, half) == pytest.approx(quarter)
    assert from_quaternion(0, 0, 3, 3) == pytest.approx(quarter)
    assert from_quaternion(0, 0, 0, 0) == pytest.approx(np.eye(3))


def test_inverse() -> None:
    pose = transform(from_rpy(0.1, 0.2, 0.3), (1, 2, 3))
    assert inverse(pose) @ pose == pytest.approx(np.eye(4))


def test_tiny_angles_between_rotations() -> None:
    assert angle_between(np.eye(3), from_rpy(0, 0, 1e-9)) == pytest.approx(1e-9)
    assert angle_between(np.eye(3), from_rpy(math.pi, 0, 0)) == pytest.approx(math.pi)


def poses(*texts: str) -> list[object]:
    links = "".join(f'<link name="l{number}">{text}</link>' for number, text in enumerate(texts))
    text = f'<sdf version="1.12"><model name="m">{links}</model></sdf>'
    return list(problems(read(text.encode(), Path("example.sdf"))))


@pytest.mark.parametrize(
    ("pose", "parts"),
    [
        ("0 0 0 0 0 90", ((5, "yaw"),)),
        ("0 0 0 -45 22.5 1.57", ((3, "roll"), (4, "pitch"))),
        ("90 0 0", ()),
        ("0 0 0 90 0 0", ((3, "roll"),)),
        ("0 0 0 0 0 6", ()),
        ("0 0 0 0 0 7.853981633974483", ()),
        ("0 0 0 0 0 inf", ()),
        ("90 90 90 0 0 0", ()),
    ],
)
def test_degrees_as_radians(pose: str, parts: tuple[tuple[int, str], ...]) -> None:
    told = poses(f"<pose>{pose}</pose>")
    assert [p.parts for p in told if isinstance(p, DegreesAsRadians)] == ([parts] if parts else [])


def test_degrees_that_say_so() -> None:
    assert poses('<pose degrees="true">0 0 0 0 0 90</pose>') == []


@pytest.mark.parametrize(
    ("quaternion", "length"),
    [
        ("0 0 1 1", math.sqrt(2)),
        ("0 0 0 0", 0.0),
        ("0 0 0.7071 0.7071", None),
        ("1 0 0 0", None),
        ("0 0 1", None),
    ],
)
def test_quaternions_of_other_lengths(quaternion: str, length: float | None) -> None:
    told = poses(f'<pose rotation_format="quat_xyzw">0 0 0 {quaternion}</pose>')
    found = [p.length for p in told if isinstance(p, NonUnitQuaternion)]
    assert found == ([pytest.approx(length)] if length is not None else [])


def test_urdf_angles() -> None:
    text = (
        '<robot name="r"><link name="l"><visual><origin xyz="90 0 0" rpy="0 0 90"/><geometry>'
        '<sphere radius="1"/></geometry></visual></link></robot>'
    )
    (problem,) = urdf_problems(read(text.encode(), Path("example.urdf")))
    assert isinstance(problem, DegreesAsRadians)
    assert problem.parts == ((2, "yaw"),)
