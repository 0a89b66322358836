"""Names in the content of ``<gazebo>`` blocks lead to what the result calls them."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.result import Conversion
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Options
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind

_MASS = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
_BOX = '<geometry><box size="1 1 1"/></geometry>'


def converted(content: str, options: Options | None = None) -> Conversion:
    text = f'<robot name="r">{content}</robot>'
    return urdf_to_sdf(read(text.encode(), Path("r.urdf"), Kind.URDF), options or Options())


def contact(link: str, collision: str) -> str:
    sensor = f'<sensor name="s" type="contact"><contact><collision>{collision}</collision></contact></sensor>'
    return f'<gazebo reference="{link}">{sensor}</gazebo>'


@pytest.mark.parametrize(
    ("collisions", "named", "written"),
    [
        ('<collision name="sole">', "foot_fixed_joint_lump__sole_collision", "sole"),
        ("<collision>", "foot_collision", "foot_collision"),
        (f"<collision>{_BOX}</collision><collision>", "foot_collision_1", "foot_collision_1"),
        (f'<collision name="a">{_BOX}</collision><collision name="b">',
         "foot_fixed_joint_lump__b_collision_1", "b"),
        ('<collision name="sole">', "sole", "sole"),
    ],
)  # fmt: skip
def test_contact_sensors_find_their_collision(collisions: str, named: str, written: str) -> None:
    link = f'<link name="foot">{_MASS}{collisions}{_BOX}</collision></link>'
    text = converted(link + contact("foot", named)).text
    assert f"<collision>{written}</collision>" in text
    assert f'<collision name="{written}">' in text


def test_a_collision_of_another_link_is_reported() -> None:
    links = f'<link name="leg">{_MASS}</link><link name="foot">{_MASS}<collision>{_BOX}</collision></link>'
    joint = '<joint name="j" type="fixed"><parent link="leg"/><child link="foot"/></joint>'
    sensor = contact("leg", "leg_fixed_joint_lump__foot_collision")
    done = converted(links + joint + sensor)
    assert [loss.message for loss in done.losses] == [
        "sensor `s` gets no contacts: collision `foot_collision` is in link `foot`"
    ]
    merged = converted(links + joint + sensor, Options(fixed_joints=FixedJoints.MERGE))
    assert "<collision>foot_collision</collision>" in merged.text


def test_plugins_of_a_merged_link_get_its_offset() -> None:
    links = f'<link name="base">{_MASS}</link><link name="imu"/>'
    joint = (
        '<joint name="j" type="fixed"><parent link="base"/><child link="imu"/>'
        '<origin xyz="1 0 0" rpy="0 0 1.5707963267948966"/></joint>'
    )
    plugin = '<plugin name="p" filename="p.so"><bodyName>imu</bodyName><xyzOffset>0 2 0</xyzOffset></plugin>'
    done = converted(f"{links}{joint}<gazebo>{plugin}</gazebo>")
    assert '<bodyName urdf:was="imu">base</bodyName>' in done.text
    assert '<xyzOffset urdf:was="0 2 0">-1 0 0</xyzOffset>' in done.text
    assert '<rpyOffset urdf:was="none">0 0 1.5707963267948966</rpyOffset>' in done.text
    assert done.verification is not None
    assert done.verification.is_equal, done.verification.differences


@pytest.mark.parametrize("written", ["0 2", "a b c", "", "0 2 nan", "1 2 3 4"])
def test_an_offset_that_is_not_three_numbers_is_reported(written: str) -> None:
    links = f'<link name="base">{_MASS}</link><link name="imu"/>'
    joint = '<joint name="j" type="fixed"><parent link="base"/><child link="imu"/>{}</joint>'
    plugin = (
        f'<plugin name="p" filename="p.so"><bodyName>imu</bodyName><rpyOffset>{written}</rpyOffset></plugin>'
    )
    moved = converted(links + joint.format('<origin xyz="1 0 0"/>') + f"<gazebo>{plugin}</gazebo>")
    message = (
        "<rpyOffset> of plugin `p` is not three numbers and stays as it is, "
        "but the link that it is measured from was merged"
    )
    assert message in {loss.message for loss in moved.losses if loss.severity is Severity.WARNING}
    assert "xyzOffset" not in moved.text
    at_its_place = converted(links + joint.format("") + f"<gazebo>{plugin}</gazebo>")
    assert not [loss for loss in at_its_place.losses if "Offset" in loss.message]


def test_the_frame_of_a_plugin_in_a_sensor_stays() -> None:
    """libsdformat rewrites such names in plugins of the model alone; programs look for the frame in ROS."""
    links = f'<link name="base">{_MASS}</link><link name="eye"/>'
    joint = (
        '<joint name="j" type="fixed"><parent link="base"/><child link="eye"/><origin xyz="1 0 0"/></joint>'
    )
    plugin = '<plugin name="p" filename="p.so"><frameName>eye</frameName></plugin>'
    sensor = f'<gazebo reference="eye"><sensor name="s" type="camera">{plugin}</sensor></gazebo>'
    done = converted(links + joint + sensor)
    assert "<frameName>eye</frameName>" in done.text
    assert "xyzOffset" not in done.text
    assert done.verification is not None
    assert done.verification.is_equal, done.verification.differences
