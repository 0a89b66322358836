"""Mistakes that the text of a xacro library shows, without being expanded."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck

HEAD = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'
QUIET = ["XAC005", "XAC009"]


def found(body: str, tmp_path: Path) -> list[tuple[str, str]]:
    """The code and the text at the place of each diagnostic of a library."""
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    path = tmp_path / "library.xacro"
    path.write_text(f"{HEAD}{body}</robot>")
    run = sdfcheck.lint(path, isolated=True, ignore=QUIET)
    return [(diagnostic.code, diagnostic.span.text) for diagnostic in run.diagnostics]


def macro(body: str, params: str = "side") -> str:
    return f'<xacro:macro name="m" params="{params}">{body}</xacro:macro>'


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        (macro('<link name="${side +}"/>'), ("XAC001", "${side +}")),
        (macro('<link name="${sine(side)}"/>'), ("XAC004", "sine")),
        (macro('<link name="${side"/>'), ("XAC010", "${side")),
        (macro('<link name="${side + 1_${side}"/>'), ("XAC010", "${side + 1_")),
        (macro('<link name="{side}_a"/>'), ("XAC010", "{side}")),
        (macro('<link name="$(agr side)"/>'), ("XAC001", "$(agr side)")),
        (macro('<xacro:if value="maybe"><link name="a"/></xacro:if>'), ("XAC001", "maybe")),
        (macro('<xacro:insert_block name="orign"/>', "*origin"), ("XAC004", "orign")),
        (macro('<insert_block name="origin"/>', "*origin"), ("XAC012", "insert_block")),
        ('<xacro:include filename="nowhere.xacro"/>' + macro(""), ("XAC001", "nowhere.xacro")),
        ('<xacro:macro nmae="m" params="a"><link name="${a}"/></xacro:macro>', ("XAC011", "nmae")),
        ('<xacro:arg name="prefix" default=""/>' + macro('<link name="$(arg prefx)"/>'), ("XAC013", "prefx")),
        ('<xacro:proprety name="long" value="1"/>' + macro('<link name="${long}"/>'), ("XAC003", "proprety")),
        ('<property name="long" value="1"/>' + macro('<link name="${long}"/>'), ("XAC012", "property")),
        (macro("") + '<xacro:m sied="left"/>', ("XAC008", "sied")),
        (
            '<xacro:property name="wheel-size" value="1"/>' + macro('<link name="${wheel-size}"/>'),
            ("XAC001", "wheel-size"),
        ),
        ('<xacro:property name="is" value="1"/>' + macro('<link name="${is + 1}"/>'), ("XAC001", "is")),
    ],
)
def test_one_mistake_gives_one_diagnostic(body: str, expected: tuple[str, str], tmp_path: Path) -> None:
    assert found(body, tmp_path) == [expected]


@pytest.mark.parametrize(
    "body",
    [
        macro('<gazebo><plugin name="p" filename="p"><format>{other}</format></plugin></gazebo>'),
        macro('<link name="${dict(a=side)}"/>'),
        macro('<link name="$${side"/>'),
        macro('<link name="${1 // side}"/>'),
        macro('<xacro:unless value="0"><link name="a"/></xacro:unless>'),
        macro('<gazebo><property name="long" value="1"/></gazebo>'),
        macro('<link name="$(arg of_the_includer)"/>'),
        '<xacro:include filename="nowhere.xacro" optional="true"/>' + macro(""),
    ],
)
def test_text_that_may_be_sound_is_left_alone(body: str, tmp_path: Path) -> None:
    assert not found(body, tmp_path)


def test_a_parameter_may_name_any_file(tmp_path: Path) -> None:
    tip = '<xacro:macro name="tip" params="PARAMS"><link name="${a}"/></xacro:macro>'
    for name, params in (("none", "a"), ("long", "a b")):
        (tmp_path / f"{name}.xacro").write_text(f"{HEAD}{tip.replace('PARAMS', params)}</robot>")
    body = """<xacro:if value="${kind == ''}"><xacro:property name="kind" value="none"/></xacro:if>"""
    body += '<xacro:include filename="${kind}.xacro"/><xacro:tip a="1" b="2"/>'
    assert found(macro(body, "kind"), tmp_path) == []


def test_a_place_in_the_comment_of_a_macro_is_where_the_comment_is_written(tmp_path: Path) -> None:
    part = tmp_path / "part.xacro"
    part.write_text(
        f"{HEAD}\n<xacro:macro name='part' params='p'>\n<!-- frame: of the tool -->\n<link name='${{p}}a'/>\n"
        "<!-- seen: twice -->\n</xacro:macro>\n</robot>"
    )
    robot = tmp_path / "bot.urdf.xacro"
    robot.write_text(
        HEAD.replace("<robot", '<robot name="bot"')
        + '<xacro:include filename="part.xacro"/><link name="b"/><xacro:part p="x_"/></robot>'
    )
    run = sdfcheck.lint(robot, isolated=True, select=["URD015"])
    (found,) = run.diagnostics
    source = found.span.source
    assert (source.path.name, source.position(found.span.start).line) == ("part.xacro", 3)


@pytest.mark.parametrize("rest", ["rest", "-->", "a &gt; b"])
def test_text_that_is_left_in_a_macro_is_found_there_once(rest: str, tmp_path: Path) -> None:
    part = tmp_path / "part.xacro"
    part.write_text(
        f"{HEAD}<xacro:macro name='part' params='p'><link name='${{p}}a'/>\n{rest}\n</xacro:macro></robot>"
    )
    robot = tmp_path / "bot.urdf.xacro"
    include = '<xacro:include filename="part.xacro"/><xacro:part p="x_"/></robot>'
    robot.write_text(HEAD.replace("<robot", '<robot name="bot"') + include)
    (found,) = sdfcheck.lint(tmp_path, isolated=True, select=["SCH010"]).diagnostics
    assert (found.span.source.path.name, found.span.text) == ("part.xacro", rest)
    assert f"text `{rest.replace('&gt;', '>')}`" in found.message


def test_an_expression_among_numbers_has_its_own_place(tmp_path: Path) -> None:
    path = tmp_path / "library.xacro"
    path.write_text(
        HEAD + macro('<origin xyz="x_off off -off/2" rpy="0 {pi / 2} 1e-3"/>', "x_off off") + "</robot>"
    )
    spans = [each.span for each in sdfcheck.lint(path, isolated=True).diagnostics if each.code == "XAC010"]
    assert [span.text for span in spans] == ["x_off", "off", "-off/2", "{pi / 2}"]
    assert [span.start - spans[0].start for span in spans] == [0, 6, 10, 25]


def test_names_in_other_values_are_texts(tmp_path: Path) -> None:
    assert found(macro('<part kind="side" xyz="up"><m size="${side}"/></part>'), tmp_path) == []
