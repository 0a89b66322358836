"""Links that the conversion from URDF merges, and parts that URDF alone has, come back."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.file_difference import compare_files
from sdfcheck.convert.loss import LossKind
from sdfcheck.convert.result import Conversion
from sdfcheck.convert.sdf_to_urdf import convert
from sdfcheck.convert.sdf_to_urdf.plan import Options as SdfToUrdf
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Options
from sdfcheck.source.document import Document, read
from sdfcheck.source.sniff import Kind

INERTIAL = '<inertial><mass value="{}"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
BODY = INERTIAL.format(1)
ENDS = '<parent link="{}"/><child link="{}"/><origin xyz="0.1 0 0.2" rpy="0 0.5 0"/>'
TOOL = f"""<robot name="r">
<link name="base">{BODY}</link>
<link name="tool"><visual name="v"><origin xyz="0 0 1"/><geometry><box size="1 1 1"/></geometry></visual></link>
<link name="tip"/><link name="finger">{BODY}</link>
<joint name="to_tool" type="fixed">{ENDS.format("base", "tool")}</joint>
<joint name="to_tip" type="fixed">{ENDS.format("tool", "tip")}</joint>
<joint name="j" type="continuous">{ENDS.format("tip", "finger")}<axis xyz="0 0 1"/></joint>
<gazebo reference="tip"><sensor name="s" type="imu"><pose>0 1 0 0 0 0</pose></sensor></gazebo>
<gazebo><plugin name="p" filename="f"><bodyName>tip</bodyName><rpyOffset>0 0 1</rpyOffset></plugin></gazebo>
</robot>"""
HEAVY = TOOL.replace('<link name="tip"/>', f'<link name="tip">{INERTIAL.format(2)}</link>')


def there(urdf: str, *, merge: bool = False) -> str:
    options = Options(fixed_joints=FixedJoints.MERGE if merge else FixedJoints.KEEP)
    return urdf_to_sdf(document(urdf, "robot.urdf"), options).text


def back(sdf: str) -> Conversion:
    done = convert(document(sdf, "robot.sdf"))
    assert done.verification is not None
    assert done.verification.is_equal
    return done


def document(text: str, name: str) -> Document:
    return read(text.encode(), Path(name))


def changes(before: str, after: str) -> list[str]:
    found = compare_files(document(before, "before.urdf"), document(after, "after.urdf"))
    return [f"{one.name} {one.what} {one.after}" for _, group in found.changes for one in group]


@pytest.mark.parametrize("urdf", [TOOL, HEAVY])
@pytest.mark.parametrize("merge", [False, True])
def test_merged_links_come_back(urdf: str, merge: bool) -> None:
    made = there(urdf, merge=merge)
    assert '<frame name="tip"' in made or not merge
    done = back(made)
    assert not changes(urdf, done.text)
    assert "preserveFixedJoint" not in done.text or not merge
    assert LossKind.UNACCOUNTED_ITEM not in {loss.kind for loss in done.losses}


def test_a_sum_that_was_changed_keeps_its_links_together() -> None:
    made = there(HEAVY, merge=True)
    assert made.count("<mass>3</mass>") == 1
    done = back(made.replace("<mass>3</mass>", "<mass>4</mass>"))
    assert '<link name="tip">' not in done.text
    assert 'mass value="4"' in done.text


def test_a_frame_whose_joint_is_gone_stays_a_frame() -> None:
    made = there(TOOL).replace('urdf:joint="to_tip"', 'urdf:joint="other"')
    assert '<frame name="tip"' in back(made).text


MARK = 'urdf:joint="to_tip"'
CHANGES = [
    (MARK, 'urdf:joint=""'),
    (MARK, 'urdf:joint="tip"'),
    ('urdf:parent="tool"', 'urdf:parent="tip"'),
    ('urdf:parent="tool"', 'urdf:parent="gone"'),
    ('<frame name="tip"', '<frame name="to_tip"'),
    ('<frame name="tip"', "<frame"),
    ('<frame name="to_tip"', "<frame"),
    ('attached_to="base" urdf', 'attached_to="finger" urdf'),
    ("<urdf:inertial>", "<urdf:inertial><mass/>"),
    ("<urdf:inertial>", "<urdf:inertial><pose>0 0 nan 0 0 0</pose>"),
    ("</model>", '<model name="n"><link name="base"/></model></model>'),
]


@pytest.mark.parametrize(("before", "after"), CHANGES)
def test_marks_that_were_changed_count_as_far_as_they_are_known(before: str, after: str) -> None:
    made = there(HEAVY, merge=True)
    assert before in made
    done = convert(document(made.replace(before, after), "robot.sdf"))
    assert '<link name="finger">' in done.text
    assert done.verification is not None
    assert done.verification.is_equal


def test_a_model_beside_has_names_of_its_own() -> None:
    made = there(HEAVY, merge=True)
    start, end = made.index("<model"), made.index("</model>") + len("</model>")
    other = made[start:end].replace('<model name="r"', '<model name="other"')
    for beside in (other, '<model name="other"><link name="base"/></model>'):
        done = convert(document(made[:end] + beside + made[end:], "robot.sdf"), SdfToUrdf(model="r"))
        assert not changes(HEAVY, done.text)


OWN = f"""<robot name="r">
<link name="base">{BODY}</link><link name="arm">{BODY}
<visual name="v"><geometry><mesh filename="package://p/a.stl"/></geometry></visual></link>
<joint name="j" type="revolute">{ENDS.format("base", "arm")}<axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="5" velocity="2" acceleration="9"/>
<safety_controller k_velocity="10" k_position="15" soft_lower_limit="-0.9" soft_upper_limit="0.9"/>
<calibration rising="0.1"/></joint>
<transmission name="t"><type>x</type><joint name="j"/><actuator name="a"/></transmission>
<ros2_control name="c" type="system"><joint name="j"/></ros2_control>
<mujoco><compiler meshdir="m" note=""/></mujoco>
</robot>"""


def test_parts_that_urdf_alone_has_come_back_as_themselves() -> None:
    done = back(there(OWN))
    assert not changes(OWN, done.text)
    for part in (
        'acceleration="9"',
        "<safety_controller k_v",
        "<calibration r",
        "<mujoco>",
        "<ros2_control name",
    ):
        assert part in done.text
    assert '<compiler meshdir="m" note=""/>' in done.text
    assert "urdf:" not in done.text
    assert 'filename="package://p/a.stl"' in done.text


def test_other_models_stay_models() -> None:
    other = there(OWN).replace('urdf:packages="p"', 'urdf:packages="q"')
    assert "model://p/a.stl" in back(other).text


def test_marks_are_only_where_frames_are() -> None:
    from sdfcheck.formats.version import Version

    old = urdf_to_sdf(document(HEAVY, "robot.urdf"), Options(Version(1, 6), FixedJoints.MERGE))
    assert "urdf:" not in old.text
    assert document(old.text, "old.sdf").kind is Kind.SDF


def test_an_inertial_in_the_wrong_place_is_no_mark() -> None:
    urdf = TOOL.replace("</robot>", f"{INERTIAL.format(7)}</robot>")
    done = back(there(urdf))
    assert 'mass value="7"' in done.text
    assert not changes(urdf, done.text)
