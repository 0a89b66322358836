"""Over stdio: formatting, colors, signatures, linked tags, selections, lenses, moved files, commands."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from lsprotocol import types
from pygls.exceptions import JsonRpcException

from tests.unit.lsp.texts import ROBOT, URDF
from tests.unit.lsp.wire import Session, Text, offset

pytestmark = [pytest.mark.asyncio(loop_scope="module"), pytest.mark.xdist_group(__name__)]

MODEL = """\
<sdf version="1.12">
  <model name="m">
      <link name="é𝛼"><inertial><mass>2.500</mass></inertial>
      <visual name="v"><geometry><sphere><radius>0.10</radius></sphere></geometry>
      <material><ambient>1 0 0.5 1</ambient><diffuse>0 0.25 1</diffuse></material></visual></link>
  </model>
</sdf>
"""


def commanded(text: Text, name: str, **given: Any) -> Any:
    """The answer to a command about a text."""
    params = types.ExecuteCommandParams(name, [{"uri": text.uri, **given}])
    return text.client.workspace_execute_command_async(params)


def item(found: Any, name: str) -> Any:
    return found[name] if isinstance(found, dict) else getattr(found, name)


async def test_format_is_the_canonical_form(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    params = types.DocumentFormattingParams(text.identifier, types.FormattingOptions(4, True))
    edits = await text.client.text_document_formatting_async(params)
    assert edits
    after = session.applied(types.WorkspaceEdit(changes={text.uri: list(edits)}))["m.sdf"]
    assert '    <link name="é𝛼">\n      <inertial>\n        <mass>2.5</mass>\n' in after
    text.replace(after)
    assert not await text.client.text_document_formatting_async(params)


@pytest.mark.parametrize(
    ("name", "written", "words"),
    [("r.xacro", ROBOT, "no canonical form"), ("m.sdf", MODEL.replace("</link>", ""), "broken")],
)
async def test_texts_that_are_not_formatted(
    name: str, written: str, words: str, session: Session, folder: Path
) -> None:
    text = session.open(folder / name, written)
    params = types.DocumentFormattingParams(text.identifier, types.FormattingOptions(2, True))
    assert not await text.client.text_document_formatting_async(params)
    await session.waited(lambda: any(words in said.message for said in text.client.messages))


async def test_colors_are_shown_and_chosen(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    params = types.DocumentColorParams(text.identifier)
    found = await text.client.text_document_document_color_async(params)
    assert [text.cut(each.range) for each in found] == ["1 0 0.5 1", "0 0.25 1"]
    assert found[0].color == types.Color(1.0, 0.0, 0.5, 1.0)
    ranges = [each.range for each in found]
    for place, color, written in [
        (ranges[0], types.Color(0.0, 1 / 3, 0.0, 0.5), "0 0.333 0 0.5"),
        (ranges[1], types.Color(0.0, 0.2, 1.0, 1.0), "0 0.2 1"),
        (ranges[1], types.Color(0.0, 0.2, 1.0, 0.5), "0 0.2 1 0.5"),
    ]:
        wanted = types.ColorPresentationParams(text.identifier, color, place)
        (one,) = await text.client.text_document_color_presentation_async(wanted)
        assert one.label == written
        assert one.text_edit == types.TextEdit(place, written)
    red = {"red": 1, "green": 0, "blue": 0, "alpha": 1}
    where = {"start": {"line": 4, "character": 25}, "end": {"line": 4, "character": 34}}
    given = {"textDocument": {"uri": text.uri}, "color": red, "range": where}
    (one,) = await session.raw("textDocument/colorPresentation", given)
    assert item(one, "label") == "1 0 0 1"


async def test_colors_of_urdf(session: Session, folder: Path) -> None:
    text = session.open(
        folder / "r.urdf",
        '<robot name="r"><material name="red"><color rgba="1 0 0 1"/></material><link name="l"><visual>'
        '<origin xyz="1 0 1"/><geometry><box size="1 1 1"/></geometry><material name="m"><color rgba="2 0 0 1"/>'
        "</material></visual></link></robot>",
    )
    found = await text.client.text_document_document_color_async(types.DocumentColorParams(text.identifier))
    assert [text.cut(each.range) for each in found] == ["1 0 0 1"]


async def test_the_parameters_of_a_macro(session: Session, folder: Path) -> None:
    text = session.open(
        folder / "r.xacro", ROBOT.replace("  <xacro:macro", "  <!-- A\n  ball. -->\n  <xacro:macro")
    )

    async def asked(mark: str, skip: int) -> types.SignatureHelp | None:
        params = types.SignatureHelpParams(**text.at(mark, skip))
        return await text.client.text_document_signature_help_async(params)

    found = await asked('<xacro:ball name="$(arg', 18)
    assert found is not None
    (one,) = found.signatures
    assert one.label == "xacro:ball name size:=1"
    assert one.documentation == "A ball."
    assert [one.label[slice(*each.label)] for each in one.parameters or ()] == ["name", "size:=1"]
    assert found.active_parameter == 0
    found = await asked('size="${size * 2}"', 0)
    assert found is not None
    assert found.active_parameter == 1
    assert await asked('<link name="base"', 8) is None
    assert await asked("<xacro:property ", 16) is None


async def test_tags_are_linked(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", MODEL)
    for mark, skip, name in [("<link", 3, "link"), ("</link", 6, "link"), ("</mass", 2, "mass")]:
        params = types.LinkedEditingRangeParams(**text.at(mark, skip))
        found = await text.client.text_document_linked_editing_range_async(params)
        assert found is not None
        assert [text.cut(each) for each in found.ranges] == [name, name]
    params = types.LinkedEditingRangeParams(**text.at("2.500"))
    assert await text.client.text_document_linked_editing_range_async(params) is None
    text.replace(MODEL.replace("</mass>", "</mess>"))
    params = types.LinkedEditingRangeParams(**text.at("<mass", 2))
    assert await text.client.text_document_linked_editing_range_async(params) is None


async def test_selections_grow(session: Session, folder: Path) -> None:
    text = session.open(folder / "r.xacro", ROBOT)
    params = types.SelectionRangeParams(text.identifier, [text.position('name="$(arg side)"', 8)])
    (found,) = await text.client.text_document_selection_range_async(params) or ()
    grown = []
    at: types.SelectionRange | None = found
    while at is not None:
        grown.append(text.cut(at.range))
        at = at.parent
    call = '<xacro:ball name="$(arg side)" size="${size * 2}"/>'
    assert grown[:3] == ["$(arg side)", 'name="$(arg side)"', call]
    assert grown[-1] == ROBOT
    assert all(inner in outer for inner, outer in pairwise(grown))


async def test_names_are_extracted(session: Session, folder: Path) -> None:
    unused = '<xacro:arg name="unused" default="1"/>\n</robot>'
    text = session.open(folder / "r.xacro", ROBOT.replace("</robot>", unused))
    actions = await text.actions(text.range("* 2", 2), "refactor")
    assert [(action.title, action.kind) for action in actions] == [
        ("Extract property `ball_size`", "refactor.extract.sdfcheck")
    ]
    after = session.applied(actions[0].edit)["r.xacro"]
    assert '  <xacro:property name="ball_size" value="2"/>\n  <xacro:ball ' in after
    assert 'size="${size * ball_size}"' in after
    (action,) = await text.actions(text.range('<link name="base"/>'), "refactor.extract")
    assert "<xacro:base_macro/>" in session.applied(action.edit)["r.xacro"]
    assert not await text.actions(text.range("* 2", 2), "refactor.inline")


async def test_lenses_count_uses(session: Session, folder: Path) -> None:
    (folder / "robot.xacro").write_text(
        '<robot name="x" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:include filename="r.xacro"/>'
        '<xacro:ball name="y"></xacro:ball></robot>'
    )
    session.notice(folder / "robot.xacro", types.FileChangeType.Created)
    text = session.open(folder / "r.xacro", ROBOT)

    async def shown() -> dict[str, str]:
        params = types.CodeLensParams(text.identifier)
        found = await text.client.text_document_code_lens_async(params) or ()
        done = [await text.client.code_lens_resolve_async(lens) for lens in found]
        return {text.cut(lens.range): lens.command.title for lens in done if lens.command is not None}

    assert await shown() == {
        "robot": "included by 1 file",
        "ball": "2 references",
        "base": "0 references",
        "${name}_ball": "0 references",
    }


async def test_lenses_of_a_model_that_a_world_includes(session: Session, folder: Path) -> None:
    (folder / "arm").mkdir()
    (folder / "w.sdf").write_text(
        '<sdf version="1.12"><world name="w"><include><uri>arm/m.sdf</uri></include></world></sdf>'
    )
    text = session.open(folder / "arm" / "m.sdf", MODEL)
    found = await text.client.text_document_code_lens_async(types.CodeLensParams(text.identifier)) or ()
    done = [await text.client.code_lens_resolve_async(lens) for lens in found]
    assert done[0].command is not None
    assert done[0].command.title == "included by 1 file"


async def test_moved_files_are_followed(session: Session, folder: Path) -> None:
    for name in ("meshes/arm.dae", "meshes/other.dae", "package.xml"):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text("<package><name>pkg</name></package>")
    robot = (
        '<robot name="r"><link name="a"><visual><geometry><mesh filename="../meshes/arm.dae"/></geometry></visual>'
        '<collision><geometry><mesh filename="../meshes/other.dae"/></geometry></collision></link></robot>'
    )
    text = session.open(folder / "urdf" / "r.urdf", robot)
    macro = ROBOT.replace('  <link name="base"/>', '  <xacro:include filename="urdf/r.urdf"/>')
    (folder / "top.xacro").write_text(macro)

    async def moved(old: str, new: str) -> dict[str, str]:
        rename = types.FileRename((folder / old).as_uri(), (folder / new).as_uri())
        edit = await text.client.workspace_will_rename_files_async(types.RenameFilesParams([rename]))
        return {} if edit is None else session.applied(edit)

    assert await moved("meshes/arm.dae", "meshes/é b.dae") == {"r.urdf": robot.replace("arm.dae", "é b.dae")}
    assert await moved("meshes/arm.dae", "urdf/arm.dae") == {"r.urdf": robot.replace("../meshes/arm", "arm")}
    assert await moved("meshes", "parts/dae") == {"r.urdf": robot.replace("../meshes", "../parts/dae")}
    assert await moved("urdf/r.urdf", "r.urdf") == {
        "r.urdf": robot.replace("../", ""),
        "top.xacro": macro.replace("urdf/r.urdf", "r.urdf"),
    }
    assert await moved("urdf", "robots") == {"top.xacro": macro.replace("urdf/r", "robots/r")}
    assert await moved("package.xml", "manifest.xml") == {}


async def test_moved_models_and_packages_are_followed(session: Session, folder: Path) -> None:
    (folder / "pkg" / "meshes").mkdir(parents=True)
    (folder / "pkg" / "meshes" / "a.stl").write_bytes(bytes(84))
    (folder / "pkg" / "package.xml").write_text("<package><name>pkg</name></package>")
    (folder / "model.config").write_text("<model><name>m</name><sdf>m.sdf</sdf></model>")
    robot = (
        '<robot name="r"><link name="a"><visual><geometry><mesh filename="package://pkg/meshes/a.stl"/></geometry>'
        "</visual></link></robot>"
    )
    text = session.open(folder / "pkg" / "r.urdf", robot)
    rename = types.FileRename(
        (folder / "pkg/meshes/a.stl").as_uri(), (folder / "pkg/meshes/visual/b.stl").as_uri()
    )
    edit = await text.client.workspace_will_rename_files_async(types.RenameFilesParams([rename]))
    assert session.applied(edit) == {"r.urdf": robot.replace("a.stl", "visual/b.stl")}


async def test_the_expanded_text_leads_back(session: Session, folder: Path) -> None:
    text = session.open(folder / "r.xacro", ROBOT.replace('value="0.5"', 'value="0.25"'), save=False)
    found = await commanded(text, "sdfcheck.expand")
    expanded = item(found, "text")
    assert '<link name="left_ball">' in expanded
    lines = expanded.split("\n")
    place = next(
        each
        for each in item(found, "places")
        if 'name="left_ball"' in lines[item(each, "first")]
        and item(each, "first") < item(each, "last")
        and "robot" not in lines[item(each, "first")]
    )
    start = item(item(item(place, "location"), "range"), "start")
    at = offset(text.text, types.Position(item(start, "line"), item(start, "character")), session.encoding)
    assert text.text[at:].startswith('link name="${name}_ball"')
    other = await commanded(text, "sdfcheck.expand", arguments={"side": "right"})
    assert "right_ball" in item(other, "text")
    assert item(found, "language") == "urdf"


async def test_conversions_say_what_they_lose(session: Session, folder: Path) -> None:
    text = session.open(folder / "r.urdf", URDF.replace("arm.dae", "package://nowhere/arm.dae"))
    found = await commanded(text, "sdfcheck.convert")
    assert '<model name="r"' in item(found, "text")
    assert item(found, "language") == "sdformat"
    assert item(found, "verified")
    sdf = session.open(
        folder / "m.sdf",
        MODEL.replace("<model name", "<!-- kept -->\n<model name")
        .replace("2.500", "1")
        .replace("</geometry>", "</geometry><cast_shadows>false</cast_shadows>"),
    )
    back = await commanded(sdf, "sdfcheck.convert", to="urdf")
    assert '<robot name="m">' in item(back, "text")
    for each in item(back, "losses"):
        assert item(each, "uri") == sdf.uri


@pytest.mark.parametrize(
    ("name", "written", "command", "words"),
    [
        ("m.sdf", MODEL, "sdfcheck.expand", "nothing to expand"),
        ("r.xacro", ROBOT.replace("${size * 2}", "${sise}"), "sdfcheck.expand", "cannot be expanded"),
        ("x.sdf", "<gui/>", "sdfcheck.convert", "looks like"),
    ],
)
async def test_commands_say_why_not(
    name: str, written: str, command: str, words: str, session: Session, folder: Path
) -> None:
    text = session.open(folder / name, written)
    with pytest.raises(JsonRpcException, match=words):
        await commanded(text, command)


async def test_files_that_are_not_open_are_linted(session: Session, folder: Path) -> None:
    wrong = folder / "wrong.sdf"
    wrong.write_text(MODEL.replace("radius", "radios"))

    async def asked(*before: types.PreviousResultId) -> dict[str, Any]:
        params = types.WorkspaceDiagnosticParams(list(before))
        return {each.uri: each for each in (await session.client.workspace_diagnostic_async(params)).items}

    found = (await asked())[wrong.as_uri()]
    assert any("radius" in each.message for each in found.items)
    wrong.write_text(MODEL)
    again = (await asked(types.PreviousResultId(wrong.as_uri(), found.result_id)))[wrong.as_uri()]
    assert not [each for each in again.items if "radius" in each.message]
    wrong.unlink()
    gone = (await asked(types.PreviousResultId(wrong.as_uri(), str(again.result_id))))[wrong.as_uri()]
    assert not gone.items
