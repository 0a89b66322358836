"""`<gazebo>` blocks hold SDFormat: linted as such, for Gazebo alone, with names in the whole robot."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck import Diagnostic, lint, targets

BODY = (
    '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    "<collision><geometry><sphere radius='1'/></geometry></collision>"
)
ROBOT = (
    f'<robot name="r"><link name="a">{BODY}</link><link name="b">{BODY}</link>'
    '<joint name="j" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>{}</robot>'
)


def found(content: str, reference: str = "") -> list[Diagnostic]:
    block = f'<gazebo reference="{reference}">' if reference else "<gazebo>"
    text = ROBOT.replace("{}", f"{block}{content}</gazebo>")
    return [d for d in lint(text, name="r.urdf", isolated=True).diagnostics if d.code != "URD008"]


def codes(content: str, reference: str = "") -> list[str]:
    return [diagnostic.code for diagnostic in found(content, reference)]


@pytest.mark.parametrize(
    ("reference", "content"),
    [
        ("a", "<mu1>0.5</mu1><mu2 value='0.5'/><fdir1>1 0 0</fdir1><kp>1e6</kp><maxContacts>3</maxContacts>"),
        ("a", "<turnGravityOff>true</turnGravityOff><selfCollide>no</selfCollide>"),
        ("a", "<material>Gazebo/Grey</material><gravity>false</gravity>"),
        ("a", "<visual><material><ambient>1 0 0 1</ambient></material></visual>"),
        ("a", "<collision><max_contacts>4</max_contacts></collision>"),
        ("a", '<sensor name="s" type="imu"><pose relative_to="b">0 0 0 0 0 0</pose></sensor>'),
        ("j", "<provideFeedback>true</provideFeedback><springStiffness>2</springStiffness>"),
        ("j", '<sensor name="s" type="force_torque"/>'),
        ("", '<plugin name="p" filename="f"><mu1>x</mu1><link name="l"/></plugin><static>false</static>'),
        ("", ('<frame name="f" attached_to="b"/><link name="c"/><joint name="k" type="fixed">'
             "<parent>f</parent><child>c</child></joint>")),
        ("", ("<include><uri>model://arm</uri></include><joint name='k' type='fixed'>"
             "<parent>a</parent><child>arm::base</child></joint>")),
    ],
)  # fmt: skip
def test_sound_blocks(reference: str, content: str) -> None:
    assert not [code for code in codes(content, reference) if not code.startswith(("RES002", "INR", "GAZ"))]


@pytest.mark.parametrize(
    ("reference", "content", "code"),
    [
        ("a", '<sensor name="s" type="camra"/>', "SCH015"),
        ("a", '<sensor name="s" type="imu"><update_rate>abc</update_rate></sensor>', "SCH011"),
        ("a", '<sensor name="s"/>', "SCH005"),
        ("a", '<sensor name="s" type="camera"><imu/></sensor>', "SCH018"),
        ("a", '<sensor name="s" type="imu"/><sensor name="s" type="imu"/>', "NAM001"),
        ("a", '<light name="l" type="point"><range>3</range></light>', "SCH003"),
        ("a", "<turnGravityOf>true</turnGravityOf>", "NS002"),
        ("a", "<turnGravityOff>treu</turnGravityOff>", "SCH012"),
        ("a", "<fdir1>1 0</fdir1>", "SCH013"),
        ("a", "<mu1>abc</mu1>", "SCH011"),
        ("a", "<mu1>-1</mu1>", "SCH014"),
        ("", '<model name="j"><link name="l"/></model>', "NAM002"),
        ("", '<joint name="k" type="fixed"><parent>a</parent><child>c</child></joint>', "JNT001"),
        ("", '<frame name="f" attached_to="c"/>', "FRM001"),
        ("", '<plugin name="p"/>', "RES008"),
    ],
)
def test_mistakes_in_blocks(reference: str, content: str, code: str) -> None:
    assert codes(content, reference) == [code]


@pytest.mark.parametrize(
    "content",
    ['<sensor name="s" type="camra"/>', '<model name="j"/>', "<mu1>x</mu1>", "<mu1>-1</mu1>"],
)
def test_only_gazebo_is_concerned(content: str) -> None:
    diagnostics = found(content, "a" if "model" not in content else "")
    assert diagnostics
    for diagnostic in diagnostics:
        concerned = [consumer for consumer, reaction in diagnostic.affects if not reaction.is_harmless]
        assert concerned == ["gazebo"]


def test_a_block_that_libsdformat_refuses_costs_the_robot(tmp_path: Path) -> None:
    text = ROBOT.replace("{}", '<gazebo reference="a"><sensor name="s" type="camra"/></gazebo>')
    path = tmp_path / "r.urdf"
    path.write_text(text)
    verdicts = {row.consumer.value: row.verdict.value for row in targets(path, isolated=True)}
    assert verdicts["gazebo"] == "reject"
    assert verdicts["urdfdom"] == "accept"
    assert verdicts["mujoco"] == "warn"  # its root becomes a part of the world


def test_blocks_for_nothing_are_not_read() -> None:
    assert codes('<sensor name="s" type="camra"/>', "nobody") == ["GAZ003"]


@pytest.mark.parametrize(
    ("reference", "content", "expected"),
    [
        ("j", "<mu1>-1</mu1>", ["GAZ009"]),
        ("", "<selfCollide>2</selfCollide>", ["GAZ009"]),
        ("a", "<static>2</static>", ["GAZ009"]),
        ("a", "<stopErp>-1</stopErp>", ["GAZ009"]),
        ("j", "<kp>soft</kp>", ["GAZ009", "SCH011"]),  # libsdformat aborts wherever it is
    ],
)
def test_values_of_settings_that_are_dropped(reference: str, content: str, expected: list[str]) -> None:
    assert codes(content, reference) == expected


def test_friction_of_a_link_without_collision_is_nobodys() -> None:
    text = ROBOT.replace("{}", '<gazebo reference="c"><mu1>-1</mu1></gazebo>')
    text = text.replace(
        "<joint",
        '<link name="c"/><joint name="i" type="fixed"><parent link="b"/><child link="c"/></joint><joint',
        1,
    )
    assert "SCH014" not in [each.code for each in lint(text, name="r.urdf", isolated=True).diagnostics]


def test_cameras_of_a_multicamera_are_all_read() -> None:
    camera = '<camera name="{}"><horizontal_fov>1</horizontal_fov></camera>'
    sensor = f'<sensor name="s" type="multicamera">{camera.format("l")}{camera.format("r")}</sensor>'
    assert codes(sensor, "a") == []


def test_plugins_may_share_a_name_wherever_they_are() -> None:
    plugin = '<plugin name="p" filename="{}"/>'
    both = plugin.format("a") + plugin.format("b")
    assert "NAM001" not in codes(f'<model name="n"><link name="l"/>{both}</model>')
    assert "NAM001" in codes('<model name="n"><link name="l"/><link name="l"/></model>')
