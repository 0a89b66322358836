from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.comparison import Verification
from sdfcheck.convert.loss import LossKind, NotConvertible
from sdfcheck.convert.result import Comparison, Conversion
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Massless, Options
from sdfcheck.convert.urdf_to_sdf.plan import legal
from sdfcheck.formats.version import Version
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind

MASS = '<inertial><mass value="2"/><inertia ixx=".1" ixy="0" ixz="0" iyy=".1" iyz="0" izz=".1"/></inertial>'
ARM = f"""<robot name="arm">
  <link name="base">{MASS}</link>
  <link name="rod">{MASS}<visual><origin xyz="0 0 0.25"/><geometry><sphere radius="0.125"/></geometry></visual></link>
  <link name="tip">{MASS}</link>
  <joint name="swing" type="revolute"><parent link="base"/><child link="rod"/><origin xyz="0 0 0.75"/>
    <axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="5" velocity="3"/></joint>
  <joint name="weld" type="fixed"><parent link="rod"/><child link="tip"/><origin xyz="0 0 0.5"/></joint>
</robot>"""

TIE = '<joint name="{}" type="fixed"><parent link="a"/><child link="b"/></joint>'


def convert(text: str, options: Options | None = None) -> Conversion:
    return urdf_to_sdf(read(text.encode(), Path("arm.urdf"), Kind.URDF), options or Options())


def kinds(done: Conversion) -> list[LossKind]:
    return [loss.kind for loss in done.losses]


@pytest.mark.parametrize("version", [Version(1, minor) for minor in range(4, 13)], ids=str)
@pytest.mark.parametrize("fixed", list(FixedJoints))
def test_every_version_holds_the_same_robot(version: Version, fixed: FixedJoints) -> None:
    done = convert(ARM, Options(version, fixed))
    assert done.verification is not None
    assert done.verification.is_equal, done.verification.differences
    assert done.verification.links == 3


@pytest.mark.parametrize(
    ("written", "other"),
    [
        ("0 0 0.75 0 0 0", "0 0 0.76 0 0 0"),
        ("<xyz>0 1 0</xyz>", "<xyz>0 -1 0</xyz>"),
        ("<mass>2</mass>", "<mass>2.1</mass>"),
        ("<ixx>.1</ixx>", "<ixx>.2</ixx>"),
        ("<upper>1</upper>", "<upper>1.5</upper>"),
        ("<radius>0.125</radius>", "<radius>0.126</radius>"),
        ("0 0 0.25 0 0 0", "0 0 0.26 0 0 0"),
    ],
)
def test_one_changed_number_is_noticed(written: str, other: str) -> None:
    done = convert(ARM)
    assert written in done.text
    assert not verified(done, done.text.replace(written, other, 1)).is_equal


@pytest.mark.parametrize("version", [Version(1, 4), Version(1, 5), Version(1, 7)], ids=str)
def test_axes_of_turned_joints_stay(version: Version) -> None:
    done = convert(ARM.replace('xyz="0 0 0.75"', 'xyz="0 0 0.75" rpy="0.3 0.2 1.1"'), Options(version))
    assert done.verification is not None
    assert done.verification.is_equal, done.verification.differences


def verified(done: Conversion, text: str) -> Verification:
    """The verification of another text in the place of the conversion's."""
    before = done.comparisons[0]
    result = mechanism_of(root_of(read(text.encode(), Path("arm.sdf"), Kind.SDF)).models[0])
    return Comparison(before.source, result, before.correspondence).verify()


def test_a_text_that_is_not_a_number_is_not_equal_to_one() -> None:
    done = convert(ARM)
    robot = done.comparisons[0].source
    for pose in (robot.links["rod"].pose, robot.joints["swing"].pose):
        pose[0, 3] = float("nan")
    assert not Comparison(robot, robot, done.comparisons[0].correspondence).verify().is_equal


def test_links_are_weighed_one_by_one() -> None:
    done = convert(ARM.replace(MASS, MASS.replace("2", "3"), 1))
    # Rod and tip are welded: what goes from one to the other changes no total.
    moved = done.text.replace("<mass>2</mass>", "<mass>1</mass>", 1)
    differences = verified(done, moved).differences
    assert ("mass", "rod") in {(one.what, one.name) for one in differences}
    split = done.text.replace("<ixx>.1</ixx>", "<ixx>.15</ixx>", 2).replace(
        "<ixx>.15</ixx>", "<ixx>.05</ixx>", 1
    )
    assert {one.name for one in verified(done, split).differences if one.what == "inertia"} >= {"base", "rod"}


def test_a_merged_link_weighs_what_its_parts_do() -> None:
    done = convert(ARM, Options(fixed_joints=FixedJoints.MERGE))
    assert "<mass>4</mass>" in done.text
    lighter = verified(done, done.text.replace("<mass>4</mass>", "<mass>2</mass>"))
    assert ("mass", "rod") in {(one.what, one.name) for one in lighter.differences}


def test_a_follower_that_does_not_follow_is_noticed() -> None:
    follower = """<joint name="echo" type="continuous"><parent link="tip"/><child link="end"/>
      <mimic joint="swing"/></joint></robot>"""
    done = convert(ARM.replace("</robot>", f'<link name="end">{MASS}</link>{follower}'))
    assert verified(done, done.text).is_equal
    start, end = done.text.index("<mimic"), done.text.index("</mimic>") + len("</mimic>")
    differences = verified(done, done.text[:start] + done.text[end:]).differences
    assert [(one.what, one.name) for one in differences] == [("joint", "echo")]


def test_a_clean_robot_loses_nothing() -> None:
    assert convert(ARM).losses == ()


def test_merging_reports_the_link_and_keeps_its_name() -> None:
    done = convert(ARM, Options(fixed_joints=FixedJoints.MERGE))
    assert kinds(done) == [LossKind.MERGED_LINK]
    assert '<frame name="tip" attached_to="rod"' in done.text


def test_a_link_without_mass_stays() -> None:
    done = convert('<robot name="r"><link name="only"/></robot>')
    assert kinds(done) == [LossKind.MASSLESS_LINK]
    assert '<link name="only">' in done.text
    with pytest.raises(NotConvertible, match="link `only` has no mass"):
        convert('<robot name="r"><link name="only"/></robot>', Options(massless=Massless.REFUSE))


@pytest.mark.parametrize(
    ("body", "reason"),
    [
        ("", "no links"),
        ('<link name="a"/><link name="a"/>', "another link `a`"),
        ("<link/>", "a link has no name"),
        (
            '<link name="a"/><joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>',
            "names link `b`, which does not exist",
        ),
        (
            '<link name="a"/><link name="b"/>' + TIE.format("j") + TIE.format("k"),
            "joint `k` closes a loop",
        ),
        (
            '<link name="a"><inertial><mass value="heavy"/></inertial></link>',
            "'heavy' is not a finite number",
        ),
        ('<link name="a"><inertial><mass value="nan"/></inertial></link>', "'nan' is not a finite number"),
        (
            '<link name="a"/><link name="b"/>'
            + TIE.format("j").replace("<parent", '<origin xyz="0 0 inf"/><parent'),
            "'0 0 inf' is not 3 finite numbers",
        ),
        (
            '<link name="a"/><joint name="j" type="fixed"><parent link="a"/><child link="world"/></joint>',
            "names link `world`, which does not exist",
        ),
        ('<link name="a"><visual><geometry><box/></geometry></visual></link>', "the box has no size"),
    ],
)
def test_a_robot_that_cannot_be_converted_is_refused_with_its_place(body: str, reason: str) -> None:
    with pytest.raises(NotConvertible, match=reason) as caught:
        convert(f'<robot name="r">{body}</robot>')
    assert caught.value.loss.kind is LossKind.NOT_CONVERTIBLE


@pytest.mark.parametrize(
    ("name", "expected"),
    [("a", "a"), ("a::b", "a__b"), ("__x__", "x_"), ("world", "world_"), ("ns/a", "ns/a"), (" a ", "a")],
)
def test_legal_names(name: str, expected: str) -> None:
    assert legal(name) == expected


def test_a_pose_in_degrees_moves_with_its_sensor() -> None:
    block = (
        '<gazebo reference="tip"><sensor name="s" type="imu">'
        '<pose degrees="true">0 0 0 0 0 90</pose></sensor></gazebo></robot>'
    )
    done = convert(ARM.replace("</robot>", block), Options(fixed_joints=FixedJoints.MERGE))
    assert "<pose>0 0 0.5 0 0 1.5707963267948966</pose>" in done.text


def test_line_ends_are_those_of_the_source() -> None:
    assert "\r" not in convert(ARM).text
    done = convert(ARM.replace("\n", "\r\n"))
    assert done.text == convert(ARM).text.replace("\n", "\r\n")


def test_a_link_takes_what_a_joint_of_its_name_cannot_have() -> None:
    robot = ARM.replace('name="weld"', 'name="rod"').replace(
        "</robot>",
        '<gazebo reference="rod"><mu1>1</mu1><sensor name="s" type="imu"/>'
        "<preserveFixedJoint>true</preserveFixedJoint></gazebo></robot>",
    )
    kept = convert(robot, Options(fixed_joints=FixedJoints.MERGE)).text
    assert '<joint name="rod_joint" type="fixed">' in kept
    merged = convert(robot.replace("true<", "false<"), Options(fixed_joints=FixedJoints.MERGE)).text
    assert "fixed" not in merged
    assert all(text.count('<sensor name="s"') == 1 for text in (kept, merged))


@pytest.mark.parametrize(
    "setting",
    [
        "<mu1/>",
        "<mu1>much</mu1>",
        '<kp value="1 2"/>',
        "<fdir1>1 0</fdir1>",
        "<dampingFactor>a</dampingFactor>",
    ],
)
def test_a_setting_that_is_no_number_is_left_out(setting: str) -> None:
    ball = "<collision><geometry><sphere radius='1'/></geometry></collision></link>"
    robot = ARM.replace("</link>", ball, 1).replace(
        "</robot>", f'<gazebo reference="base">{setting}</gazebo></robot>'
    )
    done = convert(robot)
    assert kinds(done) == [LossKind.EXTENSION_NOT_CARRIED]
    assert done.text == convert(ARM.replace("</link>", ball, 1)).text


@pytest.mark.parametrize("color", ["red", "0.5", "1 0 0 1 1"])
def test_a_color_that_is_none_is_left_out_and_reported(color: str) -> None:
    material = f'<material name="paint"><color rgba="{color}"/></material></visual>'
    done = convert(ARM.replace("</visual>", material))
    assert done.text.count("<material>") == 0
    assert LossKind.CHANGED_MATERIAL in kinds(done)


def test_a_block_that_cannot_be_read_as_sdformat_is_refused() -> None:
    block = '<gazebo><link name="extra"><pose>here</pose></link></gazebo></robot>'
    with pytest.raises(NotConvertible, match="cannot be read"):
        convert(ARM.replace("</robot>", block))


def test_a_link_of_a_block_gets_another_name_than_that_of_the_robot() -> None:
    done = convert(ARM.replace("</robot>", '<gazebo><link name="base"/></gazebo></robot>'))
    assert kinds(done) == [LossKind.RENAMED]
    assert done.text.count('<link name="base">') == 1
    assert '<link name="base_2"' in done.text


@pytest.mark.parametrize(
    ("setting", "written"),
    [
        ('<turnGravityOff value="1"/>', "<gravity>false</gravity>"),
        ("<turnGravityOff>1</turnGravityOff>", "<gravity>false</gravity>"),
        ('<dampingFactor value="0.25"/>', "<linear>0.25</linear>"),
        ('<mu1 value="0.25"/>', "<mu>0.25</mu>"),
    ],
)
def test_settings_of_a_link_are_read_from_text_and_attribute(setting: str, written: str) -> None:
    shape = "<collision><geometry><sphere radius='1'/></geometry></collision>"
    text = ARM.replace(f'<link name="base">{MASS}', f'<link name="base">{MASS}{shape}')
    done = convert(text.replace("</robot>", f'<gazebo reference="base">{setting}</gazebo></robot>'))
    assert kinds(done) == []
    assert written in done.text


def test_a_follower_without_multiplier_follows_one_to_one() -> None:
    follower = '<joint name="weld" type="revolute"><mimic joint="swing"/><limit effort="1" velocity="1"/>'
    done = convert(ARM.replace('<joint name="weld" type="fixed">', follower), Options(Version(1, 11)))
    assert done.verification is not None
    assert done.verification.is_equal
    assert "<multiplier>1</multiplier>" in done.text


def test_joints_after_a_floating_one_are_compared() -> None:
    floating = '<link name="ball"/><joint name="free" type="floating"><parent link="tip"/><child link="ball"/></joint>'
    done = convert(
        ARM.replace('<joint name="swing"', f'{floating}<joint name="swing"').replace(
            '"ball"/>', f'"ball">{MASS}</link>', 1
        )
    )
    assert done.verification is not None
    assert done.verification.is_equal, done.verification.differences
    assert "swing" in done.comparisons[0].source.joints


def test_an_origin_that_moves_nothing_is_no_pose() -> None:
    origin = '<origin xyz="0 0 0" rpy="0 0 0"/>'
    shape = f'<visual>{origin}<geometry><box size="1 1 1"/></geometry></visual>'
    done = convert(f'<robot name="r"><link name="a">{MASS}{shape}</link></robot>')
    assert "<pose" not in done.text


def test_moments_of_light_links_are_compared_as_closely_as_those_of_others() -> None:
    done = convert(ARM.replace('".1"', '"1e-8"'))
    assert "<ixx>1e-8</ixx>" in done.text
    assert verified(done, done.text).is_equal
    other = verified(done, done.text.replace("<ixx>1e-8</ixx>", "<ixx>1.01e-8</ixx>", 1))
    assert {one.what for one in other.differences} == {"inertia"}
