"""Resolved poses."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

import sdfcheck
from sdfcheck.files.library import Library
from sdfcheck.robot.motion.flatten import direction_of
from sdfcheck.robot.motion.origin import PoseError
from sdfcheck.robot.motion.poses import Array, Poses, from_rpy, transform, written_pose
from sdfcheck.robot.part import Placement
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document, read


def document(text: str, version: str = "1.12") -> Document:
    whole = text if text.startswith("<robot") else f'<sdf version="{version}">{text}</sdf>'
    return read(whole.encode(), Path("example"))


def pose_of(reference: str, parsed: Document) -> Array:
    return Poses().named(root_of(parsed).scopes[0], reference)


def at(x: float, y: float, z: float, roll: float = 0, pitch: float = 0, yaw: float = 0) -> Array:
    return transform(from_rpy(roll, pitch, yaw), (x, y, z))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("<pose>1 2 3 0.1 0.2 0.3</pose>", at(1, 2, 3, 0.1, 0.2, 0.3)),
        ('<pose degrees="true">0 0 0 0 0 90</pose>', at(0, 0, 0, yaw=math.pi / 2)),
        ('<pose rotation_format="quat_xyzw">1 0 0 0 0 1 1</pose>', at(1, 0, 0, yaw=math.pi / 2)),
        ("<pose/>", np.eye(4)),
    ],
)
def test_written_poses(text: str, expected: Array) -> None:
    parsed = document(f'<model name="m"><link name="a">{text}</link></model>')
    (pose,) = (element for element in parsed.elements if element.name == "pose")
    assert written_pose(pose) == pytest.approx(expected)
    assert written_pose(None) == pytest.approx(np.eye(4))


CHAIN = """<model name="m">
  <pose>9 9 9 0 0 0</pose>
  <link name="a"><pose>1 0 0 0 0 1.5707963267948966</pose></link>
  <link name="b"><pose relative_to="a">1 0 0 0 0 0</pose></link>
  <joint name="j" type="fixed"><pose>0 0 1 0 0 0</pose><parent>a</parent><child>b</child></joint>
  <frame name="f" attached_to="j"><pose>1 0 0 0 0 0</pose></frame>
  <frame name="g" attached_to="j"><pose relative_to="__model__">5 0 0 0 0 0</pose></frame>
  <model name="n"><pose relative_to="f">0 0 1 0 0 0</pose>
    <link name="l"><pose>0 1 0 0 0 0</pose></link></model>
</model>"""


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("b", at(1, 1, 0, yaw=math.pi / 2)),
        ("j", at(1, 1, 1, yaw=math.pi / 2)),
        ("f", at(1, 2, 1, yaw=math.pi / 2)),
        ("g", at(5, 0, 0)),
        ("n", at(1, 2, 2, yaw=math.pi / 2)),
        ("n::l", at(0, 2, 2, yaw=math.pi / 2)),
        ("__model__", np.eye(4)),
    ],
)
def test_poses_are_relative_to_what_they_say(name: str, expected: Array) -> None:
    assert pose_of(name, document(CHAIN)) == pytest.approx(expected)


def test_a_placement_frame_is_where_the_pose_says() -> None:
    parsed = document(
        '<world name="w"><model name="m" placement_frame="f"><pose>1 2 3 0 0 0.5</pose>'
        '<link name="l"/><frame name="f"><pose>4 5 6 0.7 0 0</pose></frame></model></world>'
    )
    assert pose_of("m::f", parsed) == pytest.approx(at(1, 2, 3, yaw=0.5))


def test_the_old_spelling_of_references() -> None:
    text = (
        '<model name="m"><link name="a"><pose>1 0 0 0 0 0</pose></link>'
        '<link name="b"><pose frame="a"/></link></model>'
    )
    assert pose_of("b", document(text, "1.6")) == pytest.approx(at(1, 0, 0))
    assert pose_of("b", document(text, "1.7")) == pytest.approx(np.eye(4))


@pytest.mark.parametrize(
    "text",
    [
        '<link name="a"><pose relative_to="q"/></link>',
        '<link name="a"><pose relative_to="a"/></link>',
        '<link name="a"><pose relative_to="b"/></link><link name="b"><pose relative_to="a"/></link>',
        '<link name="a"><pose relative_to="n"/></link><model name="n"><pose relative_to="a"/></model>',
        '<link name="a"><pose>1 2 3</pose></link>',
    ],
)
def test_poses_that_lead_nowhere(text: str) -> None:
    parsed = document(f'<model name="m">{text}</model>')
    with pytest.raises(PoseError):
        pose_of("a", parsed)


def test_long_chains() -> None:
    links = "".join(
        f'<link name="l{n}"><pose relative_to="l{n + 1}">1 0 0 0 0 0</pose></link>' for n in range(3000)
    )
    parsed = document(f'<model name="m">{links}<link name="l3000"/></model>')
    assert pose_of("l0", parsed)[0, 3] == 3000


def test_poses_of_parts() -> None:
    parsed = document(
        '<model name="m"><link name="a"><pose>1 0 0 0 0 0</pose>'
        '<visual name="v"><pose>0 1 0 0 0 0</pose></visual>'
        '<visual name="x"><pose relative_to="__model__"/></visual></link></model>'
    )
    scope = root_of(parsed).scopes[0]
    own, placed = scope.nodes["a"].element.children("visual")
    assert Poses().of_part(own, scope.nodes["a"]) == pytest.approx(at(0, 1, 0))
    assert Poses().of_part(placed, scope.nodes["a"]) == pytest.approx(at(-1, 0, 0))


URDF = """<robot name="r"><link name="base"/><link name="arm"/><link name="hand"/>
  <joint name="k" type="fixed"><origin xyz="0 0 1"/><parent link="arm"/><child link="hand"/></joint>
  <joint name="j" type="fixed"><origin xyz="1 0 0" rpy="1.5707963267948966 0 0"/><parent link="base"/>
    <child link="arm"/></joint></robot>"""


def test_urdf_links_are_where_their_joints_put_them() -> None:
    parsed = document(URDF)
    assert pose_of("hand", parsed) == pytest.approx(at(1, -1, 0, roll=math.pi / 2))
    assert pose_of("k", parsed) == pytest.approx(pose_of("hand", parsed))
    assert pose_of("base", parsed) == pytest.approx(np.eye(4))


def test_urdf_loops_lead_nowhere() -> None:
    closed = URDF.replace(
        "</robot>", '<joint name="i"><parent link="hand"/><child link="base"/></joint></robot>'
    )
    with pytest.raises(PoseError):
        pose_of("hand", document(closed))


def test_a_joint_of_urdf_without_a_child_is_nowhere() -> None:
    with pytest.raises(PoseError, match="joint k has no child"):
        pose_of("k", document(URDF.replace('<child link="hand"/>', "")))


@pytest.mark.parametrize(
    ("pose", "expected"),
    [
        ("", at(5, 2, 0)),
        ("<pose>0 0 7 0 0 0</pose>", at(0, 2, 7)),
        ("<pose>0 0 7 0 0 0</pose><placement_frame>hand</placement_frame>", at(0, 0, 7)),
    ],
)
def test_merged_parts_keep_their_places_among_each_other(pose: str, expected: Array, tmp_path: Path) -> None:
    (tmp_path / "arm.sdf").write_text(
        '<sdf version="1.12"><model name="arm"><pose>5 0 0 0 0 0</pose>'
        '<link name="hand"><pose>0 2 0 0 0 0</pose></link></model></sdf>'
    )
    file = tmp_path / "model.sdf"
    file.write_text(
        '<sdf version="1.12"><model name="m"><include merge="true"><uri>arm.sdf</uri>'
        f"{pose}</include></model></sdf>"
    )
    parsed = Library().document(file)
    assert parsed is not None
    assert pose_of("hand", parsed) == pytest.approx(expected)


@pytest.mark.parametrize(
    "angles", [(3, 0, 0), (0, 0, 3), (0, 0, -3), (0.1, 0.2, 3), (-3, 0.3, 1), (1, -1, -2)]
)
def test_quaternions_turn_as_their_matrices_do(angles: tuple[float, float, float]) -> None:
    robot = sdfcheck.parse(
        '<sdf version="1.9"><model name="m"><link name="l">'
        f"<pose>0 0 0 {' '.join(map(str, angles))}</pose></link></model></sdf>"
    )
    x, y, z, w = robot.models[0].link("l").pose().quaternion
    turned = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )
    assert np.allclose(turned, from_rpy(*angles))


def test_a_quaternion_of_urdf() -> None:
    robot = sdfcheck.parse(
        '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed"><parent link="a"/>'
        '<child link="b"/><origin xyz="0 0 0" quat_xyzw="0 0 1 0"/></joint><joint name="k" type="fixed">'
        '<parent link="a"/><child link="b"/><origin rpy="0 0 1"/></joint></robot>'
    )
    turned, plain = robot.each(Placement)
    assert turned.is_quaternion
    assert not plain.is_quaternion


def test_the_rotation_of_a_pose_is_what_follows_its_position() -> None:
    robot = sdfcheck.parse(
        '<sdf version="1.9"><model name="m"><link name="a"><pose>1 2 3 4 5 6</pose></link><link name="b">'
        '<pose rotation_format="quat_xyzw">1 2 3 0 0 0 1</pose></link></model></sdf>'
    )
    assert [(*each.xyz,) for each in robot.each(Placement)] == [(1, 2, 3), (1, 2, 3)]
    assert [(*each.rotation,) for each in robot.each(Placement)] == [(4, 5, 6), (0, 0, 0, 1)]
    assert [each.is_quaternion for each in robot.each(Placement)] == [False, True]


def test_a_sensor_of_urdf_is_placed_by_its_pose() -> None:
    sensor = '<gazebo reference="hand"><sensor name="s" type="imu"><pose>0 1 0 0 0 0</pose></sensor></gazebo>'
    robot = sdfcheck.parse(URDF.replace("</robot>", f"{sensor}</robot>")).models[0]
    (found,) = robot.link("hand").sensors
    assert found.pose().xyz == pytest.approx((0, 1, 0))


@pytest.mark.parametrize(
    ("version", "direction"), [("1.4", (0, -1, 0)), ("1.6", (0, -1, 0)), ("1.7", (1, 0, 0))]
)
def test_an_axis_in_the_frame_of_the_model_until_1_6(version: str, direction: tuple[float, ...]) -> None:
    axis = "<axis><xyz>1 0 0</xyz><use_parent_model_frame>true</use_parent_model_frame></axis>"
    pose = f"<pose>0 0 0 0 0 {math.pi / 2}</pose>"
    ends = f'<link name="a"/><link name="b">{pose}</link>'
    joint = f'<joint name="j" type="revolute"><parent>a</parent><child>b</child>{axis}</joint>'
    (found,) = root_of(document(f'<model name="m">{ends}{joint}</model>', version)).each("Axis")
    assert direction_of(found) == pytest.approx(direction)
