"""An include with parameters is one robot to every command: unchanged, and with the include replaced."""

from __future__ import annotations

import json
import re
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

import pytest

from sdfcheck.cli.main import main

HEAD = '<sdf version="{}" xmlns:experimental="urn:e" xmlns:my="urn:my">'
BODY = (
    "<inertial><pose>0 0 0.1 0 0 0</pose><mass>{}</mass>"
    "<inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>"
)
ARM = f"""{HEAD.format("{}")}<model name="arm">
  <link name="base">{BODY.format(1)}</link>
  <link name="tip"><pose>1 0 0 0 0 0</pose>{BODY.format(2)}<visual name="v"><geometry><sphere>
    <radius>0.1</radius></sphere></geometry></visual></link>
  <frame name="grip" attached_to="tip"><pose>0 0 1 0 0 0</pose></frame>
  <joint name="elbow" type="revolute"><parent>base</parent><child>tip</child><axis><xyz>0 0 1</xyz>
    <limit><lower>-1</lower><upper>1</upper></limit></axis></joint>
  {"{}"}
</model></sdf>"""
TOOL = f"""{HEAD.format("1.9")}<model name="tool">
  <link name="blade"><pose>0 2 0 0 0 0</pose>{BODY.format(3)}</link></model></sdf>"""
INNER = "<include><uri>tool.sdf</uri><name>held</name><pose relative_to='tip'>0 0 3 0 0 0</pose></include>"
MERGED = "<include merge='true'><uri>tool.sdf</uri><pose>0 0 3 0 0 0</pose></include>"

PARAMETERS = {
    "modified pose": '<link element_id="tip" action="modify"><pose>5 0 0 0 0 0</pose></link>',
    "modified base": '<frame element_id="grip" action="modify"><pose relative_to="base">5 0 0 0 0 0</pose></frame>',
    "modified mass": '<link element_id="tip" action="modify"><inertial><mass>7</mass></inertial></link>',
    "mass of a child": '<link element_id="tip"><inertial action="modify"><mass>7</mass></inertial></link>',
    "modified name": '<frame element_id="grip" action="modify" name="hand"/>',
    "modified axis": '<joint element_id="elbow" action="modify"><axis><xyz>1 0 0</xyz></axis></joint>',
    "modified pose of a child": '<link element_id="tip"><pose action="modify">0 5 0 0 0 0</pose></link>',
    "added frame": '<frame element_id="" name="f" action="add" attached_to="tip"><pose>0 0 4 0 0 0</pose></frame>',
    "added link": f'<link element_id="" name="l" action="add"><pose>0 8 0 0 0 0</pose>{BODY.format(5)}</link>',
    "added pose": '<link element_id="base"><pose action="add">0 0 6 0 0 0</pose></link>',
    "added custom": '<link element_id="base" action="modify" my:x="1"/>',
    "removed joint": '<joint element_id="elbow" action="remove"/>',
    "removed pose": '<link element_id="tip"><pose action="remove"/></link>',
    "removed children": '<link element_id="tip" action="remove"><pose/><inertial/></link>',
    "replaced link": '<link element_id="tip" name="tip" action="replace">'
    f'<pose>0 0 9 0 0 0</pose>{BODY.format(4)}</link>',
    "replaced child": '<link element_id="tip"><pose action="replace">0 3 0 0 0 0</pose></link>',
    "each after the other": '<frame element_id="grip" action="modify" name="hand"/>'
    '<frame element_id="hand" action="modify"><pose>0 0 2 0 0 0</pose></frame>',
}  # fmt: skip
INSIDE = {
    "pose in it": '<link element_id="held::blade" action="modify"><pose>0 0 8 0 0 0</pose></link>',
    "mass in it": '<link element_id="held::blade" action="modify"><inertial><mass>9</mass></inertial></link>',
    "added to it": '<frame element_id="held" name="f" action="add"><pose>0 0 4 0 0 0</pose></frame>',
    "pose of it": '<model element_id="held" action="modify"><pose>0 0 8 0 0 0</pose></model>',
    "name of it": '<model element_id="held" action="modify" name="knife"/>',
    "it": '<model element_id="held" action="remove"/>',
    "in its place": '<model element_id="held" name="held" action="replace"><link name="x"/></model>',
    "removed in it": '<link element_id="held::blade" action="replace" name="blade"/>',
}
MERGED_INSIDE = '<link element_id="blade" action="modify"><pose>0 0 8 0 0 0</pose></link>'


def write(folder: Path, entries: str, more: str = "", version: str = "1.9", merge: str = "false") -> Path:
    (folder / "tool.sdf").write_text(TOOL)
    (folder / "arm.sdf").write_text(ARM.format(version, more))
    include = (
        f'<include merge="{merge}"><uri>arm.sdf</uri><name>a</name><pose>0 0 1 0 0 0</pose>'
        f"<experimental:params>{entries}</experimental:params></include>"
        "<include><uri>arm.sdf</uri><name>untouched</name></include>"
    )
    path = folder / "main.sdf"
    path.write_text(f'{HEAD.format("1.9")}<model name="m"><link name="l0"/>{include}</model></sdf>')
    return path


def run(*arguments: str | Path, code: int = 0) -> str:
    """The output of a command, which has to end with an exit code."""
    with redirect_stdout(StringIO()) as output:
        assert main([*map(str, arguments), "--isolated"]) == code
    return output.getvalue()


def written_out(path: Path) -> Path:
    text = run("print", "--expand-includes", path)
    assert "<include" not in text
    expanded = path.with_name("expanded.sdf")
    expanded.write_text(text)
    return expanded


def agree(path: Path) -> tuple[str, str]:
    """The poses and the masses, which have to be those of the text that is written out."""
    expanded = written_out(path)
    poses = [poses_of(file) for file in (path, expanded)]
    masses = [run("inertia", file) for file in (path, expanded)]
    assert poses[0] == poses[1]
    assert masses[0] == masses[1]
    assert any("untouched" in line for line in poses[0])
    run("diff", path, expanded)
    return "\n".join(poses[0]), masses[0]


def poses_of(path: Path) -> list[str]:
    """Kind, name and pose of everything, however it is attached and written."""
    lines = run("graph", "poses", path).splitlines()
    return sorted(re.sub(r" \(.*?\)", "", line).lstrip("├└│─ ") for line in lines)


def plain(tmp_path: Path, **how: str) -> tuple[str, str]:
    """The same without an effect of the parameters."""
    folder = tmp_path / "plain"
    folder.mkdir()
    return agree(write(folder, "", **how))


SILENT = {"added custom", "modified axis"}


@pytest.mark.parametrize("what", PARAMETERS)
def test_every_command_sees_the_changes(tmp_path: Path, what: str) -> None:
    changed = agree(write(tmp_path, PARAMETERS[what]))
    assert (changed == plain(tmp_path)) is (what in SILENT)


@pytest.mark.parametrize("what", ["modified pose", "added link", "replaced link", "removed pose"])
def test_in_merged_models(tmp_path: Path, what: str) -> None:
    changed = agree(write(tmp_path, PARAMETERS[what], merge="true"))
    assert changed != plain(tmp_path, merge="true")


@pytest.mark.parametrize("what", INSIDE)
def test_changes_reach_into_what_is_included_there(tmp_path: Path, what: str) -> None:
    changed = agree(write(tmp_path, INSIDE[what], INNER))
    assert changed != plain(tmp_path, more=INNER)


def test_changes_reach_into_what_is_merged_there(tmp_path: Path) -> None:
    changed = agree(write(tmp_path, MERGED_INSIDE, MERGED))
    assert changed != plain(tmp_path, more=MERGED)


@pytest.mark.parametrize("version", ["1.6", "1.12"])
def test_files_of_another_version(tmp_path: Path, version: str) -> None:
    changed = agree(write(tmp_path, PARAMETERS["modified pose"], version=version))
    assert "5 0 1" in changed[0]


def test_two_includes_change_one_model(tmp_path: Path) -> None:
    middle = INNER.replace(
        "</include>",
        '<experimental:params><link element_id="blade" action="modify"><pose>0 0 7 0 0 0</pose></link>'
        '<frame element_id="" name="f" action="add"/></experimental:params></include>',
    )
    outer = '<frame element_id="held::f" action="modify" name="g"/>'
    poses, _ = agree(write(tmp_path, outer, middle))
    assert "a::held::g" in poses
    assert "untouched::held::f" in poses


def test_a_conversion_has_the_same_robot(tmp_path: Path) -> None:
    path = write(tmp_path, INSIDE["pose in it"] + PARAMETERS["modified mass"], INNER)
    forest = ("convert", "sdf-to-urdf", "--forest", "fixed")
    direct, expanded = (run(*forest, file) for file in (path, written_out(path)))
    assert direct == expanded
    assert '<mass value="7"/>' in direct


def test_findings_are_placed_in_the_file_that_was_read(tmp_path: Path) -> None:
    path = write(tmp_path, '<frame element_id="none" action="modify" name="hand"/>')
    found = json.loads(run("lint", "--output-format", "json", path, code=1))["diagnostics"]
    assert [Path(one["file"]).name for one in found if one["code"] == "RES010"] == ["main.sdf"]
