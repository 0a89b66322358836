"""Over stdio: definitions, references, and renaming in all files of a project."""

from __future__ import annotations

from pathlib import Path

import pytest
from lsprotocol import types
from pygls.exceptions import JsonRpcException

from tests.unit.lsp.wire import Session, Text

pytestmark = [pytest.mark.asyncio(loop_scope="module"), pytest.mark.xdist_group(__name__)]

MODEL = """\
<sdf version="1.12">
  <model name="m" canonical_link="arm">
    <link name="arm"/>
    <link name="hand"><pose relative_to="arm">1 0 0 0 0 0</pose></link>
    <joint name="j" type="revolute">
      <parent>arm</parent>
      <child>hand</child>
      <axis><xyz expressed_in="arm">0 0 1</xyz></axis>
    </joint>
    <frame name="f" attached_to="arm"/>
    <plugin name="gz::sim::systems::JointController" filename="gz-sim-joint-controller-system">
      <joint_name>j</joint_name>
    </plugin>
  </model>
</sdf>
"""
WORLD = """\
<sdf version="1.12">
  <world name="w">
    <include>
      <uri>m.sdf</uri>
      <name>one</name>
    </include>
    <include>
      <uri>m.sdf</uri>
      <name>two</name>
    </include>
    <frame name="g" attached_to="one::arm"/>
    <joint name="k" type="fixed">
      <parent>one::hand</parent>
      <child>two::arm</child>
    </joint>
  </world>
</sdf>
"""
URDF = """\
<robot name="r">
  <material name="red"><color rgba="1 0 0 1"/></material>
  <link name="base">
    <visual><geometry><sphere radius="1"/></geometry><material name="red"/></visual>
  </link>
  <link name="tip"/>
  <joint name="turn" type="continuous"><parent link="base"/><child link="tip"/></joint>
  <joint name="turn2" type="continuous">
    <parent link="base"/>
    <child link="other"/>
    <mimic joint="turn"/>
  </joint>
  <link name="other"/>
  <gazebo reference="tip"><gravity>true</gravity></gazebo>
  <gazebo>
    <plugin name="gz::sim::systems::JointController" filename="gz-sim-joint-controller-system">
      <joint_name>turn</joint_name>
    </plugin>
  </gazebo>
  <ros2_control name="c" type="system"><joint name="turn"><command_interface name="velocity"/></joint></ros2_control>
</robot>
"""
SRDF = """\
<robot name="r">
  <group name="arm"><chain base_link="base" tip_link="tip"/><joint name="turn"/></group>
  <group_state name="home" group="arm"><joint name="turn" value="0"/></group_state>
  <disable_collisions link1="base" link2="tip" reason="Adjacent"/>
</robot>
"""
MACROS = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="size" value="0.5"/>
  <xacro:macro name="wheel" params="name size:=1">
    <link name="${name}_wheel"><visual><geometry><sphere radius="${size}"/></geometry></visual></link>
  </xacro:macro>
</robot>
"""
ROBOT = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="macros.xacro"/>
  <xacro:arg name="side" default="left"/>
  <xacro:wheel name="$(arg side)" size="${size * 2}"/>
  <link name="base"/>
  <link name="top"/>
  <joint name="j" type="fixed"><parent link="base"/><child link="top"/></joint>
</robot>
"""


async def places(text: Text, mark: str, skip: int) -> list[tuple[str, int]]:
    """The files and lines in which what is named at a place is named."""
    found = await text.client.text_document_references_async(
        types.ReferenceParams(types.ReferenceContext(include_declaration=True), **text.at(mark, skip))
    )
    return [(Path(each.uri).name, each.range.start.line) for each in found or ()]


async def test_definition_and_references(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    (folder / "w.sdf").write_text(WORLD)
    there = await session.client.text_document_definition_async(types.DefinitionParams(**text.at(">arm<", 2)))
    assert there == types.Location(text.uri, text.range('"arm"/>', 1, 3))
    own = [("m.sdf", line) for line in (1, 2, 3, 5, 7, 9)]
    assert await places(text, '"arm"/>', 2) == [*own, ("w.sdf", 10), ("w.sdf", 13)]
    assert await places(text, '"j"', 1) == [("m.sdf", 4), ("m.sdf", 11)]
    given = types.ReferenceParams(types.ReferenceContext(include_declaration=False), **text.at('"j"', 1))
    (place,) = await session.client.text_document_references_async(given) or ()
    assert place.range.start.line == 11


async def test_the_definition_of_an_include_is_its_file(session: Session, folder: Path) -> None:
    (folder / "m.sdf").write_text(MODEL)
    text = session.open(folder / "w.sdf", WORLD)
    there = await session.client.text_document_definition_async(types.DefinitionParams(**text.at("m.sdf", 2)))
    assert isinstance(there, types.Location)
    assert there.uri == (folder / "m.sdf").as_uri()
    there = await session.client.text_document_definition_async(
        types.DefinitionParams(**text.at("one::arm", 6))
    )
    assert isinstance(there, types.Location)
    assert there == types.Location((folder / "m.sdf").as_uri(), there.range)
    assert there.range.start == types.Position(2, 16)


async def test_the_named_part_is_highlighted(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    lights = await session.client.text_document_document_highlight_async(
        types.DocumentHighlightParams(**text.at("<child>hand", 8))
    )
    assert lights is not None
    kinds = types.DocumentHighlightKind
    assert [(each.range.start.line, each.kind) for each in lights] == [(3, kinds.Write), (6, kinds.Read)]


async def test_renaming_shows_what_will_change(session: Session, folder: Path) -> None:
    (folder / "m.sdf").write_text(MODEL)
    text = session.open(folder / "w.sdf", WORLD)
    found = await session.client.text_document_prepare_rename_async(
        types.PrepareRenameParams(**text.at("two::arm", 6))
    )
    assert found == types.PrepareRenamePlaceholder(text.range("two::arm", 5), "arm")
    nothing = types.PrepareRenameParams(**text.at("<world", 3))
    assert await session.client.text_document_prepare_rename_async(nothing) is None


async def test_renaming_a_link_in_what_includes_it(session: Session, folder: Path) -> None:
    (folder / "w.sdf").write_text(WORLD)
    text = session.open(folder / "m.sdf", MODEL)
    after = await text.rename('"arm"/>', 2, "upper")
    assert after == {
        "m.sdf": MODEL.replace('"arm"', '"upper"').replace(">arm<", ">upper<"),
        "w.sdf": WORLD.replace("::arm", "::upper"),
    }
    for name, changed in after.items():
        (folder / name).write_text(changed)
    session.notice(folder / "w.sdf")
    text.replace(after["m.sdf"])
    assert await text.rename('"upper"/>', 2, "arm") == {"m.sdf": MODEL, "w.sdf": WORLD}


async def test_renaming_from_a_scoped_name(session: Session, folder: Path) -> None:
    (folder / "m.sdf").write_text(MODEL)
    text = session.open(folder / "w.sdf", WORLD)
    after = await text.rename("one::hand", 6, "gripper")
    assert after["w.sdf"] == WORLD.replace("::hand", "::gripper")
    assert after["m.sdf"] == MODEL.replace('"hand"', '"gripper"').replace(">hand<", ">gripper<")
    assert await text.rename("one::arm", 1, "first") == {"w.sdf": WORLD.replace("one", "first")}


async def test_renaming_a_joint_in_plugins(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    after = MODEL.replace('"j"', '"elbow"').replace(">j<", ">elbow<")
    assert await text.rename('"j"', 1, "elbow") == {"m.sdf": after}


async def test_renaming_in_urdf_and_srdf(session: Session, folder: Path) -> None:
    (folder / "package.xml").write_text("<package><name>p</name></package>")
    (folder / "r.srdf").write_text(SRDF)
    text = session.open(folder / "r.urdf", URDF)
    assert await text.rename('"tip"', 1, "flange") == {
        "r.urdf": URDF.replace('"tip"', '"flange"'),
        "r.srdf": SRDF.replace('"tip"', '"flange"'),
    }
    assert await text.rename('"turn"', 1, "spin") == {
        "r.urdf": URDF.replace('"turn"', '"spin"').replace(">turn<", ">spin<"),
        "r.srdf": SRDF.replace('"turn"', '"spin"'),
    }
    assert await text.rename('"red"', 1, "blue") == {"r.urdf": URDF.replace('"red"', '"blue"')}


async def test_renaming_from_srdf(session: Session, folder: Path) -> None:
    (folder / "package.xml").write_text("<package><name>p</name></package>")
    urdf = session.open(folder / "r.urdf", URDF)
    text = session.open(folder / "r.srdf", SRDF)
    there = await session.client.text_document_definition_async(
        types.DefinitionParams(**text.at('tip_link="tip"', 11))
    )
    assert there == types.Location(urdf.uri, urdf.range('"tip"', 1, 3))
    assert await text.rename('tip_link="tip"', 11, "flange") == {
        "r.urdf": URDF.replace('"tip"', '"flange"'),
        "r.srdf": SRDF.replace('"tip"', '"flange"'),
    }
    urdf.change('<link name="tip"/>', '<!-- moved --><link name="tip"/>')
    after = await text.rename('tip_link="tip"', 11, "flange")
    assert after["r.urdf"] == urdf.text.replace('"tip"', '"flange"')


async def test_renaming_in_xacro(session: Session, folder: Path) -> None:
    (folder / "macros.xacro").write_text(MACROS)
    text = session.open(folder / "r.urdf.xacro", ROBOT)
    assert await text.rename("xacro:wheel", 7, "tyre") == {
        "r.urdf.xacro": ROBOT.replace("xacro:wheel", "xacro:tyre"),
        "macros.xacro": MACROS.replace('"wheel"', '"tyre"'),
    }
    assert await text.rename("${size", 2, "scale") == {
        "r.urdf.xacro": ROBOT.replace("${size", "${scale"),
        "macros.xacro": MACROS.replace('name="size"', 'name="scale"'),
    }
    assert await text.rename(' size="', 1, "radius") == {
        "r.urdf.xacro": ROBOT.replace(' size="', ' radius="'),
        "macros.xacro": MACROS.replace("size:=1", "radius:=1").replace("${size}", "${radius}"),
    }
    assert await text.rename("arg side", 4, "hand") == {
        "r.urdf.xacro": ROBOT.replace('"side"', '"hand"').replace("arg side", "arg hand")
    }
    assert await text.rename('"base"', 1, "trunk") == {"r.urdf.xacro": ROBOT.replace('"base"', '"trunk"')}


async def test_renaming_from_the_file_of_macros(session: Session, folder: Path) -> None:
    (folder / "r.urdf.xacro").write_text(ROBOT)
    text = session.open(folder / "macros.xacro", MACROS)
    assert await text.rename('"wheel"', 2, "tyre") == {
        "r.urdf.xacro": ROBOT.replace("xacro:wheel", "xacro:tyre"),
        "macros.xacro": MACROS.replace('"wheel"', '"tyre"'),
    }


@pytest.mark.parametrize(
    ("mark", "name", "reason"),
    [
        ('"arm"/>', "hand", "already"),
        ('"arm"/>', "j", "already"),
        ('"arm"/>', "a::b", "cannot be the name"),
        ('"arm"/>', "__model__", "cannot be the name"),
        ("<link", "x", "nothing"),
    ],
)
async def test_names_that_are_refused(
    session: Session, folder: Path, mark: str, name: str, reason: str
) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    with pytest.raises(JsonRpcException, match=reason):
        await text.rename(mark, 2, name)


async def test_names_that_are_taken_in_xacro(session: Session, folder: Path) -> None:
    (folder / "macros.xacro").write_text(MACROS)
    text = session.open(folder / "r.urdf.xacro", ROBOT)
    for mark, skip, name in (('"base"', 1, "top"), ("${size", 2, "name-with-hyphen"), ("${size", 2, "pi")):
        with pytest.raises(JsonRpcException):
            await text.rename(mark, skip, name)
