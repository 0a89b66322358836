"""An included file that xacro cannot read: one diagnostic, in that file where the run reports it."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

HEAD = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
BROKEN = {
    "empty": "",
    "text": "solid cube\n",
    "unclosed": f'{HEAD}\n<link name="a">\n</robot>\n',
    "cut off": f'{HEAD}\n<link name="a"/>\n',
    "two roots": "<robot/>\n<robot/>\n",
    "repeated attribute": f'{HEAD}\n<link name="a"\n name="b"/>\n</robot>',
    "undeclared prefix": '<robot>\n<link name="a"/>\n<xacro:leg/>\n</robot>',
    "other prefix": f'{HEAD}\n<drake:joint name="a"/>\n</robot>',
    "bare ampersand": f'{HEAD}\n<link name="a&b"/>\n</robot>',
    "two ampersands": f'{HEAD}\n<link name="a && b"/>\n</robot>',
    "two ampersands in an expression": f'{HEAD}\n<link name="${{1 && 2}}"/>\n</robot>',
    "unknown entity": f'{HEAD}\n<link name="&a;"/>\n</robot>',
    "hyphens": f"{HEAD}\n<!-- a -- b -->\n</robot>",
    "no quotes": f"{HEAD}\n<link name=a/>\n</robot>",
    "not UTF-8": f"{HEAD}\n<!-- fa\xe7ade -->\n</robot>",
    "late declaration": f'\n<?xml version="1.0"?>\n{HEAD}</robot>',
    "not UTF-8 far below": f"{HEAD}{'<!-- a -->' * 3_000}\n<!-- fa\xe7ade -->\n</robot>",
}


def found(*paths: Path) -> list[tuple[str, str, int]]:
    run = sdfcheck.lint(*paths, isolated=True)
    errors = [each for each in run.diagnostics if each.severity is sdfcheck.Severity.ERROR]
    return [(each.code, each.span.source.path.name, len(each.labels)) for each in errors]


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_include_is_one_diagnostic(tmp_path: Path, name: str) -> None:
    (tmp_path / "part.xacro").write_bytes(BROKEN[name].encode("latin-1"))
    (tmp_path / "middle.xacro").write_text(f'{HEAD}<xacro:include filename="part.xacro"/></robot>')
    for file, includes in (("main", "part"), ("other", "middle")):
        (tmp_path / f"{file}.urdf.xacro").write_text(
            f'{HEAD}\n<xacro:include filename="{includes}.xacro"/>\n<link name="b"/>\n</robot>'
        )
    assert found(tmp_path / "main.urdf.xacro") == [("XAC001", "main.urdf.xacro", 1)]
    assert found(tmp_path / "other.urdf.xacro") == [("XAC001", "middle.xacro", 1)]
    assert [file for _, file, _ in found(tmp_path)] == ["part.xacro"]


@pytest.mark.parametrize("name", ["unclosed", "not UTF-8"])
def test_a_broken_file_that_is_not_linted_is_one_diagnostic_at_its_first_include(
    tmp_path: Path, name: str
) -> None:
    (tmp_path / "part.inc").write_bytes(BROKEN[name].encode("latin-1"))
    for file in ("main", "other"):
        (tmp_path / f"{file}.urdf.xacro").write_text(
            f'{HEAD}\n<xacro:include filename="part.inc"/>\n</robot>'
        )
    assert found(tmp_path) == [("XAC001", "main.urdf.xacro", 1)]


def test_it_stays_at_the_include_where_the_fault_is_not_reported(tmp_path: Path) -> None:
    (tmp_path / "part.xacro").write_text(f"<!-- sdfcheck: ignore-file XML -->\n{BROKEN['unclosed']}")
    (tmp_path / "main.urdf.xacro").write_text(f'{HEAD}\n<xacro:include filename="part.xacro"/>\n</robot>')
    assert ("XAC001", "main.urdf.xacro", 1) in found(tmp_path)


@pytest.mark.parametrize(
    ("use", "code", "line"),
    [("<link name='${width}'/>", "XAC004", 2), ("<xacro:leg/>", "XAC003", 4)],
)
def test_a_definition_without_the_prefix_is_one_diagnostic(
    tmp_path: Path, use: str, code: str, line: int
) -> None:
    (tmp_path / "part.xacro").write_text(
        f"{HEAD}\n<property name='width' value='1'/>\n<property name='height' value='1'/>\n"
        "<macro name='leg' params=''><link name='l'/></macro>\n</robot>"
    )
    robot = tmp_path / "main.urdf.xacro"
    robot.write_text(f'{HEAD}\n<xacro:include filename="part.xacro"/>\n<link name="b"/>{use}</robot>')
    run = sdfcheck.lint(robot, isolated=True)
    [alone] = [each for each in run.diagnostics if each.code.startswith("XAC")]
    assert alone.code == code
    assert alone.message.endswith(f" is not defined here: part.xacro:{line} lacks the prefix `xacro:`")
    of_xacro = [each for each in found(tmp_path) if each[0].startswith("XAC")]
    assert of_xacro == [("XAC012", "part.xacro", 1), ("XAC012", "part.xacro", 0)]


def test_a_part_calls_a_macro_of_its_includer_without_the_prefix(tmp_path: Path) -> None:
    part = f"{HEAD}\n<leg side='left'/><screw size='3'/>\n</robot>"
    (tmp_path / "part.xacro").write_text(part)
    macro = '<xacro:macro name="leg" params="side"><link name="${side}"/></xacro:macro>'
    (tmp_path / "main.urdf.xacro").write_text(
        f'{HEAD}\n{macro}<xacro:include filename="part.xacro"/></robot>'
    )
    assert [each for each in found(tmp_path) if each[0] == "XAC012"] == [("XAC012", "part.xacro", 0)]
    (tmp_path / "main.urdf.xacro").write_text(f"{HEAD}\n{macro}</robot>")
    assert [each for each in found(tmp_path) if each[0] == "XAC012"] == []


def test_consumers_lack_the_links_of_a_call_without_the_prefix() -> None:
    arm = '<link name="${m}"><visual name="${skin}"/></link>'
    use = '<link name="base"/><arm m="a"/>'
    text = f'{HEAD}<xacro:macro name="arm" params="m">{arm}</xacro:macro>{use}</robot>'
    run = sdfcheck.lint(text, isolated=True, name="r.urdf.xacro", target=["gazebo", "urdfdom"])
    shown = [(each.code, each.severity.value) for each in run.diagnostics if each.code.startswith("XAC")]
    assert sorted(shown) == [("XAC004", "warning"), ("XAC012", "error")]
    refused = {name for each in run.diagnostics for name, said in each.affects if said.is_refusal}
    assert refused & {"gazebo", "urdfdom"} == {"gazebo"}
