"""Over stdio: what is offered while typing."""

from __future__ import annotations

from pathlib import Path

import pytest
from lsprotocol import types

from tests.unit.lsp.texts import ROBOT, URDF
from tests.unit.lsp.wire import Session

pytestmark = [pytest.mark.asyncio(loop_scope="module"), pytest.mark.xdist_group(__name__)]

COMPLETIONS = {
    "elements": (
        '<sdf version="1.12"><model name="m"><|</model></sdf>',
        {"link", "joint", "drake:joint"},
        {"gps"},
    ),
    "an older version": ('<sdf version="1.4"><model name="m"><|</model></sdf>', {"link"}, {"frame"}),
    "attributes": ('<sdf version="1.12"><model |', {"name", "canonical_link"}, {"version"}),
    "choices": (
        '<sdf version="1.12"><model name="m"><joint name="j" type="|',
        {"revolute", "ball"},
        {"free"},
    ),
    "booleans": ('<sdf version="1.12"><model name="m"><static>|', {"true", "false"}, {"1"}),
    "frames in scope": (
        (
            '<sdf version="1.12"><model name="m"><link name="a"/><frame name="f"/><frame name="g" attached_to="|"/>'
            '</model><model name="n"><link name="other"/></model></sdf>'
        ),
        {"a", "f", "__model__"},
        {"g", "other"},
    ),
    "links of a joint": (
        (
            '<sdf version="1.12"><model name="m"><link name="a"/><joint name="j" type="fixed"><parent>|</parent>'
            "</joint></model></sdf>"
        ),
        {"a", "world"},
        {"m"},
    ),
    "joints of a plugin": (
        (
            '<sdf version="1.12"><model name="m"><link name="a"/><joint name="j" type="fixed"><parent>world</parent>'
            '<child>a</child></joint><plugin name="p" filename="x"><joint_name>|</joint_name></plugin></model></sdf>'
        ),
        {"j"},
        {"a"},
    ),
    "plugins": (
        '<sdf version="1.12"><world name="w"><plugin filename="|',
        {"gz-sim-physics-system", "gz-sim-diff-drive-system"},
        set(),
    ),
    "materials": (
        (
            '<robot name="r"><material name="red"><color rgba="1 0 0 1"/></material><link name="a"><visual>'
            '<material name="|"/></visual></link></robot>'
        ),
        {"red"},
        {"a"},
    ),
    "ros2_control": (
        '<robot name="r"><ros2_control name="c"><joint name="j"><|',
        {"command_interface"},
        {"link"},
    ),
    "interfaces": (
        '<robot name="r"><ros2_control name="c"><joint name="j"><command_interface name="|',
        {"position", "velocity"},
        set(),
    ),
    "tags of Drake": (
        '<sdf version="1.12" xmlns:drake="http://drake.mit.edu"><model name="m"><link name="l"><collision name="c"><|',
        {"drake:proximity_properties"},
        {"drake:joint"},
    ),
    "end tags": ('<sdf version="1.12"><model name="m"></|', {"model"}, set()),
    "a new file": ("<|", {"sdf", "robot"}, {"link"}),
    "a comment": ('<sdf version="1.12"><!-- <|', set(), {"model"}),
}


@pytest.mark.parametrize("what", COMPLETIONS)
async def test_completion(session: Session, folder: Path, what: str) -> None:
    marked, expected, unexpected = COMPLETIONS[what]
    suffix = "urdf" if "<robot" in marked else "sdf"
    text = session.open(folder / f"m.{suffix}", marked.replace("|", ""))
    offset = marked.index("|")
    found = await text.completion(marked[:offset], offset)
    assert expected <= found.keys()
    assert unexpected.isdisjoint(found)


async def test_completion_of_macros_and_parameters(session: Session, folder: Path) -> None:
    text = session.open(folder / "r.urdf.xacro", ROBOT.replace('<link name="base"/>', "<"))
    ball = (await text.completion("  <\n", 3))["xacro:ball"]
    assert "name size" in (ball.detail or "")
    text.replace(ROBOT.replace("${size * 2}", "${}"))
    assert "size" in await text.completion("${}", 2)
    text.replace(ROBOT.replace("$(arg side)", "$(arg )"))
    assert "side" in await text.completion("$(arg )", 6)
    text.replace(ROBOT.replace('<link name="base"/>', "<xacro:ball />"))
    assert {"name", "size"} <= (await text.completion("<xacro:ball />", 12)).keys()


async def test_completion_of_files(session: Session, folder: Path) -> None:
    (folder / "package.xml").write_text("<package><name>own_description</name></package>")
    (folder / "meshes").mkdir()
    (folder / "meshes" / "arm.dae").touch()
    session.notice(folder / "package.xml", types.FileChangeType.Created)
    text = session.open(folder / "r.urdf", URDF.replace("arm.dae", ""))
    own = await text.completion('mesh filename=""', 15)
    assert any(label.startswith("package://") for label in own)
    text.replace(URDF.replace("arm.dae", "package://"))
    assert any("own_description" in label for label in await text.completion("package://", 10))
    text.replace(URDF.replace("arm.dae", "package://own_description/meshes/"))
    assert "package://own_description/meshes/arm.dae" in await text.completion("/meshes/", 8)


async def test_completion_of_models(session: Session, folder: Path) -> None:
    (folder / "models" / "box").mkdir(parents=True)
    (folder / "models" / "box" / "model.config").write_text("<model/>")
    start = '<sdf version="1.12"><world name="w"><include><uri>'
    text = session.open(folder / "w.sdf", start)
    assert "model://" in await text.completion("<uri>", 5)
    text.replace(f"{start}model://")
    assert "model://box" in await text.completion("model://", 8)


async def test_completion_brings_what_an_element_needs(session: Session, folder: Path) -> None:
    text = session.open(folder / "m.sdf", '<sdf version="1.12"><model name="m"><jo</model></sdf>')
    joint = (await text.completion("<jo", 3))["joint"]
    edit = joint.text_edit
    assert isinstance(edit, types.TextEdit)
    assert text.cut(edit.range) == "jo"
    assert "<child>" in edit.new_text
    able = session.client.capabilities
    assert able is not None
    assert able.text_document is not None
    assert able.text_document.completion is not None
    item = able.text_document.completion.completion_item
    takes_snippets = item is not None and bool(item.snippet_support)
    assert ("${1" in edit.new_text or "$1" in edit.new_text) == takes_snippets
    formats = types.InsertTextFormat
    assert joint.insert_text_format is (formats.Snippet if takes_snippets else formats.PlainText)
