"""Pieces of robots for the examples of this family."""

from __future__ import annotations

import math

ARM = (
    '<robot name="r"><link name="base"><visual><geometry><box size="0.2 0.2 0.1"/></geometry></visual></link>'
    '<link name="arm">{}</link><joint name="j" type="revolute"><origin xyz="0 0 0.3"/><parent link="base"/>'
    '<child link="arm"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>'
)
"""A robot of two links whose joint is 0.3 m up; for the content of the second link."""


def wedge(length: float) -> str:
    """An OBJ file with one triangle of this length along x, a tenth along y and z."""
    side = length / 10
    return f"v 0 0 0\nv {length} 0 0\nv 0 {side} {side}\nf 1 2 3\n"


def triangles(count: int) -> str:
    """A COLLADA file that has so many triangles, as far as its header goes."""
    return (
        '<COLLADA><library_geometries><geometry id="g"><mesh><source id="p">'
        "<float_array>0 0 0 1 0 0 0 1 1</float_array></source>"
        '<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>'
        f'<triangles count="{count}"/></mesh></geometry></library_geometries></COLLADA>'
    )


def mesh(kind: str, file: str, attributes: str = "") -> str:
    """A visual or collision with a mesh in URDF."""
    return f'<{kind}><geometry><mesh filename="{file}"{attributes}/></geometry></{kind}>'


def rover(
    *,
    left: str = "left",
    y: float = 0.17,
    axis: str = "0 1 0",
    radius: str = "0.1",
    beyond: float = 0.0,
    **parameters: str,
) -> str:
    """A robot with two wheels in URDF, and the plugin that drives them: the numbers are those of the right wheel.

    The shapes of both are ``beyond`` (m) their joints.
    """
    sides = (("left", 0.17, "0 1 0", "0.1"), ("right", -y, axis, radius))
    wheels = "".join(
        f'<link name="{side}"><collision><origin xyz="0 {math.copysign(beyond, at)} 0" rpy="1.5708 0 0"/>'
        f'<geometry><cylinder radius="{size}" length="0.04"/>'
        f'</geometry></collision></link><joint name="{side}_joint" type="continuous"><origin xyz="0 {at} 0"/>'
        f'<parent link="base"/><child link="{side}"/><axis xyz="{turns}"/></joint>'
        for side, at, turns, size in sides
    )
    right = "right" if "left" in left else "left"
    given = "".join(f"<{name}>{value}</{name}>" for name, value in parameters.items())
    plugin = (
        '<plugin filename="gz-sim-diff-drive-system" name="gz::sim::systems::DiffDrive">'
        f"<left_joint>{left}_joint</left_joint><right_joint>{right}_joint</right_joint>{given}</plugin>"
    )
    return f'<robot name="r"><link name="base"/>{wheels}<gazebo>{plugin}</gazebo></robot>'


def car(*, base: str) -> str:
    """A robot with four wheels in URDF, whose axles are 0.5 m apart, and the plugin of a mecanum drive."""
    wheels, names = "", ""
    for end, x in (("front", 0.25), ("back", -0.25)):
        for side, y in (("left", 0.2), ("right", -0.2)):
            wheel = f"{end}_{side}_joint"
            wheels += (
                f'<link name="{end}_{side}"/><joint name="{wheel}" type="continuous"><origin xyz="{x} {y} 0"/>'
                f'<parent link="base"/><child link="{end}_{side}"/><axis xyz="0 1 0"/></joint>'
            )
            names += f"<{wheel}>{wheel}</{wheel}>"
    plugin = (
        '<plugin filename="gz-sim-mecanum-drive-system" name="gz::sim::systems::MecanumDrive">'
        f"{names}<wheelbase>{base}</wheelbase><wheel_separation>0.4</wheel_separation></plugin>"
    )
    return f'<robot name="r"><link name="base"/>{wheels}<gazebo>{plugin}</gazebo></robot>'


def controlled(robot: str, mark: str = "parameters") -> str:
    """A robot whose drive is a controller of ros2_control, as ``controllers`` writes it, instead of a plugin."""
    head, _, _ = robot.partition("<gazebo>")
    joints = "".join(
        f'<joint name="{side}_joint"><command_interface name="velocity"/><state_interface name="position"/></joint>'
        for side in ("left", "right")
    )
    return (
        f'{head}<ros2_control name="c" type="system"><hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin>'
        f"</hardware>{joints}</ros2_control><gazebo>"
        f'<plugin filename="gz_ros2_control-system" '
        f'name="gz_ros2_control::GazeboSimROS2ControlPlugin"><{mark}>c.yaml</parameters></plugin></gazebo></robot>'
    )


def controllers(*, left: str = "left", right: str = "right", **parameters: str) -> dict[str, str]:
    """The file of a controller for a robot with two wheels."""
    parameters = {"wheel_separation": "0.34", "wheel_radius": "0.1", **parameters}
    given = "".join(f", {name}: {value}" for name, value in parameters.items())
    return {
        "c.yaml": "drive: {ros__parameters: {type: diff_drive_controller/DiffDriveController, "
        f"left_wheel_names: [{left}_joint], right_wheel_names: [{right}_joint]{given}}}}}\n"
    }
