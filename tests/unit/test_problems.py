"""Problems that people had: small robots with a mistake, which is found on its line, and without it."""

import struct
from pathlib import Path
from typing import NamedTuple

import pytest

import sdfcheck

BALL = "<geometry><sphere><radius>0.1</radius></sphere></geometry>"
MASS = '<inertial><mass value="1"/><inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>'
BOX = '<geometry><box size="0.3 0.2 0.1"/></geometry>'
BODY = f"{MASS}<visual>{BOX}</visual><collision>{BOX}</collision>"
RIM = '<origin rpy="1.5708 0 0"/><geometry><cylinder radius="0.07" length="0.05"/></geometry>'
WHEEL = f"""<link name="{{side}}"><inertial><mass value="0.5"/>
<inertia ixx="0.0008" iyy="0.0013" izz="0.0008" ixy="0" ixz="0" iyz="0"/></inertial>
<visual>{RIM}</visual><collision>{RIM}</collision></link>
<joint name="{{side}}_joint" type="continuous">
<parent link="body"/><child link="{{side}}"/><origin xyz="0 {{y}} 0"/>
<axis xyz="0 1 0"/>
</joint>
"""
CART = (
    '<link name="base_link"/>\n'
    f'<link name="body">{BODY}</link>\n'
    '<joint name="body_joint" type="fixed"><parent link="base_link"/><child link="body"/></joint>\n'
    + WHEEL.format(side="left", y="0.15")
    + WHEEL.format(side="right", y="-0.15")
)
ROD = '<origin xyz="0 0 0.2"/><geometry><cylinder radius="0.04" length="0.4"/></geometry>'
ARM = f"""<link name="stand"/>
<link name="base">{BODY}</link>
<joint name="stand_joint" type="fixed"><parent link="stand"/><child link="base"/></joint>
<link name="upper">
<inertial><origin xyz="0 0 0.2"/><mass value="1"/>
<inertia ixx="0.014" iyy="0.014" izz="0.001" ixy="0" ixz="0" iyz="0"/></inertial>
<visual>{ROD}</visual>
<collision>{ROD}</collision>
</link>
<joint name="shoulder" type="revolute">
<parent link="base"/><child link="upper"/>
<origin xyz="0 0 0.05"/>
<axis xyz="0 1 0"/>
<limit lower="-1" upper="1" effort="10" velocity="2"/>
</joint>
"""
FINGER = """<link name="finger"><inertial><mass value="0.1"/>
<inertia ixx="0.0001" iyy="0.0001" izz="0.0001" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="grip" type="prismatic"><parent link="upper"/><child link="finger"/><origin xyz="0 0 0.4"/>
<axis xyz="0 1 0"/><limit lower="0" upper="0.04" effort="5" velocity="1"/></joint>
"""
DRIVE = """<gazebo>
<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">
<left_joint>left_joint</left_joint>
<right_joint>right_joint</right_joint>
<wheel_separation>0.3</wheel_separation>
<wheel_radius>0.07</wheel_radius>
</plugin>
</gazebo>
"""
ROS_DRIVE = """<gazebo>
<plugin filename="libgazebo_ros_diff_drive.so" name="drive">
<left_joint>left_joint</left_joint>
<right_joint>right_joint</right_joint>
<wheel_separation>0.3</wheel_separation>
<wheel_diameter>0.14</wheel_diameter>
{}
</plugin>
</gazebo>
"""
CONTROL = """<ros2_control name="all" type="system">
<hardware>
<plugin>{}</plugin>
</hardware>
<joint name="{}">
<command_interface name="position"/><state_interface name="position"/>
</joint>
</ros2_control>
"""
GZ_CONTROL = """<gazebo>
<plugin filename="{}" name="gz_ros2_control::GazeboSimROS2ControlPlugin"><parameters>c.yaml</parameters></plugin>
</gazebo>
"""
WAGON = CART + "".join(
    WHEEL.format(side=f"front_{side}", y=y).replace('origin xyz="0 ', 'origin xyz="0.4 ')
    for side, y in (("left", "0.15"), ("right", "-0.15"))
)
FOUR_WHEELS = """<gazebo>
<plugin filename="gz-sim-{0}-drive-system" name="gz::sim::systems::{1}Drive">
{2}
</plugin>
</gazebo>
"""
ROLLERS = """<gazebo reference="left"><collision><surface><friction><ode><mu>1</mu><mu2>0</mu2><fdir1>1 1 0</fdir1>
</ode></friction></surface></collision></gazebo>
"""
MECANUM = """<front_left_joint>front_left_joint</front_left_joint>
<front_right_joint>front_right_joint</front_right_joint>
<back_left_joint>left_joint</back_left_joint>
<back_right_joint>right_joint</back_right_joint>
<wheelbase>{}</wheelbase>"""
SLIDE = FINGER.replace('upper="0.04"', 'upper="@@"')
GRIPPED = '<visual><geometry><box size="0.05 0.02 0.02"/></geometry></visual></link>\n<joint name="grip"'
STATE = """<ros2_control name="all" type="system">
<hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>
<joint name="shoulder">
<{}_interface name="{}">{}</{}_interface>
</joint>
{}</ros2_control>
"""
DRIVEN = CONTROL.format("gz_ros2_control/GazeboSimSystem", "shoulder").replace("position", "effort", 1)
CONTROLLED = GZ_CONTROL.format("gz_ros2_control-system")
SCAN = """<scan><horizontal><samples>360</samples><min_angle>-3</min_angle><max_angle>3</max_angle></horizontal></scan>
<range><min>0.1</min><max>10</max></range>"""
TRANSMISSION = """<transmission name="t">
<type>{}</type>
<joint name="shoulder">
<hardwareInterface>{}</hardwareInterface>
</joint>
<actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator>
</transmission>
"""
SDF_MASS = (
    "<inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia></inertial>"
)
SDF_BODY = (
    f'{SDF_MASS}<visual name="v"><geometry><box><size>0.3 0.2 0.1</size></box></geometry></visual>'
    '<collision name="c"><geometry><box><size>0.3 0.2 0.1</size></box></geometry></collision>'
)
CAMERA = """<sensor name="{0}" type="camera"><pose>0 {1} 0 0 0 0</pose>
<topic>{2}</topic>
<camera><horizontal_fov>1</horizontal_fov><image><width>640</width><height>480</height></image></camera>
</sensor>
"""
SEMANTICS = """<group name="arm"><chain base_link="base" tip_link="upper"/></group>
<group name="tool"><joint name="grip"/></group>
"""
FINGERS = "".join(
    f'''<link name="{name}">{MASS.replace("0.01", "0.00001").replace('mass value="1"', 'mass value="0.02"')}</link>
<joint name="{name}_flex" type="revolute"><parent link="palm"/><child link="{name}"/><origin xyz="0 {y} 0.05"/>
<axis xyz="0 1 0"/>
<limit lower="0" upper="1.5" effort="{name if name == "middle" else 2}" velocity="2"/></joint>
'''
    for name, y in (("index", 0.03), ("middle", 0), ("ring", -0.03))
)
HAND = (
    f'<link name="palm">{BODY}</link><link name="mount"/><joint name="m" type="fixed"><parent link="mount"/>'
    f'<child link="palm"/></joint>\n{FINGERS}'
)
WRIST = """<link name="wrist"><inertial><mass value="0.2"/>
<inertia ixx="0.0001" iyy="0.0001" izz="0.0001" ixy="0" ixz="0" iyz="0"/></inertial>
<collision><geometry><sphere radius="0.03"/></geometry></collision></link>
<joint name="roll" type="revolute"><parent link="upper"/><child link="wrist"/><origin xyz="0 0 0.42"/>
<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="5" velocity="1"/></joint>
<link name="palm"><inertial><mass value="0.2"/>
<inertia ixx="0.0001" iyy="0.0001" izz="0.0001" ixy="0" ixz="0" iyz="0"/></inertial>
<collision>
<geometry><box size="0.06 0.06 @@"/></geometry></collision></link>
<joint name="pitch" type="revolute"><parent link="wrist"/><child link="palm"/><origin xyz="0 0 0.05"/>
<axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="5" velocity="1"/></joint>
"""
GROUND = """<model name="ground"><static>true</static><link name="l"><collision name="c"><geometry><plane>
<normal>0 0 1</normal><size>9 9</size></plane></geometry></collision></link></model>
"""
ROTOR = """<link name="rotor_{0}"><pose>{1} {2} 0.06 0 0 0</pose><inertial><mass>0.02</mass><inertia><ixx>0.0001</ixx>
<iyy>0.0001</iyy><izz>0.0001</izz></inertia></inertial></link>
<joint name="rotor_{0}_joint" type="revolute"><parent>hull</parent><child>rotor_{0}</child>
<axis><xyz>0 0 1</xyz></axis></joint>
<plugin filename="gz-sim-multicopter-motor-model-system" name="gz::sim::systems::MulticopterMotorModel">
<jointName>rotor_{0}_joint</jointName><linkName>rotor_{0}</linkName><motorNumber>{0}</motorNumber>
<turningDirection>{3}</turningDirection></plugin>
"""
ROTORS = ((0, 0.2, -0.2, "ccw"), (1, -0.2, 0.2, "ccw"), (2, 0.2, 0.2, "cw"), (3, -0.2, -0.2, "@@"))
FIN = """<link name="rudder"><pose>-0.2 0 0 0 0 0</pose><inertial><mass>0.02</mass><inertia><ixx>0.0001</ixx>
<iyy>0.0001</iyy><izz>0.0001</izz></inertia></inertial></link>
<joint name="rudder_joint" type="revolute"><parent>hull</parent><child>rudder</child>
<axis><xyz>0 0 1</xyz></axis></joint>
<plugin filename="gz-sim-joint-position-controller-system" name="gz::sim::systems::JointPositionController">
<joint_name>rudder_joint</joint_name></plugin>"""
LIFT = """<plugin filename="gz-sim-lift-drag-system" name="gz::sim::systems::LiftDrag"><area>0.1</area>{}
<link_name>hull</link_name></plugin>"""
DIFFERENTIAL = """<ros2_control name="all" type="system">
<hardware><plugin>mock_components/GenericSystem</plugin></hardware>
<joint name="roll"><command_interface name="position"/><state_interface name="position"/></joint>
<joint name="pitch"><command_interface name="position"/><state_interface name="position"/></joint>
<transmission name="t"><plugin>transmission_interface/DifferentialTransmission</plugin>
<actuator name="m1" role="actuator1"/><actuator name="m2" role="actuator2"/>
@@</transmission></ros2_control>
"""
KNUCKLE = """<link name="knuckle"><inertial><mass value="0.2"/>
<inertia ixx="0.0002" iyy="0.0002" izz="0.0002" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="steer" type="revolute"><parent link="body"/><child link="knuckle"/>
<origin xyz="0.15 0 0" rpy="-1.5708 0 0"/>
<axis xyz="@@"/><limit lower="-1" upper="1" effort="9" velocity="2"/></joint>
"""
ARM_CONTROL = CONTROL.format("gz_ros2_control/GazeboSimSystem", "shoulder")
PARAMETERS = CONTROLLED.replace("c.yaml", "@@")
TRAJECTORY = """controller_manager: {{ros__parameters: {{update_rate: 100,
  arm: {{type: joint_trajectory_controller/JointTrajectoryController}}}}}}
{}: {{ros__parameters: {{joints: [shoulder], command_interfaces: [position], state_interfaces: [position]}}}}
"""
WHEEL_CONTROL = "".join(
    CONTROL.format("gz_ros2_control/GazeboSimSystem", f"{side}_joint")
    .replace("position", "velocity", 1)
    .replace("</joint>", '<state_interface name="velocity"/></joint>')
    .replace('name="all"', f'name="{side}_system"')
    for side in ("left", "right")
)
WHEELED = """drive: {{ros__parameters: {{type: diff_drive_controller/DiffDriveController,
  left_wheel_names: [left_joint], right_wheel_names: [right_joint], {}}}}}
"""
MEASURED = "wheel_separation: 0.3, wheel_radius: 0.07"
PLANNED: dict[str, str | bytes] = {
    "package.xml": "<package format='3'><name>bot</name><buildtool_depend>ament_cmake</buildtool_depend></package>",
    "joint_limits.yaml": "joint_limits:\n  shoulder: {has_acceleration_limits: true, max_acceleration: 1.0}\n",
    "ompl_planning.yaml": "response_adapters: [default_planning_response_adapters/AddTimeOptimalParameterization]\n",
    "kinematics.yaml": "arm: {kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin}\n",
}
INERTIAL_SENSOR = (
    '<gazebo reference="body">\n<sensor name="imu" type="imu">\n<topic>imu</topic></sensor>\n</gazebo>'
)
BRIDGED = "gz_topic_name: {}, ros_topic_name: {}, ros_type_name: sensor_msgs/msg/Imu, gz_type_name: {}.IMU"
BUILD = "project(bot)\nfind_package(ament_cmake REQUIRED)\ninstall(DIRECTORY {} DESTINATION share/${{PROJECT_NAME}})\n"
LAUNCH = (
    'share = get_package_share_directory("bot")\nmodel = os.path.join(share, "urdf", "bot.urdf")\n'
    'Node(package="controller_manager", executable="spawner", arguments=["arm", "states"])\n'
)
MOVEIT_SENT = (
    "moveit_simple_controller_manager:\n  controller_names: [arm_controller]\n  arm_controller: {{{} type: "
    "FollowJointTrajectory, joints: [{}]}}\n"
)
CLOUD = (
    "sensors: [depth]\ndepth: {sensor_plugin: occupancy_map_monitor/PointCloudOctomapUpdater, @@: /points, "
    "max_range: 5.0, padding_offset: 0.1, padding_scale: 1.0, point_subsample: 1, max_update_rate: 1.0, "
    "filtered_cloud_topic: near}\n"
)
STEERED = """drive: {ros__parameters: {type: mecanum_drive_controller/MecanumDriveController,
  front_left_wheel_command_joint_name: @@, front_right_wheel_command_joint_name: front_right_joint,
  rear_right_wheel_command_joint_name: right_joint}}
"""
FRONT_CONTROL = WHEEL_CONTROL.replace('"left_', '"front_left_').replace('"right_', '"front_right_')
EYES = """<gazebo reference="body">
<sensor name="{0}" type="camera"><camera/>
<plugin filename="libgazebo_ros_camera.so" name="{1}"><ros/><frame_name>body</frame_name></plugin></sensor>
</gazebo>
"""
OPTICAL = """<link name="eye"/>
<joint name="eye_joint" type="fixed"><parent link="body"/><child link="eye"/><origin xyz="0.15 0 0.05"/></joint>
<link name="eye_optical"/>
<joint name="eye_optical_joint" type="fixed"><parent link="eye"/><child link="eye_optical"/>
<origin rpy="-1.5708 0 -1.5708"/></joint>
"""
CUP = """<link name="cup"><inertial><mass value="0.05"/>
<inertia ixx="0.00002" iyy="0.00002" izz="0.00002" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="cup_joint" type="fixed"><parent link="upper"/><child link="cup"/><origin xyz="0 0 0.41"/></joint>
"""
STATES_SENT = """<gazebo><plugin filename="gz-sim-joint-state-publisher-system"
name="gz::sim::systems::JointStatePublisher"><topic>joint_states</topic></plugin></gazebo>
"""
FILTER = """ekf:
  ros__parameters:
    odom_frame: odom
    base_link_frame: base_footprint
    world_frame: odom
"""
SIMULATED = (
    'share = get_package_share_directory("bot")\nmodel = os.path.join(share, "urdf", "bot.urdf")\n'
    'Node(package="robot_state_publisher", executable="robot_state_publisher")\n'
    'Node(package="ros_gz_sim", executable="create")\n'
)
IN_WORLD = SIMULATED + 'gz = {"gz_args": "-r yard.sdf"}\n'
COMMANDED = '<plugin filename="gz-sim-user-commands-system" name="gz::sim::systems::UserCommands"/>\n'
SYSTEMS = (
    '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>\n'
    f'{COMMANDED}<plugin filename="gz-sim-scene-broadcaster-system" name="gz::sim::systems::SceneBroadcaster"/>\n'
)
DRAWN = '<plugin filename="gz-sim-sensors-system" name="gz::sim::systems::Sensors"/>\n'
HULL = f'{MASS}\n<visual><geometry><mesh filename="a.stl" scale="@@"/></geometry></visual>'
PAN = (
    f'<link name="head">{MASS}</link>\n<joint name="pan" type="continuous"><parent link="body"/><child link="head"/>'
    '<origin xyz="0 0 0.1"/><axis xyz="0 0 1"/></joint>\n'
)
INERTIAL_AT = CART.count("\n") + 4
CALVES = "".join(
    f'<link name="{side}_calf">{MASS.replace("0.01", "0.002")}\n'
    '<visual><geometry><mesh filename="package://bot/meshes/calf.stl"/></geometry></visual>\n'
    f'<collision>{turn}<geometry><mesh filename="package://bot/meshes/calf.stl"/></geometry></collision></link>\n'
    f'<joint name="{side}_knee" type="revolute"><parent link="upper"/><child link="{side}_calf"/>'
    f'<origin xyz="0 {y} 0.4"/><axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="5" velocity="9"/></joint>\n'
    for side, y, turn in (("left", 0.15, ""), ("right", -0.15, "@@"))
)
PART = '<xacro:macro name="part" params="p"><link name="${p}_link"/></xacro:macro>'
XACRO = ' xmlns:xacro="http://www.ros.org/wiki/xacro"'


def robot(*parts: str, more: str = ' name="bot"') -> str:
    return f'<?xml version="1.0"?>\n<robot{more}>\n{"".join(parts)}\n</robot>\n'


def world(*parts: str) -> str:
    return (
        f'<?xml version="1.0"?>\n<sdf version="1.9">\n<world name="w">\n{"".join(parts)}\n</world>\n</sdf>\n'
    )


def model(*parts: str) -> str:
    return (
        f'<?xml version="1.0"?>\n<sdf version="1.9">\n<model name="m">\n{"".join(parts)}\n</model>\n</sdf>\n'
    )


def cube() -> bytes:
    """A tetrahedron about the origin, as a binary STL."""
    corners = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
    faces = [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]
    return (
        bytes(80)
        + struct.pack("<I", 4)
        + b"".join(
            struct.pack("<12fH", 0, 0, 0, *(0.1 * x for at in face for x in corners[at]), 0) for face in faces
        )
    )


def picture(side: int) -> bytes:
    """The head of a PNG file with so many pixels on each side."""
    return b"\x89PNG\r\n\x1a\n" + struct.pack(">I4sII5B", 13, b"IHDR", side, side, 8, 0, 0, 0, 0)


class Problem(NamedTuple):
    """A text in which ``@@`` is wrong, then right; or one of its files, and ``below`` is the line of the text then."""

    code: str
    text: str
    wrong: str
    right: str
    below: int = 0
    """So many lines below ``@@`` is the mistake."""
    suffix: str = ".urdf"
    files: dict[str, str | bytes] = {}  # noqa: RUF012 - never changed

    def write(self, folder: Path, what: str) -> Path:
        for name, content in self.files.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content if isinstance(content, bytes) else content.replace("@@", what).encode())
        path = folder / f"bot{self.suffix}"
        path.write_text(self.text.replace("@@", what), encoding="utf-8")
        return path

    @property
    def line(self) -> int:
        if "@@" not in self.text:
            return self.below
        return self.text[: self.text.index("@@")].count("\n") + 1 + self.below


def semantic(text: str, wrong: str, right: str, code: str) -> Problem:
    """A problem in SRDF, beside its robot."""
    return Problem(code, robot(SEMANTICS, text), wrong, right, 0, ".srdf", {"bot.urdf": robot(ARM, FINGER)})


def beside(code: str, text: str, at: str, wrong: str, right: str, files: dict[str, str | bytes]) -> Problem:
    """A problem in a file beside a description, SRDF beside its robot, which is said at a place of the description."""
    suffix = ".srdf" if "bot.urdf" in files else ".urdf"
    return Problem(code, text, wrong, right, text[: text.index(at)].count("\n") + 1, suffix, files)


def meshed(mesh: str, wrong: str, right: str, code: str, **files: str | bytes) -> Problem:
    """A problem with the address of a mesh."""
    text = f'<link name="a">{MASS}\n<visual><geometry><mesh filename="{mesh}"/></geometry></visual></link>'
    return Problem(code, robot(text), wrong, right, 0, ".urdf", {"meshes/a.stl": cube(), **files})


def in_xacro(text: str, wrong: str, right: str, code: str) -> Problem:
    """A problem with xacro; ``part`` is in a file of its own."""
    others: dict[str, str | bytes] = {"part.xacro": f"<robot{XACRO}>{PART}</robot>"}
    return Problem(code, robot(text, more=f' name="bot"{XACRO}'), wrong, right, 0, ".urdf.xacro", others)


DESCRIBED: dict[str, str | bytes] = {
    "package.xml": "<package><name>pathfinder</name></package>",
    "description/meshes/a.stl": cube(),
}
GZ_DRIVEN = robot(CART, DRIVE)
PROBLEMS = {
    # Plugins of Gazebo
    "a plugin of Classic does nothing in the new Gazebo": Problem(
        "GAZ019",
        robot(
            CART,
            DRIVE,
            '<gazebo reference="body">\n<sensor name="imu" type="imu"><topic>imu</topic>\n@@</sensor>\n</gazebo>',
        ),
        '<plugin filename="libgazebo_ros_imu_sensor.so" name="imu"><ros><namespace>/a</namespace></ros></plugin>',
        "",
    ),
    "the depth camera of ROS 1 is not there in ROS 2": Problem(
        "GAZ019",
        robot(
            ARM,
            CONTROL.format("gazebo_ros2_control/GazeboSystem", "shoulder"),
            '<gazebo><plugin filename="libgazebo_ros2_control.so" name="c"><parameters>c.yaml</parameters></plugin>'
            '</gazebo>\n<gazebo reference="upper">\n<sensor name="s" type="depth"><camera/>\n'
            '<plugin filename="@@" name="p"/></sensor>\n</gazebo>',
        ),
        "libgazebo_ros_openni_kinect.so",
        "libgazebo_ros_camera.so",
    ),
    "the laser of ROS 1 is not there in ROS 2": Problem(
        "GAZ019",
        robot(
            CART,
            ROS_DRIVE,
            f'<gazebo reference="body">\n<sensor name="s" type="ray"><ray>{SCAN}</ray>\n'
            '<plugin filename="@@" name="p"/></sensor>\n</gazebo>',
        ).replace("{}\n", ""),
        "libgazebo_ros_laser.so",
        "libgazebo_ros_ray_sensor.so",
    ),
    "two cameras have one camera_info": Problem(
        "GAZ015",
        model(
            f'<link name="l">{SDF_BODY}\n',
            CAMERA.format("a", "0.1", "left/image"),
            CAMERA.format("b", "-0.1", "@@"),
            "</link>",
        ),
        "left/raw",
        "right/image",
        suffix=".sdf",
    ),
    "a sensor on a fixed joint is lost": Problem(
        "GAZ011",
        robot(
            CART,
            DRIVE,
            '<link name="lidar"/>\n<joint name="lidar_joint" type="fixed"><parent link="body"/><child link="lidar"/>'
            '</joint>\n<gazebo reference="@@">\n<sensor name="scan" type="gpu_lidar"><topic>scan</topic>'
            f"<ray>{SCAN}</ray></sensor>\n</gazebo>",
        ),
        "lidar_joint",
        "lidar",
        1,
    ),
    "the system of the sensors is in a block about a link": Problem(
        "SCH003",
        robot(CART, DRIVE, '<gazebo reference="body">\n@@\n</gazebo>'),
        '<plugin filename="gz-sim-sensors-system" name="gz::sim::systems::Sensors"/>',
        '<sensor name="imu" type="imu"><topic>imu</topic></sensor>',
    ),
    "the sides of a drive are exchanged": Problem(
        "GEO009",
        GZ_DRIVEN.replace(
            "<left_joint>left_joint</left_joint>\n<right_joint>right_joint</right_joint>", "@@"
        ),
        "<left_joint>right_joint</left_joint>\n<right_joint>left_joint</right_joint>",
        "<left_joint>left_joint</left_joint>\n<right_joint>right_joint</right_joint>",
    ),
    "the wheels are not as far apart as the plugin says": Problem(
        "GEO011", GZ_DRIVEN.replace("<wheel_separation>0.3", "<wheel_separation>@@"), "0.8", "0.3"
    ),
    "a parameter has its name of ROS 1": Problem(
        "RES019",
        robot(CART, ROS_DRIVE.format("<ros><namespace>a</namespace></ros>\n<@@>true</@@>")),
        "publishOdom",
        "publish_odom",
    ),
    "the odometry carries a link that is not the root": Problem(
        "GAZ020",
        robot(
            CART,
            ROS_DRIVE.format(
                "<publish_odom_tf>true</publish_odom_tf>\n<robot_base_frame>@@</robot_base_frame>"
            ),
        ),
        "body",
        "base_link",
    ),
    "the odometry carries a link that is not there": Problem(
        "GAZ020",
        robot(
            CART,
            ROS_DRIVE.format(
                "<publish_odom_tf>true</publish_odom_tf>\n<robot_base_frame>@@</robot_base_frame>"
            ),
        ),
        "base_footprint",
        "base_link",
    ),
    "the link of an inertial sensor is not in the robot": Problem(
        "RES014",
        robot(
            CART,
            '<gazebo>\n<plugin filename="libgazebo_ros_imu.so" name="i">\n<bodyName>@@</bodyName>\n'
            "<topicName>imu</topicName>\n</plugin>\n</gazebo>",
        ),
        "imu_link",
        "base_link",
    ),
    "the link of a plugin of the project has the name of the robot before it": Problem(
        "RES014",
        robot(
            CART,
            '<gazebo>\n<plugin filename="libmy_multirotor_plugin.so" name="r">\n<linkName>@@</linkName>\n'
            "</plugin>\n</gazebo>",
        ),
        "bot/base_link",
        "base_link",
    ),
    "a thruster has the parameters of a drive": Problem(
        "RES021",
        robot(
            CART,
            "<gazebo>\n@@\n<thrust_coefficient>0.1</thrust_coefficient></plugin>\n</gazebo>",
        ),
        '<plugin filename="gz-sim-thruster-system" name="gz::sim::systems::Thruster">'
        "<right_joint>right_joint</right_joint>",
        '<plugin filename="gz-sim-thruster-system" name="gz::sim::systems::Thruster">'
        "<joint_name>right_joint</joint_name>",
    ),
    "a propeller has limits": Problem(
        "JNT027",
        robot(
            CART.replace(
                'name="right_joint" type="continuous"', 'name="right_joint" type="revolute"'
            ).replace(
                '<origin xyz="0 -0.15 0"/>',
                '<origin xyz="0 -0.15 0"/><limit effort="9" velocity="9" lower="-@@" upper="@@"/>',
            ),
            '<gazebo><plugin filename="gz-sim-thruster-system" name="gz::sim::systems::Thruster">\n'
            "<joint_name>right_joint</joint_name></plugin></gazebo>",
        ),
        "1.57",
        "1e16",
        4,
    ),
    "a plugin is under the root": Problem(
        "SCH003",
        '<?xml version="1.0"?>\n<sdf version="1.9">\n@@'
        f'<model name="m">\n<link name="l">{SDF_BODY}</link>\n</model>\n</sdf>\n',
        '<plugin filename="gz-sim-label-system" name="gz::sim::systems::Label"><label>1</label></plugin>\n',
        "",
        suffix=".sdf",
    ),
    "a lidar has its type of Classic": Problem(
        "GAZ022",
        robot(
            CART,
            DRIVE,
            '<gazebo reference="body">\n<sensor name="s" type="@@"><topic>scan</topic>'
            f"<ray>{SCAN}</ray></sensor>\n</gazebo>",
        ),
        "ray",
        "gpu_lidar",
    ),
    "the driven wheels have no friction": Problem(
        "GAZ018",
        robot(CART, DRIVE, '<gazebo reference="left"><mu1>@@</mu1><mu2>@@</mu2></gazebo>'),
        "0.0",
        "1.0",
    ),
    "the joints of a drive are without power": Problem(
        "JNT025",
        robot(
            CART.replace('<axis xyz="0 1 0"/>', '<axis xyz="0 1 0"/><limit effort="@@" velocity="9"/>', 1),
            DRIVE,
        ),
        "0",
        "9",
    ),
    "a plugin has its name of Fortress": Problem(
        "GAZ001",
        '<?xml version="1.0"?>\n<sdf version="1.9">\n<world name="w">\n@@\n</world>\n</sdf>\n',
        '<plugin filename="libignition-gazebo-physics-system.so" name="ignition::gazebo::systems::Physics"/>',
        '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>',
        suffix=".sdf",
    ),
    "the settings of a link are in the link": Problem(
        "URD001",
        robot(ARM.replace('<link name="stand"/>', '<link name="stand">\n@@</link>')),
        '<gazebo reference="base"><gravity>true</gravity></gazebo>',
        "",
    ),
    # ros_control and ros2_control
    "the library of gz_ros2_control lacks its end": Problem(
        "R2C028",
        robot(ARM, CONTROL.format("gz_ros2_control/GazeboSimSystem", "shoulder"), GZ_CONTROL.format("@@")),
        "gz_ros2_control",
        "gz_ros2_control-system",
    ),
    "Gazebo does not load mock hardware": Problem(
        "R2C034",
        robot(ARM, CONTROL.format("@@", "shoulder"), GZ_CONTROL.format("gz_ros2_control-system")),
        "mock_components/GenericSystem",
        "gz_ros2_control/GazeboSimSystem",
    ),
    "Classic does not load mock hardware": Problem(
        "R2C034",
        robot(
            ARM,
            CONTROL.format("@@", "shoulder"),
            GZ_CONTROL.format("libgazebo_ros2_control.so").replace("gz_ros2_control::GazeboSim", ""),
        ),
        "fake_components/GenericSystem",
        "gazebo_ros2_control/GazeboSystem",
    ),
    "nothing in the robot starts its controllers": Problem(
        "R2C029",
        robot(
            "@@",
            ARM,
            CONTROL.format("gz_ros2_control/GazeboSimSystem", "shoulder"),
        ),
        "",
        GZ_CONTROL.format("gz_ros2_control-system"),
        17,
    ),
    "the leader of a finger is not in its ros2_control": Problem(
        "R2C035",
        robot(
            ARM,
            FINGER,
            CONTROL.format("mock_components/GenericSystem", "shoulder").replace(
                "</ros2_control>",
                '<joint name="grip"><command_interface name="position"/><param name="mimic">@@</param></joint>\n'
                "</ros2_control>",
            ),
        ),
        "shoulder_joint",
        "shoulder",
    ),
    "ros2_control is for a joint that the robot does not have": Problem(
        "URD012",
        robot(ARM, CONTROL.format("mock_components/GenericSystem", "@@")),
        "shoulder_joint",
        "shoulder",
    ),
    "the interface of a transmission is misspelled": Problem(
        "URD028",
        robot(ARM, TRANSMISSION.format("transmission_interface/SimpleTransmission", "hardware_interface/@@")),
        "PositionJointInterfce",
        "PositionJointInterface",
    ),
    "the type of a transmission is misspelled": Problem(
        "URD028",
        robot(ARM, TRANSMISSION.format("@@", "hardware_interface/EffortJointInterface")),
        "transmission_interface/SimpleTransmision",
        "transmission_interface/SimpleTransmission",
    ),
    # SRDF
    "the group of an end effector is its own parent": semantic(
        '<end_effector name="e" parent_link="upper" group="@@" parent_group="arm"/>', "arm", "tool", "SRD009"
    ),
    "the parent group of an end effector lacks its parent link": semantic(
        '<end_effector name="e" parent_link="@@" group="tool" parent_group="arm"/>',
        "finger",
        "upper",
        "SRD009",
    ),
    "a state is for a joint of another group": semantic(
        '<group_state name="open" group="tool"><joint name="@@" value="0.02"/></group_state>',
        "shoulder",
        "grip",
        "SRD010",
    ),
    "a state is for a joint that is fixed": semantic(
        '<group name="all"><joint name="stand_joint"/><joint name="grip"/></group>\n'
        '<group_state name="open" group="all"><joint name="@@" value="0.02"/></group_state>',
        "stand_joint",
        "grip",
        "SRD010",
    ),
    "a virtual joint has a type that there is not": semantic(
        '<virtual_joint name="v" type="@@" parent_frame="odom" child_link="stand"/>',
        "float",
        "floating",
        "SRD011",
    ),
    # Links and joints
    "a joint of URDF has the name of a link": Problem(
        "NAM002",
        robot(
            ARM,
            '<link name="cam"/>\n<joint name="@@" type="fixed"><parent link="upper"/><child link="cam"/></joint>',
        ),
        "cam",
        "cam_joint",
    ),
    "a joint of SDFormat has the name of a link": Problem(
        "NAM002",
        model(
            f'<link name="l">{SDF_BODY}</link>\n<link name="w"><pose>0.1 0 0 0 0 0</pose>{SDF_BODY}</link>\n'
            '<joint name="@@" type="ball"><parent>l</parent><child>w</child></joint>'
        ),
        "w",
        "w_joint",
        suffix=".sdf",
    ),
    "two links have one name": Problem(
        "NAM001",
        robot(
            ARM,
            '<link name="@@"/>\n<joint name="f" type="fixed"><parent link="upper"/><child link="fore"/></joint>',
        ),
        "upper",
        "fore",
    ),
    "the link of a laser is not there": Problem(
        "JNT001",
        robot(
            ARM,
            '<joint name="laser_joint" type="fixed"><parent link="base"/><child link="@@"/></joint>\n'
            '<link name="laser"/>',
        ),
        "base_laser",
        "laser",
    ),
    "the ground hangs on nothing": Problem("URD004", robot(ARM, "@@"), '<link name="ground"/>', ""),
    "a robot has no name": Problem("SCH005", robot(CART, more="@@"), "", ' name="bot"'),
    "the mass of a link is beside it": Problem("URD001", robot(ARM, "@@"), MASS, ""),
    "the root has a body and no mass": Problem(
        "URD013", robot(ARM.replace(f'<link name="base">{MASS}', '<link name="base">@@')), "", MASS, -1
    ),
    "moments that no body has": Problem(
        "INR003", robot(ARM.replace('ixx="0.014"', 'ixx="@@"')), "0.14", "0.014", 0
    ),
    "a negative moment": Problem("INR002", robot(ARM.replace('ixx="0.014"', 'ixx="@@"')), "-0.014", "0.014"),
    "a joint mimics one that is not there": Problem(
        "JNT009",
        robot(ARM, FINGER.replace("</joint>", '\n<mimic joint="@@"/></joint>')),
        "elbow",
        "shoulder",
    ),
    "the world has a body": Problem(
        "URD029",
        robot(
            ARM.replace(
                '<link name="stand"/>', '<link name="@@">\n<visual>' + BOX + "</visual></link>"
            ).replace('link="stand"', 'link="@@"')
        ),
        "world",
        "table",
        1,
    ),
    # Meshes
    "a mesh has another name": meshed("meshes/@@", "base.STL", "a.stl", "RES001"),
    "a package has no name": meshed("@@", "package:///meshes/a.stl", "meshes/a.stl", "RES004"),
    "a package was renamed": meshed(
        "package://@@/meshes/a.stl",
        "scan",
        "scan_xd",
        "RES001",
        **{"package.xml": '<package format="3"><name>scan_xd</name><version>1.0.0</version></package>'},
    ),
    "a folder of a package is taken for one": meshed(
        "package://@@/meshes/a.stl", "description", "pathfinder/description", "RES001", **DESCRIBED
    ),
    # Drives
    "a drive and ros2_control turn one wheel": Problem(
        "GAZ023",
        robot(
            CART,
            STATE.format("@@", "velocity", "", "@@", "").replace("shoulder", "left_joint"),
            CONTROLLED,
            DRIVE,
        ),
        "command",
        "state",
        8,
    ),
    "a drive has one joint for both sides": Problem(
        "GAZ023",
        GZ_DRIVEN.replace("<right_joint>right_joint", "<right_joint>@@"),
        "left_joint",
        "right_joint",
    ),
    "one wheel is fixed": Problem(
        "JNT028",
        robot(CART.replace('"right_joint" type="continuous"', '"right_joint" type="@@"')),
        "fixed",
        "continuous",
    ),
    "the wheels of one axle are exchanged": Problem(
        "GEO009",
        robot(
            WAGON,
            FOUR_WHEELS.format(
                "diff",
                "Diff",
                "<left_joint>front_left_joint</left_joint>\n<right_joint>front_right_joint</right_joint>\n@@",
            ),
        ),
        "<left_joint>right_joint</left_joint><right_joint>left_joint</right_joint>",
        "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>",
    ),
    "front and rear of a mecanum drive are exchanged": Problem(
        "GEO009",
        robot(WAGON, ROLLERS, FOUR_WHEELS.format("mecanum", "Mecanum", MECANUM.format("0.4")))
        .replace("<front_left_joint>front_left_joint</front_left_joint>", "@@", 1)
        .replace("<back_left_joint>left_joint</back_left_joint>", "<!-- -->"),
        "<front_left_joint>left_joint</front_left_joint><back_left_joint>front_left_joint</back_left_joint>",
        "<front_left_joint>front_left_joint</front_left_joint><back_left_joint>left_joint</back_left_joint>",
    ),
    "the axles are not as far apart as the plugin says": Problem(
        "GEO016",
        robot(WAGON, ROLLERS, FOUR_WHEELS.format("mecanum", "Mecanum", MECANUM.format("@@"))),
        "0.8",
        "0.4",
    ),
    "a drive has the diameter of Classic": Problem(
        "RES019",
        GZ_DRIVEN.replace("<wheel_radius>0.07</wheel_radius>", "<@@>0.07</@@>"),
        "wheel_diameter",
        "wheel_radius",
    ),
    "a class stands in place of its library": Problem(
        "RES015",
        GZ_DRIVEN.replace('filename="gz-sim-diff-drive-system"', 'filename="@@"'),
        "gz::sim::systems::DiffDrive",
        "gz-sim-diff-drive-system",
    ),
    "a library of ROS is misspelled": Problem(
        "RES015",
        robot(CART, ROS_DRIVE.format("").replace("libgazebo_ros_diff_drive.so", "@@")),
        "libgazebo_ros_diff_drives.so",
        "libgazebo_ros_diff_drive.so",
    ),
    "the odometry is that of a link that is not there": Problem(
        "GAZ020",
        robot(
            CART,
            DRIVE,
            '<gazebo><plugin filename="gz-sim-odometry-publisher-system" name="gz::sim::systems::OdometryPublisher">\n'
            "<robot_base_frame>@@</robot_base_frame></plugin></gazebo>",
        ),
        "base_footprint",
        "base_link",
    ),
    "a plugin for mimic joints moves one that is not there": Problem(
        "RES014",
        robot(
            ARM,
            FINGER,
            '<gazebo><plugin filename="libroboticsgroup_gazebo_mimic_joint_plugin.so" name="m">\n'
            "<joint>shoulder</joint><mimicJoint>@@</mimicJoint></plugin></gazebo>",
        ),
        "grip_joint",
        "grip",
    ),
    "a gripper has no such palm": Problem(
        "RES014",
        robot(
            ARM,
            '<gazebo><plugin filename="libgazebo_grasp_fix.so" name="m">\n'
            "<arm><palm_link>@@</palm_link></arm></plugin></gazebo>",
        ),
        "palm",
        "upper",
    ),
    "a list of joints has one that is not there": Problem(
        "RES014",
        robot(
            ARM,
            '<gazebo><plugin filename="libgazebo_ros_joint_state_publisher.so" name="m">\n'
            "<jointName>shoulder, @@</jointName></plugin></gazebo>",
        ),
        "elbow",
        "shoulder",
    ),
    "a static model is to be driven": Problem(
        "GAZ021",
        model(
            "<static>@@</static>",
            f'<link name="l">{SDF_BODY}</link>\n<link name="w"><pose>0.3 0 0 0 0 0</pose>{SDF_BODY}</link>\n'
            '<joint name="j" type="revolute"><parent>l</parent><child>w</child><axis><xyz>0 0 1</xyz></axis></joint>\n'
            '<plugin filename="gz-sim-joint-controller-system" name="gz::sim::systems::JointController">'
            "<joint_name>j</joint_name></plugin>",
        ),
        "true",
        "false",
        suffix=".sdf",
    ),
    "two sensors have one name once their links are merged": Problem(
        "NAM001",
        robot(
            CART,
            DRIVE,
            '<link name="mast"/>\n<joint name="m" type="fixed"><parent link="body"/><child link="mast"/></joint>\n'
            '<gazebo reference="body"><sensor name="imu" type="imu"><topic>a</topic></sensor></gazebo>\n'
            '<gazebo reference="mast"><sensor name="@@" type="imu"><topic>b</topic></sensor></gazebo>',
        ),
        "imu",
        "imu_2",
    ),
    "a sensor is turned by degrees": Problem(
        "FRM006",
        robot(
            CART,
            DRIVE,
            '<gazebo reference="body"><sensor name="imu" type="imu"><topic>a</topic>\n<pose>0 0 0 @@ 0 0</pose>'
            "</sensor></gazebo>",
        ),
        "90",
        "1.5708",
    ),
    "an address of Fuel has the wrong kind": Problem(
        "RES004",
        '<?xml version="1.0"?>\n<sdf version="1.9">\n<world name="w">\n<include>'
        "<uri>https://fuel.gazebosim.org/1.0/me/@@/Mine</uri></include>\n</world>\n</sdf>\n",
        "model",
        "models",
        suffix=".sdf",
    ),
    # ros2_control and transmissions, once more
    "there is nothing that ros2_control could move": Problem(
        "R2C037",
        robot(ARM, "@@", CONTROLLED),
        "",
        STATE.format("command", "position", "", "command", ""),
        1,
    ),
    "Gazebo does not load the hardware of MuJoCo": Problem(
        "R2C034",
        robot(ARM, CONTROL.format("@@", "shoulder"), CONTROLLED),
        "mujoco_ros2_control/MujocoSystem",
        "gz_ros2_control/GazeboSimSystem",
    ),
    "a sensor of ros2_control has the name of its link": Problem(
        "R2C036",
        robot(
            ARM,
            STATE.format(
                "command",
                "position",
                "",
                "command",
                '<sensor name="@@"><state_interface name="orientation.x"/></sensor>\n',
            ),
            CONTROLLED,
            '<gazebo reference="upper"><sensor name="imu" type="imu"><topic>a</topic></sensor></gazebo>',
        ),
        "upper",
        "imu",
    ),
    "Gazebo knows no torque": Problem(
        "R2C024",
        robot(ARM, STATE.format("command", "@@", "", "command", ""), CONTROLLED),
        "torque",
        "effort",
    ),
    "a joint starts where older hardware was told to": Problem(
        "R2C006",
        robot(
            ARM, STATE.format("state", "position", '<param name="@@">0.2</param>', "state", ""), CONTROLLED
        ),
        "initial_position",
        "initial_value",
    ),
    "a parameter has its value in an attribute": Problem(
        "R2C006",
        robot(
            ARM, STATE.format("state", "position", '<param name="initial_value"@@', "state", ""), CONTROLLED
        ),
        ' value="0.2"/>',
        ">0.2</param>",
    ),
    "a transmission is for a joint that is fixed": Problem(
        "URD011",
        robot(
            ARM,
            TRANSMISSION.format(
                "transmission_interface/SimpleTransmission", "hardware_interface/EffortJointInterface"
            ).replace('joint name="shoulder"', 'joint name="@@"'),
        ),
        "stand_joint",
        "shoulder",
    ),
    # Joints and shapes, once more
    "all soft limits are zero": Problem(
        "JNT017",
        robot(ARM.replace('velocity="2"/>', 'velocity="2"/>\n<safety_controller k_velocity="1" @@/>')),
        'soft_lower_limit="0" soft_upper_limit="0"',
        'soft_lower_limit="-0.9" soft_upper_limit="0.9"',
    ),
    "a gripper opens by sixty meters": Problem(
        "JNT029", robot(ARM, SLIDE.replace('</link>\n<joint name="grip"', GRIPPED)), "60", "0.06"
    ),
    "limits have other names": Problem("URD002", robot(ARM.replace('lower="-1"', '@@="-1"')), "min", "lower"),
    "a cylinder has a height": Problem(
        "URD002", robot(ARM.replace('length="0.4"', '@@="0.4"')), "height", "length"
    ),
    "a child has a name": Problem(
        "URD002", robot(ARM.replace('child link="upper"', 'child @@="upper"')), "name", "link"
    ),
    "nothing is seen of a color": Problem(
        "URD031", robot('<material name="grey">\n<color rgba="0.5 0.5 0.5 @@"/></material>', ARM), "0", "1"
    ),
    "a box is in millimeters": Problem(
        "GEO001",
        robot(ARM.replace(f"<visual>{BOX}", '<visual>\n<geometry><box size="@@"/></geometry>')),
        "300 200 100",
        "0.3 0.2 0.1",
    ),
    "a joint is placed in millimeters": Problem(
        "GEO015", robot(ARM.replace('xyz="0 0 0.05"', 'xyz="0 0 @@"')), "50", "0.05"
    ),
    "a mesh in meters is scaled down": Problem(
        "GEO002",
        robot(
            ARM.replace(
                f"<visual>{BOX}</visual><collision>{BOX}</collision>",
                '\n<visual><geometry><mesh filename="meshes/a.stl"@@/></geometry></visual>',
            )
        ),
        ' scale="0.001 0.001 0.001"',
        "",
        files={"meshes/a.stl": cube()},
    ),
    "a mesh is a drawing": meshed(
        "meshes/@@", "a.step", "a.stl", "GEO006", **{"meshes/a.step": "ISO-10303-21;"}
    ),
    "a mesh lacks its materials": meshed(
        "meshes/@@",
        "a.obj",
        "a.stl",
        "GEO017",
        **{"meshes/a.obj": "mtllib a.mtl\nv 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\n"},
    ),
    # xacro
    "a parenthesis is not closed": in_xacro(
        '<xacro:property name="r" value="1"/>\n<link name="l${@@}"/>', "(r*2", "(r*2)", "XAC001"
    ),
    "an include takes no parameter": in_xacro(
        '<xacro:include filename="part.xacro"@@/>\n<xacro:part p="x"/>', ' prefix="left_"', "", "XAC011"
    ),
    "a macro does not take a parameter any more": in_xacro(
        f'{PART}\n<xacro:part p="x"@@/>', ' material="grey"', "", "XAC008"
    ),
    "a macro is not defined": in_xacro(f'{PART}\n<xacro:@@ p="x"/>', "base", "part", "XAC003"),
    "an include lacks its prefix": in_xacro(
        '<@@ filename="part.xacro"/>\n<link name="x"/>', "include", "xacro:include", "XAC012"
    ),
    # Bodies of robots and worlds, once more
    "the points of a depth camera are in the frame of its body": Problem(
        "GAZ024",
        robot(
            CART,
            '<link name="lens"/>\n<joint name="l" type="fixed"><parent link="body"/><child link="lens"/>'
            '<origin rpy="-1.5708 0 -1.5708"/></joint>\n<gazebo reference="body">\n<sensor name="s" type="depth">'
            '<camera/>\n<plugin filename="libgazebo_ros_camera.so" name="p">\n<frame_name>@@</frame_name></plugin>'
            "</sensor>\n</gazebo>",
        ),
        "body",
        "lens",
    ),
    "a sensor takes the weight from its robot": Problem(
        "GAZ025",
        robot(
            CART,
            f'<link name="scan">{MASS.replace("1", "0.1", 1).replace("0.01", "0.0001")}</link>\n<joint name="s"'
            ' type="fixed"><parent link="body"/><child link="scan"/></joint>\n<gazebo reference="scan">@@</gazebo>',
        ),
        "<turnGravityOff>true</turnGravityOff>",
        "",
    ),
    "the wheels of one side have less friction": Problem(
        "GAZ026",
        robot(
            CART,
            DRIVE,
            '<gazebo reference="left"><mu1>1</mu1><mu2>1</mu2></gazebo>\n'
            '<gazebo reference="right"><mu1>@@</mu1><mu2>1</mu2></gazebo>',
        ),
        "0.2",
        "1",
    ),
    "the picture of a heightmap has any size": Problem(
        "GEO022",
        model(
            '<static>true</static>\n<link name="l"><collision name="c"><geometry><heightmap>\n<uri>@@</uri>'
            "<size>10 10 1</size></heightmap></geometry></collision></link>"
        ),
        "500.png",
        "513.png",
        suffix=".sdf",
        files={f"{side}.png": picture(side) for side in (500, 513)},
    ),
    "a caster is too low": Problem(
        "GEO023",
        robot(
            CART,
            DRIVE,
            f'<link name="ball">{MASS.replace("1", "0.1", 1).replace("0.01", "0.0001")}<collision><geometry>'
            '<sphere radius="0.03"/></geometry></collision></link><joint name="b" type="fixed"><parent link="body"/>'
            '<child link="ball"/><origin xyz="-0.12 0 @@"/></joint>',
        ),
        "-0.055",
        "-0.04",
    ),
    "a link of a model is meant to be a frame": Problem(
        "FRM012",
        model(f'<link name="foot"/>\n<link name="l">{SDF_BODY}</link>\n@@'),
        "",
        '<joint name="j" type="fixed"><parent>l</parent><child>foot</child></joint>',
        -2,
        ".sdf",
    ),
    "a wrist turns without end on one side": Problem(
        "JNT032",
        robot(
            ARM,
            *(
                f'<link name="{side}_hand">{BODY}</link>\n<joint name="{side}_wrist" type="{kind}">'
                f'<parent link="upper"/><child link="{side}_hand"/><origin xyz="0 {y} 0.3"/><axis xyz="0 1 0"/>\n'
                '<limit lower="-1" upper="1" effort="9" velocity="9"/></joint>\n'
                for side, kind, y in (("left", "revolute", "0.1"), ("right", "@@", "-0.1"))
            ),
        ),
        "continuous",
        "revolute",
    ),
    "the cylinder of a wheel lies flat": Problem(
        "GEO013",
        robot(
            CART.replace(
                f"<visual>{RIM}</visual><collision>{RIM}</collision>",
                f"<visual>{RIM}</visual>\n<collision>{RIM.replace('1.5708 0 0', '@@')}</collision>",
                1,
            )
        ),
        "0 0 0",
        "1.5708 0 0",
    ),
    "a collision stays where the visual was": Problem(
        "GEO003",
        robot(
            ARM.replace(
                f"<collision>{ROD}</collision>", f"<collision>{ROD.replace('0 0 0.2', '@@')}</collision>"
            )
        ),
        "0.1 0 0.2",
        "0 0 0.2",
    ),
    "the wheels have another radius than the plugin says": Problem(
        "GEO012", GZ_DRIVEN.replace("<wheel_radius>0.07", "<wheel_radius>@@"), "0.0465", "0.07"
    ),
    "an endless joint has limits": Problem(
        "JNT011",
        robot(ARM).replace('"shoulder" type="revolute"', '"shoulder" type="@@"'),
        "continuous",
        "revolute",
        4,
    ),
    "the inertia of a small part is 1": Problem(
        "INR005",
        robot(ARM, FINGER.replace("</inertial></link>", f"</inertial><visual>{BOX}</visual></link>")).replace(
            '<inertia ixx="0.0001" iyy="0.0001" izz="0.0001"', '<inertia ixx="@@" iyy="@@" izz="@@"'
        ),
        "1.0",
        "0.0005",
    ),
    "the mass of an arm is in its base": Problem(
        "INR013",
        robot(ARM).replace('<inertial><origin xyz="0 0 0.2"/>', '<inertial><origin xyz="@@"/>'),
        "0 0 -0.3",
        "0 0 0.2",
    ),
    "the frame of a camera is not in the robot": Problem(
        "GAZ012",
        robot(
            CART,
            '<gazebo reference="body">\n<sensor name="s" type="camera"><camera/>\n'
            '<plugin filename="libgazebo_ros_camera.so" name="p">\n<frameName>@@</frameName></plugin></sensor>'
            "\n</gazebo>",
        ),
        "camera_link",
        "body",
    ),
    "a collision is named in quotation marks": Problem(
        "RES011",
        robot(
            CART,
            '<gazebo reference="body">\n<sensor name="s" type="contact"><contact>\n<collision>@@</collision></contact>'
            "</sensor>\n</gazebo>",
        ),
        '"base_link_fixed_joint_lump__body_collision"',
        "base_link_fixed_joint_lump__body_collision",
    ),
    "a link is to be kept apart, and has no mass": Problem(
        "URD014",
        robot(
            CART,
            '<link name="mount">@@</link>\n<joint name="m" type="fixed"><parent link="body"/>'
            '<child link="mount"/></joint>\n'
            '<gazebo reference="m"><preserveFixedJoint>true</preserveFixedJoint></gazebo>',
        ),
        "",
        MASS,
    ),
    "the interface of a transmission is in its motor alone": Problem(
        "URD024",
        robot(
            ARM,
            '<transmission name="t">\n<type>transmission_interface/SimpleTransmission</type>\n<joint name="shoulder">@@'
            '</joint>\n<actuator name="m">'
            "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface></actuator>\n</transmission>\n"
            '<gazebo><plugin name="c" filename="libgazebo_ros_control.so"/></gazebo>',
        ),
        "",
        "<hardwareInterface>hardware_interface/EffortJointInterface</hardwareInterface>",
    ),
    "a plugin has no file": Problem(
        "RES008",
        robot(CART, '<gazebo>\n<plugin name="c"@@><robotNamespace>/</robotNamespace></plugin>\n</gazebo>'),
        "",
        ' filename="libmy_plugin.so"',
    ),
    "links are named with their own model": Problem(
        "JNT001",
        model(
            f'<link name="l">{SDF_BODY}</link>\n<link name="w"><pose>0.3 0 0 0 0 0</pose>{SDF_BODY}</link>\n'
            '<joint name="j" type="fixed"><parent>l</parent><child>@@</child></joint>'
        ),
        "m::w",
        "w",
        suffix=".sdf",
    ),
    "the axis of a joint is not closed": Problem(
        "XML001",
        model(
            f'<link name="l">{SDF_BODY}</link>\n<link name="w"><pose>0.3 0 0 0 0 0</pose>{SDF_BODY}</link>\n'
            '<joint name="j" type="revolute"><parent>l</parent><child>w</child>\n<axis><xyz>0 0 1</xyz>@@\n</joint>'
        ),
        "",
        "</axis>",
        1,
        ".sdf",
    ),
    "an include is beside the world": Problem(
        "SCH003",
        '<?xml version="1.0"?>\n<sdf version="1.6">\n@@<world name="w"/>\n</sdf>\n',
        "<include><uri>model://table</uri></include>\n",
        "",
        suffix=".sdf",
    ),
    "an argument is used above its declaration": Problem(
        "XAC001",
        f'<?xml version="1.0"?>\n<robot{XACRO} name="@@">\n<xacro:arg name="name" default="bot"/>\n<link name="a"/>\n'
        "</robot>\n",
        "$(arg name)",
        "bot",
        suffix=".urdf.xacro",
    ),
    "the name of a macro has its prefix": in_xacro(
        '<xacro:macro name="@@neck" params=""><link name="neck"/></xacro:macro>\n<xacro:neck/>',
        "xacro:",
        "",
        "XAC016",
    ),
    "a launch file expands macros alone": Problem(
        "XAC022",
        robot(
            '<xacro:macro name="all" params="">\n<link name="a"/>\n</xacro:macro>\n@@',
            more=f' name="bot"{XACRO}',
        ),
        "",
        "<xacro:all/>",
        -3,
        ".urdf.xacro",
        {"bot.launch": '<launch><param name="d" command="xacro bot.urdf.xacro"/></launch>'},
    ),
    # Neighbors, drives, worlds and files that meet
    "two neighbors of a robot may collide": Problem(
        "SRD012",
        robot(SEMANTICS, '<disable_collisions link1="base" link2="upper" reason="Adjacent"/>\n@@'),
        "",
        '<disable_collisions link1="finger" link2="upper" reason="Adjacent"/>',
        -1,
        ".srdf",
        {"bot.urdf": robot(ARM, FINGER.replace("</link>", f"<collision>{BOX}</collision></link>", 1))},
    ),
    "an arm does not hold its own weight": Problem(
        "JNT026",
        robot(ARM.replace('effort="10"', 'effort="@@"'), DRIVEN + CONTROLLED),
        "0.5",
        "10",
    ),
    "damping lets a joint hardly move": Problem(
        "JNT033",
        robot(ARM.replace('velocity="2"/>', 'velocity="2"/>\n<dynamics damping="@@"/>')),
        "900",
        "0.5",
    ),
    "the center of mass of a wheel is beside its axis": Problem(
        "INR019",
        robot(
            CART.replace('<link name="left"><inertial>', '<link name="left"><inertial>\n<origin xyz="@@"/>'),
        ),
        "0.02 0 0.01",
        "0 0 0",
    ),
    "the moments of a box are for other axes": Problem(
        "INR015",
        robot(
            ARM.replace('<link name="stand"/>', f'<link name="stand">{BODY}</link>'),
            '<link name="crate">\n<inertial><mass value="15"/>\n<inertia @@ ixy="0" ixz="0" iyz="0"/></inertial>'
            '<collision><geometry><box size="0.42 0.31 0.18"/></geometry></collision></link>\n'
            '<joint name="c" type="fixed"><parent link="base"/><child link="crate"/></joint>',
        ),
        'ixx="0.261" iyy="0.3406" izz="0.1606"',
        'ixx="0.1606" iyy="0.261" izz="0.3406"',
    ),
    "a world is slower than it says": Problem(
        "SCH036",
        '<?xml version="1.0"?>\n<sdf version="1.6">\n<world name="w">\n<physics type="ode">'
        "<max_step_size>0.002</max_step_size><real_time_factor>1</real_time_factor>\n"
        "<real_time_update_rate>@@</real_time_update_rate></physics>\n</world>\n</sdf>\n",
        "250",
        "500",
        suffix=".sdf",
    ),
    "a figure slides along its way": Problem(
        "SCH035",
        '<?xml version="1.0"?>\n<sdf version="1.9">\n<world name="w">\n<actor name="a">'
        "<skin><filename>https://example.org/walk.dae</filename></skin>\n"
        '<animation name="walk"><filename>https://example.org/walk.dae</filename>@@</animation>\n'
        '<script><trajectory id="0" type="walk"><waypoint><time>0</time><pose>0 0 0 0 0 0</pose></waypoint>'
        "<waypoint><time>2</time><pose>2 0 0 0 0 0</pose></waypoint></trajectory></script></actor>\n</world>\n</sdf>\n",
        "",
        "<interpolate_x>true</interpolate_x>",
        suffix=".sdf",
    ),
    "a mesh is mirrored": Problem(
        "GAZ027",
        model(
            f'<link name="l">{SDF_MASS}\n<visual name="v"><geometry><mesh><uri>meshes/a.stl</uri>\n'
            "<scale>@@</scale></mesh></geometry></visual></link>\n"
            '<plugin filename="gz-sim-label-system" name="gz::sim::systems::Label"><label>1</label></plugin>'
        ),
        "1 -1 1",
        "1 1 1",
        suffix=".sdf",
        files={"meshes/a.stl": cube()},
    ),
    "a magnetometer is nowhere on the earth": Problem(
        "GAZ014",
        '<?xml version="1.0"?>\n<sdf version="1.9">\n<world name="w">@@'
        '<plugin filename="gz-sim-magnetometer-system" name="gz::sim::systems::Magnetometer"/>'
        '<model name="m"><link name="l">\n'
        f'<sensor name="s" type="magnetometer"><topic>m</topic></sensor>{SDF_BODY}</link></model></world>\n</sdf>\n',
        "",
        "<spherical_coordinates><surface_model>EARTH_WGS84</surface_model><latitude_deg>1</latitude_deg>"
        "<longitude_deg>1</longitude_deg><elevation>0</elevation><heading_deg>0</heading_deg></spherical_coordinates>",
        1,
        ".sdf",
    ),
    "two included files define one property": Problem(
        "XAC031",
        robot(
            '<xacro:include filename="small.xacro"/>\n<xacro:include filename="@@.xacro"/>\n'
            '<xacro:small p="a"/><xacro:large p="b"/>\n<joint name="j" type="fixed"><parent link="a"/>'
            '<child link="b"/></joint>',
            more=f' name="bot"{XACRO}',
        ),
        "large",
        "great",
        suffix=".urdf.xacro",
        files={
            f"{file}.xacro": f'<robot{XACRO}><xacro:property name="{own}" value="{value}"/>'
            f'<xacro:macro name="{name}" params="p"><link name="${{p}}"><visual><geometry><sphere radius="${{{own}}}"/>'
            "</geometry></visual></link></xacro:macro></robot>"
            for file, name, own, value in (
                ("small", "small", "reach", "0.1"),
                ("large", "large", "reach", "0.2"),
                ("great", "large", "own_reach", "0.2"),
            )
        },
    ),
    "a true pose is given in a frame of the odometry": Problem(
        "RES014",
        robot(
            ARM,
            '<gazebo><plugin name="truth" filename="libgazebo_ros_p3d.so"><bodyName>base</bodyName>\n'
            "<topicName>pose</topicName><frameName>@@</frameName></plugin></gazebo>",
        ),
        "odom",
        "world",
    ),
    "the hardware of a real arm is beside that of Gazebo": Problem(
        "R2C006",
        robot(
            ARM,
            CONTROL.format(
                "gz_ros2_control/GazeboSimSystem</plugin>\n@@<plugin>acme_arm/Hardware", "shoulder"
            ),
            CONTROLLED,
        ),
        "",
        '</hardware>\n</ros2_control>\n<ros2_control name="real" type="system"><hardware>',
    ),
    "a joint starts at 0, where it may not be": Problem(
        "R2C022",
        robot(
            ARM.replace('lower="-1" upper="1"', 'lower="-3" upper="-0.5"'),
            STATE.format("state", "position", "@@", "state", ""),
            CONTROLLED,
        ),
        "",
        '<param name="initial_value">-1</param>',
    ),
    "a transmission is written as in the first ROS": Problem(
        "URD028",
        robot(
            ARM,
            '<transmission name="t" @@\n<joint name="shoulder"><hardwareInterface>'
            'hardware_interface/EffortJointInterface</hardwareInterface></joint>\n<actuator name="m">'
            "<mechanicalReduction>1</mechanicalReduction></actuator></transmission>",
        ),
        'type="transmission_interface/SimpleTransmission">',
        "><type>transmission_interface/SimpleTransmission</type>",
    ),
    "a car steers to the wrong side": Problem(
        "GEO010",
        robot(
            CART,
            *(
                f'<link name="{side}_knuckle">{MASS}</link>\n<joint name="{side}_steering" type="revolute">'
                f'<parent link="body"/><child link="{side}_knuckle"/><origin xyz="0.3 {y} 0"/>\n'
                f'<axis xyz="0 0 {axis}"/><limit lower="-0.5" upper="0.5" effort="9" velocity="2"/></joint>\n'
                for side, y, axis in (("left", 0.15, "@@1"), ("right", -0.15, 1))
            ),
            '<gazebo><plugin filename="gz-sim-ackermann-steering-system" name="gz::sim::systems::AckermannSteering">'
            "<left_joint>left_joint</left_joint><right_joint>right_joint</right_joint>\n"
            "<left_steering_joint>left_steering</left_steering_joint>"
            "<right_steering_joint>right_steering</right_steering_joint>\n<kingpin_width>0.3</kingpin_width>"
            "<wheel_base>0.3</wheel_base><wheel_separation>0.3</wheel_separation><wheel_radius>0.07</wheel_radius>"
            "<steering_limit>0.5</steering_limit></plugin></gazebo>",
        ),
        "-",
        "",
    ),
    "the speed of a joint is copied from a data sheet": Problem(
        "JNT014",
        robot(ARM.replace('velocity="2"', 'velocity="@@"')),
        "156",
        "2.72",
    ),
    "a wrist has a plugin for forces alone": Problem(
        "GAZ028",
        robot(
            ARM,
            '<gazebo reference="shoulder"><implicitSpringDamper>1</implicitSpringDamper>@@</gazebo>\n<gazebo>'
            '<plugin name="forces" filename="libgazebo_ros_ft_sensor.so"><jointName>shoulder</jointName>'
            "<topicName>forces</topicName></plugin></gazebo>",
        ),
        "",
        "<provideFeedback>1</provideFeedback>",
        1,
    ),
    "a world has one system alone": Problem(
        "GAZ029",
        '<?xml version="1.0"?>\n<sdf version="1.9">\n<world name="w">@@\n'
        '<plugin filename="gz-sim-user-commands-system" name="gz::sim::systems::UserCommands"/>\n'
        f'<model name="m"><link name="l"><pose>0 0 0.05 0 0 0</pose>{SDF_BODY}</link>\n'
        f'<link name="lid"><pose>0 0 0.15 0 0 0</pose>{SDF_BODY}</link>\n'
        '<joint name="hinge" type="revolute"><parent>l</parent><child>lid</child><axis><xyz>0 0 1</xyz><limit>'
        "<lower>-1</lower><upper>1</upper></limit></axis></joint></model></world>\n</sdf>\n",
        "",
        '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>',
        1,
        ".sdf",
    ),
    "the origin of a cart is not on the floor": Problem(
        "GEO024",
        robot(
            CART.replace("base_link", "base_footprint").replace(
                '<child link="body"/>', '<child link="body"/><origin xyz="0 0 @@"/>'
            ),
            DRIVE,
        ),
        "0.1",
        "0.07",
        -2,
    ),
    "the center of the left leg is that of the right one": Problem(
        "INR020",
        robot(
            ARM,
            *(
                f'<link name="{side}_leg"><inertial>\n<origin xyz="0 {center} -0.2"/><mass value="1"/>'
                '<inertia ixx="0.02" iyy="0.02" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial>'
                f'<collision><origin xyz="0 {at} -0.2"/><geometry><box size="0.1 0.1 0.4"/></geometry></collision>'
                f'</link>\n<joint name="{side}_leg_joint" type="revolute"><parent link="base"/>'
                f'<child link="{side}_leg"/><origin xyz="0 {y} -0.06"/><axis xyz="0 1 0"/>'
                '<limit lower="-1" upper="1" effort="90" velocity="2"/></joint>\n'
                for side, center, at, y in (("left", "@@0.03", 0.03, 0.12), ("right", "-0.03", -0.03, -0.12))
            ),
        ),
        "-",
        "",
    ),
    "a macro has a mass of its own": Problem(
        "INR021",
        robot(
            ARM.replace(
                '<inertia ixx="0.014" iyy="0.014" izz="0.001" ixy="0" ixz="0" iyz="0"/>',
                '<inertia @@ ixy="0" ixz="0" iyz="0"/>',
            )
        ),
        'ixx="0.0041200" iyy="0.0041200" izz="0.00024"',
        'ixx="0.0137333" iyy="0.0137333" izz="0.0008"',
    ),
    "the fingers of a closed gripper may not collide": Problem(
        "SRD012",
        robot(
            '<group name="tool"><joint name="left_slide"/><joint name="right_slide"/></group>\n@@'
            '<disable_collisions link1="base" link2="upper" reason="Adjacent"/>\n'
            '<disable_collisions link1="upper" link2="left" reason="Adjacent"/>\n'
            '<disable_collisions link1="upper" link2="right" reason="Adjacent"/>'
        ),
        "",
        '<disable_collisions link1="left" link2="right" reason="Default"/>',
        2,
        ".srdf",
        {
            "bot.urdf": robot(
                ARM,
                *(
                    f'<link name="{side}">{MASS}<collision><geometry><box size="0.02 0.03 0.06"/></geometry>'
                    f'</collision></link><joint name="{side}_slide" type="prismatic"><parent link="upper"/>'
                    f'<child link="{side}"/><origin xyz="0 {y} 0.43"/><axis xyz="0 {way} 0"/>'
                    '<limit lower="0" upper="0.03" effort="5" velocity="1"/></joint>'
                    for side, y, way in (("left", 0.012, 1), ("right", -0.012, -1))
                ),
            )
        },
    ),
    "a CAD program gives products of inertia with the other sign": Problem(
        "INR022",
        robot(
            ARM.replace(
                '<inertia ixx="0.014" iyy="0.014" izz="0.001" ixy="0" ixz="0" iyz="0"/>',
                '<inertia ixx="0.0137" iyy="0.0108" izz="0.0038" ixy="0" ixz="0" iyz="@@0.00544"/>',
            ).replace(
                ROD,
                '<origin xyz="0 0 0.2" rpy="0.5 0 0"/><geometry><cylinder radius="0.04" length="0.4"/></geometry>',
            )
        ),
        "-",
        "",
    ),
    # Threads of a later set
    "a submarine is lighter than its water": Problem(
        "GAZ034",
        world(
            '<plugin filename="gz-sim-buoyancy-system" name="gz::sim::systems::Buoyancy">'
            "<uniform_fluid_density>1000</uniform_fluid_density></plugin>",
            f'<model name="auv"><pose>0 0 -3 0 0 0</pose><link name="l">{SDF_BODY}</link>'.replace(
                "<mass>1<", "\n<mass>@@<"
            ),
            '<plugin filename="gz-sim-hydrodynamics-system" name="gz::sim::systems::Hydrodynamics">'
            "<link_name>l</link_name></plugin></model>",
        ),
        "1",
        "6",
        suffix=".sdf",
    ),
    "the library of a drive lacks its end": Problem(
        "RES015",
        robot(CART, ROS_DRIVE.format("").replace("libgazebo_ros_diff_drive.so", "@@")),
        "libgazebo_ros_diff_drive",
        "libgazebo_ros_diff_drive.so",
    ),
    "the hinge of a door is twice as far away": Problem(
        "JNT035",
        model(
            f'<link name="frame">{SDF_BODY}</link><link name="door"><pose>0.3 0 0 0 0 0</pose>{SDF_BODY}</link>'
            '<joint name="hinge" type="revolute">\n<pose>@@ 0 0 0 0 0</pose>\n<parent>frame</parent>'
            "<child>door</child><axis><xyz>0 0 1</xyz></axis></joint>"
        ),
        "0.3",
        "-0.15",
        suffix=".sdf",
    ),
    "the lidar of a rover hangs on nothing": Problem(
        "FRM013",
        model(
            f'<link name="body">{SDF_BODY}</link>\n<model name="lidar"><pose>0 0 0.1 0 0 0</pose><link name="l">'
            f'{SDF_BODY}<sensor name="s" type="imu"><topic>imu</topic></sensor></link></model>\n@@'
        ),
        "",
        '<joint name="j" type="fixed"><parent>body</parent><child>lidar::l</child></joint>',
        -1,
        suffix=".sdf",
    ),
    "a cart has no caster": Problem(
        "GEO023",
        robot(CART, DRIVE).replace('<mass value="1"', '<origin xyz="@@ 0 0"/><mass value="1"', 1),
        "-0.1",
        "0",
    ),
    "an elbow bends farther on the right": Problem(
        "JNT034",
        robot(
            ARM,
            *(
                FINGER.replace("finger", f"{side}_finger")
                .replace('"grip"', f'"{side}_grip"')
                .replace('"0 1 0"', f'"0 {axis} 0"')
                .replace("0.04", reach)
                .replace("<limit", "\n<limit")
                for side, axis, reach in (("left", 1, "0.05"), ("right", -1, "@@"))
            ),
        ),
        "0.0715",
        "0.05",
    ),
    "one finger has no effort": Problem(
        "JNT016",
        robot(HAND).replace('effort="middle"', 'effort="@@"'),
        "0",
        "2",
    ),
    "a finger mimics with the limits of its leader": Problem(
        "JNT022",
        robot(ARM, FINGER.replace('"prismatic"', '"revolute"'))
        .replace('lower="-1" upper="1"', 'lower="0" upper="0.8"')
        .replace(
            '<limit lower="0" upper="0.04" effort="5" velocity="1"/>',
            '<limit @@ effort="5" velocity="1"/><mimic joint="shoulder" multiplier="-1"/>',
        ),
        'lower="0" upper="0.8"',
        'lower="-0.8" upper="0"',
    ),
    "a finger mimics with a multiplier of 0": Problem(
        "JNT019",
        robot(ARM, FINGER.replace("</joint>", '\n<mimic joint="shoulder" multiplier="@@"/></joint>')),
        "0",
        "0.02",
    ),
    "a joint starts where an attribute says": Problem(
        "R2C006",
        robot(ARM, CONTROL.format("mock_components/GenericSystem", "shoulder")).replace(
            '<state_interface name="position"/>', "\n@@"
        ),
        '<state_interface name="position" initial_value="0.5"/>',
        '<state_interface name="position"><param name="initial_value">0.5</param></state_interface>',
    ),
    "a property has its dollar and no braces": in_xacro(
        '<xacro:property name="side" value="left"/>\n<link name="@@_wheel"/>', "$side", "${side}", "XAC010"
    ),
    "the rollers of a mecanum drive are not modeled": Problem(
        "GAZ031",
        robot(WAGON, "@@\n", FOUR_WHEELS.format("mecanum", "Mecanum", MECANUM.format("0.4"))),
        "<!-- -->",
        ROLLERS.replace("\n", " "),
        2,
    ),
    "four wheels are one pair": Problem(
        "RES025",
        robot(
            WAGON,
            ROS_DRIVE.format(
                "<num_wheel_pairs>@@</num_wheel_pairs><left_joint>front_left_joint</left_joint>"
                "<right_joint>front_right_joint</right_joint><wheel_separation>0.3</wheel_separation>"
                "<wheel_diameter>0.14</wheel_diameter>"
            ),
        ),
        "1",
        "2",
    ),
    "a drive publishes the frames of its wheels as well": Problem(
        "GAZ032",
        robot(
            CART,
            ROS_DRIVE.format("<publish_wheel_tf>@@</publish_wheel_tf>"),
            '<gazebo><plugin filename="libgazebo_ros_joint_state_publisher.so" name="states">'
            "<ros><namespace>a</namespace></ros><joint_name>left_joint</joint_name></plugin></gazebo>",
        ),
        "true",
        "false",
    ),
    "a gripper reaches into the arm that it collides with": Problem(
        "GEO026",
        robot(
            ARM,
            WRIST,
            *(
                f'<gazebo reference="{name}"><selfCollide>true</selfCollide></gazebo>'
                for name in ("upper", "wrist", "palm")
            ),
        ),
        "0.4",
        "0.06",
        -1,
    ),
    "a robot is static and is to move": Problem(
        "GAZ021",
        robot(CART, DRIVE, "<gazebo><static>@@</static></gazebo>"),
        "true",
        "false",
    ),
    "a drone is half in the ground": Problem(
        "GEO025",
        world(
            GROUND, f'<model name="drone">\n<pose>0 0 @@ 0 0 0</pose><link name="l">{SDF_BODY}</link></model>'
        ),
        "0",
        "0.05",
        suffix=".sdf",
    ),
    "the link of a payload has another name": Problem(
        "RES024",
        world(
            GROUND,
            f'<model name="carrier"><pose>0 0 1 0 0 0</pose><link name="l">{SDF_BODY}</link>\n'
            '<plugin filename="gz-sim-detachable-joint-system" name="gz::sim::systems::DetachableJoint">'
            "<parent_link>l</parent_link><child_model>payload</child_model><child_link>@@</child_link></plugin></model>",
            f'<model name="payload"><pose>0 0 0.05 0 0 0</pose><link name="box">{SDF_BODY}</link></model>',
        ),
        "dummy",
        "box",
        suffix=".sdf",
    ),
    "an autopilot looks for its sensor on another link": Problem(
        "RES024",
        model(
            f'<link name="hull">{SDF_BODY}<sensor name="imu" type="imu"><topic>imu</topic></sensor></link>\n'
            '<plugin name="ArduPilotPlugin" filename="ArduPilotPlugin">\n<imuName>@@</imuName></plugin>'
        ),
        "imu_link::imu",
        "hull::imu",
        suffix=".sdf",
    ),
    "three of four rotors turn one way": Problem(
        "GAZ030",
        model(f'<link name="hull">{SDF_BODY}</link>', *(ROTOR.format(*each) for each in ROTORS)),
        "ccw",
        "cw",
        suffix=".sdf",
    ),
    "a rudder changes no lift": Problem(
        "GAZ033",
        model(f'<link name="hull">{SDF_BODY}</link>', FIN, "\n", LIFT.format("@@")),
        "",
        "<control_joint_name>rudder_joint</control_joint_name>",
        -1,
        suffix=".sdf",
    ),
    "wind blows on nothing": Problem(
        "GAZ014",
        world(
            GROUND,
            '<plugin filename="gz-sim-wind-effects-system" name="gz::sim::systems::WindEffects"/>\n',
            f'<model name="balloon"><pose>0 0 1 0 0 0</pose>@@<link name="l">{SDF_BODY}</link></model>',
        ),
        "",
        "<enable_wind>true</enable_wind>",
        -1,
        suffix=".sdf",
    ),
    "the wind of Classic has no factor": Problem(
        "RES021",
        world(GROUND, '<plugin filename="libWindPlugin.so" name="wind">@@</plugin>'),
        "",
        "<force_approximation_scaling_factor>1</force_approximation_scaling_factor>",
        suffix=".world",
    ),
    "an actor walks by an animation that it does not have": Problem(
        "SCH027",
        world(
            GROUND,
            '<actor name="walker"><skin><filename>https://example.org/walk.dae</filename></skin>'
            '<animation name="walk"><filename>https://example.org/walk.dae</filename>'
            "<interpolate_x>true</interpolate_x></animation>"
            '<script>\n<trajectory id="0" type="@@"><waypoint><time>0</time><pose>0 0 1 0 0 0</pose></waypoint>'
            "<waypoint><time>4</time><pose>4 0 1 0 0 0</pose></waypoint></trajectory></script></actor>",
        ),
        "walking",
        "walk",
        suffix=".sdf",
    ),
    "the sun shines up": Problem(
        "SCH037",
        world('<light name="sun" type="directional">\n<direction>@@</direction></light>'),
        "0.1 0.1 1",
        "0.1 0.1 -1",
        suffix=".sdf",
    ),
    "the rows of a lidar have no angles": Problem(
        "SCH038",
        model(
            f'<link name="l">{SDF_BODY}<sensor name="s" type="gpu_lidar"><topic>scan</topic><lidar>\n<scan>'
            "<horizontal><samples>360</samples><min_angle>-3</min_angle><max_angle>3</max_angle></horizontal>"
            "<vertical><samples>16</samples>@@</vertical></scan><range><min>0.1</min><max>10</max></range></lidar>"
            "</sensor></link>"
        ),
        "<min_angle>0</min_angle><max_angle>0</max_angle>",
        "<min_angle>-0.2</min_angle><max_angle>0.2</max_angle>",
        suffix=".sdf",
    ),
    # Threads of a fifth set
    "an inertial sensor hangs on nothing": Problem(
        "FRM012",
        model(
            f'<link name="base_link">{SDF_BODY}</link>\n<link name="imu_link"><pose>0 0 0.07 0 0 0</pose>'
            '<sensor name="imu" type="imu"><topic>imu</topic></sensor></link>\n@@'
        ),
        "",
        '<joint name="j" type="fixed"><parent>base_link</parent><child>imu_link</child></joint>',
        -1,
        suffix=".sdf",
    ),
    "a lidar sees from the middle of itself on": Problem(
        "SCH039",
        model(
            f'<link name="l">{SDF_BODY}<sensor name="s" type="gpu_lidar"><topic>scan</topic>\n'
            f"<lidar>{SCAN.replace('0.1', '@@')}</lidar></sensor></link>"
        ),
        "0.0",
        "0.08",
        suffix=".sdf",
    ),
    "a topic begins with a digit": Problem(
        "SCH040",
        robot(
            CART,
            '<gazebo reference="body"><sensor name="s" type="imu">\n<topic>@@</topic></sensor></gazebo>',
        ),
        "sensors/9axis",
        "sensors/imu",
    ),
    "the joints of a differential are exchanged": Problem(
        "R2C038",
        robot(ARM, WRIST.replace("@@", "0.06"), DIFFERENTIAL),
        '<joint name="pitch" role="joint2"/> <joint name="roll" role="joint1"/>',
        '<joint name="roll" role="joint1"/> <joint name="pitch" role="joint2"/>',
    ),
    "a controller commands what its joint does not take": Problem(
        "R2C039",
        robot(
            ARM,
            CONTROL.format("gz_ros2_control/GazeboSimSystem", "shoulder").replace("position", "@@", 1),
            CONTROLLED,
        ),
        "effort",
        "position",
        files={
            "c.yaml": "arm: {ros__parameters: {type: joint_trajectory_controller/JointTrajectoryController,"
            " joints: [shoulder], command_interfaces: [position], state_interfaces: [position]}}\n"
        },
    ),
    "a controller reads what its joint does not measure": Problem(
        "R2C040",
        robot(
            ARM,
            CONTROL.format("gz_ros2_control/GazeboSimSystem", "shoulder").replace("<state_", "@@<state_"),
            CONTROLLED,
        ),
        "",
        '<state_interface name="velocity"/>',
        -1,
        files={
            "c.yaml": "arm: {ros__parameters: {type: joint_trajectory_controller/JointTrajectoryController,"
            " joints: [shoulder], command_interfaces: [position], state_interfaces: [position, velocity]}}\n"
        },
    ),
    "a controller steers a car to the wrong side": Problem(
        "GEO010",
        robot(
            CART,
            KNUCKLE,
            CONTROL.format("gz_ros2_control/GazeboSimSystem", "steer"),
            CONTROLLED,
        ),
        "0 1 0",
        "0 -1 0",
        files={
            "c.yaml": "car: {ros__parameters: {type: tricycle_controller/TricycleController,"
            " steering_joint_name: steer, wheelbase: 0.3, wheel_radius: 0.07}}\n"
        },
    ),
    "a kingpin leans on one side": Problem(
        "JNT036",
        robot(CART.replace('<origin xyz="0 -0.15 0"/>', '\n<origin xyz="0 -0.15 0" rpy="@@ 0 0"/>')),
        "0.089",
        "0",
    ),
    "an arm and its fingers are solved as one chain": Problem(
        "SRD013",
        '<robot name="bot">\n<group name="arm">@@</group>\n</robot>',
        '<joint name="shoulder"/><joint name="grip"/><joint name="grip2"/>',
        '<chain base_link="base" tip_link="finger"/>',
        suffix=".srdf",
        files={
            "bot.urdf": robot(ARM, FINGER, FINGER.replace('finger"', 'finger2"').replace('grip"', 'grip2"')),
            "kinematics.yaml": "arm:\n  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n",
        },
    ),
    "an arm is its own end effector": Problem(
        "SRD009",
        f'<robot name="bot">\n{SEMANTICS}<end_effector name="e" parent_link="upper" group="@@"/>\n</robot>',
        "arm",
        "tool",
        suffix=".srdf",
        files={"bot.urdf": robot(ARM, FINGER), "kinematics.yaml": "arm: {}\n"},
    ),
    "a world of today has the window of Fortress": Problem(
        "SCH042",
        world(
            '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>'
            '<plugin filename="gz-sim-scene-broadcaster-system" name="gz::sim::systems::SceneBroadcaster"/>\n<gui>\n'
            '<plugin filename="@@" name="view"><gz-gui><title>View</title></gz-gui></plugin>\n'
            '<plugin filename="GzSceneManager" name="scene"/></gui>'
        ),
        "GzScene3D",
        "MinimalScene",
        suffix=".sdf",
    ),
    "a bumper names the collision of another robot": Problem(
        "RES011",
        robot(
            ARM,
            '<gazebo reference="upper"><sensor name="s" type="contact"><contact>\n<collision>@@</collision></contact>'
            "</sensor></gazebo>",
        ),
        "collision",
        "upper_collision",
    ),
    "a note is behind a value": Problem(
        "SCH010",
        model(
            f'<link name="l">{SDF_BODY}<sensor name="s" type="camera"><topic>c</topic><camera>'
            "\n<horizontal_fov>1.1</horizontal_fov>@@<image><width>64</width><height>48</height></image></camera>"
            "</sensor></link>"
        ),
        " # guessed",
        "<!-- guessed -->",
        suffix=".sdf",
    ),
    "a package has three slashes before it": meshed(
        "package:@@bot/meshes/a.stl", "///", "//", "RES004"
    )._replace(files={"meshes/a.stl": cube(), "package.xml": "<package><name>bot</name></package>"}),
    "a wrist in the middle of an arm has no mass": Problem(
        "URD014",
        robot(ARM, WRIST.replace("@@", "0.06").replace('mass value="0.2"', 'mass value="@@"', 1)),
        "0",
        "0.2",
    ),
    "braces are in braces": in_xacro(
        '<xacro:property name="w" value="0.4"/>\n<link name="a"/><link name="b"/><joint name="j" type="fixed">'
        '<parent link="a"/><child link="b"/>\n<origin xyz="@@ 0 0"/></joint>',
        "${w/2+${w/4}}",
        "${w/2+w/4}",
        "XAC010",
    ),
    # Threads of a sixth set: the files beside a description, and what only one program reads.
    "a controller is called otherwise in its file": Problem(
        "R2C042",
        robot(ARM, ARM_CONTROL, PARAMETERS),
        "wrong.yaml",
        "right.yaml",
        files={
            "right.yaml": TRAJECTORY.format("arm"),
            "wrong.yaml": TRAJECTORY.format("arm_position"),
        },
    ),
    "a robot has a namespace, and the file of its controllers has none": Problem(
        "R2C042",
        robot(ARM, ARM_CONTROL, CONTROLLED.replace("</parameters>", "</parameters>@@")),
        "<ros><namespace>r1</namespace></ros>",
        "",
        files={"c.yaml": TRAJECTORY.format("arm")},
    ),
    "the time of a drive has no point": Problem(
        "R2C043",
        robot(CART, WHEEL_CONTROL, PARAMETERS),
        "wrong.yaml",
        "right.yaml",
        files={
            "right.yaml": WHEELED.format(f"{MEASURED}, cmd_vel_timeout: 1.0"),
            "wrong.yaml": WHEELED.format(f"{MEASURED}, cmd_vel_timeout: 1"),
        },
    ),
    "a drive is told ten times the distance of its wheels": Problem(
        "GEO011",
        robot(CART, WHEEL_CONTROL, PARAMETERS),
        "wrong.yaml",
        "right.yaml",
        files={
            "right.yaml": WHEELED.format(MEASURED),
            "wrong.yaml": WHEELED.format(MEASURED.replace("0.3", "3.0")),
        },
    ),
    "a drive is told that its right wheel is the left one": Problem(
        "GEO009",
        robot(CART, WHEEL_CONTROL, PARAMETERS),
        "wrong.yaml",
        "right.yaml",
        files={
            "right.yaml": WHEELED.format(MEASURED),
            "wrong.yaml": WHEELED.format(MEASURED)
            .replace("[left", "[@")
            .replace("[right", "[left")
            .replace("[@", "[right"),
        },
    ),
    "a drive hangs a link on the odometry that hangs on another": Problem(
        "GAZ020",
        robot(CART, WHEEL_CONTROL, PARAMETERS),
        "wrong.yaml",
        "right.yaml",
        files={
            "right.yaml": WHEELED.format(f"{MEASURED}, base_frame_id: base_link, enable_odom_tf: true"),
            "wrong.yaml": WHEELED.format(f"{MEASURED}, base_frame_id: body, enable_odom_tf: true"),
        },
    ),
    "states are published, and no joint has one": Problem(
        "R2C040",
        robot(ARM, ARM_CONTROL.replace('<state_interface name="position"/>', "@@"), CONTROLLED),
        "",
        '<state_interface name="position"/>',
        -1,
        files={
            "c.yaml": "controller_manager: {ros__parameters: {states: {type:"
            " joint_state_broadcaster/JointStateBroadcaster}}}\n"
        },
    ),
    "a drive has two wheels on one side and one on the other": Problem(
        "RES025",
        robot(WAGON, WHEEL_CONTROL, PARAMETERS),
        "wrong.yaml",
        "right.yaml",
        files={
            "right.yaml": WHEELED.format(MEASURED),
            "wrong.yaml": WHEELED.format(MEASURED).replace("[left_joint", "[left_joint, front_left_joint"),
        },
    ),
    "the start of a joint is beside its interfaces": Problem(
        "R2C006",
        robot(
            ARM,
            CONTROL.format("mock_components/GenericSystem", "shoulder").replace(
                '<state_interface name="position"/>', '<state_interface name="position"@@</state_interface>'
            ),
        ),
        '/><param name="initial_value">0.5</param><state_interface name="velocity">',
        '><param name="initial_value">0.5</param>',
    ),
    "a ground for MuJoCo is in a robot": Problem(
        "URD001",
        robot(ARM, '<mujoco>\n<compiler fusestatic="false"/>@@</mujoco>'),
        '<worldbody><geom type="plane" size="1 1 1"/></worldbody>',
        "",
    ),
    "the wheels of a drive have no collisions": Problem(
        "GEO008",
        robot(CART.replace(f"<collision>{RIM}</collision>", "@@"), DRIVE),
        "",
        f"<collision>{RIM}</collision>",
        -2,
    ),
    "a part has the moments of a cube of one meter": Problem(
        "INR005",
        robot(
            ARM.replace("<inertia ", "<inertia @@ ", 1).replace(
                '@@ ixx="0.01" iyy="0.01" izz="0.01"', "@@", 1
            )
        ),
        'ixx="0.166667" iyy="0.166667" izz="0.166667"',
        'ixx="0.004" iyy="0.008" izz="0.01"',
    ),
    "a group moves a joint without a limit of acceleration": Problem(
        "JNT038",
        '<robot name="bot">\n<group name="all">@@</group>\n</robot>',
        '<joint name="grip"/>',
        '<joint name="shoulder"/>',
        suffix=".srdf",
        files={**PLANNED, "bot.urdf": robot(ARM, FINGER)},
    ),
    "a group is called otherwise by its solver": Problem(
        "SRD015",
        '<robot name="bot">\n<group name="@@"><chain base_link="base" tip_link="upper"/></group>\n</robot>',
        "manipulator",
        "arm",
        -1,
        suffix=".srdf",
        files={**PLANNED, "bot.urdf": robot(ARM)},
    ),
    "a limit of ros2_control has braces without a dollar": in_xacro(
        ARM
        + CONTROL.format("mock_components/GenericSystem", "shoulder").replace(
            '<command_interface name="position"/>',
            '<command_interface name="position"><param name="min">-1</param>\n<param name="max">@@{pi/4}</param>'
            "</command_interface>",
        ),
        "",
        "$",
        "R2C020",
    ),
    "an include is placed by its own name": Problem(
        "FRM004",
        model(
            f'<link name="base">{SDF_BODY}</link><include><uri>crate</uri><name>some_crate</name>\n'
            "<placement_frame>@@</placement_frame><pose>1 0 0 0 0 0</pose></include>",
        ),
        "some_crate",
        "l",
        suffix=".sdf",
        files={
            "crate/model.config": "<model><name>crate</name><sdf version='1.9'>model.sdf</sdf></model>",
            "crate/model.sdf": model(f'<link name="l">{SDF_BODY}</link>').replace('name="m"', 'name="crate"'),
        },
    ),
    "the damping under water is that of one direction": Problem(
        "GAZ037",
        model(
            f'<link name="l">{SDF_BODY}</link><plugin filename="gz-sim-hydrodynamics-system" '
            'name="gz::sim::systems::Hydrodynamics"><link_name>l</link_name>\n@@</plugin>'
        ),
        "<xUU>-6</xUU><yVV>-60</yVV>",
        "<xUabsU>-6</xUabsU><yVabsV>-60</yVabsV>",
        suffix=".sdf",
    ),
    # Bridges, builds and files of controllers
    "a bridge is one mapping": beside(
        "RES028",
        robot(CART, INERTIAL_SENSOR),
        "<topic>",
        "",
        "- ",
        {"bridge.yaml": f"@@{{{BRIDGED.format('imu', 'imu', 'gz.msgs')}}}\n"},
    ),
    "a bridge has a type of messages that Gazebo has not": beside(
        "RES028",
        robot(CART, INERTIAL_SENSOR),
        "<topic>",
        "ign_msgs",
        "gz.msgs",
        {"bridge.yaml": f"- {{{BRIDGED.format('imu', 'imu', '@@')}}}\n"},
    ),
    "a topic of ROS has a part that begins with a digit": beside(
        "RES028",
        robot(CART, INERTIAL_SENSOR),
        "<topic>",
        "/joint/0/imu",
        "/imu",
        {"bridge.yaml": f"- {{{BRIDGED.format('imu', '@@', 'gz.msgs')}}}\n"},
    ),
    "a bridge puts the name of the model before a topic": beside(
        "RES030",
        robot(CART, INERTIAL_SENSOR),
        "<topic>",
        "/model/bot/imu",
        "/imu",
        {"bridge.yaml": f"- {{{BRIDGED.format('@@', 'imu', 'gz.msgs')}}}\n"},
    ),
    "a package installs a folder that is not there": beside(
        "RES029",
        robot(CART),
        "<robot",
        "launch",
        "",
        {
            "package.xml": PLANNED["package.xml"],
            "CMakeLists.txt": BUILD.format("config @@"),
            "config/a.yaml": "",
        },
    ),
    "a controller has no type": beside(
        "R2C045",
        robot(ARM, ARM_CONTROL, CONTROLLED),
        "c.yaml",
        "",
        "arm: {type: joint_trajectory_controller/JointTrajectoryController},",
        {
            "c.yaml": "controller_manager: {ros__parameters: {update_rate: 100, @@\n"
            "  states: {type: joint_state_broadcaster/JointStateBroadcaster}}}\n"
            "arm: {ros__parameters: {joints: [shoulder], command_interfaces: [position], "
            "state_interfaces: [position]}}\n",
            "sim.launch.py": LAUNCH,
        },
    ),
    "a gripper has joints in place of a joint": beside(
        "R2C044",
        robot(ARM, ARM_CONTROL, CONTROLLED),
        "c.yaml",
        "joints: [shoulder]",
        "joint: shoulder",
        {"c.yaml": "hand: {ros__parameters: {type: position_controllers/GripperActionController, @@}}\n"},
    ),
    "the axles of a car have a name of another controller": beside(
        "R2C044",
        robot(ARM, ARM_CONTROL, CONTROLLED),
        "c.yaml",
        "wheel_base",
        "wheelbase",
        {
            "c.yaml": "car: {ros__parameters: {type: bicycle_steering_controller/BicycleSteeringController, @@: 0.3}}\n"
        },
    ),
    "the wheels of a mecanum drive are exchanged in a file": beside(
        "GEO009",
        robot(WAGON, WHEEL_CONTROL, FRONT_CONTROL, CONTROLLED),
        "c.yaml",
        "left_joint, rear_left_wheel_command_joint_name: front_left_joint",
        "front_left_joint, rear_left_wheel_command_joint_name: left_joint",
        {"c.yaml": STEERED},
    ),
    "a file of parameters has a tab": beside(
        "R2C046",
        robot(CART),
        "<robot",
        "\t",
        "    ",
        {"package.xml": PLANNED["package.xml"], "ekf.yaml": "ekf:\n  ros__parameters:\n@@frequency: 30.0\n"},
    ),
    "MoveIt is given no action of a controller": beside(
        "SRD019",
        robot(SEMANTICS.splitlines()[0]),
        "<robot",
        "",
        "action_ns: follow_joint_trajectory,",
        {
            **PLANNED,
            "bot.urdf": robot(ARM),
            "moveit_controllers.yaml": MOVEIT_SENT.format("@@", "shoulder"),
        },
    ),
    "MoveIt is given pictures for points": beside(
        "SRD019",
        robot(SEMANTICS.splitlines()[0]),
        "<robot",
        "image_topic",
        "point_cloud_topic",
        {**PLANNED, "bot.urdf": robot(ARM), "sensors_3d.yaml": CLOUD},
    ),
    "servo is set up for another robot": beside(
        "SRD015",
        robot(SEMANTICS.splitlines()[0]),
        "<robot",
        "panda_arm",
        "arm",
        {
            **PLANNED,
            "bot.urdf": robot(ARM),
            "bot_servo.yaml": "move_group_name: @@\nee_frame_name: upper\n",
        },
    ),
    "a package is called like a folder in it": Problem(
        "RES001",
        robot(
            f'<link name="a">{MASS}\n<visual><geometry><mesh filename="package://@@meshes/a.stl"/></geometry></visual></link>'
        ),
        "",
        "bot/",
        files={"meshes/a.stl": cube(), "package.xml": "<package><name>bot</name></package>"},
    ),
    "two meshes for MuJoCo have one name": Problem(
        "MUJ006",
        robot(
            '<mujoco><compiler strippath="true" meshdir="meshes"/></mujoco>\n<link name="a"/>\n'
            '<link name="b"><collision><geometry><mesh filename="meshes/a.stl"/></geometry></collision>\n'
            '<collision><geometry><mesh filename="meshes/@@.stl"/></geometry></collision></link>\n'
            '<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>'
        ),
        "thin/a",
        "thin",
        files={"meshes/a.stl": cube(), "meshes/thin/a.stl": cube(), "meshes/thin.stl": cube()},
    ),
    "the start of an arm is one level too deep": Problem(
        "XAC001",
        robot(
            '<xacro:property name="start" value="${xacro.load_yaml(\'start.yaml\')@@}"/>\n',
            '<link name="a"/>\n<link name="b"/>\n<joint name="j" type="fixed"><parent link="a"/><child link="b"/>'
            "<origin xyz=\"0 0 ${start['lift']}\"/></joint>",
            more=f' name="bot"{XACRO}',
        ),
        "",
        "['initial']",
        3,
        ".urdf.xacro",
        {"start.yaml": "initial:\n  lift: 0.5\n"},
    ),
    # Of launch files, and of the worlds in which they start robots
    "a controller of velocities has no gains": beside(
        "R2C049",
        robot(ARM, ARM_CONTROL.replace("position", "velocity", 1), CONTROLLED),
        "c.yaml",
        "",
        ", gains: {shoulder: {p: 5.0}}",
        {
            "c.yaml": TRAJECTORY.format("arm")
            .replace("[position]", "[velocity]", 1)
            .replace("]}}\n", "]@@}}\n")
        },
    ),
    "a drive does not know how far its wheels are apart": beside(
        "R2C049",
        robot(CART, WHEEL_CONTROL, CONTROLLED),
        "c.yaml",
        "wheel_radius: 0.07",
        "wheel_radius: 0.07, wheel_separation: 0.3",
        {"c.yaml": WHEELED.format("@@")},
    ),
    "no bridge carries the clock": beside(
        "RES032",
        robot(CART, STATES_SENT, DRIVE),
        "<robot",
        "",
        '"/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock", ',
        {
            "sim.launch.py": SIMULATED.replace(
                'robot_state_publisher")', 'robot_state_publisher", parameters=[{"use_sim_time": True}])', 1
            )
            + 'Node(package="ros_gz_bridge", arguments=[@@'
            '"/model/bot/odometry@nav_msgs/msg/Odometry[gz.msgs.Odometry"])\n'
        },
    ),
    "the world of a robot has no system for its sensor": Problem(
        "RES018",
        robot(CART, INERTIAL_SENSOR, STATES_SENT, DRIVE),
        "",
        '<plugin filename="gz-sim-imu-system" name="gz::sim::systems::Imu"/>',
        INERTIAL_AT,
        files={"sim.launch.py": IN_WORLD, "yard.sdf": world(SYSTEMS, "@@", GROUND)},
    ),
    "a joint is not among those whose states are sent": Problem(
        "RES031",
        robot(CART, PAN, "@@", DRIVE),
        STATES_SENT.replace(
            "<topic>", "<joint_name>left_joint</joint_name><joint_name>right_joint</joint_name><topic>"
        ),
        STATES_SENT,
        files={"sim.launch.py": SIMULATED},
    ),
    "the controller that sends the states is not started": beside(
        "RES031",
        robot(ARM, ARM_CONTROL, CONTROLLED),
        "c.yaml",
        '"arm"',
        '"arm", "states"',
        {
            "c.yaml": TRAJECTORY.format("arm").replace(
                "arm: {type", "states: {type: joint_state_broadcaster/JointStateBroadcaster},\n  arm: {type"
            ),
            "sim.launch.py": SIMULATED
            + 'Node(package="controller_manager", executable="spawner", arguments=[@@])\n',
        },
    ),
    "RViz shows a robot whose states nothing sends": beside(
        "RES031",
        robot(CART),
        "<robot",
        "",
        'Node(package="joint_state_publisher_gui", executable="joint_state_publisher_gui")\n',
        {
            "view.launch.py": 'Node(package="robot_state_publisher", executable="robot_state_publisher")\n'
            'Node(package="rviz2", executable="rviz2")\n@@'
        },
    ),
    "a launch file joins xacro and the name of its file": in_xacro(
        f'@@{PART}<xacro:part p="a"/>', "", "", "RES033"
    )._replace(
        text=robot(PART, '<xacro:part p="a"/>', more=f' name="bot"{XACRO}'),
        wrong="xacro",
        right="xacro ",
        below=2,
        files={"view.launch.py": 'Command(["@@", os.path.join(share, "bot.urdf.xacro")])\n'},
    ),
    "a launch file reads xacro as it is written": in_xacro("", "", "", "RES033")._replace(
        text=robot(PART, '<xacro:part p="a"/>', more=f' name="bot"{XACRO}'),
        wrong='open(os.path.join(share, "bot.urdf.xacro")).read()',
        right='xacro.process_file(os.path.join(share, "bot.urdf.xacro")).toxml()',
        below=2,
        files={"view.launch.py": "description = @@\n"},
    ),
    "a package of Python installs no meshes": Problem(
        "RES029",
        robot(
            f'<link name="a">{MASS}\n<visual>\n'
            '<geometry><mesh filename="package://bot/meshes/a.stl"/></geometry></visual></link>'
        ),
        "",
        '("share/bot/meshes", glob("meshes/*"))',
        5,
        files={
            "meshes/a.stl": cube(),
            "package.xml": "<package format='3'><name>bot</name><buildtool_depend>ament_python</buildtool_depend>"
            "</package>",
            "setup.py": "from glob import glob\nsetup(data_files=[('share/bot/urdf', glob('urdf/*.urdf')), @@])\n",
        },
    ),
    "a robot is created where nothing is to stand on": Problem(
        "GAZ014",
        robot(CART, STATES_SENT, DRIVE),
        "",
        GROUND,
        (robot(CART, STATES_SENT, DRIVE)).split("diff-drive")[0].count("\n") + 1,
        files={"sim.launch.py": IN_WORLD, "yard.sdf": world(SYSTEMS, "@@")},
    ),
    "a world takes no robots": Problem(
        "GAZ014",
        robot(CART, STATES_SENT, DRIVE),
        SYSTEMS.replace(COMMANDED, ""),
        SYSTEMS,
        2,
        files={"sim.launch.py": IN_WORLD, "yard.sdf": world("@@", GROUND)},
    ),
    "a robot is created in a world of another name": Problem(
        "RES023",
        robot(CART, STATES_SENT, DRIVE),
        "default",
        "w",
        2,
        files={
            "sim.launch.py": IN_WORLD.replace('"create"', '"create", arguments=["-world", "@@"]'),
            "yard.sdf": world(SYSTEMS, GROUND),
        },
    ),
    "commands are carried out of Gazebo": Problem(
        "RES030",
        GZ_DRIVEN.replace("<left_joint>", "<topic>cmd_vel</topic>\n<left_joint>"),
        "[",
        "]",
        GZ_DRIVEN.split("<left_joint>")[0].count("\n") + 1,
        files={
            "sim.launch.py": 'Node(package="ros_gz_bridge", arguments=['
            '"/cmd_vel@geometry_msgs/msg/Twist@@gz.msgs.Twist"])\n'
        },
    ),
    "all limits of a robot are zero": Problem(
        "JNT023",
        robot(ARM, FINGER, WRIST.replace("@@", "0.06"))
        .replace('lower="-1" upper="1"', '\nlower="0" upper="0"')
        .replace('lower="0" upper="0.04"', 'lower="0" upper="@@"')
        .replace('effort="10" velocity="2"', 'effort="0" velocity="0"')
        .replace('effort="5" velocity="1"', 'effort="0" velocity="0"'),
        "0",
        "0.04",
        -5,
    ),
    "a camera tells things apart that have no label": Problem(
        "GAZ014",
        world(
            SYSTEMS.replace("user-commands", "sensors").replace("UserCommands", "Sensors"),
            GROUND,
            '<model name="eye"><static>true</static><link name="l">\n<sensor name="s" type="segmentation">'
            "<topic>s</topic><camera><horizontal_fov>1</horizontal_fov></camera></sensor></link></model>\n"
            f'<model name="box"><pose>3 0 0.05 0 0 0</pose><link name="l">{SDF_BODY}</link>@@</model>',
        ),
        "",
        '<plugin filename="gz-sim-label-system" name="gz::sim::systems::Label"><label>1</label></plugin>',
        -1,
        ".sdf",
    ),
    # Of a later set of threads.
    "the drive and a filter publish the odometry": Problem(
        "GAZ036",
        robot(
            CART,
            ROS_DRIVE.format(
                "<publish_wheel_tf>true</publish_wheel_tf>\n<publish_odom_tf>@@</publish_odom_tf>"
            ),
        ),
        "true",
        "false",
        files={
            "ekf.yaml": FILTER,
            "sim.launch.py": SIMULATED + 'Node(package="robot_localization", parameters=["ekf.yaml"])\n',
        },
    ),
    "a camera is in its optical frame": Problem(
        "GAZ038",
        robot(
            CART,
            OPTICAL,
            '<gazebo reference="@@">\n<sensor name="front" type="camera"><camera/></sensor>\n</gazebo>',
        ),
        "eye_optical",
        "eye",
    ),
    "the plugins of two cameras have one name": Problem(
        "GAZ041",
        robot(CART, EYES.format("front", "camera_controller"), EYES.format("rear", "@@")),
        "camera_controller",
        "rear_camera_controller",
    ),
    "a map was made into a model that is called a world": Problem(
        "SCH043",
        '<?xml version="1.0"?>\n<sdf version="1.6">\n@@\n</sdf>\n',
        f'<model name="map"><static>true</static><link name="l">{SDF_BODY}</link></model>',
        f'<world name="w"><model name="map"><static>true</static><link name="l">{SDF_BODY}</link></model></world>',
        -1,
        ".world",
    ),
    "the states of joints have the controller of ROS 1": beside(
        "R2C047",
        robot(ARM, ARM_CONTROL, CONTROLLED),
        "c.yaml",
        "joint_state_controller/JointStateController",
        "joint_state_broadcaster/JointStateBroadcaster",
        {"c.yaml": "controller_manager: {ros__parameters: {update_rate: 100, states: {type: @@}}}\n"},
    ),
    "a second controller manager is started": beside(
        "R2C048",
        robot(ARM, ARM_CONTROL, CONTROLLED),
        "gz_ros2_control/GazeboSimSystem",
        'Node(package="controller_manager", executable="ros2_control_node", parameters=["c.yaml"])\n',
        "",
        {"c.yaml": TRAJECTORY.format("arm"), "sim.launch.py": f"{SIMULATED}@@"},
    ),
    "RViz has no transform for the wheels": Problem(
        "RES031",
        robot(CART, "@@", DRIVE),
        "",
        STATES_SENT,
        1,
        files={
            "sim.launch.py": SIMULATED
            + 'Node(package="ros_gz_bridge", arguments=["/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model"])\n'
        },
    ),
    "all wheels turn backwards": Problem(
        "GEO010",
        robot(CART.replace("0 1 0", "@@"), WHEEL_CONTROL, CONTROLLED),
        "0 -1 0",
        "0 1 0",
        files={"c.yaml": WHEELED.format(MEASURED)},
    ),
    "the wheels in front are larger": Problem(
        "GEO012",
        robot(
            WAGON.replace('radius="0.07"', 'radius="@@"', 4),
            FOUR_WHEELS.format(
                "diff",
                "Diff",
                "<left_joint>front_left_joint</left_joint><left_joint>left_joint</left_joint>"
                "<right_joint>front_right_joint</right_joint><right_joint>right_joint</right_joint>"
                "<wheel_separation>0.3</wheel_separation><wheel_radius>0.07</wheel_radius>",
            ),
        ),
        "0.055",
        "0.07",
    ),
    "the sensor of an autopilot is in a link that is merged": Problem(
        "RES024",
        robot(
            f'<link name="base_link">{BODY}</link>\n<link name="imu_link"/>\n'
            '<joint name="imu_joint" type="fixed"><parent link="base_link"/><child link="imu_link"/></joint>\n'
            '<gazebo reference="imu_link"><sensor name="imu_sensor" type="imu"><topic>imu</topic></sensor></gazebo>\n'
            '<gazebo><plugin name="ArduPilotPlugin" filename="ArduPilotPlugin">\n'
            "<imuName>@@::imu_sensor</imuName></plugin></gazebo>"
        ),
        "imu_link",
        "base_link",
    ),
    "the settings for MuJoCo are above the robot": Problem(
        "XML009",
        f'<?xml version="1.0"?>\n@@\n{ARM}</robot>\n',
        '<mujoco><compiler discardvisual="false"/></mujoco>\n<robot name="bot">',
        '<robot name="bot">\n<mujoco><compiler discardvisual="false"/></mujoco>',
    ),
    "a sensor whose topic is bridged has none": Problem(
        "RES030",
        robot(CART, INERTIAL_SENSOR.replace("<topic>imu</topic>", "@@"), DRIVE),
        "",
        "<topic>imu</topic>",
        -1,
        files={"bridge.yaml": f"- {{{BRIDGED.format('imu', 'imu', 'gz.msgs')}, direction: GZ_TO_ROS}}\n"},
    ),
    "a suction cup is merged into the arm": Problem(
        "RES014",
        robot(
            ARM,
            CUP,
            "@@<gazebo>\n"
            '<plugin name="suction" filename="libgazebo_ros_vacuum_gripper.so">\n'
            "<link_name>cup</link_name></plugin></gazebo>",
        ),
        "",
        '<gazebo reference="cup_joint"><preserveFixedJoint>true</preserveFixedJoint></gazebo>',
        2,
    ),
    "a collision is turned, and the visual of the same mesh is not": Problem(
        "GEO003",
        robot(ARM, CALVES),
        '<origin rpy="1.5708 0 0"/>',
        "",
        files={"meshes/calf.stl": cube(), "package.xml": PLANNED["package.xml"]},
    ),
    "the pose of a link in an old version depends on a joint": Problem(
        "SCH019",
        f'<?xml version="1.0"?>\n<sdf version="@@">\n<model name="m">\n<link name="hull">{SDF_BODY}</link>\n'
        f'<link name="rotor">\n<pose relative_to="rotor_joint">0 0 0 0 0 0</pose>{SDF_MASS}</link>\n'
        '<joint name="rotor_joint" type="revolute">\n<pose relative_to="hull">0.2 0 0.06 0 0 0</pose>\n'
        "<parent>hull</parent><child>rotor</child><axis><xyz>0 0 1</xyz></axis></joint>\n</model>\n</sdf>\n",
        "1.5",
        "1.7",
        4,
        ".sdf",
    ),
    "an inertial has one angle": Problem(
        "SCH013",
        robot(ARM).replace(
            '<inertial><origin xyz="0 0 0.2"/>', '<inertial>\n<origin rpy="@@" xyz="0 0 0.2"/>'
        ),
        "0.0",
        "0 0 0",
    ),
    "friction of SDFormat is in a collision of URDF": Problem(
        "URD001",
        robot(
            ARM,
            FINGER.replace(
                "</link>",
                '<collision>\n<geometry><box size="0.02 0.02 0.05"/></geometry>\n@@</collision></link>',
                1,
            ),
        ),
        "<surface><friction><ode><mu1>1000</mu1></ode></friction></surface>",
        "",
    ),
    "a caster has a negative radius": Problem(
        "SCH014",
        robot(
            CART,
            f'<link name="caster">{MASS.replace("0.01", "0.0002")}\n'
            '<collision><geometry><sphere radius="${@@*(0.07-0.05)}"/></geometry></collision></link>\n'
            '<joint name="c" type="fixed"><parent link="body"/><child link="caster"/>'
            '<origin xyz="-0.13 0 -0.05"/></joint>',
            more=f' name="bot"{XACRO}',
        ),
        "-1",
        "1",
        suffix=".urdf.xacro",
    ),
    "damping is written as Bullet's own files do": Problem(
        "URD001",
        robot(ARM.replace("<limit", '<@@ damping="1" friction="0.2"/>\n<limit')),
        "joint_properties",
        "dynamics",
    ),
    "a link that slides has no mass": Problem(
        "URD013",
        robot(
            '<link name="world"/>\n<link name="x">\n'
            '<inertial><mass value="@@"/>'
            '<inertia ixx="@@" iyy="@@" izz="@@" ixy="0" ixz="0" iyz="0"/></inertial>\n</link>\n',
            f'<link name="body">{BODY}</link>\n<joint name="slide_x" type="prismatic"><parent link="world"/>'
            '<child link="x"/><axis xyz="1 0 0"/><limit lower="-5" upper="5" effort="9" velocity="1"/></joint>\n'
            '<joint name="slide_y" type="prismatic"><parent link="x"/><child link="body"/><axis xyz="0 1 0"/>'
            '<limit lower="-5" upper="5" effort="9" velocity="1"/></joint>',
        ),
        "0",
        "0.1",
        -1,
    ),
    "the system for sensors is in a model of a world that has it": Problem(
        "RES017",
        world(
            SYSTEMS,
            DRAWN,
            f'<model name="eye">\n@@<static>true</static><link name="l">{SDF_BODY}',
            CAMERA.format("eye", 0.2, "eye"),
            "</link></model>",
        ),
        DRAWN,
        "",
        suffix=".sdf",
    ),
    "a whole robot is to collide with itself": Problem(
        "GAZ009",
        robot(ARM, "<gazebo>\n<@@>true</@@>\n</gazebo>"),
        "selfCollide",
        "self_collide",
    ),
    "a camera floats before its arm": Problem(
        "URD020",
        robot(
            ARM,
            f'<link name="eye">{MASS}</link>\n<joint name="eye_joint" type="@@"><parent link="upper"/>'
            '<child link="eye"/><origin xyz="0 0 0.4"/></joint>',
        ),
        "floating",
        "fixed",
    ),
    "a finger follows a joint without its prefix": Problem(
        "JNT009",
        robot(
            '<xacro:macro name="grip" params="prefix">\n',
            ARM,
            FINGER.replace('"finger"', '"${prefix}finger"').replace('"grip"', '"${prefix}grip"'),
            FINGER.replace('"finger"', '"${prefix}thumb"')
            .replace('"grip"', '"${prefix}thumb_joint"')
            .replace("</joint>", '\n<mimic joint="@@grip"/></joint>'),
            '</xacro:macro>\n<xacro:grip prefix="left_"/>',
            more=f' name="bot"{XACRO}',
        ),
        "",
        "${prefix}",
        suffix=".urdf.xacro",
    ),
    "an argument is read as if it were a property": in_xacro(
        '<xacro:arg name="camera" default="eye"/><xacro:include filename="part.xacro"/>\n<xacro:part p="@@"/>\n',
        "${camera}",
        "$(arg camera)",
        "XAC004",
    ),
    "all meshes of a boat are ten times too large": Problem(
        "GEO001",
        robot(
            '<link name="base_link"/><joint name="h" type="fixed"><parent link="base_link"/>'
            f'<child link="hull"/></joint><link name="hull">{HULL}</link>\n<link name="pod">{HULL}</link>\n'
            '<joint name="pod_joint" type="continuous"><parent link="hull"/><child link="pod"/>'
            '<origin xyz="0 0 0.2"/><axis xyz="1 0 0"/></joint>'
        ),
        "10 10 10",
        "1 1 1",
        files={"a.stl": cube()},
    ),
    "a contact sensor names its collision as URDF has none": Problem(
        "RES011",
        robot(
            ARM,
            '<gazebo reference="upper"><sensor name="touch" type="contact"><contact>\n'
            "<collision>@@</collision></contact></sensor></gazebo>",
        ),
        "collision",
        "upper_collision",
    ),
    "an axis is in the frame of its model as in old versions": Problem(
        "SCH008",
        model(
            f'<link name="hull">{SDF_BODY}</link>\n'
            f'<link name="rotor"><pose>0.2 0.2 0.1 0.6 0 0.7854</pose>{SDF_MASS}</link>\n'
            '<joint name="j" type="revolute"><parent>hull</parent><child>rotor</child><axis><xyz>0.48 -0.6 0.64</xyz>\n'
            "@@</axis></joint>"
        ),
        "<use_parent_model_frame>1</use_parent_model_frame>",
        "",
        suffix=".sdf",
    ),
    "a buoy's receiver is nowhere on the earth": Problem(
        "GAZ014",
        world(
            SYSTEMS,
            '<plugin filename="gz-sim-navsat-system" name="gz::sim::systems::NavSat"/>\n@@<model name="m">'
            '<link name="l">\n'
            f'<sensor name="s" type="navsat"><topic>fix</topic></sensor>{SDF_BODY}</link></model>',
        ),
        "",
        "<spherical_coordinates><surface_model>EARTH_WGS84</surface_model><latitude_deg>1</latitude_deg>"
        "<longitude_deg>1</longitude_deg><elevation>0</elevation><heading_deg>0</heading_deg></spherical_coordinates>",
        1,
        ".sdf",
    ),
    "planning may be faster than the robot": Problem(
        "SRD015",
        '<robot name="bot">\n<group name="arm"><chain base_link="base" tip_link="upper"/></group>\n</robot>',
        "2.618",
        "2.0",
        1,
        ".srdf",
        {
            **PLANNED,
            "bot.urdf": robot(ARM),
            "joint_limits.yaml": "joint_limits:\n  shoulder: {has_velocity_limits: true, max_velocity: @@, "
            "has_acceleration_limits: true, max_acceleration: 1.0}\n",
        },
    ),
    "the body of a vehicle on tracks is called otherwise": Problem(
        "RES014",
        '<?xml version="1.0"?>\n<sdf version="1.6">\n<model name="m">\n'
        + "".join(
            f'<link name="{name}">{SDF_BODY}</link>\n' for name in ("base_link", "left_track", "right_track")
        )
        + "".join(
            f'<joint name="{side}" type="fixed"><parent>base_link</parent><child>{side}_track</child></joint>\n'
            for side in ("left", "right")
        )
        + '<plugin name="tracks" filename="libSimpleTrackedVehiclePlugin.so">\n<body>@@</body>\n'
        "<left_track>left_track</left_track><right_track>right_track</right_track></plugin>\n</model>\n</sdf>\n",
        "body",
        "base_link",
        suffix=".sdf",
    ),
    "a macro has a parameter that its caller does not know": in_xacro(
        '<xacro:macro name="tool" params="parent@@"><xacro:if value="${lit}"><link name="lamp"/>'
        '<joint name="lamp_joint" type="fixed"><parent link="${parent}"/><child link="lamp"/></joint></xacro:if>'
        '</xacro:macro>\n<link name="base"/>\n<xacro:tool parent="base"/>',
        " lit",
        " lit:=false",
        "XAC008",
    )._replace(below=2),
    "a folder stands where xacro is to read values": Problem(
        "XAC001",
        robot(
            '<xacro:arg name="limits" default="@@"/>\n'
            '<xacro:property name="limits" value="${xacro.load_yaml(\'$(arg limits)\')}"/>\n',
            ARM.replace('effort="10"', "effort=\"${limits['shoulder']}\""),
            more=f' name="bot"{XACRO}',
        ),
        "",
        "limits.yaml",
        1,
        ".urdf.xacro",
        {"limits.yaml": "shoulder: 10.0\n"},
    ),
    "a block about a foot that has a surface is not the first": Problem(
        "GAZ042",
        robot(
            ARM,
            '@@<gazebo reference="upper">\n<kp>1e7</kp>\n<collision><surface><bounce><threshold>9</threshold></bounce>'
            "</surface></collision>\n</gazebo>",
        ),
        '<gazebo reference="upper"><sensor name="imu" type="imu"><topic>imu</topic></sensor></gazebo>',
        "",
        1,
    ),
    # Of joints that differ from all others, grippers, and worlds
    "a camera is moved, and its collision is not": Problem(
        "GEO003",
        robot(
            CART,
            '<link name="eye"><visual><origin xyz="-0.2 0 0.1"/><geometry>'
            '<mesh filename="eye.stl" scale="0.3 0.3 0.3"/>'
            '</geometry></visual>\n<collision><origin xyz="@@"/><geometry>'
            '<mesh filename="eye.stl" scale="0.3 0.3 0.3"/>'
            "</geometry></collision></link>"
            '<joint name="on" type="fixed"><parent link="body"/><child link="eye"/></joint>',
        ),
        "0 0 0.2",
        "-0.2 0 0.1",
        files={"eye.stl": cube()},
    ),
    "soft limits belong to another joint": Problem(
        "JNT037",
        robot(
            ARM,
            "".join(
                f'<link name="s{number}">{MASS}</link><joint name="j{number}" type="revolute"><parent link="upper"/>'
                f'<child link="s{number}"/><axis xyz="0 0 1"/>'
                '<limit lower="-2.97" upper="2.97" effort="9" velocity="2"/>\n'
                f'<safety_controller soft_lower_limit="-{soft}" soft_upper_limit="{soft}" k_velocity="2"/></joint>'
                for number, soft in enumerate(("2.93", "2.93", "@@", "2.93"))
            ),
        ),
        "2.06",
        "2.93",
    ),
    "one of two arms bends less by a typo": Problem(
        "JNT034",
        robot(
            f'<link name="stand"/><link name="body">{BODY}</link><joint name="b" type="fixed"><parent link="stand"/>'
            '<child link="body"/></joint>',
            "".join(
                f'<link name="{side}_arm">{MASS}</link><joint name="{side}_elbow" type="revolute"><parent link="body"/>'
                f'<child link="{side}_arm"/><origin xyz="0 {y} 0"/><axis xyz="0 1 0"/>\n'
                f'<limit lower="{lower}" upper="1.4" effort="9" velocity="2"/></joint>'
                for side, y, lower in (("left", 0.2, "-2.016"), ("right", -0.2, "@@"))
            ),
        ),
        "-1.981",
        "-2.016",
    ),
    "a color does not reach a visual that has a name": Problem(
        "GAZ004",
        robot(
            CART.replace("<visual>", "<visual@@>", 1),
            '<gazebo reference="body">\n<material>Gazebo/Black</material></gazebo>',
        ),
        ' name="look"',
        "",
        CART.count("\n"),
    ),
    "a plugin of a multicopter names a link without its prefix": Problem(
        "RES014",
        model(
            f'<link name="fly/base">{SDF_BODY}</link>\n<plugin name="base" '
            'filename="librotors_gazebo_multirotor_base_plugin.so"><robotNamespace>fly</robotNamespace>\n'
            "<linkName>@@</linkName></plugin>"
        ),
        "base",
        "fly/base",
        suffix=".sdf",
    ),
    "a macro does not hand on what it hangs on": Problem(
        "XAC009",
        robot(
            '<xacro:macro name="arm" params="at:=\'\'"><xacro:if value="${at != \'\'}"><joint name="on" type="fixed">'
            '<parent link="${at}"/><child link="arm"/></joint></xacro:if>\n',
            '<link name="arm"/><link name="tip"/>'
            '<joint name="end" type="fixed"><parent link="arm"/><child link="tip"/>'
            "</joint></xacro:macro>\n",
            '<xacro:macro name="whole" params="at"><xacro:arm@@/></xacro:macro>\n',
            '<link name="table"/><xacro:whole at="table"/>',
            more=f' name="bot"{XACRO}',
        ),
        "",
        ' at="${at}"',
        0,
        ".urdf.xacro",
    ),
    "parentheses are around a property": in_xacro(
        '<xacro:property name="space" value="a"/><link name="x"/>\n<gazebo><plugin name="p" '
        'filename="libgazebo_ros_control.so"><robotNamespace>@@</robotNamespace></plugin></gazebo>',
        "($space)",
        "${space}",
        "XAC010",
    ),
    "a property is defined for one arrangement alone": in_xacro(
        '<xacro:arg name="kind" default="alone"/><link name="world"/><link name="body"/>\n<xacro:if '
        'value="${\'$(arg kind)\' == \'@@\'}"><xacro:property name="base" value="world"/></xacro:if>\n'
        '<joint name="j" type="fixed"><child link="body"/>\n<parent link="${base}"/></joint>',
        "placed",
        "alone",
        "XAC004",
    )._replace(below=2),
    "two fingers are in each other in a state": Problem(
        "SRD012",
        '<robot name="bot">\n<group name="tool"><joint name="one_joint"/><joint name="two_joint"/></group>\n'
        '<group_state name="closed" group="tool"><joint name="one_joint" value="@@"/>'
        '<joint name="two_joint" value="0"/></group_state>\n'
        + "".join(
            f'<disable_collisions link1="{one}" link2="{two}" reason="Adjacent"/>\n'
            for one, two in (("base", "upper"), ("upper", "one"), ("upper", "two"))
        )
        + '<disable_collisions link1="base" link2="one" reason="Never"/>'
        '<disable_collisions link1="base" link2="two" reason="Never"/></robot>',
        "0.03",
        "0.01",
        0,
        ".srdf",
        {
            "bot.urdf": robot(
                ARM,
                "".join(
                    f'<link name="{name}">{MASS}<collision>'
                    '<geometry><box size="0.02 0.03 0.06"/></geometry></collision>'
                    f'</link><joint name="{name}_joint" type="prismatic"><parent link="upper"/><child link="{name}"/>'
                    f'<origin xyz="0 {y} 0.43"/><axis xyz="0 1 0"/>'
                    '<limit lower="0" upper="0.04" effort="5" velocity="1"/></joint>\n'
                    for name, y in (("one", -0.04), ("two", 0.01))
                ),
            ),
            "package.xml": "<package><name>bot</name></package>",
        },
    ),
    "a state leaves the finger that follows at 0": Problem(
        "SRD010",
        '<robot name="bot">\n<group name="tool"><joint name="grip"/><joint name="thumb_joint"/></group>\n'
        '<group_state name="open" group="tool"><joint name="grip" value="0.03"/>\n'
        '<joint name="thumb_joint" value="@@"/></group_state></robot>',
        "0",
        "0.03",
        0,
        ".srdf",
        {
            "bot.urdf": robot(
                ARM,
                FINGER,
                FINGER.replace('"finger"', '"thumb"')
                .replace('"grip"', '"thumb_joint"')
                .replace("</joint>", '<mimic joint="grip"/></joint>'),
            )
        },
    ),
    "an endless joint has a velocity and no effort": Problem(
        "URD005",
        robot(
            ARM,
            f'<link name="eye">{MASS}</link><joint name="pan" type="continuous"><parent link="upper"/>'
            '<child link="eye"/><axis xyz="0 0 1"/>\n<limit @@velocity="3"/></joint>',
        ),
        "",
        'effort="2" ',
    ),
    "moments are written row by row": Problem(
        "INR002",
        robot(
            '<link name="stand"/><joint name="b" type="fixed"><parent link="stand"/><child link="body"/></joint>'
            '<link name="body"><inertial><mass value="20"/>\n'
            '<inertia ixx="0.66" ixy="-0.02" ixz="0" @@/></inertial></link>'
        ),
        'iyy="-0.02" iyz="0.66" izz="0"',
        'iyy="0.66" iyz="0" izz="0.9"',
    ),
    "a moment of a propeller lacks the minus of its exponent": Problem(
        "INR003",
        model(
            '<link name="rotor"><inertial><mass>0.016</mass><inertia>\n<ixx>3.8e@@7</ixx><iyy>2.612e-05</iyy>'
            "<izz>2.645e-05</izz></inertia></inertial></link>"
        ),
        "",
        "-0",
        suffix=".sdf",
    ),
    "a car is rolled instead of turned": Problem(
        "GEO027",
        world(
            SYSTEMS,
            GROUND,
            f'<model name="car">\n<pose>2 3 0.5 @@</pose><link name="hull">{SDF_BODY}</link>',
            *(
                f'<link name="{side}"><pose>0 {y} 0 -1.5708 0 0</pose>{SDF_MASS}<collision name="c">'
                "<geometry><cylinder>"
                "<radius>0.1</radius><length>0.04</length></cylinder></geometry></collision></link>"
                f'<joint name="{side}_joint" type="revolute"><parent>hull</parent><child>{side}</child><axis>'
                '<xyz expressed_in="__model__">0 1 0</xyz></axis></joint>'
                for side, y in (("left", 0.2), ("right", -0.2))
            ),
            '<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive"><left_joint>left_joint'
            "</left_joint><right_joint>right_joint</right_joint><wheel_separation>0.4</wheel_separation>"
            "<wheel_radius>0.1</wheel_radius></plugin></model>",
        ),
        "1.57 0 0",
        "0 0 1.57",
        suffix=".sdf",
    ),
    "the frame of a camera begins with a slash": Problem(
        "GAZ012",
        robot(
            CART,
            OPTICAL,
            '<gazebo reference="body"><sensor name="eye" type="depth"><camera/><plugin name="eye" '
            'filename="libgazebo_ros_openni_kinect.so">\n<frameName>@@eye_optical</frameName></plugin></sensor></gazebo>',
        ),
        "/",
        "",
    ),
    "a bumper of ROS 2 has the topic of ROS 1": Problem(
        "RES019",
        robot(
            ARM,
            '<gazebo reference="upper"><sensor name="touch" type="contact"><contact>'
            "<collision>upper_collision</collision></contact>"
            '<plugin name="touch" filename="libgazebo_ros_bumper.so">\n@@</plugin></sensor></gazebo>',
        ),
        "<bumperTopicName>touch</bumperTopicName>",
        "<ros><remapping>bumper_states:=touch</remapping></ros>",
        files={
            "package.xml": "<package><name>bot</name><buildtool_depend>ament_cmake</buildtool_depend></package>"
        },
    ),
    # Of hands and grippers, vehicles under water, drives, and what is in the wrong place
    "a finger overlaps the one that is fixed": Problem(
        "SRD012",
        '<robot name="bot">\n<group name="arm"><joint name="shoulder"/></group>'
        '<group name="tool"><joint name="one_joint"/></group>\n'
        + "".join(
            f'<disable_collisions link1="{one}" link2="{two}" reason="Adjacent"/>'
            for one, two in (("base", "upper"), ("upper", "one"), ("upper", "two"))
        )
        + "\n@@</robot>",
        "",
        '<disable_collisions link1="one" link2="two" reason="Default"/>',
        -1,
        ".srdf",
        {
            "bot.urdf": robot(
                ARM,
                "".join(
                    f'<link name="{name}">{MASS}<collision><geometry><box size="0.03 0.04 0.06"/></geometry>'
                    f'</collision></link><joint name="{name}_joint" type="{kind}"><parent link="upper"/>'
                    f'<child link="{name}"/><origin xyz="0 {y} 0.44"/><axis xyz="1 0 0"/>'
                    '<limit lower="0" upper="1" effort="5" velocity="1"/></joint>\n'
                    for name, kind, y in (("one", "revolute", 0.012), ("two", "fixed", -0.012))
                ),
            ),
            "package.xml": "<package><name>bot</name></package>",
        },
    ),
    "the sides of a drive of ROS 1 are exchanged": Problem(
        "GEO009",
        robot(
            CART,
            ROS_DRIVE.format("<odometryFrame>odom</odometryFrame><robotBaseFrame>base_link</robotBaseFrame>")
            .replace("<left_joint>left_joint</left_joint>\n<right_joint>right_joint</right_joint>", "@@")
            .replace("wheel_separation", "wheelSeparation")
            .replace("wheel_diameter", "wheelDiameter"),
        ),
        "<leftJoint>right_joint</leftJoint><rightJoint>left_joint</rightJoint>",
        "<leftJoint>left_joint</leftJoint><rightJoint>right_joint</rightJoint>",
    ),
    "a car is drawn along y": Problem(
        "GEO010",
        robot(
            '<link name="body"/><link name="base_link">'
            + MASS
            + '</link><joint name="b" type="fixed"><parent link="body"/>'
            '<child link="base_link"/>\n<origin rpy="0 0 @@"/></joint>',
            "".join(
                f'<link name="{side}">{MASS}<collision><origin rpy="0 1.5708 0"/>'
                '<geometry><cylinder radius="0.07" length="0.05"/></geometry></collision></link>\n'
                f'<joint name="{side}_joint" type="continuous"><parent link="body"/><child link="{side}"/>'
                f'<origin xyz="{x} 0 0"/><axis xyz="-1 0 0"/></joint>'
                for side, x in (("left", -0.15), ("right", 0.15))
            ),
            DRIVE,
        ),
        "0",
        "1.5708",
        1,
    ),
    "the wheels of a robot without a drive are above its footprint": Problem(
        "GEO024",
        robot(
            f'<link name="base_footprint"/><joint name="f" type="fixed"><parent link="base_footprint"/>'
            f'<child link="base_link"/>\n<origin xyz="0 0 @@"/></joint>{CART}'
        ),
        "0.082",
        "0.07",
        -1,
    ),
    "the water that moves with a vehicle is heavier than it": Problem(
        "GAZ043",
        model(
            f'<link name="hull">{SDF_BODY}</link>\n<plugin filename="gz-sim-hydrodynamics-system" '
            'name="gz::sim::systems::Hydrodynamics"><link_name>hull</link_name>\n<zDotW>@@</zDotW><zW>-4</zW></plugin>'
        ),
        "-1.2",
        "-0.5",
        suffix=".sdf",
    ),
    "the body of a vehicle is an element in a value": Problem(
        "RES027",
        model(
            f'<link name="hull">{SDF_BODY}</link>\n',
            *(
                f'<link name="{side}">{SDF_MASS}</link><joint name="{side}_joint" type="fixed"><parent>hull</parent>'
                f"<child>{side}</child></joint>\n"
                for side in ("left", "right")
            ),
            '<plugin filename="gz-sim-tracked-vehicle-system" name="gz::sim::systems::TrackedVehicle">\n<body_link>@@'
            "</body_link><left_track><link>left</link></left_track><right_track><link>right</link></right_track></plugin>",
        ),
        "<link>hull</link>",
        "hull",
        suffix=".sdf",
    ),
    "damping is written as attributes in SDFormat": Problem(
        "NS001",
        model(
            f'<link name="hull">{SDF_BODY}</link><link name="fin">{SDF_MASS}</link><joint name="j" type="revolute">'
            "<parent>hull</parent><child>fin</child><axis><xyz>1 0 0</xyz>\n@@</axis></joint>"
        ),
        '<dynamics damping="0.2"/>',
        "<dynamics><damping>0.2</damping></dynamics>",
        suffix=".sdf",
    ),
    "damping is in an element of the first robots": Problem(
        "URD001",
        robot(ARM.replace("</joint>\n", '<@@ damping="1"/></joint>\n').replace("<@@", "<dynamics", 1)),
        "joint_properties",
        "dynamics",
    ),
    "a spring is in attributes of a joint": Problem(
        "URD002",
        robot(ARM, SLIDE.replace("@@", "0.04").replace("<limit", '<dynamics damping="9"@@/><limit')),
        ' springStiffness="1200"',
        "",
    ),
    "moments have both halves of a matrix": Problem(
        "URD002", robot(ARM.replace('ixz="0"', 'ixz="0"@@', 1)), ' iyx="0"', ""
    ),
    "SRDF is about a robot with finer collisions": semantic(
        '<disable_collisions link1="base" link2="upper" reason="Adjacent"/>\n'
        '<disable_collisions link1="upper" link2="@@" reason="Adjacent"/>',
        "upper_sc",
        "finger",
        "SRD001",
    ),
    "the scene is beside the world": Problem(
        "SCH003",
        world(SYSTEMS).replace("</world>", "</world>\n@@"),
        "<scene><ambient>1 1 1 1</ambient></scene>",
        "",
        suffix=".sdf",
    ),
    "a sensor is in a model": Problem(
        "SCH003",
        model("@@", f'\n<link name="hull">{SDF_BODY}</link>'),
        '<sensor name="s" type="imu"><topic>imu</topic></sensor>',
        "",
        suffix=".sdf",
    ),
    "a sensor is on a joint": Problem(
        "GAZ011",
        robot(
            CART,
            OPTICAL,
            f'<gazebo reference="@@">\n<sensor name="s" type="gpu_lidar"><topic>scan</topic><lidar>{SCAN}'
            "</lidar></sensor></gazebo>",
        ),
        "eye_joint",
        "eye",
        1,
    ),
    "a propeller has the limits of its rudder": Problem(
        "JNT027",
        robot(
            ARM,
            f'<link name="blade">{MASS}</link>\n<joint name="spin" @@<parent link="upper"/><child link="blade"/>'
            '<axis xyz="1 0 0"/></joint>\n<gazebo><plugin filename="gz-sim-thruster-system" '
            'name="gz::sim::systems::Thruster"><joint_name>spin</joint_name><propeller_diameter>0.24</propeller_diameter>'
            "</plugin></gazebo>",
        ),
        'type="revolute"><limit lower="-1.57" upper="1.57" effort="9" velocity="9"/>',
        'type="continuous">',
        1,
    ),
    "a joint names its own model": Problem(
        "JNT001",
        model(
            f'<link name="hull">{SDF_BODY}</link><model name="load"><link name="l">{SDF_BODY}</link></model>\n'
            '<joint name="j" type="fixed"><parent>hull</parent><child>@@load::l</child></joint>'
        ),
        "drone::",
        "",
        suffix=".sdf",
    ),
    "the left wheels are turned around": Problem(
        "GEO010",
        robot(CART.replace('xyz="0 0.15 0"', 'xyz="0 0.15 0" rpy="@@ 0 0"'), DRIVE),
        "3.14159",
        "0",
        8,
    ),
    "a part of a robot is on a floating joint": Problem(
        "URD020",
        robot(
            ARM,
            f'<link name="part">{MASS}</link>\n<joint name="j" type="@@"><parent link="upper"/><child link="part"/>'
            '<origin xyz="0 0 1"/></joint>',
        ),
        "floating",
        "fixed",
    ),
    "a controller drives an arm that has no effort": Problem(
        "JNT025",
        robot(
            ARM.replace('effort="10"', 'effort="@@"'),
            TRANSMISSION.format(
                "transmission_interface/SimpleTransmission", "hardware_interface/EffortJointInterface"
            ),
        ),
        "0",
        "99",
    ),
    # Of arms without numbers, collisions or solvers, and expressions that xacro does not see
    "a height is written as a property without its signs": in_xacro(
        '<xacro:property name="height" value="0.4"/>\n<link name="a"/><link name="b"/>\n<joint name="j" type="fixed">'
        '<parent link="a"/><child link="b"/><origin xyz="0 0 @@"/></joint>',
        "height",
        "${height}",
        "XAC010",
    ),
    "an angle has the braces of an expression": in_xacro(
        '<link name="a"/><link name="b"/>\n<joint name="j" type="fixed"><parent link="a"/><child link="b"/>'
        '<origin rpy="@@ 0 0"/></joint>',
        "{pi/2}",
        "${pi/2}",
        "XAC010",
    ),
    "a block calls a macro by the namespace of its own file": in_xacro(
        '<xacro:include filename="part.xacro" ns="P"/>\n<xacro:property name="parts">\n<xacro:@@ p="x"/>\n'
        "</xacro:property>\n<xacro:P.all/>",
        "P.part",
        "part",
        "XAC003",
    )._replace(
        files={
            "part.xacro": f"<robot{XACRO}>{PART}"
            '<xacro:macro name="all"><xacro:insert_block name="parts"/></xacro:macro></robot>'
        }
    ),
    "MoveIt plans for an arm that is only to be seen": beside(
        "GEO008",
        robot(SEMANTICS, '<disable_collisions link1="base" link2="upper" reason="Adjacent"/>'),
        "<disable",
        "",
        f"<collision>{BOX}</collision>",
        {
            "bot.urdf": robot(ARM, FINGER)
            .replace(f"<collision>{BOX}</collision>", "@@")
            .replace(f"<collision>{ROD}</collision>", "")
        },
    ),
    "a solver is set for the hull of a drone": beside(
        "SRD020",
        robot(
            '<virtual_joint name="fly" type="floating" parent_frame="map" child_link="stand"/>\n'
            '<group name="hull"><link name="stand"/></group>\n<group name="arm"><joint name="shoulder"/></group>'
        ),
        'group name="hull"',
        "hull",
        "arm",
        {
            "bot.urdf": robot(ARM),
            "kinematics.yaml": "@@:\n  kinematics_solver: kdl_kinematics_plugin/KDLKinematicsPlugin\n",
        },
    ),
    "all joints of an arm but the last have no effort": Problem(
        "JNT016",
        robot(
            f'<link name="stand"/>\n<link name="link_0">{BODY}</link>\n'
            '<joint name="foot" type="fixed"><parent link="stand"/><child link="link_0"/></joint>\n',
            *(
                f'<link name="link_{each}">{BODY}</link>\n<joint name="joint_{each}" type="revolute">'
                f'<parent link="link_{each - 1}"/><child link="link_{each}"/><origin xyz="0 0 0.15"/>\n'
                f'<axis xyz="0 1 0"/><limit lower="-1" upper="1" {numbers}/></joint>\n'
                for each, numbers in enumerate(("@@", "@@", 'effort="90" velocity="2"'), 1)
            ),
        ),
        'effort="0" velocity="0"',
        'effort="90" velocity="2"',
    ),
    "the centers of mass of an arm are given in the world": Problem(
        "INR013", robot(ARM.replace('xyz="0 0 0.2"/><mass', 'xyz="0 0 @@"/><mass')), "1.25", "0.2"
    ),
    "the wheels of a cart turn about the vertical": Problem(
        "GEO013", robot(CART.replace('<axis xyz="0 1 0"/>', '<axis xyz="0 @@"/>'), DRIVE), "0 1", "1 0"
    ),
    "a model is placed by a shelf that is in the world": Problem(
        "FRM009",
        model("<pose@@>0 0 1 0 0 0</pose>", f'<link name="l">{SDF_BODY}</link>'),
        ' relative_to="shelf"',
        "",
        suffix=".sdf",
    ),
    "the link of a sensor of forces has no mass": Problem(
        "URD014",
        robot(
            ARM,
            '<link name="wrist">@@</link>\n<joint name="ft" type="fixed"><parent link="upper"/><child link="wrist"/>'
            '<origin xyz="0 0 0.4"/></joint>\n<gazebo reference="ft"><preserveFixedJoint>true</preserveFixedJoint>'
            "<provideFeedback>true</provideFeedback></gazebo>\n"
            '<gazebo><plugin name="forces" filename="libgazebo_ros_ft_sensor.so"><joint_name>ft</joint_name>'
            "</plugin></gazebo>",
        ),
        "",
        MASS.replace('"1"', '"0.1"').replace("0.01", "0.0001"),
    ),
    "a link is held by two joints of which Gazebo makes one": Problem(
        "JNT007",
        model(
            *(
                f'<link name="{name}"><pose>0 {y} 0 0 0 0</pose>{SDF_BODY}</link>\n'
                for name, y in (("l", 0), ("m", 0.5), ("n", 1))
            ),
            '<joint name="i" type="fixed"><parent>l</parent><child>m</child></joint>\n'
            '<joint name="j" type="ball"><parent>m</parent><child>n</child></joint>\n@@',
        ),
        '<joint name="k" type="fixed"><parent>l</parent><child>n</child></joint>',
        "",
        suffix=".sdf",
    ),
    "the last of the fingers follows and is commanded": Problem(
        "R2C015",
        robot(
            ARM,
            FINGER,
            FINGER.replace('"finger"', '"thumb"')
            .replace('"grip"', '"press"')
            .replace("0 0 0.4", "0 0.1 0.4")
            .replace("</joint>", '<mimic joint="grip"/></joint>'),
            STATE.format("command", "position", "", "command", "").replace(
                "</ros2_control>",
                '<joint name="grip"><command_interface name="position"/><state_interface name="position"/></joint>\n'
                '<joint name="press">@@<state_interface name="position"/></joint>\n</ros2_control>',
            ),
            CONTROLLED,
        ),
        '<command_interface name="position"/>',
        "",
    ),
    # Of names and tags that are misspelled, macros without what they take, and shapes that lie across others
    "the attribute with the name of a link is misspelled": Problem(
        "URD002", robot(ARM.replace('<link name="upper">', '<link @@="upper">')), "nmae", "name"
    ),
    "a joint is closed as if it were a link": Problem(
        "XML001", robot(f"{ARM[:-9]}@@\n"), "</link>", "</joint>"
    ),
    "a line of a comment ends with a colon": Problem(
        "URD015", robot("<!-- All others are mounted on it@@\n wheels and caster -->\n", CART), ":", ","
    ),
    "a macro is included and never called": in_xacro(
        '<xacro:include filename="part.xacro"/>\n@@', "", '<xacro:part p="x"/>', "XAC022"
    )._replace(
        below=-2,
        files={
            "part.xacro": f"<robot{XACRO}>{PART}</robot>",
            "view.launch": '<launch><param name="robot_description" command="xacro bot.urdf.xacro"/></launch>',
        },
    ),
    "the text of an argument is compared without quotes": in_xacro(
        '<xacro:arg name="tool" default="none"/>\n<link name="a"/>\n<xacro:if value="${@@ == \'none\'}">'
        '<link name="b"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint></xacro:if>',
        "$(arg tool)",
        "'$(arg tool)'",
        "XAC004",
    ),
    "a macro takes a place that its caller does not give": in_xacro(
        '<xacro:macro name="arm" params="p *origin"><link name="${p}"/><joint name="${p}_joint" type="fixed">'
        '<parent link="a"/><child link="${p}"/><xacro:insert_block name="origin"/></joint></xacro:macro>\n'
        '<link name="a"/>\n<xacro:arm p="b">@@</xacro:arm>',
        "",
        '<origin xyz="0 0 1"/>',
        "XAC008",
    ),
    "a joint of a macro lacks the prefix of two arms": in_xacro(
        '<xacro:macro name="arm" params="p"><link name="${p}base"/>\n<joint name="@@world_joint" type="fixed">'
        '<parent link="a"/><child link="${p}base"/></joint></xacro:macro>\n'
        '<link name="a"/><xacro:arm p="left_"/><xacro:arm p="right_"/>',
        "",
        "${p}",
        "NAM001",
    ),
    "the frame of a camera is in quotation marks": Problem(
        "GAZ012",
        robot(
            CART,
            DRIVE,
            '<gazebo reference="body"><sensor name="s" type="camera"><topic>s</topic><camera>\n'
            "<optical_frame_id>@@</optical_frame_id><horizontal_fov>1</horizontal_fov><image><width>640</width>"
            "<height>480</height></image></camera></sensor></gazebo>",
        ),
        '"body"',
        "body",
    ),
    "a car takes the radius of a wheel that has none": Problem(
        "GEO012",
        robot(
            WAGON[::-1].replace(f"<collision>{RIM}"[::-1], "\n<collision>@@"[::-1], 1)[::-1],
            '<gazebo><plugin filename="libgazebo_ros_ackermann_drive.so" name="drive">',
            *(
                f"<{name}>{joint}</{name}>"
                for name, joint in (
                    ("front_left_joint", "front_left_joint"),
                    ("front_right_joint", "front_right_joint"),
                    ("rear_left_joint", "left_joint"),
                    ("rear_right_joint", "right_joint"),
                )
            ),
            "</plugin></gazebo>",
        ),
        '<geometry><box size="0.14 0.05 0.14"/></geometry>',
        RIM,
    ),
    "the base of a cart is not between its wheels": Problem(
        "GAZ020",
        robot(CART.replace('xyz="0 0.15', 'xyz="@@ 0.15').replace('xyz="0 -0.15', 'xyz="@@ -0.15'), DRIVE),
        "-0.05",
        "0",
        below=11,
    ),
    "a drive has the joints of skid steering": Problem(
        "RES019",
        robot(
            CART,
            '<gazebo><plugin filename="libgazebo_ros_diff_drive.so" name="drive">\n@@\n'
            "<wheelSeparation>0.3</wheelSeparation><wheelDiameter>0.14</wheelDiameter></plugin></gazebo>",
        ),
        "<leftFrontJoint>left_joint</leftFrontJoint><rightFrontJoint>right_joint</rightFrontJoint>",
        "<leftJoint>left_joint</leftJoint><rightJoint>right_joint</rightJoint>",
    ),
    "a mesh for the looks lies across its collision": Problem(
        "GEO003",
        robot(
            ARM.replace(
                f"<visual>{ROD}</visual>\n",
                '<visual><origin rpy="0 @@ 0"/><geometry><mesh filename="package://pathfinder/a.obj"/></geometry>'
                "</visual>",
            )
        ),
        "0",
        "-1.5708",
        files={
            "package.xml": DESCRIBED["package.xml"],
            "a.obj": "v 0 -0.04 -0.04\nv 0.4 0.04 0.04\nv 0.4 0 0\nf 1 2 3\n",
        },
    ),
    "a sensor for Gazebo is in a link": Problem(
        "URD001",
        robot(ARM.replace('<link name="upper">\n', '<link name="upper">\n@@\n')),
        '<sensor name="s" type="ray"><update_rate>10</update_rate></sensor>',
        "",
    ),
    "the noise of a lidar is beside it": Problem(
        "SCH003",
        robot(
            CART,
            DRIVE,
            f'<gazebo reference="body"><sensor name="s" type="gpu_lidar"><topic>s</topic><lidar>{SCAN}</lidar>\n@@\n'
            "</sensor></gazebo>",
        ),
        "<noise><type>gaussian</type><stddev>0.01</stddev></noise>",
        "",
    ),
    "the moments of a palm are those of a ball of half a meter": Problem(
        "INR006",
        robot(
            ARM,
            '<link name="palm"><inertial><mass value="0.1"/>\n<inertia ixx="@@" iyy="@@" izz="@@" ixy="0" ixz="0"'
            ' iyz="0"/></inertial><visual><geometry><box size="0.08 0.08 0.03"/></geometry></visual><collision>'
            '<geometry><box size="0.08 0.08 0.03"/></geometry></collision></link>\n<joint name="wrist" type="revolute">'
            '<parent link="upper"/><child link="palm"/><origin xyz="0 0 0.41"/><axis xyz="0 0 1"/>'
            '<limit lower="-1" upper="1" effort="5" velocity="1"/></joint>',
        ),
        "0.01",
        "0.00008",
    ),
    "an arm is driven by effort, and its safety controller allows none": Problem(
        "JNT025",
        robot(
            ARM.replace(
                'velocity="2"/>\n',
                'velocity="2"/>\n<safety_controller k_velocity="@@" soft_lower_limit="-0.9" soft_upper_limit="0.9"/>\n',
            ),
            DRIVEN.replace('<state_interface name="position"/>', '<state_interface name="velocity"/>'),
            CONTROLLED,
        ),
        "0",
        "5",
    ),
    "MoveIt plans in a frame with a slash": semantic(
        '<virtual_joint name="v" type="planar" parent_frame="@@" child_link="stand"/>',
        "/odom",
        "odom",
        "URD021",
    ),
    "the center of mass of a rod is on the other side of its joint": Problem(
        "INR013",
        robot(ARM.replace('<inertial><origin xyz="0 0 0.2"/>', '<inertial><origin xyz="0 0 @@"/>')),
        "-0.2",
        "0.2",
    ),
    "a world asks for an engine that Gazebo does not have": Problem(
        "RES027",
        world(
            '<plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics">\n'
            "<engine><filename>@@</filename></engine></plugin>\n",
            COMMANDED,
            '<plugin filename="gz-sim-scene-broadcaster-system" name="gz::sim::systems::SceneBroadcaster"/>',
        ),
        "gz-physics-ode-plugin",
        "gz-physics-tpe-plugin",
        suffix=".sdf",
    ),
    "a drive does not turn to the right": Problem(
        "RES027",
        robot(CART, DRIVE.replace("</plugin>", "<min_velocity>@@</min_velocity>\n</plugin>")),
        "0",
        "-1",
    ),
    "a list is written as a text": in_xacro(
        '<xacro:property name="some" value="@@"/>\n<xacro:include filename="part.xacro"/>\n'
        '<xacro:if value="${2 in some}"><xacro:part p="a"/></xacro:if>',
        "[1, 2]",
        "${[1, 2]}",
        "XAC001",
    )._replace(below=2),
    "a block is inserted without the prefix of xacro": in_xacro(
        '<link name="a"/><link name="b"/><xacro:macro name="tie" params="*place">\n'
        '<joint name="j" type="fixed"><@@ name="place"/><parent link="a"/><child link="b"/></joint>\n'
        '</xacro:macro><xacro:tie><origin xyz="0 0 1"/></xacro:tie>',
        "insert_block",
        "xacro:insert_block",
        "XAC012",
    ),
    "a property is defined by itself": in_xacro(
        '<xacro:arg name="name" default="a"/>\n<xacro:property name="name" value="@@"/>\n<link name="${name}"/>',
        "${name}",
        "$(arg name)",
        "XAC001",
    ),
    "a property begins with two underscores": in_xacro(
        '<xacro:property name="@@name" value="a"/>\n<link name="${@@name}"/>', "__", "", "XAC001"
    ),
    "the numbers of a pose have decimal commas": Problem(
        "SCH012",
        model(
            f'<pose>@@ 0 0 0</pose>\n<static>true</static>\n<link name="a"><visual name="v">{BALL}</visual></link>'
        ),
        "-0,17 0,26 0,12",
        "-0.17 0.26 0.12",
        suffix=".sdf",
    ),
    "the ends of a joint are beside its limit": Problem(
        "SCH003",
        model(
            '<link name="a"/>\n<link name="b"/>\n<joint name="j" type="revolute"><parent>a</parent><child>b</child>\n'
            "<axis><xyz>0 0 1</xyz><limit><effort>5</effort><velocity>1</velocity></limit>\n@@\n</axis></joint>"
        ),
        "<lower>0</lower><upper>2</upper>",
        "",
        suffix=".sdf",
    ),
    "a model is placed by its own name": Problem(
        "FRM004",
        model('<link name="a"/>').replace('name="m"', 'name="m" placement_frame="@@"'),
        "m",
        "a",
        suffix=".sdf",
    ),
    "the plugin of a lidar is beside its sensor": Problem(
        "RES026",
        robot(
            CART,
            f'<gazebo reference="body"><sensor name="s" type="ray"><ray>{SCAN}</ray></sensor></gazebo>\n@@',
        ),
        '<gazebo><plugin name="p" filename="libgazebo_ros_ray_sensor.so"><ros/></plugin></gazebo>',
        "",
    ),
    "two collisions of a table have one name": Problem(
        "NAM001",
        model(
            f'<static>true</static>\n<link name="a">\n<collision name="top">{BALL}</collision>\n'
            f'<collision name="@@">{BALL}</collision>\n</link>'
        ),
        "top",
        "leg",
        suffix=".sdf",
    ),
}


def findings(path: Path) -> list[tuple[str, int]]:
    found = sdfcheck.as_json(sdfcheck.lint([path], isolated=True))["diagnostics"]
    return [
        (each["code"], each["range"]["start"]["line"])
        for each in found
        if Path(each["file"]) == path and each["severity"] != "info"
    ]


@pytest.mark.parametrize("name", PROBLEMS)
def test_problem(name: str, tmp_path: Path) -> None:
    problem = PROBLEMS[name]
    assert findings(problem.write(tmp_path, problem.right)) == []
    assert (problem.code, problem.line) in findings(problem.write(tmp_path, problem.wrong))


@pytest.mark.parametrize("name", ["a sensor whose topic is bridged has none", "a controller has no type"])
def test_problem_of_a_relative_path(name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    problem = PROBLEMS[name]
    problem.write(tmp_path, problem.wrong)
    monkeypatch.chdir(tmp_path)
    assert (problem.code, problem.line) in findings(Path(f"bot{problem.suffix}"))
