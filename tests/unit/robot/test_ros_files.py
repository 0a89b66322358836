"""Topics of bridges and frames of nodes, in files as people and attackers write them."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

import sdfcheck

SENSOR = '<gazebo reference="b"><sensor name="imu" type="imu">{}</sensor></gazebo>'
MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
ROBOT = (
    f'<robot name="r"><link name="a">{MASS}</link><link name="b">{MASS}</link>'
    '<joint name="j" type="{}"><parent link="a"/><child link="b"/></joint>{}</robot>'
)
ENTRY = "- {{gz_topic_name: {}, ros_topic_name: x, gz_type_name: gz.msgs.IMU, ros_type_name: sensor_msgs/msg/Imu}}\n"
ARGUMENT = "'/data@sensor_msgs/msg/Imu[gz.msgs.IMU'"
LAUNCH = "from launch_ros.actions import Node\nNode(package='ros_gz_bridge', arguments={})\n"


def gaps(folder: Path, files: dict[str, str], robot: str) -> list[tuple[str, str, str]]:
    """File, bridged topic and the robot's own one for each gap."""
    (folder / ".git").mkdir(exist_ok=True)
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text.encode("utf-8", "surrogatepass"))
    path = folder / "urdf" / "r.urdf"
    path.parent.mkdir(exist_ok=True)
    path.write_text(robot)
    found = sdfcheck.load(path).bridge_gaps
    assert all(gap.bridged.span.text.strip("/ ") == gap.bridged.topic for gap in found)
    return [(gap.bridged.span.source.path.name, gap.bridged.topic, gap.topic or gap.names) for gap in found]


def imu(topic: str = "<topic>imu</topic>", joint: str = "continuous") -> str:
    return ROBOT.format(joint, SENSOR.format(topic))


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("config/b.yaml", ENTRY.format("/data")),
        ("config/b.yml", ENTRY.format('"data"')),
        ("b.yaml", ENTRY.replace("gz.msgs", "ignition.msgs").replace("gz_t", "ign_t").format("data")),
        ("b.yaml", "bridges:\n  imu: {gz_topic_name: data, gz_type_name: gz.msgs.IMU, direction: GZ_TO_ROS}\n"),
        ("b.yaml", "- topic_name: data\n  ros_type_name: sensor_msgs/msg/Imu\n  gz_type_name: gz.msgs.IMU\n"),
        ("launch/b.py", LAUNCH.format(f"[{ARGUMENT}]")),
        ("b.launch.py", LAUNCH.format(f"['/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock', {ARGUMENT},]")),
        ("b.launch.py", LAUNCH.format(f"[{ARGUMENT}, '--ros-args', '-r', 'a@b:=c']")),
        ("b.launch.xml", '<launch><node pkg="ros_gz_bridge" args="/data@sensor_msgs/msg/Imu[gz.msgs.IMU"/></launch>'),
    ],
)  # fmt: skip
def test_ways_to_write_a_bridge(name: str, text: str, tmp_path: Path) -> None:
    assert gaps(tmp_path, {name: text}, imu()) == [(Path(name).name, "data", "imu")]
    assert gaps(tmp_path, {name: text}, imu("<topic>data</topic>")) == []


@pytest.mark.parametrize(
    "files",
    [
        {"b.launch.py": LAUNCH.format(f"['/robot', {ARGUMENT}]")},
        {"b.launch.py": LAUNCH.format(f"[LaunchConfiguration('name'), {ARGUMENT}]")},
        {"b.launch.py": LAUNCH.format("[f'{name}/data@sensor_msgs/msg/Imu[gz.msgs.IMU']")},
        {"b.launch.py": LAUNCH.format(f"[{ARGUMENT}]") + "x = 'gz_topic_name: '\n"},
        {"b.launch.py": f"# {ARGUMENT}\n"},
        {"b.yaml": "# " + ENTRY.format("data")},
        {"b.yaml": ENTRY.format("data").replace("{gz", "{direction: ROS_TO_GZ, gz")},
        {"b.yaml": ENTRY.format("<robot>/data")},
        {"b.yaml": ENTRY.format("data"), "c.yaml": ENTRY.format("$(var name)/imu")},
        {"b.yaml": ENTRY.format("data"), "c.yaml": ENTRY.format("imu")},
        {"b.yaml": ENTRY.format("data"), "launch/c.py": LAUNCH.format("[name + '@sensor_msgs/msg/Imu[gz.msgs.IMU']")},
        {"b.yaml": ENTRY.format("data"), "o.sdf": "<sensor type='imu'><topic>data</topic></sensor>"},
        {"b.yaml": ENTRY.format("data"), "o.sdf": "<sensor type='imu'><topic>${x}</topic></sensor>"},
        {"b.yaml": ENTRY.format("data"), "o.sdf": "<sensor type='imu'></sensor>"},
        {"b.yaml": ENTRY.format("/world/w/model/r/link/b/sensor/other/imu")},
    ],
)  # fmt: skip
def test_a_topic_that_may_be_right_is_not_reported(files: dict[str, str], tmp_path: Path) -> None:
    assert gaps(tmp_path, files, imu()) == []


def test_a_merged_link_is_not_in_a_topic(tmp_path: Path) -> None:
    files = {"b.yaml": ENTRY.format("/world/w/model/r/link/b/sensor/imu/imu")}
    assert gaps(tmp_path, files, imu("")) == []
    assert gaps(tmp_path, files, imu("", "fixed"))[0][2] == "link/a/sensor/imu"


def test_a_topic_is_said_once_for_the_part_that_shares_words_with_it(tmp_path: Path) -> None:
    plugin = (
        '<plugin filename="gz-sim-joint-position-controller-system" '
        'name="gz::sim::systems::JointPositionController"><joint_name>{0}</joint_name><topic>{0}_cmd</topic></plugin>'
    )
    robot = ROBOT.format(
        "continuous", f"<gazebo>{''.join(map(plugin.format, ('lift', 'grip', 'turn')))}</gazebo>"
    )
    entry = "- {{gz_topic_name: {}, gz_type_name: gz.msgs.Double, direction: ROS_TO_GZ}}\n"
    files = {"b.yaml": entry.format("lift_cmd") + entry.format("/turn/cmd")}
    assert gaps(tmp_path, files, robot) == [("b.yaml", "turn/cmd", "turn_cmd")]


def test_calibrations_follow_their_camera(tmp_path: Path) -> None:
    camera = SENSOR.replace('"imu"', '"camera"').format("<topic>front/image</topic>")
    robot = ROBOT.format("continuous", camera)
    entries = "- {{gz_topic_name: front/image, gz_type_name: gz.msgs.Image}}\n{}"
    info = "- {{gz_topic_name: {}, gz_type_name: gz.msgs.CameraInfo}}\n"
    right, wrong = (
        entries.format(info.format(name)) for name in ("front/camera_info", "front/image/camera_info")
    )
    assert gaps(tmp_path, {"b.yaml": right}, robot) == []
    assert gaps(tmp_path, {"b.yaml": wrong}, robot) == [
        ("b.yaml", "front/image/camera_info", "front/camera_info")
    ]


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("b.yaml", "[" * 50_000 + "gz_type_name"),
        ("b.yaml", "- &a [*a, {gz_type_name: 1, gz_topic_name: [1]}]\n"),
        ("b.yaml", "\tgz_type_name: 1"),
        ("b.yaml", ENTRY.format("other") * 500),
        ("b.launch.py", "x" * 60_000 + ".msgs."),
        ("b.launch.py", "x@" * 30_000 + ".msgs."),
        ("b.launch.py", "[" * 20_000 + "'/data@a[gz.msgs.IMU'"),
        ("b.launch.py", LAUNCH.format("[" + "'/other@a/b[gz.msgs.Other', " * 1_500 + "]")),
        ("o.sdf", "<sensor>" * 30_000),
        ("o.sdf", "<!--" * 60_000),
        ("o.sdf", ">" + " " * 200_000),
        ("o.sdf", "<topic>x</topic>" * 12_000),
    ],
)
def test_other_texts_take_no_time(name: str, text: str, tmp_path: Path) -> None:
    begin = time.process_time()
    gaps(tmp_path, {"z.yaml": ENTRY.format("data"), name: text}, imu())
    assert time.process_time() - begin < 5


WHEELED = (
    f'<robot name="r"><link name="base_link">{MASS}</link><link name="left_wheel">{MASS}</link>'
    '<joint name="j" type="continuous"><parent link="base_link"/><child link="left_wheel"/></joint></robot>'
)
AMCL = "amcl:\n  ros__parameters:\n    base_frame_id: {}\n"


def bases(folder: Path, files: dict[str, str], robot: str = WHEELED) -> list[tuple[str, str]]:
    """Node and frame for each place where a node takes a frame that is missing."""
    gaps(folder, files, robot)
    found = sdfcheck.load(folder / "urdf" / "r.urdf").missing_bases
    assert all(each.span.text == each.name for each in found)
    return [(each.node, each.name) for each in found]


@pytest.mark.parametrize(
    ("text", "node"),
    [
        (AMCL.format("base_footprint"), "amcl"),
        (AMCL.format('"base_footprint"  # on the floor'), "amcl"),
        ("robot1:\n" + "".join(f"  {line}\n" for line in AMCL.format("base_footprint").splitlines()), "amcl"),
        ("robot_base_frame: base_footprint\n", "robot_base_frame"),
        (
            "local_costmap:\n  local_costmap:\n    ros__parameters:\n      robot_base_frame: base_footprint\n",
            "local_costmap",
        ),
        ("ekf_node:\n  ros__parameters:\n    odom_frame: odom\n    base_link_frame: base_footprint\n", "ekf_node"),
    ],
)  # fmt: skip
def test_nodes_take_frames_for_the_base(text: str, node: str, tmp_path: Path) -> None:
    assert bases(tmp_path, {"config/p.yaml": text}) == [(node, "base_footprint")]


@pytest.mark.parametrize(
    "files",
    [
        {"p.yaml": AMCL.format("base_link")},
        {"p.yaml": AMCL.format("/base_footprint")},
        {"p.yaml": AMCL.format("<robot>base_footprint")},
        {"p.yaml": AMCL.format("robot1_base_link")},
        {"p.yaml": AMCL.format("base_footprint").replace("amcl", "wheel_controller")},
        {"p.yaml": "# robot_base_frame: base_footprint\n"},
        {"p.yaml": AMCL.format("base_footprint"), "launch/tf.py": "['base_link', 'base_footprint']\n"},
        {
            "p.yaml": AMCL.format("base_footprint"),
            "other.urdf": '<robot name="o"><link name="base_footprint"/></robot>',
        },
        {"p.yaml": AMCL.format("base_footprint"), "src/odometry.cpp": 'frame = "base_footprint";'},
        {"p.yaml": "[" * 50_000 + "\nrobot_base_frame: base_footprint\n"},
        {"p.yaml": "a: &a {robot_base_frame: *a}\n"},
    ],
)  # fmt: skip
def test_a_frame_that_may_be_there_is_not_reported(files: dict[str, str], tmp_path: Path) -> None:
    assert bases(tmp_path, files) == []


@pytest.mark.parametrize(
    "files",
    [
        {"p.yaml": "\n" * 64_000 + "robot_base_frame: base_footprint\n"},
        {f"{number}.yaml": f"robot_base_frame: b{number}\n" * 2_000 for number in range(200)},
        {f"{number}.yaml": ENTRY.format("other") * 500 for number in range(100)},
        {f"{number}.py": "x" * 250_000 for number in range(100)},
    ],
)
def test_large_projects_take_no_time(files: dict[str, str], tmp_path: Path) -> None:
    begin = time.process_time()
    bases(tmp_path, {"a.yaml": AMCL.format("base_footprint"), **files})
    gaps(tmp_path, {}, imu())
    assert time.process_time() - begin < 5


def test_a_robot_without_a_root_has_no_base_to_miss(tmp_path: Path) -> None:
    joint = '<joint name="k" type="fixed"><parent link="left_wheel"/><child link="base_link"/></joint>'
    assert (
        bases(
            tmp_path,
            {"p.yaml": AMCL.format("base_footprint")},
            WHEELED.replace("</robot>", f"{joint}</robot>"),
        )
        == []
    )


def test_robots_without_wheels_have_no_base_to_miss(tmp_path: Path) -> None:
    robot = WHEELED.replace("left_wheel", "left_arm")
    assert bases(tmp_path, {"p.yaml": AMCL.format("base_footprint")}, robot) == []


PACKAGE = "<package><name>bot</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
ODD_BRIDGES = {
    "brackets": "- {gz_topic_name: imu, gz_type_name: " + "[" * 50_000,
    "a long name": ENTRY.format("1/" * 20_000),
    "many faults": "- {topic_name: imu, gz_topic_name: imu, ros_type_name: a/b, gz_type_name: gz.msgs.IMU}\n"
    * 500,
    "values that are none": "- {gz_topic_name: imu, ros_type_name: [1], gz_type_name: gz.msgs.IMU, "
    "direction: {a: 1}}\n",
}


@pytest.mark.parametrize("name", ODD_BRIDGES)
def test_faults_of_odd_bridges_end_soon(name: str, tmp_path: Path) -> None:
    start = time.process_time()
    gaps(tmp_path, {"bridge.yaml": ODD_BRIDGES[name]}, imu())
    found = sdfcheck.load(tmp_path / "urdf" / "r.urdf").bridge_faults
    assert len(found) <= 1
    assert time.process_time() - start < 20


def test_one_finding_for_faults_of_one_kind(tmp_path: Path) -> None:
    entry = "- {topic_name: imu, gz_topic_name: imu, ros_type_name: a/b, gz_type_name: gz.msgs.IMU}\n"
    gaps(tmp_path, {"bridge.yaml": entry * 3}, imu())
    assert [each.more for each in sdfcheck.load(tmp_path / "urdf" / "r.urdf").bridge_faults] == [2]


def test_builds_of_relative_paths(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    files = {
        "package.xml": PACKAGE,
        "CMakeLists.txt": "project(bot)\n"
        + "if(BUILD_TESTING)\n" * 20_000
        + "install(DIRECTORY "
        + "a " * 50_000,
    }
    gaps(tmp_path, files, imu())
    monkeypatch.chdir(tmp_path / "urdf")
    assert sdfcheck.load(Path("r.urdf")).unbuilt == ()
    (tmp_path / "CMakeLists.txt").write_text(
        "project(bot)\ninstall(DIRECTORY launch DESTINATION share/bot)\n"
    )
    assert [each.words for each in sdfcheck.load(Path("r.urdf")).unbuilt] == [
        "installs `launch`, which is not there"
    ]


def test_tabs_before_entries(tmp_path: Path) -> None:
    files = {
        "package.xml": PACKAGE,
        "config/bad.yaml": "a:\n  ros__parameters:\n\tb: 1\n",
        "config/fine.yaml": "a:\n  ros__parameters: {b: 1,\n\tc: 2}\n",
        "config/other.yaml": "a:\n\tb: 1\n",
        "config/much.yaml": "ros__parameters:\n" + "\tb:\n" * 10_000,
    }
    gaps(tmp_path, files, imu())
    found = sdfcheck.load(tmp_path / "urdf" / "r.urdf").tabs_in_parameters
    assert {span.source.path.name for span in found} == {"bad.yaml", "much.yaml"}
