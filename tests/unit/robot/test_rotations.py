"""Rotations: the conversions agree with each other, and what cannot be meant is found."""

from __future__ import annotations

import math

import numpy as np
import pytest

import sdfcheck
from sdfcheck.robot.motion.origin import of_quaternion
from sdfcheck.robot.motion.poses import about_axis, angle_between, from_rpy, inverse, to_rpy, transform

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
    assert np.array(of_quaternion(0, 0, half, half)) == pytest.approx(quarter)
    assert np.array(of_quaternion(0, 0, 3, 3)) == pytest.approx(quarter)
    assert np.array(of_quaternion(0, 0, 0, 0)) == pytest.approx(np.eye(3))


def test_inverse() -> None:
    pose = transform(from_rpy(0.1, 0.2, 0.3), (1, 2, 3))
    assert inverse(pose) @ pose == pytest.approx(np.eye(4))


def test_tiny_angles_between_rotations() -> None:
    assert angle_between(np.eye(3), from_rpy(0, 0, 1e-9)) == pytest.approx(1e-9)
    assert angle_between(np.eye(3), from_rpy(math.pi, 0, 0)) == pytest.approx(math.pi)


def reported(pose: str, code: str) -> list[sdfcheck.Diagnostic]:
    text = f'<sdf version="1.12"><model name="m"><link name="l">{pose}</link></model></sdf>'
    run = sdfcheck.lint(text, isolated=True, name="model.sdf")
    return [diagnostic for diagnostic in run.diagnostics if diagnostic.code == code]


@pytest.mark.parametrize(
    ("pose", "parts"),
    [
        ("0 0 0 0 0 90", "yaw 90"),
        ("0 0 0 -45 22.5 1.57", "roll -45 and pitch 22.5"),
        ("90 0 0", None),
        ("0 0 0 90 0 0", "roll 90"),
        ("0 0 0 0 0 6", None),
        ("0 0 0 0 0 7.853981633974483", None),
        ("0 0 0 0 0 inf", None),
        ("90 90 90 0 0 0", None),
        ("0 0 0 x 0 90", None),
    ],
)
def test_degrees_as_radians(pose: str, parts: str | None) -> None:
    shown = [
        each.message.partition(" is ")[0].partition(" are ")[0]
        for each in reported(f"<pose>{pose}</pose>", "FRM006")
    ]
    assert shown == ([] if parts is None else [parts])


def test_degrees_that_say_so() -> None:
    assert reported('<pose degrees="true">0 0 0 0 0 90</pose>', "FRM006") == []
    assert reported('<pose rotation_format="quat_xyzw">0 0 0 0 0 90 0</pose>', "FRM006") == []


@pytest.mark.parametrize(
    ("quaternion", "length"),
    [
        ("0 0 1 1", "1.41"),
        ("0 0 0 0", "zero"),
        ("0 0 0.7071 0.7071", None),
        ("1 0 0 0", None),
        ("0 0 1", None),
        ("0 0 x 1", None),
    ],
)
def test_quaternions_of_other_lengths(quaternion: str, length: str | None) -> None:
    found = reported(f'<pose rotation_format="quat_xyzw">0 0 0 {quaternion}</pose>', "FRM007")
    assert len(found) == (length is not None)
    assert all(str(length) in diagnostic.message for diagnostic in found)


def test_urdf_angles() -> None:
    text = (
        '<robot name="r"><link name="l"><visual><origin xyz="90 0 0" rpy="0 0 90"/><geometry>'
        '<sphere radius="1"/></geometry></visual></link></robot>'
    )
    run = sdfcheck.lint(text, isolated=True, name="robot.urdf")
    (found,) = (diagnostic for diagnostic in run.diagnostics if diagnostic.code == "FRM006")
    assert found.message.startswith("yaw 90")
