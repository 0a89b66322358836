"""Names of Gazebo's generations, and settings that get lost."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck import problems
from sdfcheck.consumers.gazebo import classic_problems
from sdfcheck.consumers.gazebo import problems as gazebo_problems
from sdfcheck.consumers.gazebo_names import new_class, new_file
from sdfcheck.source.document import read
from sdfcheck.source.record import Record

LINK = '<link name="base">{}</link>'
BOX = '<geometry><box size="1 1 1"/></geometry>'


def found(text: str) -> list[object]:
    return list(gazebo_problems(read(text.encode(), Path("f"))))


def in_model(text: str, version: str = "1.9") -> list[object]:
    return found(f'<sdf version="{version}"><model name="m"><link name="l"/>{text}</model></sdf>')


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("libignition-gazebo-diff-drive-system.so", "gz-sim-diff-drive-system"),
        ("ignition-gazebo-imu-system", "gz-sim-imu-system"),
        ("libignition-gazebo6-imu-system.so", "gz-sim-imu-system"),
        ("gz-sim-imu-system", None),
        ("libgazebo_ros_imu.so", None),
        ("my-ignition-gazebo-plugin", None),
    ],
)
def test_files(old: str, new: str | None) -> None:
    assert new_file(old) == new


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("ignition::gazebo::systems::DiffDrive", "gz::sim::systems::DiffDrive"),
        ("ignition::gazebo", "gz::sim"),
        ("ignition::gui::plugins::Plot", "gz::gui::plugins::Plot"),
        ("ignition::gazebox::A", "gz::gazebox::A"),
        ("gz::sim::systems::Imu", None),
        ("my::ignition::Spark", None),
    ],
)
def test_classes(old: str, new: str | None) -> None:
    assert new_class(old) == new


def test_file_and_class_are_one_name() -> None:
    (one,) = in_model('<plugin filename="ignition-gazebo-x-system" name="ignition::gazebo::systems::X"/>')
    assert isinstance(one, problems.IgnitionName)
    assert [text for _, text in one.changes] == ["gz-sim-x-system", "gz::sim::systems::X"]


def test_a_prefix_that_nobody_declared() -> None:
    (one,) = in_model('<ignition:a ignition:b="1"><c/></ignition:a>')
    assert isinstance(one, problems.IgnitionName)
    assert sorted((span.text, text) for span, text in one.changes) == [
        ("ignition:a", "gz:a"),
        ("ignition:a", "gz:a"),
        ("ignition:b", "gz:b"),
    ]


def test_a_word_that_is_no_name() -> None:
    assert (
        in_model("<!-- ignition --><include><uri>https://fuel.ignitionrobotics.org/a</uri></include>") == []
    )


@pytest.mark.parametrize(
    ("version", "name", "instead"),
    [
        ("1.9", "ignition_frame_id", "gz_frame_id"),
        ("1.9", "gz_frame_id", "gz_frame_id"),
        ("1.12", "gz_frame_id", "frame_id"),
        ("1.12", "ignition_frame_id", "frame_id"),
    ],
)
def test_frame_ids(version: str, name: str, instead: str) -> None:
    sensor = f'<link name="k"><sensor name="s" type="imu"><{name}>a</{name}></sensor></link>'
    (one,) = in_model(sensor, version)
    assert isinstance(one, problems.FrameIdSpelling)
    assert (one.instead, one.version) == (instead, version)


def test_frame_ids_elsewhere() -> None:
    assert in_model('<plugin filename="f"><frame_id>a</frame_id><gz_frame_id>a</gz_frame_id></plugin>') == []


def robot(link: str, block: str, joint: str = "fixed") -> list[object]:
    return found(
        f'<robot name="r">{LINK.format(link)}<link name="b"/><joint name="j" type="{joint}">'
        f'<parent link="base"/><child link="b"/></joint>{block}</robot>'
    )


@pytest.mark.parametrize(
    ("name", "lost"), [("hull", True), ("base_hull", False), ("base", False), ("", False), ("my_base", True)]
)
def test_named_shapes(name: str, lost: bool) -> None:
    shape = f'<collision name="{name}">{BOX}</collision>'
    reported = robot(shape, '<gazebo reference="base"><mu1>1</mu1></gazebo>')
    assert [type(one) for one in reported] == [problems.ExtensionLostByName] * lost


def test_how_many_shapes_are_missed() -> None:
    shapes = "".join(f'<collision name="c{n}">{BOX}</collision>' for n in range(3))
    (one,) = robot(shapes, '<gazebo reference="base"><mu1>1</mu1><kp>1</kp></gazebo>')
    assert isinstance(one, problems.ExtensionLostByName)
    assert (one.count, len(one.settings)) == (3, 2)


@pytest.mark.parametrize(
    ("joint", "block", "count"),
    [
        ("fixed", "<disableFixedJointLumping>true</disableFixedJointLumping>", 1),
        ("fixed", '<disableFixedJointLumping value="True"/>', 1),
        ("fixed", "<disableFixedJointLumping/>", 0),
        ("revolute", "<disableFixedJointLumping>true</disableFixedJointLumping>", 0),
    ],
)
def test_lumping(joint: str, block: str, count: int) -> None:
    reported = robot("", f'<gazebo reference="j">{block}</gazebo>', joint)
    assert [type(one) for one in reported] == [problems.DisabledLumping] * count


def test_lumping_settled_in_another_block() -> None:
    kept = '<gazebo reference="j"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'
    disabled = '<gazebo reference="j"><disableFixedJointLumping>true</disableFixedJointLumping></gazebo>'
    assert robot("", kept + disabled) == []


def test_materials() -> None:
    block = '<gazebo reference="base"><material>Wood</material></gazebo>'
    (one,) = robot(f"<visual>{BOX}</visual>", block)
    assert isinstance(one, problems.ScriptMaterial)
    assert one.script == "Wood"
    assert robot("", block) == []


def test_what_only_classic_reads_is_counted() -> None:
    text = '<sdf version="1.6"><world name="w"><plugin name="a" filename="libgazebo_ros_init.so"/>{}</world></sdf>'
    again = '<plugin name="b" filename="libgazebo_ros_init.so"/><audio><device>default</device></audio>'
    reported = list(classic_problems(read(text.format(again).encode(), Path("f"))))
    assert all(isinstance(one, Record) for one in reported)
    assert {(one.what, one.count) for one in reported if isinstance(one, problems.ClassicOnlyElement)} == {
        ("`audio` in `world`", 1),
        ("plugin `libgazebo_ros_init.so`", 2),
    }
