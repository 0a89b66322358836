"""Names of Gazebo's generations, and settings that get lost."""

from __future__ import annotations

import pytest

import sdfcheck
from sdfcheck_rules.gaz.ignition import new_class, new_file

LINK = '<link name="base">{}</link>'
BOX = '<geometry><box size="1 1 1"/></geometry>'


def reported(text: str) -> list[sdfcheck.Diagnostic]:
    """The reports of the rules about Gazebo in a document."""
    return list(sdfcheck.lint(text, isolated=True, select=["GAZ"]).diagnostics)


def in_model(text: str, version: str = "1.9") -> list[sdfcheck.Diagnostic]:
    return reported(f'<sdf version="{version}"><model name="m"><link name="l"/>{text}</model></sdf>')


def changes(diagnostic: sdfcheck.Diagnostic) -> list[tuple[str, str]]:
    """The text that the fix replaces, and the new one."""
    assert diagnostic.fix is not None
    return [(edit.span.text, edit.text) for edit in diagnostic.fix.edits]


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
    assert [d.code for d in in_model(f'<plugin name="p" filename="{old}"/>')].count("GAZ001") == (
        new is not None
    )


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
    assert len(in_model(f'<plugin name="{old}" filename="p"/>')) == (new is not None)


def test_file_and_class_are_one_name() -> None:
    (one,) = in_model('<plugin filename="ignition-gazebo-x-system" name="ignition::gazebo::systems::X"/>')
    assert [text for _, text in changes(one)] == ["gz-sim-x-system", "gz::sim::systems::X"]


def test_a_plugin_of_another_program_is_left_alone() -> None:
    assert in_model('<plugin filename="ignition-gazebo" name="p"/>') == []


def test_a_prefix_that_nobody_declared() -> None:
    (one,) = in_model('<ignition:a ignition:b="1"><c/></ignition:a>')
    assert one.span.text == "ignition"
    assert sorted(changes(one)) == [("ignition:a", "gz:a"), ("ignition:a", "gz:a"), ("ignition:b", "gz:b")]


def test_a_word_that_is_no_name() -> None:
    assert in_model("<!-- ignition --><include><uri>https://ignition.example.org/a</uri></include>") == []


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
    if name == instead:
        assert one.fix is None
        assert f"not in SDFormat {version}" in one.message
    else:
        assert changes(one) == [(name, instead)] * 2


def test_frame_ids_elsewhere() -> None:
    assert in_model('<plugin filename="f"><frame_id>a</frame_id><gz_frame_id>a</gz_frame_id></plugin>') == []


def robot(link: str, block: str, joint: str = "fixed") -> list[sdfcheck.Diagnostic]:
    return reported(
        f'<robot name="r">{LINK.format(link)}<link name="b"/><joint name="j" type="{joint}">'
        f'<parent link="base"/><child link="b"/></joint>{block}</robot>'
    )


@pytest.mark.parametrize(
    ("name", "lost"), [("hull", True), ("base_hull", False), ("base", False), ("", False), ("my_base", True)]
)
def test_named_shapes(name: str, lost: bool) -> None:
    shape = f'<collision name="{name}">{BOX}</collision>'
    found = robot(shape, '<gazebo reference="base"><mu1>1</mu1></gazebo>')
    assert [one.code for one in found] == ["GAZ004"] * lost


def test_how_many_shapes_are_missed() -> None:
    shapes = "".join(f'<collision name="c{n}">{BOX}</collision>' for n in range(3))
    (one,) = robot(shapes, '<gazebo reference="base"><mu1>1</mu1><kp>1</kp></gazebo>')
    assert one.message.startswith("`mu1` and `kp` do not reach collision `c0` and 2 more of link `base`")


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
    found = robot("", f'<gazebo reference="j">{block}</gazebo>', joint)
    assert [one.code for one in found] == ["GAZ005"] * count


def test_lumping_settled_in_another_block() -> None:
    kept = '<gazebo reference="j"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'
    disabled = '<gazebo reference="j"><disableFixedJointLumping>true</disableFixedJointLumping></gazebo>'
    assert robot("", kept + disabled) == []


def test_materials() -> None:
    block = '<gazebo reference="base"><material>Wood</material></gazebo>'
    (one,) = robot(f"<visual>{BOX}</visual>", block)
    assert (one.code, one.span.text, one.severity) == ("GAZ006", "Wood", sdfcheck.Severity.WARNING)
    assert robot("", block) == []


def test_elements_that_only_classic_reads_are_counted() -> None:
    text = '<sdf version="1.6"><world name="w"><plugin name="a" filename="libgazebo_ros_init.so"/>{}</world></sdf>'
    again = '<plugin name="b" filename="libgazebo_ros_init.so"/><audio><device>default</device></audio>'
    assert {one.message for one in reported(text.format(again))} == {
        "`audio` in `world` is for Gazebo Classic only",
        "plugin `libgazebo_ros_init.so` is for Gazebo Classic only (used 2 times)",
    }


def test_a_camera_of_an_extension_is_not_that_of_the_view() -> None:
    block = '<gazebo reference="base"><sensor name="s" type="sonar"><camera/></sensor></gazebo>'
    assert robot("", block) == []


@pytest.mark.parametrize(
    ("reference", "message"),
    [
        ("base", ""),
        ("j", ""),
        ("", ""),
        ("${prefix}base", ""),
        ("bese", "there is no link or joint `bese`; did you mean `base`?"),
        ("hull", "`hull` is a collision, not a link or joint"),
        ("__model__", "there is no link or joint `__model__`"),
        ("elsewhere", "there is no link or joint `elsewhere`"),
    ],
)
def test_references_of_blocks(reference: str, message: str) -> None:
    shape = f'<collision name="hull">{BOX}</collision>'
    found = robot(shape, f'<gazebo reference="{reference}"><selfCollide>true</selfCollide></gazebo>')
    assert [one.message for one in found if one.code == "GAZ003"] == [message] * bool(message)


def test_a_link_that_joints_miss_is_not_missed_again() -> None:
    joint = '<joint name="k" type="fixed"><parent link="base"/><child link="hand"/></joint>'
    assert robot("", f'{joint}<gazebo reference="hand"/>') == []


def test_a_block_in_a_block_is_nothing() -> None:
    inner = '<gazebo reference="bese"><disableFixedJointLumping>true</disableFixedJointLumping></gazebo>'
    assert robot("", f'<gazebo reference="base">{inner}</gazebo>') == []
