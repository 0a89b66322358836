"""The proof of a conversion about sensors, plugins, materials and custom data."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.migrate.migrate import sdf_to_sdf
from sdfcheck.convert.result import Comparison, Conversion
from sdfcheck.convert.sdf_to_urdf import convert
from sdfcheck.convert.settings_tree import of_model
from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import Options
from sdfcheck.formats.version import NEWEST, Version
from sdfcheck.robot.motion.flatten import mechanism_of
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind

MASS = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
ROBOT = (
    '<robot name="r" xmlns:drake="http://drake.mit.edu" xmlns:shop="urn:shop">'
    f'<link name="a">{MASS}<visual><geometry><box size="1 1 1"/></geometry>'
    '<material name="red"><color rgba="1 0 0 1"/></material></visual>'
    '<collision><geometry><box size="1 1 1"/></geometry><drake:proximity_properties>'
    '<drake:mu_static value="0.8"/></drake:proximity_properties></collision><shop:price>17</shop:price></link>'
    f'<link name="b">{MASS}</link><joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
    '<limit lower="-1" upper="1" effort="5" velocity="3" drake:acceleration="7"/></joint>'
    '<gazebo reference="a"><mu1>0.5</mu1><kp>100</kp><sensor name="cam" type="camera"><update_rate>30</update_rate>'
    '</sensor></gazebo><gazebo reference="j"><provideFeedback>true</provideFeedback></gazebo>'
    '<gazebo><plugin name="p" filename="p.so"><gain>1</gain></plugin></gazebo></robot>'
)


def converted() -> Conversion:
    return urdf_to_sdf(read(ROBOT.encode(), Path("r.urdf"), Kind.URDF), Options())


def differences(done: Conversion, text: str) -> list[tuple[str, str, str]]:
    """The verdict on another text in the place of the result's."""
    model = root_of(read(text.encode(), Path("r.sdf"), Kind.SDF)).models[0]
    before = done.comparisons[0]
    result = mechanism_of(model, vendors=True)
    assert before.contents is not None
    contents = (before.contents[0], of_model(model))
    found = Comparison(before.source, result, before.correspondence, contents).verify(done.losses)
    custom = [(one.name, "", f"was {one.before} and is {one.after}") for one in found.custom]
    return [(one.what, one.name, one.text) for one in found.differences] + custom


def test_the_summary_says_what_was_compared() -> None:
    assert str(converted().verification) == (
        "2 links, 1 joint, 2 shapes, 3 custom elements, 1 material, 1 plugin, 1 sensor, 1 surface, "
        "64 configurations, max pose error 0 m"
    )


def test_of_shapes_in_one_place_each_may_be_the_one() -> None:
    visual = (
        '<visual><origin xyz="{}" rpy="{} 1.5707963267948966 0"/><geometry><mesh filename="{}.stl"/></geometry>'
        '<material name="{}"><color rgba="{} 1"/></material></visual>'
    )
    head = visual.format(
        "-0.12905999999999934191 7.9e-16 0.060949999999999997236", "2.2e-16", "a", "a", "1 0 0"
    )
    mount = visual.format(
        "-0.12906000000000428241 3.0e-16 0.060949999999999886213", "7.1e-31", "b", "b", "0 1 0"
    )
    text = f'<robot name="r"><link name="l">{MASS}{head}{mount}</link></robot>'
    done = urdf_to_sdf(read(text.encode(), Path("r.urdf"), Kind.URDF), Options())
    assert done.verification is not None
    assert not done.verification.differences


@pytest.mark.parametrize(
    ("written", "other", "expected"),
    [
        ("<update_rate>30<", "<update_rate>60<", ("sensor `cam`/update_rate", "a", "was 30 and is 60")),
        ("<gain>1<", "<gain>2<", ("plugin `p`/gain", "r", "was 1 and is 2")),
        ("<diffuse>1 0 0 1<", "<diffuse>0 0 0 1<", ("visual/material/diffuse", "a", "was 1 0 0 1 and is 0 0 0 1")),
        ("<mu>0.5<", "<mu>0.6<", ("collision/surface/friction/ode/mu", "a", "was 0.5 and is 0.6")),
        ("<kp>100<", "<kp>10<", ("collision/surface/contact/ode/kp", "a", "was 100 and is 10")),
        ("<drake:mu_static>0.8<", "<drake:mu_static>0.7<",
         ("collision/drake:proximity_properties/mu_static", "a", "was 0.8 and is 0.7")),
        ("<drake:acceleration>7<", "<drake:acceleration>8<", ("drake:acceleration", "j", "was 7 and is 8")),
        ("<shop:price>17</shop:price>", "", ("shop:price", "", "was 17 and is none")),
        ("<provide_feedback>true<", "<provide_feedback>false<",
         ("physics/provide_feedback", "j", "was true and is false")),
    ],
)  # fmt: skip
def test_one_changed_setting_is_noticed(written: str, other: str, expected: tuple[str, str, str]) -> None:
    done = converted()
    assert written in done.text
    assert differences(done, done.text) == []
    assert differences(done, done.text.replace(written, other)) == [expected]


def test_a_part_reported_as_lost_need_not_exist() -> None:
    text = ROBOT.replace("<shop:price>", '<shop:price where="x">').replace(
        "</collision>", "<drake:nonsense/></collision>"
    )
    done = urdf_to_sdf(read(text.encode(), Path("r.urdf"), Kind.URDF), Options())
    assert "nonsense" not in done.text
    assert done.verification is not None
    assert done.verification.is_equal, done.verification.differences


VERSIONED = (
    '<sdf version="1.9"><model name="m"><link name="a"><sensor name="gps" type="navsat"><update_rate>5</update_rate>'
    "<navsat/></sensor><visual name='v'><geometry><box><size>1 1 1</size></box></geometry>"
    "<material><diffuse>1 0 0 1</diffuse></material></visual></link>"
    '<plugin name="p" filename="p.so"><gain>1</gain></plugin></model></sdf>'
)


@pytest.mark.parametrize(
    ("written", "other", "expected"),
    [
        ("<update_rate>5<", "<update_rate>6<", ("sensor `gps`/update_rate", "a", "was 5 and is 6")),
        ("<gain>1<", "<gain>2<", ("plugin `p`/gain", "m", "was 1 and is 2")),
        ("<diffuse>1 0 0 1<", "<diffuse>0 0 0 1<", ("visual/material/diffuse", "a", "was 1 0 0 1 and is 0 0 0 1")),
        ('type="gps"', 'type="imu"', ("sensor `gps` @type", "a", "was navsat and is imu")),
    ],
)  # fmt: skip
@pytest.mark.parametrize("version", ["1.5", "1.6"])
def test_another_version_has_the_same_settings(
    version: str, written: str, other: str, expected: tuple[str, str, str]
) -> None:
    done = sdf_to_sdf(read(VERSIONED.encode(), Path("m.sdf"), Kind.SDF), Version.parse(version) or NEWEST)
    assert not differences(done, done.text)
    assert written in done.text
    assert differences(done, done.text.replace(written, other)) == [expected]


@pytest.mark.parametrize("kind", ["ray", "lidar"])
def test_older_names_of_sensors_mean_the_same(kind: str) -> None:
    sensor = f'<sensor name="s" type="{kind}"><{kind}><range><min>0.1</min></range></{kind}></sensor>'
    text = f'<robot name="r"><link name="a">{MASS}</link><gazebo reference="a">{sensor}</gazebo></robot>'
    for version in (Version(1, 5), NEWEST):
        done = urdf_to_sdf(read(text.encode(), Path("r.urdf"), Kind.URDF), Options(version))
        assert done.verification is not None
        assert done.verification.is_equal, done.verification.differences
        back = convert(read(done.text.encode(), Path("r.sdf"), Kind.SDF))
        assert back.verification is not None
        assert back.verification.is_equal, back.verification.differences


def test_an_element_that_is_kept_is_no_setting_of_its_name() -> None:
    surface = "<surface><friction><ode><mu>0.5</mu></ode></friction></surface>"
    shape = f'<collision><geometry><box size="1 1 1"/></geometry>{surface}</collision>'
    block = '<gazebo reference="a"><mu1>1</mu1></gazebo>'
    text = f'<robot name="r"><link name="a">{MASS}{shape}</link>{block}</robot>'
    done = urdf_to_sdf(read(text.encode(), Path("r.urdf"), Kind.URDF), Options())
    assert "<urdf:surface>" in done.text
    assert done.verification is not None
    assert done.verification.is_equal
