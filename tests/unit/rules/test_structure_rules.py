"""Versions, shapes and sensors: what the rules about structure report, and what they leave to others."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.formats.urdf.schema import VERSIONS
from sdfcheck.formats.version import NEWEST, OLDEST

BOX = "<geometry><box><size>1 1 1</size></box></geometry>"


def messages(text: str, code: str) -> list[str]:
    return [
        diagnostic.message for diagnostic in sdfcheck.lint(text, isolated=True, select=[code]).diagnostics
    ]


def in_link(text: str) -> str:
    return f'<sdf version="1.12"><model name="m"><link name="l">{text}</link></model></sdf>'


@pytest.mark.parametrize(
    ("attributes", "found"),
    [
        ("", ["`sdf` has no `version`"]),
        (' version=""', ["`version` of `sdf` is empty"]),
        (' version="  "', ["`version` of `sdf` is empty"]),
        (' version="1.13"', []),
    ],
)
def test_missing_version(attributes: str, found: list[str]) -> None:
    assert messages(f'<sdf{attributes}><model name="m"><link name="l"/></model></sdf>', "SCH001") == found


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("1.6.0", "1.6"),
        ("1.06", "1.6"),
        (" 1.12", "1.12"),
        ("1,9", "1.9"),
        ("v1.10", "1.10"),
        ("1.13", None),
        ("1.1", None),
        ("2.0", None),
        ("newest", None),
    ],
)
def test_unknown_version_of_sdformat(text: str, meant: str | None) -> None:
    guess = f"; did you mean `{meant}`?" if meant else ""
    assert messages(f'<sdf version="{text}"/>', "SCH002") == [f"version `{text}` is not known{guess}"]


@pytest.mark.parametrize(("text", "meant"), [("1", "1.0"), (" 1.1", "1.1"), ("2", None), ("", None)])
def test_unknown_version_of_urdf(text: str, meant: str | None) -> None:
    guess = f"; did you mean `{meant}`?" if meant else ""
    robot = f'<robot name="r" version="{text}"><link name="a"/></robot>'
    assert messages(robot, "SCH002") == [f"version `{text}` is not known{guess}"]


def test_the_versions_of_the_tables_are_known() -> None:
    for minor in range(OLDEST.minor, NEWEST.minor + 1):
        assert messages(f'<sdf version="1.{minor}"/>', "SCH002") == []
    for version in VERSIONS:
        assert messages(f'<robot name="r" version="{version}"><link name="a"/></robot>', "SCH002") == []


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ('<visual name="v"><geometry/></visual>', ["`geometry` has no shape"]),
        ('<visual name="v"><geometry><!-- none --></geometry></visual>', ["`geometry` has no shape"]),
        ('<visual name="v"><geometry><!-- one --><sphere/></geometry></visual>', []),
        ('<collision name="c"/>', ["collision `c` has no `geometry`"]),
        (
            '<sensor name="s" type="contact"><contact><collision>c</collision></contact></sensor>',
            [],
        ),
        ('<sensor name="s" type="sonar"><sonar><geometry>cone</geometry><max>1</max></sonar></sensor>', []),
    ],
)
def test_missing_shapes(text: str, found: list[str]) -> None:
    assert messages(in_link(text), "SCH016") == found


def test_states_go_by_the_names_of_parts() -> None:
    state = (
        '<state world_name="w"><model name="m"><link name="l"><collision name="c"/></link></model></state>'
    )
    assert messages(f'<sdf version="1.11"><world name="w">{state}</world></sdf>', "SCH016") == []


@pytest.mark.parametrize(
    ("kind", "content", "found"),
    [
        ("imu", "<camera/>", ["does not read `camera`, but `imu`"]),
        ("camera", "", ["has no `camera`, so it runs on defaults"]),
        ("gpu_lidar", "<update_rate>5</update_rate>", ["has no `lidar`, so it runs on defaults"]),
        ("navsat", "<navsat/><imu/>", ["does not read `imu`, but `navsat`"]),
        ("imu", "", []),
        ("multicamera", '<camera name="a"/><camera name="b"/>', []),
        ("custom", "<camera/>", []),
        ("odd", "<imu/>", []),
    ],
)
def test_sensors_and_their_settings(kind: str, content: str, found: list[str]) -> None:
    text = in_link(f'<sensor name="s" type="{kind}">{content}</sensor>')
    assert [message.partition(f"type `{kind}` ")[2] for message in messages(text, "SCH018")] == found


@pytest.mark.parametrize(("kind", "count"), [("imu", 1), ("custom", 0), ("odd", 0)])
def test_sensors_in_blocks_of_urdf_have_settings_too(kind: str, count: int) -> None:
    block = f'<gazebo reference="l"><sensor name="s" type="{kind}"><camera/></sensor></gazebo>'
    assert len(messages(f'<robot name="r"><link name="l"/>{block}</robot>', "SCH018")) == count


def test_a_model_without_root_is_known_by_the_name_of_its_file(tmp_path: Path) -> None:
    path = tmp_path / "a.sdf"
    path.write_text('<model name="m"><link name="a"/></model>')
    (diagnostic,) = sdfcheck.lint(path, isolated=True).diagnostics
    assert diagnostic.code == "XML011"
    path = path.rename(tmp_path / "model.config")
    assert "XML011" not in {found.code for found in sdfcheck.lint(path, isolated=True).diagnostics}


@pytest.mark.parametrize(
    ("text", "is_refused"),
    [
        ("<pose>1 <!-- m --> 0 0 0 0 0</pose>", True),
        ("<pose>0 0 1 0 0 0 <!-- rpy --> 1</pose>", False),
        ("<inertial><mass>1 <!-- kg --> 2</mass></inertial>", False),
    ],
)
def test_a_pose_that_a_comment_cuts_off_is_refused(text: str, is_refused: bool) -> None:
    (found,) = sdfcheck.lint(in_link(text), isolated=True, select=["SCH012"]).diagnostics
    assert dict(found.affects)["gazebo"].is_refusal is is_refused


@pytest.mark.parametrize(("text", "severity"), [(".5,", "warning"), ("-0.5;", "warning"), (".5kg", "error")])
def test_a_number_with_a_comma_after_it_is_read_as_meant(text: str, severity: str) -> None:
    inertial = f"<inertial><mass>{text}</mass></inertial>"
    (found,) = sdfcheck.lint(in_link(inertial), isolated=True, select=["SCH012"]).diagnostics
    assert found.severity.value == severity


def test_a_file_that_an_argument_chooses_is_a_part_of_the_robot(tmp_path: Path) -> None:
    head = '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro">'
    robot, arm = tmp_path / "robot.urdf.xacro", tmp_path / "arms" / "small.urdf.xacro"
    arm.parent.mkdir()
    chosen = '<xacro:include filename="arms/$(arg arm).urdf.xacro"/>'
    robot.write_text(
        f'{head}<xacro:arg name="arm" default=""/><xacro:property name="gap" value="1"/>'
        f'<link name="base"/>{chosen}</robot>'
    )
    arm.write_text(f'{head}<link name="l${{gap}}"/></robot>')
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    found = {path: sdfcheck.lint(path, isolated=True, select=["XAC"]).diagnostics for path in (robot, arm)}
    assert [(each.code, each.severity.value) for each in found[robot]] == [("XAC001", "warning")]
    assert "the default of argument `arm` is empty" in found[robot][0].message
    assert not [each for each in found[arm] if each.severity.value == "error"]
