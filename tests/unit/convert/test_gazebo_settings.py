"""Settings of ``<gazebo>`` blocks: the table says what SDFormat calls them, for the writer and the comparison."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.urdf_to_sdf.conversion import urdf_to_sdf
from sdfcheck.convert.urdf_to_sdf.options import FixedJoints, Options
from sdfcheck.formats.sdf.schema import schema
from sdfcheck.formats.urdf.schema import all_settings, extension, settings
from sdfcheck.formats.version import NEWEST
from sdfcheck.source.document import Document, read
from sdfcheck.source.sniff import Kind

_ROBOT = """\
<robot name="r">
  <link name="a">
    <inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    <collision><geometry><box size="1 1 1"/></geometry></collision>
  </link>
  <gazebo reference="a">{}</gazebo>
</robot>
"""


@pytest.mark.parametrize("about", ["link", "joint"])
def test_each_place_is_one_of_the_newest_version(about: str) -> None:
    root = schema(NEWEST).root.children["model"].children[about]
    for name, setting in settings(about).items():
        for path in setting.counterparts:
            place = root
            for step in path:
                assert step in place.children, f"{name}: {'/'.join(path)}"
                place = place.children[step]


def test_frictions_have_the_range_of_the_newest_version() -> None:
    place = schema(NEWEST).root.children["model"].children["link"].children["collision"]
    for step in ("surface", "friction", "ode"):
        place = place.children[step]
    for setting, name in (("mu1", "mu"), ("mu2", "mu2")):
        ours, theirs = extension().children[setting].range, place.children[name].range
        assert ours is not None
        assert theirs is not None
        assert (ours.low, ours.refused) == (theirs.low, theirs.refused)


def test_settings_of_links_and_joints_have_a_place() -> None:
    hints = {"material", "preserveFixedJoint", "disableFixedJointLumping"}
    for name, setting in all_settings().items():
        assert bool(setting.counterparts) is (setting.about in {"link", "joint"} and name not in hints), name


def converted(setting: str) -> str:
    return urdf_to_sdf(as_urdf(_ROBOT.format(setting)), Options()).text


def as_urdf(text: str) -> Document:
    return read(text.encode(), Path("r.urdf"), Kind.URDF)


@pytest.mark.parametrize("setting", ["<mu>0.01</mu>", "<max_contacts>3</max_contacts>"])
def test_words_that_libsdformat_does_not_translate_change_no_collision(setting: str) -> None:
    name = setting[1 : setting.index(">")]
    text = converted(setting)
    assert f"<{name}>" not in text
    assert f'<urdf:{name} urdf:block="true">' in text


@pytest.mark.parametrize(
    ("setting", "written"),
    [
        ("<mu1>0.01</mu1>", "<mu>0.01</mu>"),
        ("<maxContacts>3</maxContacts>", "<max_contacts>3</max_contacts>"),
        ('<turnGravityOff value="Yes"/>', "<gravity>false</gravity>"),
        ("<turnGravityOff>sure</turnGravityOff>", "<gravity>true</gravity>"),
        ("<dampingFactor>0.5</dampingFactor>", "<angular>0.5</angular>"),
    ],
)
def test_settings_are_written_where_libsdformat_writes_them(setting: str, written: str) -> None:
    assert written in converted(setting)


@pytest.mark.parametrize(("given", "taken"), [("yes", "true"), ("sure", "false")])
def test_a_robot_stands_still_as_libsdformat_reads_it(given: str, taken: str) -> None:
    text = _ROBOT.replace("</robot>", f"<gazebo><static>{given}</static></gazebo></robot>").format("")
    assert f"<static>{taken}</static>" in urdf_to_sdf(as_urdf(text), Options()).text


@pytest.mark.parametrize(("second", "count"), [("false", 1), ("true", 0)])
def test_a_setting_that_merging_replaces_is_reported(second: str, count: int) -> None:
    blocks = "".join(
        f'<gazebo reference="{link}"><selfCollide>{value}</selfCollide></gazebo>'
        for link, value in (("a", "true"), ("b", second))
    )
    body = '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    robot = (
        f'<robot name="r"><link name="a">{body}</link><link name="b">{body}</link>'
        f'<joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>{blocks}</robot>'
    )
    done = urdf_to_sdf(read(robot.encode(), Path("r.urdf")), Options(fixed_joints=FixedJoints.MERGE))
    assert done.verification is not None
    assert done.verification.is_equal
    assert f"<self_collide>{second}</self_collide>" in done.text
    said = [loss.message for loss in done.losses if "gives way" in loss.message]
    assert said == ["<selfCollide> of link `a` gives way to that of `b`: they are one link"] * count
