"""Over stdio: hover, completion, and the hints beside a text."""

from __future__ import annotations

from pathlib import Path

import pytest
from lsprotocol import types

from tests.unit.lsp.texts import ROBOT, URDF
from tests.unit.lsp.wire import Session, Text

pytestmark = [pytest.mark.asyncio(loop_scope="module"), pytest.mark.xdist_group(__name__)]

MODEL = """\
<sdf version="1.12">
  <model name="m">
    <link name="arm">
      <pose>1 0 0 0 0 1.570796</pose>
      <inertial><mass>2</mass></inertial>
    </link>
    <link name="hand">
      <pose relative_to="arm">1 0 0 0 0 0</pose>
      <inertial><mass>0.5</mass></inertial>
    </link>
    <joint name="j" type="revolute">
      <parent>arm</parent>
      <child>hand</child>
      <axis><xyz>0 0 1</xyz><limit><lower>-1.5708</lower></limit></axis>
    </joint>
    <!-- of two
         lines -->
  </model>
</sdf>
"""
WORLD = """\
<sdf version="1.12">
  <world name="w">
    <include><uri>m.sdf</uri><name>one</name><pose>0 5 0 0 0 0</pose></include>
    <frame name="g" attached_to="one::hand"/>
  </world>
</sdf>
"""


async def test_hover_says_what_a_place_is_for(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    lower = await text.hover("<lower>", 2)
    for part in ("`joint/axis/limit/lower`", "`double`", "in rad", "SDFormat"):
        assert part in lower
    assert "required" in await text.hover("type=", 1)
    assert "since 1.7" in await text.hover("relative_to", 2)


async def test_hover_knows_places_masses_and_joints(session: Session, folder: Path) -> None:
    (folder / "w.sdf").write_text(WORLD)
    text = session.open(folder / "m.sdf", MODEL)
    arm = await text.hover('"arm"', 2)
    assert "`1 0 0` m, rpy `0 0 90" in arm
    assert "2 kg" in arm
    assert "1 link hangs on it: 0.5 kg" in arm
    assert "`1 1 " in await text.hover('"hand"', 2)
    assert "revolute: `arm` → `hand`" in await text.hover('"j"', 1)
    assert "link `arm`" in await text.hover(">arm<", 2)


async def test_hover_knows_scoped_names(session: Session, folder: Path) -> None:
    (folder / "m.sdf").write_text(MODEL)
    text = session.open(folder / "w.sdf", WORLD)
    hand = await text.hover("::hand", 3)
    assert "link `hand`" in hand
    assert "m.sdf" in hand
    assert "`one::hand`" in hand
    assert "in the world: `1 6 " in hand


async def test_hover_knows_xacro(session: Session, folder: Path) -> None:
    text = session.open(folder / "r.urdf.xacro", ROBOT)
    size = await text.hover("size * 2", 1)
    assert "value `0.5`" in size
    assert "set in line 3" in size
    assert "macro `ball`" in await text.hover("xacro:ball", 8)


async def test_hover_knows_the_parameters_of_a_macro(session: Session, folder: Path) -> None:
    macro = '<!-- A leg\n of two links. --><xacro:macro name="leg" params="side length:=0.3 *origin"/>'
    text = session.open(
        folder / "r.urdf.xacro", ROBOT.replace("</robot>", f'{macro}<xacro:leg side="l"/></robot>')
    )
    shown = await text.hover("<xacro:leg ", 8)
    assert "A leg of two links." in shown
    assert (
        "- `side`: required\n- `length:=0.3`: optional\n- `*origin`: an element inside of the call" in shown
    )


async def test_hover_knows_what_consumers_do(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL.replace(">hand<", ">hnd<"))
    await text.diagnostics()
    assert "- gazebo: " in (await text.hover(">hnd<", 2)).lower()


async def test_hover_says_nothing_where_there_is_nothing(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    assert await text.hover("of two") == ""


async def test_symbols_of_a_file(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    found = await session.client.text_document_document_symbol_async(
        types.DocumentSymbolParams(text.identifier)
    )
    (top,) = [each for each in found or () if isinstance(each, types.DocumentSymbol)]
    (model,) = top.children or ()
    assert [(child.name, child.detail) for child in model.children or ()] == [
        ("arm", "link"),
        ("hand", "link"),
        ("j", "joint revolute"),
    ]
    for child in model.children or ():
        assert text.cut(child.selection_range) == child.name
        assert text.cut(child.range).startswith("<")


async def test_symbols_of_the_project(session: Session, folder: Path) -> None:
    (folder / "m.sdf").write_text(MODEL.replace('"hand"', '"far_hand"'))
    text = session.open(folder / "n.sdf", MODEL.replace('"hand"', '"near_hand"'), save=False)
    found = await session.client.workspace_symbol_async(types.WorkspaceSymbolParams("r_hnd"))
    places = {each.name: each.location.uri for each in found or ()}
    assert places == {"far_hand": (folder / "m.sdf").as_uri(), "near_hand": text.uri}


async def test_folding(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    found = await session.client.text_document_folding_range_async(types.FoldingRangeParams(text.identifier))
    ranges = {(each.start_line, each.end_line, each.kind) for each in found or ()}
    assert {(0, 17, None), (2, 4, None), (10, 13, None), (15, 16, types.FoldingRangeKind.Comment)} <= ranges


async def test_links(session: Session, folder: Path) -> None:
    (folder / "arm.dae").touch()
    text = session.open(folder / "r.urdf", URDF)
    (found,) = (
        await session.client.text_document_document_link_async(types.DocumentLinkParams(text.identifier))
        or ()
    )
    assert found.target == (folder / "arm.dae").as_uri()
    assert text.cut(found.range) == "arm.dae"


async def hints(text: Text) -> dict[str, str]:
    """The hints, by the word before them."""
    everything = types.Range(types.Position(0, 0), types.Position(text.text.count("\n"), 0))
    found = await text.client.text_document_inlay_hint_async(
        types.InlayHintParams(text.identifier, everything)
    )
    start = types.Position(0, 0)
    return {text.cut(types.Range(start, hint.position)).split()[-1]: str(hint.label) for hint in found or ()}


async def test_hints(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    shown = await hints(text)
    assert shown["1.570796"] == "0 0 90°"
    assert shown["1</xyz><limit><lower>-1.5708"] == "-90°"
    assert shown['name="m'] == "2.5 kg"
    robot = session.open(folder / "r.urdf", URDF)
    assert (await hints(robot))["3.141593"] == "0 0 180°"


async def test_colors_of_names(session: Session, folder: Path) -> None:
    (folder / "m.sdf").write_text(MODEL)
    text = session.open(folder / "w.sdf", WORLD)
    assert session.answer is not None
    provider = session.answer.capabilities.semantic_tokens_provider
    assert isinstance(provider, types.SemanticTokensOptions)
    kinds = provider.legend.token_types
    found = await session.client.text_document_semantic_tokens_full_async(
        types.SemanticTokensParams(text.identifier)
    )
    assert found is not None
    line = column = 0
    shown = []
    for at in range(0, len(found.data), 5):
        down, right, length, kind, modifiers = found.data[at : at + 5]
        line, column = line + down, right if down else column + right
        where = types.Range(types.Position(line, column), types.Position(line, column + length))
        shown.append((text.cut(where), kinds[kind], bool(modifiers)))
    assert ("w", "namespace", True) in shown
    assert ("one", "namespace", True) in shown
    assert ("hand", "class", False) in shown
    part = await session.client.text_document_semantic_tokens_range_async(
        types.SemanticTokensRangeParams(text.identifier, text.range("one::hand"))
    )
    assert part is not None
    assert len(part.data) == 10
