"""The joints and sensors that controllers ask for, in files of parameters as people and attackers write them."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

import sdfcheck

INERTIA = '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
ROBOT = f"""<robot name="r"><link name="a"><inertial><mass value="1"/>{INERTIA}</inertial></link>
<link name="b"><inertial><mass value="1"/>{INERTIA}</inertial></link>
<joint name="lift" type="prismatic"><parent link="a"/><child link="b"/>
<limit lower="0" upper="1" effort="50" velocity="2"/></joint>
<ros2_control name="c" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
<joint name="lift"><command_interface name="position"/><state_interface name="position"/></joint></ros2_control>
<gazebo><plugin filename="gz_ros2_control-system" name="gz_ros2_control::GazeboSimROS2ControlPlugin">
<parameters>{{}}</parameters></plugin></gazebo></robot>"""
GROUP = "{{ros__parameters: {{type: position_controllers/JointGroupPositionController, joints: {}}}}}\n"
CAR = "ackermann_steering_controller/AckermannSteeringController"


def needs(folder: Path, text: str | bytes, address: str = "c.yaml") -> list[tuple[str, str, str]]:
    """Controller, name and interface of what is asked for, by a file ``c.yaml``."""
    (folder / "c.yaml").write_bytes(text if isinstance(text, bytes) else text.encode())
    (folder / "r.urdf").write_text(ROBOT.format(address))
    robot = sdfcheck.load(folder / "r.urdf").model(0)
    found = [need for _, need in robot.controller_needs]
    assert all(need.span.text == need.name for need in found)
    return [(need.controller, need.name, need.interface) for need in found]


@pytest.mark.parametrize(
    "text",
    [
        "arm: " + GROUP.format("[lift]"),
        "arm: " + GROUP.format("lift"),
        "/arm: " + GROUP.format("['lift']"),
        "space:\n  arm: " + GROUP.format('["lift"]'),
        "\ufeffarm: " + GROUP.format("[lift]"),
        (
            "arm:\n  ros__parameters:\n    joints:\n      - lift  # the first\n"
            "controller_manager: {ros__parameters: {arm: {type: position_controllers/JointGroupPositionController}}}\n"
        ),
    ],
)
def test_ways_to_write_a_controller(text: str, tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>r</name></package>")
    assert needs(tmp_path, text) == [("arm", "lift", ""), ("arm", "lift", "position")]


@pytest.mark.parametrize(
    ("parameters", "expected"),
    [
        ("traction_joints_names: [w], steering_joints_names: [s]", [("w", "velocity"), ("s", "position")]),
        ("rear_wheels_names: [w], front_wheels_names: [s]", [("w", "velocity"), ("s", "position")]),
        (
            "front_steering: false, rear_wheels_names: [s], front_wheels_names: [w]",
            [("w", "velocity"), ("s", "position")],
        ),
    ],
)
def test_cars_steer_by_some_joints(parameters: str, expected: list[tuple[str, str]], tmp_path: Path) -> None:
    found = needs(tmp_path, f"car: {{ros__parameters: {{type: {CAR}, {parameters}}}}}")
    assert [(name, interface) for _, name, interface in found if interface] == expected


@pytest.mark.parametrize(
    "text",
    [
        "",
        "- a list",
        "arm: [",
        "\tarm: 1",
        b"\xff\xfe\x00",
        "a: 1\n---\nb: 2\n",
        "arm: " + GROUP.format("[$(var prefix)lift, <prefix>lift]"),
        "arm: {ros__parameters: 1}\n",
        "arm: {ros__parameters: {type: [1], joints: {a: b}}}\n",
        "? [a]\n: b\n",
        "[" * 50_000,
        "arm: &a {ros__parameters: &b {type: *a, joints: *b}}\n",
        "x: 1\n" * 60_000,
        "a: &a {" + ", ".join(f"k{n}: &n{n} {{}}" for n in range(500)) + "}\nb: {"
        + ", ".join(f"k{n}: *a" for n in range(2_000)) + "}\n",
    ],
)  # fmt: skip
def test_other_texts_ask_for_nothing_and_take_no_time(text: str | bytes, tmp_path: Path) -> None:
    begin = time.process_time()
    assert needs(tmp_path, text) == []
    assert time.process_time() - begin < 5


def test_a_file_elsewhere_is_not_read(tmp_path: Path) -> None:
    other, project = tmp_path / "other", tmp_path / "project"
    other.mkdir()
    (project / ".git").mkdir(parents=True)
    (project / "package.xml").write_text("<package><name>r</name></package>")
    (other / "secret.yaml").write_text("arm: " + GROUP.format("[lift]"))
    (project / "link.yaml").symlink_to(other / "secret.yaml")
    for address in (f"{other}/secret.yaml", "../other/secret.yaml", "link.yaml", "none.yaml", "package.xml"):
        assert needs(project, "", address) == [], address
