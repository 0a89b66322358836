"""Changing a description leaves every other byte alone."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

SDF = """<?xml version="1.0"?>
<sdf version="1.12"><!-- kept -->
  <model name='m' canonical_link="base">
    <link name="base"/>
    <link name="arm">
      <pose relative_to='base'>0 0 1 0 0 0</pose>
      <inertial><mass>2</mass></inertial>
    </link>
    <joint name="j" type="fixed"><parent>base</parent><child>arm</child></joint>
    <model name="n"><link name="base"/></model>
    <frame name="f" attached_to="n::base"/>
    <plugin name="p" filename="x"><joint_name>j</joint_name><link>base</link><note>base</note></plugin>
  </model>
</sdf>
"""

URDF = """<robot name="r">
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="revolute"><parent link="a"/><child link="b"/><limit effort="1" velocity="1"/></joint>
  <joint name="k" type="fixed"><parent link="b"/><child link="a"/><mimic joint="j"/></joint>
  <gazebo reference="b"><mu1>1</mu1></gazebo>
  <transmission name="t"><joint name="j"/></transmission>
  <ros2_control name="c" type="system"><joint name="j"/></ros2_control>
</robot>
"""


def test_a_link_is_renamed_wherever_it_is_named() -> None:
    robot = sdfcheck.edit(SDF)
    robot.rename(robot.model("m").link("base"), "trunk")
    wanted = SDF.replace('canonical_link="base"', 'canonical_link="trunk"')
    wanted = wanted.replace('    <link name="base"/>\n', '    <link name="trunk"/>\n')
    wanted = wanted.replace("relative_to='base'", "relative_to='trunk'")
    wanted = wanted.replace("<parent>base<", "<parent>trunk<").replace("<link>base<", "<link>trunk<")
    assert robot.text == wanted


def test_scoped_names_are_followed() -> None:
    robot = sdfcheck.edit(SDF)
    robot.rename(robot.model("m").model("n"), "inner")
    robot.rename(robot.model("m").link("n::base"), "foot")
    wanted = SDF.replace('<model name="n"><link name="base"/>', '<model name="inner"><link name="foot"/>')
    assert robot.text == wanted.replace("n::base", "inner::foot")


def test_joints_and_links_of_urdf_are_renamed() -> None:
    robot = sdfcheck.edit(URDF)
    (model,) = robot.models
    robot.rename(model.joint("j"), "elbow")
    robot.rename(model.link("b"), "hand")
    wanted = URDF.replace('joint name="j"', 'joint name="elbow"').replace('joint="j"', 'joint="elbow"')
    wanted = wanted.replace('link="b"', 'link="hand"').replace('reference="b"', 'reference="hand"')
    assert robot.text == wanted.replace('<link name="b"', '<link name="hand"')


def test_vendors_elements_states_and_plugins_that_name_their_own_model_follow() -> None:
    urdf = URDF.replace(
        "</robot>",
        '<drake:collision_filter_group name="g"><drake:member link="b"/></drake:collision_filter_group></robot>',
    )
    robot = sdfcheck.edit(urdf.replace('name="r"', 'name="r" xmlns:drake="http://drake.mit.edu"', 1))
    robot.rename(robot.models[0].link("b"), "hand")
    assert '<drake:member link="hand"/>' in robot.text
    world = (
        '<sdf version="1.9"><world name="w"><model name="bot"><link name="arm"/>'
        '<plugin name="p" filename="x"><body>bot::arm</body></plugin></model>'
        '<state world_name="w"><model name="bot"><link name="arm"/></model></state></world></sdf>'
    )
    robot = sdfcheck.edit(world)
    robot.rename(robot.world("w").model("bot").link("arm"), "hand")
    assert robot.text == world.replace("arm", "hand")
    robot = sdfcheck.edit(world)
    robot.rename(robot.world("w").model("bot"), "car")
    assert robot.text == world.replace("bot", "car")


@pytest.mark.parametrize("name", ["base", "a::b", "", "__x__", "world", "base ", "j"])
def test_names_that_cannot_be_are_refused(name: str) -> None:
    robot = sdfcheck.edit(SDF)
    with pytest.raises(sdfcheck.EditError):
        robot.rename(robot.model("m").link("arm"), name)


def test_values_are_set_and_added() -> None:
    robot = sdfcheck.edit(SDF)
    arm = robot.model("m").link("arm")
    robot.set(arm, "inertial/mass", 2.5)
    robot.set(arm, "pose", [0, 0, 1.5, 0, 0, 0])
    robot.set(arm, "gravity", False)
    robot.set(robot.model("m").link("base"), "@farm:tag", 'a "b" & c')
    text = robot.text
    assert "<mass>2.5</mass>" in text
    assert "<pose relative_to='base'>0 0 1.5 0 0 0</pose>" in text
    assert "      <inertial><mass>2.5</mass></inertial>\n      <gravity>false</gravity>\n    </link>" in text
    assert '<link farm:tag="a &quot;b&quot; &amp; c" name="base"/>' in text


def test_missing_elements_around_a_value_are_added() -> None:
    robot = sdfcheck.edit(SDF)
    robot.set(robot.model("m").link("base"), "inertial/inertia/ixx", 2.0)
    assert (
        '<link name="base">\n      <inertial><inertia><ixx>2</ixx></inertia></inertial>\n    </link>'
        in robot.text
    )
    with pytest.raises(sdfcheck.EditError, match="is new: save before"):
        robot.set(robot.model("m").link("base"), "inertial/mass", 2.0)
    robot = sdfcheck.edit(URDF)
    robot.set(robot.models[0].joint("k"), "dynamics/damping", 0.5)
    assert '<dynamics damping="0.5"/>' in robot.text


@pytest.mark.parametrize(
    ("path", "value", "reason"),
    [("inertial/mass", "heavy", "should be a number"), ("pose", [1, 2, 3], "has 3 numbers and needs 6")],
)
def test_a_text_with_a_new_error_is_not_saved(
    tmp_path: Path, path: str, value: str | list[float], reason: str
) -> None:
    file = tmp_path / "m.sdf"
    file.write_text(SDF)
    with pytest.raises(sdfcheck.EditError, match=reason), sdfcheck.edit(file) as robot:
        robot.set(robot.model("m").link("arm"), path, value)
    assert file.read_text() == SDF


def test_errors_that_were_there_before_do_not_keep_a_text_from_being_saved(tmp_path: Path) -> None:
    file = tmp_path / "m.sdf"
    file.write_text(SDF.replace("<mass>2<", "<mass>heavy<"))
    with sdfcheck.edit(file) as robot:
        robot.set(robot.model("m").link("base"), "gravity", False)
    assert "<gravity>false</gravity>" in file.read_text()


def test_urdf_has_its_values_in_attributes() -> None:
    robot = sdfcheck.edit(URDF)
    joint = robot.models[0].joint("j")
    robot.set(joint, "limit/effort", 5)
    robot.set(joint, "limit/lower", -1.5)
    assert '<limit lower="-1.5" effort="5" velocity="1"/>' in robot.text


def test_elements_are_added_and_removed() -> None:
    robot = sdfcheck.edit(SDF)
    model = robot.model("m")
    robot.add(model.link("base"), '<visual name="v">\n  <transparency>0</transparency>\n</visual>')
    robot.add(model, '<link name="new"/>')
    robot.remove(model.joint("j"))
    changed = sdfcheck.parse(robot.text).model("m")
    assert [link.name for link in changed.links] == ["base", "arm", "new"]
    assert changed.joints == ()
    assert [visual.name for visual in changed.link("base").visuals] == ["v"]
    assert robot.text.count("\n") == SDF.count("\n") + 4 + 1 - 1


def test_leaving_the_block_saves_the_file(tmp_path: Path) -> None:
    file = tmp_path / "m.sdf"
    file.write_bytes(b"\xef\xbb\xbf" + SDF.replace("\n", "\r\n").encode())
    before = file.read_bytes()
    with sdfcheck.edit(file) as robot:
        robot.set(robot.model("m").link("arm"), "inertial/mass", 3)
    assert file.read_bytes() == before.replace(b"<mass>2<", b"<mass>3<")


def test_an_error_leaves_the_file_alone(tmp_path: Path) -> None:
    file = tmp_path / "m.sdf"
    file.write_text(SDF)
    with pytest.raises(sdfcheck.NotFound), sdfcheck.edit(file) as robot:
        robot.set(robot.model("m").link("arm"), "inertial/mass", robot.model("m").link("none").name)
    assert file.read_text() == SDF


def test_renaming_and_back_gives_the_same_bytes() -> None:
    robot = sdfcheck.edit(SDF)
    robot.rename(robot.model("m").link("arm"), "x")
    back = sdfcheck.edit(robot.text)
    back.rename(back.model("m").link("x"), "arm")
    assert back.text == SDF


def test_a_file_is_written_only_if_it_changes(tmp_path: Path) -> None:
    file = tmp_path / "m.sdf"
    file.write_text(SDF)
    before = file.stat().st_ino
    sdfcheck.edit(file).save()
    assert file.stat().st_ino == before
    sdfcheck.edit(file).save(tmp_path / "copy.sdf")
    assert (tmp_path / "copy.sdf").read_text() == SDF


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize("before", ["", "  ", "<!-- x -->"])
def test_an_element_is_removed_with_its_line(end: str, before: str) -> None:
    text = end.join(['<robot name="r">', '  <link name="a"/>', f'{before}<link name="b"/>', "</robot>"])
    robot = sdfcheck.edit(text)
    robot.remove(robot.model("r").link("b"))
    rest = f"{before}{end}</robot>" if before.strip() else "</robot>"
    assert robot.text == end.join(['<robot name="r">', '  <link name="a"/>', rest])


def test_a_text_needs_a_path_to_be_saved(tmp_path: Path) -> None:
    robot = sdfcheck.edit('<robot name="r"><link name="a"/></robot>')
    with pytest.raises(sdfcheck.EditError, match="no file to be saved in: give a path"):
        robot.save()
    robot.save(tmp_path / "r.urdf")
    assert (tmp_path / "r.urdf").read_text() == robot.text


def test_values_of_urdf_are_written_where_they_are_read() -> None:
    robot = sdfcheck.edit(
        '<robot name="r"><link name="a"><inertial><mass value="1"/><origin/></inertial></link></robot>'
    )
    link = robot.model("r").link("a")
    robot.set(link, "inertial/mass", 0.5)
    assert '<mass value="0.5"/>' in robot.text
    robot = sdfcheck.edit(URDF)
    (model,) = robot.models
    robot.set(model.joint("j"), "parent", "b")
    robot.set(model.link("a"), "inertial/mass", 2)
    assert '<joint name="j" type="revolute"><parent link="b"/>' in robot.text
    assert '<inertial><mass value="2"/></inertial>' in robot.text


def test_an_element_of_urdf_with_one_attribute_is_a_value() -> None:
    robot = sdfcheck.edit('<robot name="r"><link name="a"/><joint name="j" type="fixed"/></robot>')
    (model,) = robot.models
    robot.set(model.link("a"), "collision/geometry/box", (1, 2, 3))
    robot.set(model.joint("j"), "axis", (0, 0, 1))
    assert '<geometry><box size="1 2 3"/></geometry>' in robot.text
    assert '<joint name="j" type="fixed" axis=' not in robot.text


def test_an_element_of_urdf_without_a_value_is_refused() -> None:
    robot = sdfcheck.edit(URDF)
    (model,) = robot.models
    with pytest.raises(
        sdfcheck.EditError, match="`limit` has no value of its own in URDF: set `limit/lower`, `limit/upper`"
    ):
        robot.set(model.joint("j"), "limit", 2)
