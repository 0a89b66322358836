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


def controllers(folder: Path, text: str, inside: str = "") -> sdfcheck.Plugin:
    """The plugin that names a file ``c.yaml``."""
    (folder / "c.yaml").write_text(text)
    robot = ROBOT.format("c.yaml").replace("<parameters>", f"{inside}<parameters>")
    (folder / "r.urdf").write_text(robot)
    return sdfcheck.load(folder / "r.urdf").model(0).control_plugins[0]


DRIVE = "drive: {{ros__parameters: {{type: diff_drive_controller/DiffDriveController, {}}}}}\n"


@pytest.mark.parametrize(
    ("parameters", "wrong"),
    [
        ("wheel_radius: 0.1", []),
        ("wheel_radius: 1e-1", []),
        ("wheel_radius: .inf", []),
        ("wheel_radius: $(var radius)", []),
        ("wheel_radius: null", []),
        ("wheel_radius: 1", ["wheel_radius"]),
        ("wheel_radius: -1", ["wheel_radius"]),
        ("wheel_radius: 0x1f", ["wheel_radius"]),
        ("wheel_radius: '0.1'", ["wheel_radius"]),
        ("wheel_radius: [0.1]", ["wheel_radius"]),
        ("wheel_radius: {a: 1}", []),
        ("open_loop: true, position_feedback: yes", []),
        ("open_loop: 1", ["open_loop"]),
        ("velocity_rolling_window_size: 10", []),
        ("velocity_rolling_window_size: 10.0", ["velocity_rolling_window_size"]),
        ("odom_frame_id: odom", []),
        ("odom_frame_id: '1'", []),
        ("odom_frame_id: 1", ["odom_frame_id"]),
        ("left_wheel_names: [a]", []),
        ("left_wheel_names: a", ["left_wheel_names"]),
        ("pose_covariance_diagonal: [0.1, 0]", []),
        ("pose_covariance_diagonal: [1, 0]", ["pose_covariance_diagonal"]),
        ("linear: {x: {has_velocity_limits: true, max_velocity: 1.0}}", []),
        ("linear: {x: {max_velocity: 1}}", ["linear.x.max_velocity"]),
        ("linear.x.max_velocity: 1", ["linear.x.max_velocity"]),
        ("something_else: 1", []),
    ],
)
def test_types_of_parameters(parameters: str, wrong: list[str], tmp_path: Path) -> None:
    found = controllers(tmp_path, DRIVE.format(parameters)).controllers.mistyped
    assert [each.parameter.name for each in found] == wrong


def test_parameters_of_one_type_are_one_mistake(tmp_path: Path) -> None:
    text = DRIVE.format("wheel_radius: 1, wheel_separation: 2, left_wheel_names: a")
    found = controllers(tmp_path, text).controllers.mistyped
    assert [(each.parameter.name, each.more) for each in found] == [
        ("wheel_radius", 1),
        ("left_wheel_names", 0),
    ]


MANAGER = "{}controller_manager: {{ros__parameters: {{arm: {{type: {}{}}}}}}}\n"
GROUPED = "position_controllers/JointGroupPositionController"
LIFT = "{}: {{ros__parameters: {{joints: [lift]}}}}\n"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (MANAGER.format("", GROUPED, "") + LIFT.format("arm"), []),
        (MANAGER.format("", GROUPED, "") + LIFT.format("/r/arm"), []),
        (MANAGER.format("", GROUPED, "") + LIFT.format("/**"), []),
        (MANAGER.format("", GROUPED, "") + LIFT.format("arms"), [("arm", "arms")]),
        (MANAGER.format("", GROUPED, "") + LIFT.format("arms") + LIFT.format("legs"), []),
        (MANAGER.format("", GROUPED, "") + "node: {ros__parameters: {rate: 1}}\n", []),
        (MANAGER.format("", GROUPED, ", joints: [lift]"), [("arm", "")]),
        (MANAGER.format("", "my/Own", ", joints: [lift]"), []),
        (MANAGER.format("", "joint_state_broadcaster/JointStateBroadcaster", "") + LIFT.format("arms"), []),
    ],
)
def test_parameters_that_no_controller_reads(
    text: str, expected: list[tuple[str, str]], tmp_path: Path
) -> None:
    found = controllers(tmp_path, text).controllers.unreached
    assert [(each.controller, each.stray) for each in found] == expected


@pytest.mark.parametrize(
    ("space", "text", "is_lost"),
    [
        ("/r1", MANAGER.format("", GROUPED, ""), True),
        ("r1", MANAGER.format("/", GROUPED, ""), True),
        ("/", MANAGER.format("", GROUPED, ""), False),
        ("", MANAGER.format("", GROUPED, ""), False),
        ("/r1", MANAGER.format("/r1/", GROUPED, ""), False),
        ("/r1", "r1:\n  " + MANAGER.format("", GROUPED, ""), False),
        ("/r1", MANAGER.format("/**/", GROUPED, ""), False),
        ("/r1", MANAGER.format("", GROUPED, "") + LIFT.format("/**"), False),
        ("/r1", LIFT.format("arm"), False),
    ],
)
def test_namespaces(space: str, text: str, is_lost: bool, tmp_path: Path) -> None:
    plugin = controllers(tmp_path, text, f"<ros><namespace>{space}</namespace></ros>")
    assert (plugin.lost_namespace is not None) is is_lost


def test_many_parameters_take_no_time(tmp_path: Path) -> None:
    times = []
    for count in (500, 1000, 2000):
        given = ", ".join(f"p{n}_multiplier: 1" for n in range(count))
        plugin = controllers(tmp_path, DRIVE.format(given))
        begin = time.process_time()
        assert [each.more for each in plugin.controllers.mistyped] == [count - 1]
        times.append(time.process_time() - begin)
    assert times[2] < 8 * times[0] + 1


MOVEIT = (
    "moveit_simple_controller_manager: {{controller_names: [{0}], "
    "{0}: {{type: FollowJointTrajectory, joints: {1}}}}}\n"
)
SRDF = '<robot name="r"><group name="all"><joint name="lift"/></group></robot>'


@pytest.mark.parametrize(
    ("files", "expected"),
    [
        ({}, []),
        ({"joint_limits.yaml": "joint_limits: {lift: {}, other: {}}"}, []),
        ({"joint_limits.yaml": "joint_limits: {other: {}}"}, ["limits joint `other`"]),
        ({"a/joint_limits.yaml": "joint_limits: {other: {}}", "b/joint_limits.yaml": ""}, []),
        ({"joint_limits.yaml": "joint_limits: {other: {}}", "s.srdf": SRDF}, []),
        ({"joint_limits.yaml": "[" * 50_000}, []),
        ({"moveit_controllers.yaml": MOVEIT.format("arm", "[lift]")}, []),
        ({"moveit_controllers.yaml": MOVEIT.format("arm", "[lft]")}, ["sends joint `lft`"]),
        (
            {
                "moveit_controllers.yaml": MOVEIT.format("arms", "[lift]"),
                "ros2_controllers.yaml": MANAGER.format("", GROUPED, "") + LIFT.format("arm"),
            },
            [
                "sends trajectories to `arms`, and the controller of these joints in `ros2_controllers.yaml` is `arm`"
            ],
        ),
        (
            {
                "moveit_controllers.yaml": MOVEIT.format("arms", "[lift]"),
                "ros2_controllers.yaml": MANAGER.format("", GROUPED, "")
                + LIFT.format("arm").replace("lift", "x"),
            },
            [],
        ),
        (
            {
                "moveit_controllers.yaml": MOVEIT.format("arms", "[finger]").replace(
                    "FollowJointTrajectory", "GripperCommand"
                )
            },
            ["sends joint `finger`, which robot `r` does not have"],
        ),
    ],
)
def test_names_in_files_of_moveit(files: dict[str, str], expected: list[str], tmp_path: Path) -> None:
    manifest = "<package><name>r</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
    for name, text in {"package.xml": manifest, "r.urdf": ROBOT, "r.srdf": SRDF, **files}.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text(text)
    found = sdfcheck.lint([tmp_path / "r.srdf"], isolated=True, select=["SRD015"]).diagnostics
    assert len(found) == len(expected)
    assert all(words in each.message for words, each in zip(expected, found, strict=True))


def test_many_plugins_take_no_time(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>r</name></package>")
    plugin = '<plugin filename="gz_ros2_control-system" name="p"><parameters>{}.yaml</parameters></plugin>'
    for number in range(50):
        (tmp_path / f"{number}.yaml").write_text("x: 1\n" * 10_000)
    plugins = f"<gazebo>{''.join(plugin.format(number % 50) for number in range(300))}</gazebo>"
    (tmp_path / "r.urdf").write_text(ROBOT.format("c.yaml").replace("</robot>", f"{plugins}</robot>"))
    begin = time.process_time()
    sdfcheck.load(tmp_path / "r.urdf").model(0).controller_needs  # noqa: B018 - it is what reads them
    assert time.process_time() - begin < 15, "4 of 50 files are parsed; each takes about 1 s"


def test_steps_out_of_a_package_are_not_followed(tmp_path: Path) -> None:
    for name in ("r", "other"):
        (tmp_path / name / "config").mkdir(parents=True)
        (tmp_path / name / "package.xml").write_text(f"<package><name>{name}</name></package>")
        (tmp_path / name / "config" / "c.yaml").write_text("x: 1\n")
    (tmp_path / "r" / ".git").mkdir()
    file = tmp_path / "r" / "r.urdf.xacro"
    for address, near in (
        ("$(find r)/cofing/c.yaml", "config/c.yaml"),
        ("$(find r)/../other/cofing/c.yaml", None),
    ):
        robot = ROBOT.format(address).replace(
            "<robot ", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" '
        )
        file.write_text(robot)
        (plugin,) = sdfcheck.load(file).model(0).plugins
        missing = plugin.missing_parameters_file
        assert (missing[1] if missing else None) == near
