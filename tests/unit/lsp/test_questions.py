"""The questions of a person at many places of many files, and names that xacro makes of expressions."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from lsprotocol import types

from benchmarks.editor import (
    DEFINITIONS,
    REFERENCES,
    Editor,
    Tally,
    chosen,
    completions,
    every_character,
    names,
    rename_once,
)
from sdfcheck.lsp.completion import complete
from sdfcheck.lsp.rename import Refused
from sdfcheck.lsp.watch import choices_of
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.source.sniff import Kind

pytestmark = pytest.mark.xdist_group(__name__)

FILES = chosen([Path(__file__).parents[3] / "fixtures"], 24, 3)
HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n'
ARM = """\
  <xacro:macro name="arm" params="prefix">
    <link name="${prefix}base"/>
    <link name="${prefix}tip"/>
    <joint name="${prefix}elbow" type="continuous">
      <parent link="${prefix}base"/>
      <child link="${prefix}tip"/>
    </joint>
  </xacro:macro>
"""
CONTROL = """\
  <xacro:macro name="control" params="prefix">
    <ros2_control name="c" type="system"><joint name="${prefix}elbow"/></ros2_control>
  </xacro:macro>
"""
ROBOT = """\
  <xacro:include filename="arm.xacro"/>
  <xacro:include filename="control.xacro"/>
  <xacro:arm prefix="l_"/>
  <xacro:control prefix="l_"/>
"""
BRANCHES = """\
  <xacro:arg name="long" default="false"/>
  <link name="base"/>
  <xacro:if value="$(arg long)"><link name="tip"/></xacro:if>
  <xacro:unless value="$(arg long)"><link name="tip"/></xacro:unless>
  <joint name="j" type="fixed"><parent link="base"/><child link="tip"/></joint>
"""


@pytest.fixture
def editor() -> Iterator[Editor]:
    made = Editor()
    yield made
    made.workspace.close()


def written(folder: Path, **texts: str) -> Path:
    """A folder with xacro files; the last one's path."""
    path = folder
    for name, text in texts.items():
        path = folder / f"{name}.xacro"
        path.write_text(f"{HEAD}{text}</robot>\n")
    return path


def renamed(editor: Editor, path: Path, mark: str, skip: int, name: str) -> dict[str, list[str]] | str:
    """The new texts by files, or the reason for the refusal."""
    buffer = editor.open(path, path.read_text())
    place = editor.place(buffer, buffer.source.text.index(mark) + skip)
    found = editor.answers.rename(buffer, types.RenameParams(new_name=name, **place))
    if isinstance(found, Refused):
        return str(found)
    assert found.changes is not None
    return {
        uri.rpartition("/")[2]: sorted(edit.new_text for edit in edits)
        for uri, edits in found.changes.items()
    }


def test_each_character_of_a_name_is_answered(editor: Editor) -> None:
    tally = Tally()
    for path, kind, text in FILES[:2]:
        every_character(editor, editor.open(path, text), kind, tally)
    assert sum(tally.asked.values()) > 200
    for question, asked in tally.asked.items():
        assert tally.right[question] >= 0.9 * asked, (question, tally.missed[:5])


def test_removed_parts_are_suggested(editor: Editor) -> None:
    tally, chance = Tally(), random.Random(1)
    for path, kind, text in FILES[:8]:
        completions(editor, path, kind, text, chance, tally)
    asked = {what: count for what, count in tally.asked.items() if "anywhere" not in what}
    assert sum(tally.right[what] for what in asked) >= 0.9 * sum(asked.values()), tally.missed[:20]


def test_renaming_makes_no_finding_and_moves_nothing(editor: Editor) -> None:
    tally, chance = Tally(), random.Random(2)
    for path, kind, text in FILES[:6]:
        places = list(names(text, REFERENCES[kind] | DEFINITIONS[kind]))
        buffer = editor.open(path, text)
        for name in chance.sample(places, min(1, len(places))):
            rename_once(editor, {path}, buffer, name.start, chance, tally)
    assert tally.right["rename is done"] > 2
    for question in ("rename: no new finding", "rename: same poses"):
        assert tally.right[question] == tally.asked[question], tally.missed


@pytest.mark.parametrize("skip", range(len("${prefix}tip")))
def test_each_character_of_a_name_with_an_expression(editor: Editor, tmp_path: Path, skip: int) -> None:
    path = written(tmp_path, arm=f'{ARM}<xacro:arm prefix="l_"/>')
    buffer = editor.open(path, path.read_text())
    place = editor.place(buffer, buffer.source.text.index("${prefix}tip") + skip)
    found = editor.answers.definition(buffer, types.DefinitionParams(**place))
    assert isinstance(found, types.Location)
    assert found.range.start.line == (1 if 2 <= skip <= 8 else 3)
    assert editor.answers.prepared(buffer, types.PrepareRenameParams(**place)) is not None


def test_sensors_and_collisions_have_a_name_in_each_link(editor: Editor, tmp_path: Path) -> None:
    link = (
        '<link name="{}"><collision name="c"/><sensor name="s" type="contact"><contact><collision>c</collision>'
        "</contact></sensor></link>"
    )
    body = f'<model name="m">{link.format("a")}{link.format("b")}</model></sdf>'
    for name, head in (("m.sdf", "<sdf>"), ("m.sdf.xacro", '<sdf xmlns:xacro="http://ros.org/wiki/xacro">')):
        path = tmp_path / name
        path.write_text(head + body)
        assert renamed(editor, path, ">c<", 1, "shell") == {name: ["shell", "shell"]}
        assert renamed(editor, path, 'name="s"', 6, "touch") == {name: ["touch"]}
    sensors = body.replace("</sensor>", '</sensor><sensor name="t" type="imu"/>', 1)
    path.with_suffix(".sdf").write_text(f"<sdf>{sensors}")
    refusal = renamed(editor, path.with_suffix(".sdf"), 'name="s"', 6, "t")
    assert refusal == "there is a sensor `t` already in m.sdf.sdf"


@pytest.mark.parametrize(
    ("part", "mark", "line"),
    [
        ('<xacro:include filename="arm.xacro" ns="my"/><xacro:my.arm prefix="a"/>', "y.arm", 2),
        ('<xacro:include filename="arm.xacro" ns="my"/><xacro:my.arm prefix="a"/>', "prefix", 2),
        ('<xacro:include filename="arm.xacro"/><xacro:call macro="arm" prefix="a"/>', "prefix", 2),
        ('<xacro:arm prefix="a"/>', "arm", 2),
        ('<xacro:macro name="m" params=""><link name="l" mass="${heavy}"/></xacro:macro>', "heavy", 1),
        (
            (
                '<xacro:macro name="in" params=""><link name="${own}"/></xacro:macro>\n'
                '<xacro:macro name="out" params="own"><xacro:in/></xacro:macro>'
            ),
            "own",
            2,
        ),
        ('<xacro:macro name="m" params="up"><link name="${up}"/></xacro:macro>', "{up}", 1),
        ('<xacro:macro name="m" params="\r\n  up\r\n  a"><link name="${up}"/></xacro:macro>', "up}", 2),
        (
            (
                '<xacro:macro name="m" params="p"><gazebo><plugin name="g"><frameName>${p}tip</frameName>'
                "</plugin></gazebo></xacro:macro>"
            ),
            "tip<",
            4,
        ),
    ],
    ids="namespace,parameter there,call,nobody's,nobody's property,caller's,around,CRLF,includer's".split(
        ","
    ),
)
def test_names_that_are_defined_elsewhere(
    editor: Editor, tmp_path: Path, part: str, mark: str, line: int
) -> None:
    include = '<xacro:include filename="part.xacro"/>' if "plugin" in part else ""
    arm = ARM.replace("prefix}", "p}") if include else ARM
    path = written(tmp_path, arm=f'<xacro:property name="heavy" value="9"/>{include}\n{arm}', part=part)
    buffer = editor.open(path, path.read_bytes().decode())
    place = editor.place(buffer, buffer.source.text.index(mark))
    found = editor.answers.definition(buffer, types.DefinitionParams(**place))
    assert isinstance(found, types.Location)
    assert found.range.start.line == line


def test_a_name_that_no_robot_shows_is_kept(editor: Editor, tmp_path: Path) -> None:
    block = '<xacro:macro name="b" params="prefix"><gazebo reference="${prefix}tip"/></xacro:macro>'
    written(tmp_path, arm=f'{ARM}<xacro:include filename="block.xacro"/>')
    path = written(tmp_path, block=block)
    assert renamed(editor, path, "tip", 1, "end") == "no robot is known that has link `${prefix}tip`"
    assert renamed(editor, tmp_path / "arm.xacro", "tip", 1, "end") == {
        "arm.xacro": ["${prefix}end"] * 2,
        "block.xacro": ["${prefix}end"],
    }


@pytest.mark.parametrize("asked", ["paint", "body", "pair"])
def test_a_material_of_parts_that_no_robot_includes(editor: Editor, tmp_path: Path, asked: str) -> None:
    use = '<xacro:macro name="{}"><visual><material name="red"/></visual></xacro:macro>'
    written(tmp_path, paint='<material name="red"><color rgba="1 0 0 1"/></material>')
    written(tmp_path, body=f'<xacro:include filename="paint.xacro"/>{use.format("body")}')
    written(tmp_path, pair=f'<xacro:include filename="body.xacro"/>{use.format("pair")}')
    assert renamed(editor, tmp_path / f"{asked}.xacro", "red", 1, "rouge") == {
        f"{name}.xacro": ["rouge"] for name in ("body", "paint", "pair")
    }


def test_renaming_a_macro_in_a_namespace(editor: Editor, tmp_path: Path) -> None:
    call = '<xacro:include filename="arm.xacro" ns="my"/><xacro:my.arm prefix="a"></xacro:my.arm>'
    written(tmp_path, arm=ARM, robot=call)
    after = renamed(editor, tmp_path / "arm.xacro", '"arm"', 1, "limb")
    assert after == {"arm.xacro": ["limb"], "robot.xacro": ["xacro:my.limb"] * 2}


@pytest.mark.parametrize("file", ["arm", "control"])
def test_renaming_reaches_files_beside_one_another(editor: Editor, tmp_path: Path, file: str) -> None:
    written(tmp_path, arm=ARM, control=CONTROL, robot=ROBOT)
    after = renamed(editor, tmp_path / f"{file}.xacro", "${prefix}elbow", 10, "knee")
    assert after == {"arm.xacro": ["${prefix}knee"], "control.xacro": ["${prefix}knee"]}


def test_renaming_where_a_name_is_written_out(editor: Editor, tmp_path: Path) -> None:
    path = written(tmp_path, arm=f'{ARM}<xacro:arm prefix="l_"/><gazebo reference="l_tip"/>')
    assert renamed(editor, path, '"l_tip"', 2, "l_hand") == {
        "arm.xacro": ["${prefix}hand", "${prefix}hand", "l_hand"]
    }


def test_renaming_through_macros_of_one_name(editor: Editor, tmp_path: Path) -> None:
    block = '<xacro:macro name="block" params="of"><gazebo reference="${of}"/></xacro:macro>'
    part = '<xacro:macro name="{0}" params="p">{1}<link name="${{p}}{0}"/><xacro:block of="${{p}}{0}"/></xacro:macro>'
    robot = '<xacro:include filename="a.xacro"/><xacro:include filename="b.xacro"/><xacro:a p="x"/><xacro:b p="y"/>'
    written(tmp_path, b=part.format("b", block), robot=robot)
    path = written(tmp_path, a=part.format("a", block))
    assert renamed(editor, path, 'name="${p}a"', 10, "tip") == {"a.xacro": ["${p}tip"] * 2}


def test_renaming_both_of_two_branches(editor: Editor, tmp_path: Path) -> None:
    path = written(tmp_path, robot=BRANCHES)
    assert renamed(editor, path, '"tip"', 2, "hand") == {"robot.xacro": ["hand"] * 3}


GIVEN_TWICE = """\
  <xacro:arg name="big" default="false"/>
  <xacro:if value="$(arg big)"><xacro:property name="size" value="2"/></xacro:if>
  <xacro:unless value="$(arg big)"><xacro:property name="size" value="1"/></xacro:unless>
  <xacro:macro name="load" params="k">
    <xacro:if value="${k}"><xacro:property name="mass" value="2" scope="parent"/></xacro:if>
    <xacro:unless value="${k}"><xacro:property name="mass" value="1" scope="parent"/></xacro:unless>
    <xacro:property name="ratio" value="${mass * 2}" scope="global"/>
  </xacro:macro>
"""
USING = """\
  <xacro:macro name="body" params="n">
    <xacro:load k="1"/>
    <link name="${n}"><visual><geometry><box size="${mass} ${ratio} ${size}"/></geometry></visual></link>
  </xacro:macro>
  <xacro:body n="a"/>
"""


@pytest.mark.parametrize(
    ("mark", "places"), [("size", 3), ("mass", 4), ("ratio", 2), ("big", 3), ("body", 2), ("n", 3)]
)
def test_names_that_are_defined_twice_or_last(editor: Editor, tmp_path: Path, mark: str, places: int) -> None:
    written(tmp_path, load=GIVEN_TWICE)
    path = written(tmp_path, robot=f'<xacro:include filename="load.xacro"/>{USING}')
    for file in ("load.xacro", "robot.xacro"):
        text = (tmp_path / file).read_text()
        found = list(re.finditer(rf"(?<=[\"{{ :]){mark}(?=[\" }}*)])", text))
        for each in found:
            after = renamed(editor, tmp_path / file, text[each.start() :], 0, "other")
            assert isinstance(after, dict), after
            assert sum(map(len, after.values())) == places, (file, each)
    assert path.exists()


IN_EXPRESSIONS = """\
  <xacro:arg name="side" default="left"/>
  <link name="a"><visual><geometry><box size="${'$(arg side)' == 'left'} ${xacro.arg('side') == ''} 1"/></geometry>
  </visual></link><xacro:if value="$(arg side)"/>
"""


def test_arguments_within_expressions(editor: Editor, tmp_path: Path) -> None:
    path = written(tmp_path, robot=IN_EXPRESSIONS)
    for mark in ("side)'", "side')", 'side" default', 'side)"'):
        buffer = editor.open(path, path.read_text())
        place = editor.place(buffer, buffer.source.text.index(mark) + 2)
        context = types.ReferenceContext(True)
        found = editor.answers.references(buffer, types.ReferenceParams(context, **place))
        assert found is not None
        assert len(found) == 4


@pytest.mark.parametrize(("name", "after"), [("${side}_wheel", "${side}_disk"), ("wheel", "disk")])
def test_parameters_of_plugins_name_parts(editor: Editor, tmp_path: Path, name: str, after: str) -> None:
    inside = f"<wheel_link>{name}</wheel_link><frame>odom</frame>"
    plugin = f'<gazebo><plugin name="p" filename="x.so">{inside}</plugin></gazebo>'
    macro = f'<xacro:macro name="m" params="side"><link name="{name}"/>{plugin}</xacro:macro>'
    path = written(tmp_path, robot=f'{macro}<xacro:m side="left"/>')
    new = "_disk" if "$" in name else "disk"
    assert renamed(editor, path, f"{name}</wheel_link>", len(name) - 1, new) == {"robot.xacro": [after] * 2}
    buffer = editor.open(path, path.read_text())
    place = editor.place(buffer, buffer.source.text.index("odom") + 1)
    assert editor.answers.prepared(buffer, types.PrepareRenameParams(**place)) is None


def test_a_name_in_two_robots_that_include_one_file(editor: Editor, tmp_path: Path) -> None:
    written(tmp_path, common='<xacro:property name="size" value="1"/>')
    use = '<xacro:include filename="common.xacro"/><xacro:property name="size" value="{}"/><link name="${{size}}"/>'
    path = written(tmp_path, b=use.format(2))
    written(tmp_path, a=use.format(3), other='<xacro:property name="size" value="1"/><link name="${size}"/>')
    expected = {"a.xacro": ["width"] * 2, "b.xacro": ["width"] * 2, "common.xacro": ["width"]}
    for file in ("a.xacro", "b.xacro", "common.xacro"):
        assert renamed(editor, tmp_path / file, '"size"', 1, "width") == expected
    assert path.exists()


def test_the_link_that_is_the_world_keeps_its_name(editor: Editor, tmp_path: Path) -> None:
    path = written(tmp_path, robot='<link name="world"/>')
    assert "is the world to Gazebo" in renamed(editor, path, '"world"', 1, "earth")
    (tmp_path / "r.urdf").write_text('<robot name="r"><link name="world"/></robot>')
    assert "is the world to Gazebo" in renamed(editor, tmp_path / "r.urdf", '"world"', 1, "earth")


def test_an_argument_that_a_launch_file_gives_keeps_its_name(editor: Editor, tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    (tmp_path / "r.launch").write_text(
        '<launch><param name="d" command="xacro $(find p)/robot.xacro side:=r"/></launch>'
    )
    ask = '<xacro:arg name="{0}" default="l"/><link name="$(arg {0})"/>'
    path = written(tmp_path, robot=ask.format("side") + ask.format("end"))
    assert renamed(editor, path, '"end"', 1, "tip") == {"robot.xacro": ["tip", "tip"]}
    assert "`side` is given to robot.xacro from outside" in renamed(editor, path, '"side"', 1, "hand")


def test_an_argument_that_the_configuration_gives_keeps_its_name(editor: Editor, tmp_path: Path) -> None:
    (tmp_path / "sdfcheck.toml").write_text('[xacro]\n"robot.xacro" = [{ side = "r" }]\n')
    path = written(tmp_path, robot='<xacro:arg name="side" default="l"/><link name="$(arg side)"/>')
    assert "`side` is given to robot.xacro from outside" in renamed(editor, path, '"side"', 1, "hand")


SCENE = """\
<sdf version="1.9"><model name="m">
  <link name="body"/><link name="wheel"><pose relative_to="axle"/></link>
  <joint name="steer" type="revolute"><parent>body</parent><child>body</child></joint>
  <joint name="axle" type="revolute"><parent>body</parent><child>wheel</child><pose relative_to="body"/></joint>
  <plugin name="a" filename="libmine.so"><|</plugin>
</model></sdf>
"""


@pytest.mark.parametrize(
    ("removed", "expected"), [('relative_to="axle', "axle"), ('relative_to="body', "body")]
)
def test_poses_are_relative_to_what_moves_a_link_or_carries_a_joint(
    editor: Editor, tmp_path: Path, removed: str, expected: str
) -> None:
    place = SCENE.index(removed) + len(removed) - len(expected)
    text = SCENE.replace("<|", "")
    buffer = editor.open(tmp_path / "m.sdf", text[:place] + text[place + len(expected) :])
    assert complete(editor.workspace, buffer, place).items[0].label == expected


def test_a_plugin_is_suggested_what_it_holds_elsewhere(editor: Editor, tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    plugin = '<plugin name="b" filename="mine"><gain>1</gain><deep><inner/></deep></plugin>'
    other = f'<sdf><world name="w">{plugin}</world></sdf>'
    (tmp_path / "other.sdf").write_text(other)
    place = SCENE.index("<|") + 1
    buffer = editor.open(tmp_path / "m.sdf", SCENE.replace("<|", "<"))
    labels = [item.label for item in complete(editor.workspace, buffer, place).items]
    assert set(labels[:2]) == {"gain", "deep"}
    assert "inner" not in labels


def test_the_other_branch_follows_a_condition(editor: Editor, tmp_path: Path) -> None:
    path = written(tmp_path, robot='<xacro:if value="1"><link name="a"/></xacro:if>\n<xacro:|')
    text = path.read_text()
    place = text.index("|")
    buffer = editor.open(path, text.replace("|", ""))
    assert complete(editor.workspace, buffer, place).items[0].label == "xacro:unless"


def test_renaming_is_refused_where_more_would_change(editor: Editor, tmp_path: Path) -> None:
    wheel = '<xacro:macro name="w" params="n"><link name="${n}"/><joint name="${n}_joint" type="fixed"/></xacro:macro>'
    robot = f'{wheel}<xacro:w n="a"/><gazebo reference="a"/>'
    after = renamed(editor, written(tmp_path, robot=robot), 'reference="a"', 11, "b")
    assert isinstance(after, str)
    assert "more than this name would change" in after


def test_renaming_is_refused_where_the_name_is_taken(editor: Editor, tmp_path: Path) -> None:
    path = written(tmp_path, arm=f'{ARM}<xacro:arm prefix="l_"/>')
    assert "already" in renamed(editor, path, "${prefix}tip", 10, "base")


def test_semantics_follow_the_robot(editor: Editor, tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    path = written(tmp_path, arm=f'{ARM}<xacro:arm prefix="l_"/>')
    group = '<group name="arm"><chain base_link="l_base" tip_link="l_tip"/></group>'
    (tmp_path / "r.srdf").write_text(f'<robot name="r">{group}<group_state name="h" group="arm"/></robot>')
    after = renamed(editor, path, "${prefix}tip", 10, "hand")
    assert after == {"arm.xacro": ["${prefix}hand", "${prefix}hand"], "r.srdf": ["l_hand"]}
    after = renamed(editor, tmp_path / "r.srdf", '"arm"', 2, "all")
    assert after == {"r.srdf": ["all", "all"]}
    buffer = editor.open(tmp_path / "r.srdf", (tmp_path / "r.srdf").read_text())
    place = editor.place(buffer, buffer.source.text.index("l_tip"))
    ready = editor.answers.prepared(buffer, types.PrepareRenameParams(**place))
    assert isinstance(ready, types.PrepareRenamePlaceholder)
    assert ready.placeholder == "l_tip"


def test_semantics_made_with_xacro_rename_what_the_robot_defines(editor: Editor, tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    (tmp_path / "r.urdf").write_text(PLAIN)
    group = '<group name="hand"><link name="tip"/></group>'
    apart = '<disable_collisions link1="base" link2="base" reason="Never"/>'
    part = f'<xacro:macro name="hand">{group}{apart}</xacro:macro>'
    path = written(tmp_path, hand=part)
    alone = editor.open(path, path.read_text())
    place = editor.place(alone, alone.source.text.index('"tip"') + 1)
    found = editor.answers.definition(alone, types.DefinitionParams(**place))
    assert isinstance(found, types.Location)
    assert found.uri.endswith("r.urdf")
    whole = f'{HEAD}<xacro:include filename="hand.xacro"/><xacro:hand/></robot>'
    (tmp_path / "r.srdf.xacro").write_text(whole)
    assert renamed(editor, path, '"tip"', 1, "end") == {"hand.xacro": ["end"], "r.urdf": ["end", "end"]}


SEMANTICS = """\
<robot name="r">
  <virtual_joint name="floor" type="fixed" parent_frame="world" child_link="base"/>
  <group name="arm"><chain base_link="base" tip_link="tip"/></group>
  <group name="all"><group name="arm"/></group>
  <group_state name="home" group="arm"><joint name="elbow" value="0"/><joint name="floor" value="0"/></group_state>
  <group_state name="home" group="all"><joint name="elbow" value="1"/></group_state>
  <end_effector name="hand" group="arm" parent_link="tip"/>
  <passive_joint name="elbow"/>
  <disable_collisions link1="base" link2="tip" reason="Adjacent"/>
  <gripper name="g"><link name="tip"/></gripper>
</robot>
"""
PLAIN = """\
<robot name="r"><link name="base"/><link name="tip"/>
<joint name="elbow" type="continuous"><parent link="base"/><child link="tip"/></joint></robot>
"""


@pytest.fixture(params=["r.urdf", "r.urdf.xacro", "other.urdf"])
def robot(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """SRDF beside a robot: plain, made with xacro, or of another package, which the assistant's settings name."""
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    (tmp_path / "r.srdf").write_text(SEMANTICS)
    path: Path = tmp_path / request.param
    if path.name == "other.urdf":
        (tmp_path / ".git").mkdir()
        (tmp_path / "q").mkdir()
        (tmp_path / "q" / "package.xml").write_text("<package><name>q</name></package>")
        settings = "moveit_setup_assistant_config:\n  URDF:\n    package: q\n    relative_path: other.urdf\n"
        (tmp_path / ".setup_assistant").write_text(settings)
        path = tmp_path / "q" / "other.urdf"
        path.write_text(PLAIN.replace('"r"', '"another"'))
    elif path.suffix == ".xacro":
        path.write_text(f'{HEAD}{ARM}<xacro:arm prefix=""/></robot>')
    else:
        path.write_text(PLAIN)
    return path


def test_every_name_in_semantics_is_defined_somewhere(editor: Editor, robot: Path, tmp_path: Path) -> None:
    buffer = editor.open(tmp_path / "r.srdf", SEMANTICS)
    own = {"virtual_joint@name", "group_state@name", "end_effector@name"}
    for name in names(SEMANTICS, REFERENCES[Kind.SRDF] | DEFINITIONS[Kind.SRDF] | own):
        for offset in range(name.start, name.end + 1):
            place = editor.place(buffer, offset)
            found = editor.answers.definition(buffer, types.DefinitionParams(**place))
            assert isinstance(found, types.Location), (name, SEMANTICS[name.start : name.end])
            value = SEMANTICS[name.start : name.end]
            is_own = value in {"floor", "arm", "all", "home", "hand"}
            assert found.uri == (buffer.uri if is_own else robot.as_uri()), value


def test_of_many_semantics_those_are_looked_at_that_may_name_a_part(
    editor: Editor, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in ("names", "rename"):
        monkeypatch.setattr(f"sdfcheck.lsp.{module}.MOST_SEMANTICS", 2)
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    (tmp_path / "r.urdf").write_text(PLAIN)
    made = f'{HEAD}<xacro:property name="j" value="el"/><passive_joint name="${{j}}bow"/></robot>'
    (tmp_path / "made.srdf.xacro").write_text(made)
    for name in "abc":
        (tmp_path / f"{name}.srdf").write_text('<robot name="r"><passive_joint name="wrist"/></robot>')
    (tmp_path / "r.srdf").write_text(SEMANTICS)
    new = renamed(editor, tmp_path / "r.urdf", 'joint name="elbow"', 14, "elbows")
    assert new == {"r.urdf": ["elbows"], "r.srdf": ["elbows"] * 3, "made.srdf.xacro": ["${j}bows"]}
    (tmp_path / "d.srdf").write_text(SEMANTICS)
    refusal = renamed(editor, tmp_path / "r.urdf", 'joint name="elbow"', 14, "elbows")
    assert refusal == "more than 2 SRDF files may name it, too many to change"


def test_renaming_from_a_robot_to_its_semantics_and_back(editor: Editor, robot: Path) -> None:
    mark = '"${prefix}elbow"' if robot.suffix == ".xacro" else '"elbow"'
    new = "${prefix}knee" if robot.suffix == ".xacro" else "knee"
    after = {robot.name: [new], "r.srdf": ["knee"] * 3}
    assert renamed(editor, robot, mark, len(mark) - 3, "knee") == after
    semantics = next(path / "r.srdf" for path in robot.parents if (path / "r.srdf").exists())
    assert renamed(editor, semantics, 'joint name="elbow" value="1"', 14, "knee") == after
    buffer = editor.open(robot, robot.read_text())
    context = types.ReferenceContext(True)
    place = editor.place(buffer, buffer.source.text.index(mark) + len(mark) - 3)
    found = editor.answers.references(buffer, types.ReferenceParams(context, **place))
    assert sum(each.uri.endswith("r.srdf") for each in found or ()) == 3


def test_states_of_one_name_are_states_of_their_groups(editor: Editor, robot: Path, tmp_path: Path) -> None:
    assert renamed(editor, tmp_path / "r.srdf", '"home" group="all"', 2, "rest") == {"r.srdf": ["rest"]}
    assert renamed(editor, tmp_path / "r.srdf", '"floor" type', 2, "ground") == {"r.srdf": ["ground"] * 2}


@pytest.mark.parametrize(
    ("removed", "at", "expected"),
    [
        ('child_link="base"', 12, "base"),
        ('tip_link="tip"', 10, "tip"),
        ('joint name="elbow"', 12, "elbow"),
        ('parent_link="tip"', 13, "tip"),
        ('link2="tip"', 7, "tip"),
        ('link1="base"', 7, "base"),
    ],
)
def test_names_that_are_suggested_in_semantics(
    editor: Editor, robot: Path, tmp_path: Path, removed: str, at: int, expected: str
) -> None:
    place = SEMANTICS.index(removed) + at
    text = SEMANTICS[:place] + SEMANTICS[place + len(expected) :]
    buffer = editor.open(tmp_path / "r.srdf", text)
    assert complete(editor.workspace, buffer, place).items[0].label == expected


def test_joints_in_semantics_are_those_of_the_robot(editor: Editor, tmp_path: Path) -> None:
    limit = PLAIN.replace("continuous", "revolute").replace(
        "</joint>", '<limit lower="-1" upper="2"/></joint>'
    )
    (tmp_path / "r.urdf").write_text(limit)
    (tmp_path / "r.srdf").write_text(SEMANTICS)
    buffer = editor.open(tmp_path / "r.srdf", SEMANTICS)
    place = editor.place(buffer, SEMANTICS.index('"elbow" value') + 2)
    found = editor.answers.hover(buffer, types.HoverParams(**place))
    assert found is not None
    assert "`base` → `tip`" in str(found.contents)
    assert "from `-1` to `2` rad" in str(found.contents)


def test_everything_in_semantics_is_explained(editor: Editor, robot: Path, tmp_path: Path) -> None:
    buffer = editor.open(
        tmp_path / "r.srdf", SEMANTICS.replace("<gripper", "<!--").replace("</gripper>", "-->")
    )
    for match in re.finditer(r"(?<=[<\s])[a-z_]+\d?(?=[\s=])", SEMANTICS[: SEMANTICS.index("<gripper")]):
        place = editor.place(buffer, match.start())
        found = editor.answers.hover(buffer, types.HoverParams(**place))
        assert found is not None, match[0]
        assert "SRDF" in str(found.contents), match[0]


@pytest.mark.parametrize(
    ("text", "mark", "expected"),
    [
        ('<xacro:property name="a" value="${2*3}"/>', "${2*3}", "`6`"),
        ('<xacro:property name="w" value="3"/><link name="${w/2}"/>', "${w/2}", "`1.5`"),
        ('<xacro:arg name="a" default="1"/>', "arg name", "Declares an argument"),
        (
            '<link name="a"/><xacro:if value="1"><joint name="b" type="fixed"/></xacro:if>',
            "joint",
            "Connects",
        ),
    ],
)
def test_hover_in_xacro(editor: Editor, tmp_path: Path, text: str, mark: str, expected: str) -> None:
    path = written(tmp_path, robot=text)
    buffer = editor.open(path, path.read_text())
    place = editor.place(buffer, buffer.source.text.index(mark) + 2)
    found = editor.answers.hover(buffer, types.HoverParams(**place))
    assert found is not None
    assert isinstance(found.contents, types.MarkupContent)
    assert expected in found.contents.value


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('<gazebo><plugin name="p" filename="x.so"><m>${|}</m></plugin></gazebo>', "mass"),
        ('<gazebo><plugin name="p" filename="x.so"><m>$(arg |)</m></plugin></gazebo>', "side"),
        ("<xacro:wheel |/>", "red"),
        ('<link name="a"/><link name="b"/><gazebo reference="|"/>', "a"),
        ('<xacro:macro name="m" params="one *two"><xacro:insert_block name="|"/></xacro:macro>', "two"),
        (
            '<xacro:property name="block"><origin/></xacro:property><xacro:insert_block name="|"/>',
            "block",
        ),
        ('<xacro:if value="$(arg |)"/>', "launched"),
        ('<transmission name="t"><joint name="j"><|</joint></transmission>', "hardwareInterface"),
        ('<transmission name="t"><actuator name="j"><|</actuator></transmission>', "mechanicalReduction"),
        ('<xacro:wheel red="left"/><gazebo reference="|"/>', "left"),
        (
            '<ros2_control name="c" type="system"><sensor name="s"><state_interface name="|"/></sensor></ros2_control>',
            "force.x",
        ),
        ('<ros2_control name="c" type="system"><xacro:if value="1"><|</xacro:if></ros2_control>', "joint"),
        ("<xacro:unknown><|</xacro:unknown>", "origin"),
        ('<xacro:include filename="$(find gone)/other.xacro"/><xacro:|', "xacro:hub"),
        ("<xacro:hub |/>", "bore"),
        ('<xacro:wheel red="$(arg |)"/>', "elsewhere"),
        (
            '<link name="l"><visual><geometry><xacro:if value="1"><box/></xacro:if><xacro:if value="0"><|</xacro:if>',
            "box",
        ),
        ('<xacro:macro name="m" params="a"><link name="l"/><|</xacro:macro>', "joint"),
        ("""<xacro:if value="${'$(arg |)' == 'left'}"/>""", "side"),
        ('<gazebo><plugin name="p" filename="a.so"/><|</gazebo>', "plugin"),
        ('<xacro:include filename="other.xacro"/><xacro:include filename="hub.xacro"/><|', "xacro:hub"),
        ('<xacro:include filename="$(find |)/a.xacro"/>', "found_elsewhere"),
        (
            '<gazebo><plugin filename="|" name="gz::sim::systems::JointStatePublisher"/></gazebo>',
            "gz-sim-joint-state-publisher-system",
        ),
        ('<gazebo><plugin filename="|" name="wheel_drive"/></gazebo>', "libgazebo_ros_diff_drive.so"),
        (
            (
                '<link name="base"/><xacro:macro name="m" params="a"><link name="${a}l"/><gazebo reference="|"/>'
                '<gazebo reference="${a}l"/></xacro:macro><xacro:m a="x_"/>'
            ),
            "base",
        ),
        (
            '<xacro:macro name="many" params="a:=1 b:=1 c:=1 d:=1 e:=1 f:=1 g:=1 h:=1"/><xacro:many g="2" |/>',
            "h",
        ),
    ],
)
def test_suggestions_in_xacro(editor: Editor, tmp_path: Path, text: str, expected: str) -> None:
    around = (
        '<xacro:arg name="side" default="left"/><xacro:property name="mass" value="2"/>'
        '<xacro:macro name="wheel" params="red"><link name="${red}"/></xacro:macro>'
    )
    (tmp_path / ".git").mkdir()
    hub = (
        '<xacro:macro name="hub" params="bore"/><xacro:arg name="elsewhere" default=""/>'
        '<xacro:property name="folder" value="$(find found_elsewhere)"/>'
    )
    (tmp_path / "robot.launch").write_text(
        '<launch><param name="robot" command="xacro robot.xacro launched:=1"/></launch>'
    )
    path = written(tmp_path, other=hub, robot=around + text)
    shown = path.read_text()
    buffer = editor.open(path, shown.replace("|", ""))
    place = editor.place(buffer, shown.index("|"))
    found = editor.answers.completion(buffer, types.CompletionParams(**place))
    assert expected in [item.label for item in found.items[:5]]


def test_expressions_use_the_parameters_around_them(editor: Editor, tmp_path: Path) -> None:
    text = '<xacro:macro name="one" params="own"><a b="${|}"/></xacro:macro><xacro:macro name="two" params="other"/>'
    path = written(tmp_path, robot=f'<xacro:property name="mass" value="1"/>{text}')
    shown = path.read_text()
    buffer = editor.open(path, shown.replace("|", ""))
    found = editor.answers.completion(
        buffer, types.CompletionParams(**editor.place(buffer, shown.index("|")))
    )
    assert {item.label for item in found.items} == {"own", "mass"}


def test_files_are_suggested_by_the_names_around_them(editor: Editor, tmp_path: Path) -> None:
    (tmp_path / "meshes").mkdir()
    for name in ("elbow", "hand", "knuckle", "shoulder", "thumb", "upper_arm", "wrist"):
        (tmp_path / "meshes" / f"{name}.stl").touch()
    text = '<robot name="r"><link name="wrist"><visual><geometry><mesh filename="meshes/|"/></geometry></visual></link>'
    buffer = editor.open(tmp_path / "r.urdf", text.replace("|", ""))
    found = complete(editor.workspace, buffer, text.index("|"))
    assert found.items[0].label == "meshes/wrist.stl"
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    text = text.replace("meshes/", "file://$(find p)/meshes/")
    buffer = editor.open(tmp_path / "r.urdf.xacro", text.replace("|", ""))
    found = complete(editor.workspace, buffer, text.index("|"))
    assert found.items[0].label == "file://$(find p)/meshes/wrist.stl"


def test_parameters_of_plugins_are_spelled_as_their_neighbors(editor: Editor, tmp_path: Path) -> None:
    plugin = '<plugin name="p" filename="libgazebo_ros_diff_drive.so"><left_joint>l</left_joint><|'
    text = f'<robot name="r"><gazebo>{plugin}</plugin></gazebo></robot>'
    buffer = editor.open(tmp_path / "r.urdf", text.replace("|", ""))
    labels = [item.label for item in complete(editor.workspace, buffer, text.index("|")).items]
    assert all(label == label.lower() for label in labels[:5])


def test_versions_are_suggested_as_the_project_has_them(editor: Editor, tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    text = '<sdf version="|"><world name="w"/></sdf>'
    for path in (tmp_path / "new.sdf", tmp_path / "other.sdf"):
        buffer = editor.open(path, text.replace("|", ""))
        labels = [item.label for item in complete(editor.workspace, buffer, text.index("|")).items]
        expected = "1.12" if path.stem == "new" else "1.6"
        assert labels[0] == expected
        (tmp_path / "old.sdf").write_text(text.replace("|", "1.6"))
        editor.workspace.close()
        editor = Editor()


def test_a_macro_does_not_call_itself(editor: Editor, tmp_path: Path) -> None:
    text = '<xacro:macro name="one" params=""/><xacro:macro name="two" params=""><xacro:|</xacro:macro>'
    path = written(tmp_path, robot=text)
    shown = path.read_text()
    buffer = editor.open(path, shown.replace("|", ""))
    labels = [item.label for item in complete(editor.workspace, buffer, shown.index("|")).items]
    assert labels.index("xacro:one") < labels.index("xacro:two")


def test_a_wrong_setting_is_named_and_the_others_count(tmp_path: Path) -> None:
    workspace = Workspace()
    given = {"preview": "yes", "select": ["XML", "NOPE001"], "target": "gazeboo", "ignore": ["ALL"]}
    workspace.choose(choices_of(given, tmp_path))
    for setting in ("preview", "select", "target"):
        assert f"setting `{setting}`" in workspace.fault
    assert "`ignore`" not in workspace.fault
    assert workspace.facts(tmp_path / "m.sdf")


def test_definitions_of_an_open_text_are_known_before_it_is_saved(editor: Editor, tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    part, whole = tmp_path / "part.xacro", tmp_path / "robot.urdf.xacro"
    used = (
        f'{HEAD}  <xacro:macro name="part" params=""><link name="l" x="${{turn}}"/></xacro:macro>\n</robot>'
    )
    defined = (
        f'{HEAD}  <xacro:property name="turn" value="1"/>\n  <xacro:include filename="part.xacro"/>\n</robot>'
    )
    part.write_text(used.replace('name="r" ', ""))
    whole.write_text(defined)
    for path in (part, whole):
        editor.open(path, path.read_text().replace("turn", "turn_z"))
    editor.findings.lint(editor.workspace.buffers[editor.workspace.key(part)])
    assert [found.code for found in editor.findings.at(part)] == []
