"""The answers of the server about a place, without the protocol."""

from __future__ import annotations

import random
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
from lsprotocol import types
from lsprotocol.converters import get_converter

from sdfcheck.lsp.answers import Answers, survey
from sdfcheck.lsp.completion import complete
from sdfcheck.lsp.context import Item
from sdfcheck.lsp.edits import Edits
from sdfcheck.lsp.findings import Findings
from sdfcheck.lsp.hints import hints, tokens
from sdfcheck.lsp.hover import hover
from sdfcheck.lsp.names import everywhere, occurrences
from sdfcheck.lsp.outline import Part, links, outline
from sdfcheck.lsp.rename import Refused, Target, rename
from sdfcheck.lsp.speech import ProtocolTypes, Units
from sdfcheck.lsp.workspace import Workspace
from sdfcheck.source.document import Document
from sdfcheck.source.text import Source
from tests.unit.lsp.texts import ROBOT

SDF = """\
<sdf version="1.12">
  <model name="m">
    <link name="arm"><pose>1 0 0 0 0 1.570796</pose><inertial><mass>2</mass></inertial></link>
    <link name="hand"><pose relative_to="arm">1 0 0 0 0 0</pose></link>
    <joint name="j" type="revolute">
      <parent>arm</parent>
      <child>hand</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-3.141593</lower></limit></axis>
    </joint>
    <plugin name="p" filename="x"><joint_name>j</joint_name></plugin>
  </model>
</sdf>
"""
URDF = """\
<robot name="r">
  <material name="red"><color rgba="1 0 0 1"/></material>
  <link name="base"><visual><geometry><sphere radius="1"/></geometry><material name="red"/></visual></link>
  <link name="tip"/>
  <joint name="tip" type="fixed"><parent link="base"/><child link="tip"/><origin rpy="0 0 3.141593"/></joint>
  <gazebo reference="base"><gravity>true</gravity></gazebo>
  <ros2_control name="c" type="system"><joint name="tip"><command_interface name="position"/></joint></ros2_control>
</robot>
"""


def opened(text: str, path: Path = Path("there/m.sdf")) -> tuple[Workspace, Document]:
    workspace = Workspace()
    workspace.open("file:///there/m", path, text, 1)
    document = workspace.document(path)
    assert document is not None
    return workspace, document


def offered(marked: str, name: str = "there/m.sdf") -> dict[str, Item]:
    """The items that are offered at the ``|`` in a text."""
    offset = marked.index("|")
    workspace, document = opened(marked.replace("|", "", 1), Path(name))
    buffer = workspace.buffers[workspace.key(document.path)]
    return {item.label: item for item in complete(workspace, buffer, offset).items}


def hover_text(text: str, mark: str, skip: int = 0, path: str = "there/m.sdf") -> str:
    """The hover at the beginning of a piece of text."""
    _, document = opened(text, Path(path))
    found = hover(document, text.index(mark) + skip)
    return "" if found is None else found.text


def places(text: str, mark: str, skip: int = 0, path: str = "there/m.sdf") -> list[str]:
    """The lines in which what is named at a place is named."""
    workspace, document = opened(text, Path(path))
    named = occurrences(document).at(text.index(mark) + skip)
    assert named is not None
    found = everywhere(workspace, document, named.symbol)
    return [f"{each.span.begin.line}:{each.span.text}" for each in found]


def test_elements_are_offered_with_what_they_need() -> None:
    found = offered('<sdf version="1.12"><model name="m"><|</model></sdf>')
    assert "link" in found
    assert found["joint"].text.startswith('joint name="" type="')
    assert "<parent></parent>" in found["joint"].text
    assert "drake:joint" in found
    assert "link" not in offered('<sdf version="1.12"><world name="w"><|')


def test_only_what_the_version_has_is_offered() -> None:
    assert "frame" in offered('<sdf version="1.7"><model name="m"><|')
    assert "gps" not in offered('<sdf version="1.12"><model name="m"><link name="l"><|')


@pytest.mark.parametrize(
    ("marked", "labels"),
    [
        ('<sdf version="1.12"><model |', {"name", "canonical_link"}),
        ('<sdf version="1.12"><model name="m"><joint name="j" type="|', {"revolute", "fixed"}),
        ('<sdf version="1.12"><model name="m"><static>|', {"true", "false"}),
        (
            '<sdf version="1.12"><model name="m"><link name="a"/><frame name="f" attached_to="|"/></model></sdf>',
            {"a"},
        ),
        ('<sdf version="1.12"><world name="w"><plugin filename="|', {"gz-sim-physics-system"}),
        (
            '<robot name="r"><link name="a"/><joint name="j" type="fixed"><parent link="|"/></joint></robot>',
            {"a"},
        ),
        ('<robot name="r"><ros2_control name="c"><joint name="j"><|', {"command_interface"}),
        ('<robot name="r"><ros2_control name="c"><joint name="j"><command_interface name="|', {"velocity"}),
        ('<robot name="r"><link name="a"><|', {"visual", "inertial", "/link"}),
        ("<|", {"sdf", "robot"}),
        ('<sdf version="1.12"><model name="m"></|', {"model"}),
    ],
)
def test_names_that_fit_are_offered(marked: str, labels: set[str]) -> None:
    assert labels <= offered(marked).keys()


def test_xacro_is_offered() -> None:
    text = ROBOT.replace('<link name="base"/>', "<|")
    found = offered(text, "there/m.xacro")
    assert "name size" in found["xacro:ball"].detail
    assert "size" in offered(ROBOT.replace("${size * 2}", "${|}"), "there/m.xacro")
    assert "side" in offered(ROBOT.replace("$(arg side)", "$(arg |)"), "there/m.xacro")
    assert {"name", "size"} <= offered(
        ROBOT.replace('<link name="base"/>', "<xacro:ball |/>"), "there/m.xacro"
    ).keys()


def test_files_are_offered(tmp_path: Path) -> None:
    (tmp_path / "meshes").mkdir()
    (tmp_path / "meshes" / "arm.dae").touch()
    (tmp_path / "meshes" / "arm.txt").touch()
    text = '<sdf version="1.12"><model name="m"><link name="l"><visual name="v"><geometry><mesh><uri>meshes/|</uri>'
    found = offered(text, str(tmp_path / "m.sdf"))
    assert "meshes/arm.dae" in found
    assert "meshes/arm.txt" not in found


def test_nothing_is_offered_in_comments() -> None:
    assert not offered('<sdf version="1.12"><!-- <|')


def test_hover_knows_poses_and_masses() -> None:
    text = hover_text(SDF, '"hand"', 2)
    assert "1 1 0" in text
    assert "90" in text
    assert "2 kg" in hover_text(SDF, '"arm"', 2)
    assert "1 link hangs on it" in hover_text(SDF, '"arm"', 2)
    assert "revolute: `arm` → `hand`" in hover_text(SDF, '"j"', 1)


def test_hover_knows_the_format() -> None:
    assert "in rad" in hover_text(SDF, "<lower>", 2)
    assert "required" in hover_text(SDF, "type=", 1)
    assert "urdfdom" not in hover_text(URDF, "<sphere", 2, "there/m.urdf")
    assert "URDF" in hover_text(URDF, "<sphere", 2, "there/m.urdf")


def test_hover_knows_properties_of_xacro() -> None:
    assert "0.5" in hover_text(ROBOT, "size * 2", 1, "there/m.xacro")


def test_references_of_all_kinds() -> None:
    assert places(SDF, '"arm"', 2) == ["3:arm", "4:arm", "6:arm"]
    assert places(SDF, '"j"', 1) == ["5:j", "10:j"]
    assert places(URDF, '"red"', 2, "there/m.urdf") == ["2:red", "3:red"]
    assert places(URDF, '"base"', 2, "there/m.urdf") == ["3:base", "5:base", "6:base"]


def test_a_joint_with_the_name_of_a_link_is_another() -> None:
    assert places(URDF, '<joint name="tip"', 13, "there/m.urdf") == ["5:tip", "7:tip"]
    assert places(URDF, '<link name="tip"', 12, "there/m.urdf") == ["4:tip", "5:tip"]


def test_xacro_names_have_scopes() -> None:
    outer = places(ROBOT, '"size"', 2, "there/m.xacro")
    assert outer == ["3:size", "7:size"]
    assert places(ROBOT, "size:=1", 1, "there/m.xacro") == ["4:size", "5:size", "7:size"]
    ended = ROBOT.replace('2}"/>', '2}"></xacro:ball>')
    assert places(ended, '"ball"', 2, "there/m.xacro") == ["4:ball", "7:xacro:ball", "7:xacro:ball"]
    assert places(ROBOT, '"side"', 2, "there/m.xacro") == ["2:side", "7:side"]


@pytest.mark.parametrize("name", ["hand", "a::b", "", "__model__", " x"])
def test_names_that_cannot_be(name: str) -> None:
    workspace, document = opened(SDF)
    named = occurrences(document).at(SDF.index('"arm"') + 1)
    assert named is not None
    with pytest.raises(Refused):
        rename(workspace, document, Target(named, named.span), name)


def test_the_world_is_not_renamed_where_it_is_called_world() -> None:
    text = '<sdf version="1.12"><world name="w"><frame name="f" attached_to="world"/></world></sdf>'
    assert places(text, '"w"', 1) == ["1:w"]


def test_the_outline_has_the_parts() -> None:
    _, document = opened(SDF)
    assert outline(document.source, shown).parts == ["sdf(m(arm(), hand(), j(), p()))"]


@pytest.mark.parametrize("seed", range(40))
def test_an_outline_that_follows_edits_is_that_of_the_text(seed: int) -> None:
    chance = random.Random(seed)
    model = '<model name="m{}"><link name="a"><visual name="v"/></link>\n <joint name="j" type="fixed"/>\n</model>\n'
    text = '<sdf version="1.12">\n' + "".join(map(model.format, range(9))) + "</sdf>"
    pieces = ("\n", "<", "x", "</link>", "<!--", "-->", '<link name="l">', "<material name='c'/>", "")

    def made(part: Part[str], end: int) -> str:
        places = [source.position(offset) for offset in (*part[3:6], end)]
        return f"{part[:3]} {places} {part[6]}"

    source = Source(Path("w.sdf"), text)
    known = outline(source, made)
    for _ in range(12):
        at = chance.randrange(len(text))
        text = text[:at] + chance.choice(pieces) + text[at + chance.randrange(3) :]
        source = Source(Path("w.sdf"), text)
        known = outline(source, made, known)
        assert known.parts == outline(source, made).parts


@pytest.mark.parametrize("units", list(Units))
@pytest.mark.parametrize("name", ["a", "100%d", "&quot;line&quot;:7", "é"])
def test_links_that_are_written_as_earlier_ones_are_outlined_like_them(name: str, units: Units) -> None:
    answers = Answers.__new__(Answers)
    answers.speech = cast("Any", SimpleNamespace(units=units))
    link = f'<link name="{name}">\n <visual name="v"/>\n</link>\n'
    model = f'<model name="m">\n  {link}{link}</model>\n'
    chance = random.Random(7)
    pieces = ("\n", "<", "x", "</link>", "<!--", "-->", '<link name="l">', " ", "")
    text = f'<sdf version="1.12">\n{model * 5}</sdf>'
    for _ in range(60):
        source = Source(Path("w.sdf"), text)
        made, moved = answers._written_symbol(source), answers._moved_symbol(source)
        assert (moved is None) == (not text.isascii() and units is not Units.UTF32)
        plain, repeated = outline(source, made), outline(source, made, None, moved)
        assert (repeated.parts, repeated.units) == (plain.parts, plain.units)
        at = chance.randrange(len(text))
        text = text[:at] + chance.choice(pieces) + text[at + chance.randrange(3) :]


def shown(part: Part[str], _: int) -> str:
    """A part of an outline with those in it."""
    return f"{part[2]}({', '.join(part[-1])})"


def test_hints_show_degrees_and_masses() -> None:
    _, document = opened(SDF)
    texts = [hint.text for hint in hints(document, document.source.span(0, len(SDF)))]
    assert "0 0 90°" in texts
    assert "-180°" in texts
    assert any(text.endswith(" kg") for text in texts)


def test_tokens_are_the_names() -> None:
    _, document = opened(SDF)
    assert [token.span.text for token in tokens(document)].count("arm") == 3


def test_links_lead_to_files(tmp_path: Path) -> None:
    (tmp_path / "a.dae").touch()
    mesh = '<visual><geometry><mesh filename="a.dae"/></geometry></visual>'
    text = f'<robot name="r"><link name="l">{mesh}</link></robot>'
    _, document = opened(text, tmp_path / "r.urdf")
    assert [link.target.name for link in links(document)] == ["a.dae"]


def test_the_project_is_searched(tmp_path: Path) -> None:
    (tmp_path / "m.sdf").write_text(SDF)
    workspace = Workspace()
    workspace.folders = (tmp_path,)
    assert [found.name for found in survey(workspace, "hnd")] == ["hand"]


def test_unsaved_macros_count_for_their_includers(tmp_path: Path) -> None:
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    macros = head.replace(' name="r"', "") + '<xacro:macro name="m"><link name="a"/></xacro:macro></robot>'
    main = f'{head}<xacro:include filename="macros.xacro"/><xacro:m/></robot>'
    (tmp_path / "macros.xacro").write_text(macros)
    (tmp_path / "r.urdf.xacro").write_text(main)
    workspace = Workspace()
    findings = Findings(workspace)
    path = tmp_path / "macros.xacro"
    text = macros.replace('<link name="a"/>', '<link name="a"/><link name="a"/>')
    buffer = workspace.open(path.as_uri(), path, text, 1)
    try:
        findings.lint(buffer)
        (root,) = findings.includers(buffer)
        findings.lint_from_disk(root)
        assert any("a" in found.message for found in findings.at(path))
    finally:
        workspace.close()


def test_included_files_are_linted_for_their_includers(tmp_path: Path) -> None:
    (tmp_path / "m.sdf").write_text(SDF.replace("<child>hand", "<child>hnd"))
    world = '<sdf version="1.12"><world name="w"><include><uri>m.sdf</uri></include></world></sdf>'
    workspace = Workspace()
    findings = Findings(workspace)
    buffer = workspace.open("file:///w", tmp_path / "w.sdf", world, 1)
    findings.lint(buffer)
    (found,) = findings.at(tmp_path / "m.sdf")
    assert found.origins[-1].span.source is buffer.source


def test_lines_above_definitions_lead_to_places_where_the_client_can() -> None:
    workspace, document = opened(ROBOT, Path("there/r.xacro"))
    buffer = workspace.buffers[workspace.key(document.path)]
    speech = ProtocolTypes(workspace)
    edits = Edits(workspace, speech)
    ball = next(lens for lens in edits.lenses(buffer, None) if lens.range.start.line == 3)
    plain = edits.counted(buffer, ball).command
    assert plain is not None
    assert (plain.title, plain.command, plain.arguments) == ("1 reference", "", None)
    speech.client = types.ClientCapabilities(experimental={"commands": ["sdfcheck.references"]})
    able = edits.counted(buffer, ball).command
    assert able is not None
    assert (able.title, able.command) == ("1 reference", "sdfcheck.references")
    sent = get_converter().unstructure(able)
    uri, position, places = sent["arguments"]
    assert uri == "file:///there/m"
    assert position == {"line": 3, "character": 21}
    assert [place["range"]["start"]["line"] for place in places] == [6]
