"""The result of an expansion, and where its elements were written."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from lxml import etree

from sdfcheck.source.document import Document, Element, read
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Step
from sdfcheck.xacro.expansion import Expander, Expansion, Surroundings, expand
from sdfcheck.xacro.origins import ExpandedDocument, annotated

TOP = """<?xml version="1.0"?>
<robot name="$(arg name)" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="parts/leg.xacro"/>
  <!-- a comment that stays -->
  <link name="base"/>
  <xacro:leg side="left" length="${2 * reach}">
    <origin xyz="0 ${reach} 0"/>
  </xacro:leg>
  <xacro:leg side="right"><origin xyz="0 0 0"/></xacro:leg>
</robot>
"""
LEG = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="reach" value="0.5"/>
  <xacro:macro name="foot" params="prefix">
    <link name="${prefix}_foot"/>
  </xacro:macro>
  <xacro:macro name="leg" params="side length:=1.0 *place">
    <link name="${side}_leg">
      <visual><xacro:insert_block name="place"/>
        <geometry><cylinder length="${length}" radius='0.1'/></geometry></visual>
    </link>
    <xacro:foot prefix="${side}"/>
  </xacro:macro>
  <material name="grey"><color rgba="${reach} 0.5 0.5 1"/></material>
</robot>
"""


@pytest.fixture(scope="module")
def expander() -> Iterator[Expander]:
    with Expander() as one:
        yield one


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts" / "leg.xacro").write_text(LEG)
    path = tmp_path / "robot.urdf.xacro"
    path.write_text(TOP)
    return path


def load(path: Path) -> Document:
    return read(path.read_bytes(), path, Kind.XACRO)


def document(expansion: Expansion) -> ExpandedDocument:
    assert expansion.document is not None, expansion.problems
    return expansion.document


def elements(document: Document) -> list[Element]:
    return document.elements


def named(document: Document, name: str) -> Element:
    return next(element for element in elements(document) if element.attributes.get("name") == name)


def lines(steps: tuple[Step, ...]) -> list[tuple[str, int]]:
    return [(step.text, step.span.begin.line) for step in steps]


def test_the_text_is_that_of_plain_xacro(robot: Path, expander: Expander) -> None:
    script = (
        "import sys, xacro; d = xacro.process_file(sys.argv[1], mappings={'name': 'r'}, verbosity=0);"
        "sys.stdout.write(d.toprettyxml(indent='  '))"
    )
    plain = subprocess.run(
        [sys.executable, "-c", script, str(robot)], capture_output=True, text=True, check=True
    )
    assert expander.expand(load(robot), {"name": "r"}).text == plain.stdout


def test_every_element_is_at_its_place(robot: Path, expander: Expander) -> None:
    found = document(expander.expand(load(robot), {"name": "r"}))
    assert len(elements(found)) > 10
    for element in elements(found):
        assert element.span.text == element.name
        assert element.span.source.path.suffix == ".xacro"


def test_a_value_has_the_place_of_its_expression(robot: Path, expander: Expander) -> None:
    found = document(expander.expand(load(robot), {"name": "r"}))
    cylinder = next(element for element in elements(found) if element.name == "cylinder")
    length = cylinder.attribute("length")
    assert length is not None
    assert (length.text, length.span.text) == ("1.0", "${length}")
    radius = cylinder.attribute("radius")
    assert radius is not None
    assert radius.span.text == "0.1"
    color = next(element for element in elements(found) if element.name == "color").attribute("rgba")
    assert color is not None
    assert [color.part(n).text for n in range(4)] == ["${reach}", "0.5", "0.5", "1"]


def test_origins_lead_from_inside_out(robot: Path, expander: Expander) -> None:
    found = document(expander.expand(load(robot), {"name": "r"}))
    assert lines(found.origins(named(found, "left_foot"))) == [
        ("in macro `foot`, called here", 11),
        ("in macro `leg`, called here", 6),
    ]
    assert lines(found.origins(named(found, "right_leg"))) == [("in macro `leg`, called here", 9)]
    assert lines(found.origins(named(found, "grey"))) == [("included here", 3)]
    assert found.origins(named(found, "base")) == ()


def test_a_block_has_the_place_where_it_was_passed(robot: Path, expander: Expander) -> None:
    found = document(expander.expand(load(robot), {"name": "r"}))
    origin = next(element for element in elements(found) if element.name == "origin")
    assert origin.span.source.path.name == "robot.urdf.xacro"
    assert origin.span.begin.line == 7
    assert found.origins(origin) == ()


def test_places_in_the_expanded_text_lead_home(robot: Path, expander: Expander) -> None:
    found = document(expander.expand(load(robot), {"name": "r"}))
    at = found.source.text.index("right_leg")
    home = found.written(found.source.span(at, at + 5))
    assert home.text == "${side}_leg"
    assert lines(found.origins_at(home)) == [("in macro `leg`, called here", 9)]


def test_elements_made_by_xacro_have_a_place(tmp_path: Path, expander: Expander) -> None:
    path = tmp_path / "r.xacro"
    path.write_text(
        '<robot name="r" xmlns:xacro="x"><xacro:element xacro:name="${\'li\' + \'nk\'}" name="a">'
        '<xacro:attribute name="extra" value="1"/></xacro:element></robot>'
    )
    found = document(expander.expand(load(path)))
    link = named(found, "a")
    assert (link.name, link.span.text) == ("link", "xacro:element")
    assert found.spans.attribute_value(link, "extra").text == "xacro:element"
    end = found.spans.end_name(link)
    assert end is not None
    assert end.text == "xacro:element"


@pytest.mark.parametrize("line_end", ["\n", "\r\n", "\r"])
def test_columns_hold_with_other_letters_tabs_and_line_ends(
    tmp_path: Path, expander: Expander, line_end: str
) -> None:
    text = '\ufeff<robot name="r" xmlns:xacro="x"><!-- Größe 𝄞 -->\n\t<!-- ü --><link name="é"/></robot>\n'
    path = tmp_path / "r.xacro"
    path.write_bytes(text.replace("\n", line_end).encode())
    found = document(expander.expand(load(path)))
    assert [element.span.text for element in elements(found)] == ["robot", "link"]


def test_the_text_at_hand_counts_not_that_on_disk(robot: Path, expander: Expander) -> None:
    changed = read(TOP.replace('"base"', '"trunk"').encode(), robot, Kind.XACRO)
    expansion = expander.expand(changed, {"name": "r"})
    assert expansion.text is not None
    assert "trunk" in expansion.text
    assert [path.name for path in expansion.files] == ["robot.urdf.xacro", "leg.xacro"]


def test_one_expansion_leaves_nothing_to_the_next(tmp_path: Path, expander: Expander) -> None:
    first, second = tmp_path / "a.xacro", tmp_path / "b.xacro"
    first.write_text('<robot name="a" xmlns:xacro="x"><xacro:arg name="p" default="FIRST"/></robot>')
    second.write_text('<robot name="$(arg p)" xmlns:xacro="x"/>')
    assert expander.expand(load(first)).text is not None
    assert expander.expand(load(second)).text is None


def test_comments_say_where_elements_were_written(robot: Path) -> None:
    text = annotated(document(expand(robot, {"name": "r"})))
    assert "leg.xacro:4; in macro `foot`:" in text
    assert "robot.urdf.xacro:6 -->" in text
    etree.fromstring(text.encode())


def test_packages_are_found_and_their_files_read(tmp_path: Path) -> None:
    folder = tmp_path / "elsewhere" / "arm_description"
    folder.mkdir(parents=True)
    (folder / "arm.xacro").write_text(LEG)
    (tmp_path / "project").mkdir()
    path = tmp_path / "project" / "r.xacro"
    path.write_text(TOP.replace("parts/leg.xacro", "$(find arm_description)/arm.xacro"))
    surroundings = Surroundings({"arm_description": folder}, root=tmp_path / "project")
    found = document(expand(path, {"name": "r"}, surroundings))
    assert named(found, "left_leg").span.source.path.name == "arm.xacro"
