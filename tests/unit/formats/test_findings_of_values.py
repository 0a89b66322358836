"""The findings of the walk in values."""

from __future__ import annotations

import pytest

from sdfcheck.formats import problems
from tests.unit.formats.walk import found, in_link, only_in_link
from tests.unit.only import only

MESH = '<visual name="v"><geometry><mesh>{}</mesh></geometry></visual>'


@pytest.mark.parametrize(
    ("text", "kind", "part"),
    [
        ("<pose>0 0 x 0 0 0</pose>", problems.MalformedValue, "x"),
        ("<pose>0 0 0</pose>", problems.WrongComponentCount, "0 0 0"),
        ("<pose>0 0 0 0 0 0 7 8</pose>", problems.WrongComponentCount, "7 8"),
        ("<pose>0 0 0 0 0 1,5</pose>", problems.MisreadValue, "1,5"),
        ('<pose rotation_format="quat_xyzw">0 0 0 0 0 0</pose>', problems.WrongComponentCount, "0 0 0 0 0 0"),
        ("<inertial><mass/></inertial>", problems.MalformedValue, "mass"),
        (
            "<sensor name='s' type='imu'><update_rate>-1</update_rate></sensor>",
            problems.ValueOutOfRange,
            "-1",
        ),
        ("<inertial><mass>inf</mass></inertial>", problems.ValueOutOfRange, "inf"),
        ("<light name='l' type='area'/>", problems.UnknownChoice, "area"),
    ],
)
def test_values(text: str, kind: type, part: str) -> None:
    problem = only_in_link(text, kind)
    span = problem.value.span if kind is problems.UnknownChoice else problem.span
    assert span.text == part


def test_an_empty_value_is_refused_or_the_default() -> None:
    assert not only_in_link("<inertial><mass/></inertial>", problems.MalformedValue).reading.refused
    assert only_in_link(MESH.format("<uri/>"), problems.MalformedValue).reading.refused
    assert in_link("<pose/>") == []


@pytest.mark.parametrize(
    ("text", "rest"),
    [
        ("<pose>0 0 0 <!-- rpy --> 0 0 0</pose>", "0 0 0"),
        ("<pose><!-- a -->0 0 0 0 0<!-- b --><!-- c -->0</pose>", "0"),
        ("<inertial><mass>1<!-- kg -->.5</mass></inertial>", ".5"),
    ],
)
def test_values_end_at_a_comment(text: str, rest: str) -> None:
    assert only_in_link(text, problems.CutText).rest.text == rest


def test_comments_around_a_value_do_no_harm() -> None:
    assert in_link("<pose><!-- a --> 0 0 0 0 0 0 <!-- b --></pose>") == []


def test_degrees_and_quaternions() -> None:
    pose = '<pose degrees="{}" rotation_format="quat_xyzw">0 0 0 0 0 0 1</pose>'
    problem = only_in_link(pose.format("true"), problems.ConflictingRotation)
    assert (problem.value.text, problem.format.text) == ("true", "quat_xyzw")
    assert in_link(pose.format("false")) == []


def test_a_value_that_the_newest_version_accepts_is_accepted() -> None:
    camera = "<sensor name='s' type='camera'><camera><horizontal_fov>3</horizontal_fov></camera></sensor>"
    assert in_link(camera, "1.4") == []


def test_choices_of_a_list_that_nobody_enforces() -> None:
    world = '<sdf version="1.9"><world name="w"><physics type="{}"/></world></sdf>'
    assert not only(found(world.format("quick")), problems.UnknownChoice).refused
    assert found(world.format("dart")) == []
