"""Over stdio: diagnostics, and what can be done about them."""

from __future__ import annotations

import asyncio
from pathlib import Path

import pytest
from lsprotocol import types

from tests.unit.lsp.wire import Session

pytestmark = [pytest.mark.asyncio(loop_scope="module"), pytest.mark.xdist_group(__name__)]

MODEL = """\
<sdf version="1.12">
  <model name="m">
    <link name="arm"/>
    <link name="hand"/>
    <joint name="j" type="fixed">
      <parent>arm</parent>
      <child>hnd</child>
    </joint>
    <frame name="f" attached_to="arm"/>
  </model>
</sdf>
"""
WORLD = """\
<sdf version="1.12">
  <world name="w">
    <include>
      <uri>m.sdf</uri>
      <name>m</name>
    </include>
  </world>
</sdf>
"""
MACROS = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="m"><link name="a"/></xacro:macro>
</robot>
"""
ROBOT = (
    '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    '<xacro:include filename="macros.xacro"/><xacro:m/></robot>'
)


async def test_a_diagnostic_has_all_that_clients_show(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL.replace('name="hand"', 'name="arm"'))
    found = await text.diagnostics()
    double = next(each for each in found if each.range == text.range('"arm"/>\n    <joint', 1, 3))
    assert double.severity is types.DiagnosticSeverity.Error
    assert double.source == "sdfcheck"
    assert double.code_description is not None
    assert double.code_description.href.endswith("/duplicate-name/")
    (related,) = double.related_information or ()
    assert related.location == types.Location(text.uri, text.range('"arm"', 1, 3))


async def test_old_names_are_struck_through(session: Session, folder: Path) -> None:
    gps = '<link name="arm"><sensor name="s" type="navsat"><gps/></sensor></link>'
    text = session.open(folder / "m.sdf", MODEL.replace("hnd", "hand").replace('<link name="arm"/>', gps))
    (found,) = await text.diagnostics()
    assert list(found.tags or ()) == [types.DiagnosticTag.Deprecated]
    assert text.cut(found.range) == "gps"


async def test_other_arguments_bring_diagnostics_when_the_text_rests(session: Session, folder: Path) -> None:
    text = session.open(
        folder / "r.urdf.xacro",
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="imu" default="false"/>'
        '<link name="base"/><xacro:if value="$(arg imu)"><joint name="j" type="fixed"><parent link="base"/>'
        '<child link="imu"/></joint></xacro:if></robot>',
    )

    def said(found: list[types.Diagnostic]) -> list[str]:
        return [each.message.split("`")[3] for each in found if "(with `imu:=true`)" in each.message]

    await text.diagnostics(lambda found: said(found) == ["j"])
    text.change('"j"', '"k"')
    await text.diagnostics(lambda found: said(found) == ["k"])


async def test_typing_brings_new_diagnostics(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    (first,) = await text.diagnostics()
    assert text.cut(first.range) == "hnd"
    text.change("hnd", "hand")
    await text.diagnostics(lambda found: not found)
    text.change('<link name="arm"/>', '<link name="arm"')
    found = await text.diagnostics()
    assert {(each.code, each.range.start.line) for each in found} == {("XML001", 2)}
    text.change('<link name="arm"', '<link name="arm"/>')
    await text.diagnostics(lambda found: not found)


async def test_an_overtaken_result_is_not_sent(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    await text.diagnostics()
    for number in range(40):
        text.replace(MODEL.replace("hnd", f"hnd{number}"))
        if not number % 8:
            await asyncio.sleep(0.05)
    await text.diagnostics(lambda found: any("`hnd39`" in each.message for each in found))
    sent = [params for params in session.published if params.uri == text.uri and params.diagnostics]
    versions = [params.version or 0 for params in sent]
    assert versions == sorted(versions)
    for params in sent:  # what is said fits the version that it is said of
        assert params.version == 1 or f"`hnd{(params.version or 0) - 2}`" in params.diagnostics[0].message
    if not session.pulls:
        assert versions[-1] == text.version


async def test_an_included_file_is_linted_for_its_includer(session: Session, folder: Path) -> None:
    (folder / "m.sdf").write_text(MODEL)
    world = session.open(folder / "w.sdf", WORLD)
    await session.waited(lambda: bool(session.pushed(folder / "m.sdf")))
    (found,) = session.pushed(folder / "m.sdf")
    assert [each.location for each in found.related_information or ()][-1:] == [
        types.Location(world.uri, world.range("m.sdf"))
    ]
    model = session.open(folder / "m.sdf", MODEL)
    await model.diagnostics()
    model.change("hnd", "hand")
    await model.diagnostics(lambda found: not found)
    session.close(world)
    await session.waited(lambda: not session.pushed(world.path))


async def test_macros_are_linted_for_their_robots(session: Session, folder: Path) -> None:
    (folder / "r.urdf.xacro").write_text(ROBOT)
    session.notice(folder / "r.urdf.xacro", types.FileChangeType.Created)
    text = session.open(folder / "macros.xacro", MACROS)
    await text.diagnostics(lambda found: not found)
    text.change('<link name="a"/>', '<link name="a"/><link name="a"/>')
    found = await text.diagnostics()
    assert any("`a`" in each.message for each in found)


async def test_a_closed_text_is_what_the_file_holds(session: Session, folder: Path) -> None:
    (folder / "m.sdf").write_text(MODEL.replace("hnd", "hand"))
    world = session.open(folder / "w.sdf", WORLD)
    model = session.open(folder / "m.sdf", MODEL, save=False)
    await model.diagnostics()
    session.close(model)
    await session.waited(lambda: not session.pushed(model.path))
    await world.diagnostics(lambda found: not found)


async def test_a_quick_fix(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    (found,) = await text.diagnostics()
    fix, ignore = await text.actions(found.range, "quickfix")
    assert fix.title.startswith("Write `hand`")
    assert fix.diagnostics is not None
    assert fix.diagnostics[0].range == found.range
    assert session.applied(fix.edit) == {"m.sdf": MODEL.replace("hnd", "hand")}
    assert ignore.title == "Ignore unknown-joint-end here"
    text.replace(session.applied(ignore.edit)["m.sdf"])
    await text.diagnostics(lambda found: not found)


async def test_all_safe_fixes(session: Session, folder: Path) -> None:
    mistakes = MODEL.replace('<link name="hand"/>', '<link name="hand"/>\n    <drake:joint name="k"/>')
    text = session.open(folder / "m.sdf", mistakes)
    await text.diagnostics()
    everything = types.Range(types.Position(0, 0), types.Position(0, 0))
    (action,) = await text.actions(everything, "source.fixAll")
    assert action.kind == "source.fixAll.sdfcheck"
    after = session.applied(action.edit)["m.sdf"]
    assert after == mistakes.replace('"1.12">', '"1.12" xmlns:drake="http://drake.mit.edu">')
    assert "hnd" in after, "the fix of that is not safe"


async def test_columns_after_tabs_and_characters_beyond_the_first_plane(
    session: Session, folder: Path
) -> None:
    wide = MODEL.replace("      <child>hnd", "\t<!-- \U0001f916\U0001f9be é --><child>hnd")
    text = session.open(folder / "m.sdf", wide)
    (found,) = await text.diagnostics()
    assert text.cut(found.range) == "hnd"
    expected = {"utf-8": 1 + 5 + 8 + 1 + 2 + 4 + 7, "utf-16": 1 + 5 + 4 + 1 + 1 + 4 + 7}
    assert found.range.start.character == expected[session.encoding]
    assert "child" in await text.hover("<child>", 2)
    text.change("hnd", "\U0001f916")
    await text.diagnostics(lambda found: any("\U0001f916" in each.message for each in found))
    text.change("\U0001f916</child>", "hand</child>")
    await text.diagnostics(lambda found: not found)
