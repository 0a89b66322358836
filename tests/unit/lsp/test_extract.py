"""Extracting a property or a macro leaves the expansion as it is."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from sdfcheck.lsp.actions import Extraction, extractions, keeps_expansion
from sdfcheck.lsp.workspace import Buffer, Workspace
from sdfcheck.source.splice import replaced
from tests.unit.lsp.texts import ROBOT

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"
XACRO = sorted(path for path in ROBOTS.rglob("*.xacro") if path.is_file())
TAGS = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="width" value="0.2"/>
  <xacro:macro name="part" params="name *where">
    <link name="${name}">
      <visual>
        <xacro:insert_block name="where"/>
        <geometry><box size="${width} 0.50 0.1"/></geometry>
      </visual>
    </link>
    <gazebo reference="${name}"><static>true</static></gazebo>
  </xacro:macro>
  <xacro:part name="part_007"><origin xyz="0 0 ${width * 1.5 + 2}" rpy="0 0 1e-1"/></xacro:part>
  <xacro:if value="true">
    <link name="tip"><inertial><mass value="01.5"/></inertial></link>
  </xacro:if>
  <joint name="j" type="fixed"><parent link="part_007"/><child link="tip"/></joint>
</robot>
"""


def opened(text: str, path: Path = Path("there/r.urdf.xacro")) -> tuple[Workspace, Buffer]:
    workspace = Workspace()
    return workspace, workspace.open("file:///there/r", path, text, 1)


def offered(text: str, start: int, end: int) -> tuple[Workspace, Buffer, list[Extraction]]:
    workspace, buffer = opened(text)
    document = workspace.document(buffer.path)
    assert document is not None
    return workspace, buffer, list(extractions(document, buffer.source.span(start, end)))


def result(text: str, mark: str, *, whole: bool = True) -> str:
    """The text after what is marked was extracted; what is made of it is the same robot."""
    start = text.index(mark)
    workspace, buffer, found = offered(text, start, start + len(mark) if whole else start)
    try:
        (one,) = found
        assert keeps_expansion(workspace, buffer, one.edits)
    finally:
        workspace.close()
    return replaced(text, [(edit.span.start, edit.span.end, edit.text) for edit in one.edits])


@pytest.mark.parametrize(
    ("mark", "property_", "use"),
    [
        ("0.50", '<xacro:property name="box_size" value="0.50"/>\n    <link name="${name}">', " ${box_size} 0.1"),
        ("1.5 + 2", None, None),
        ("1.5", '  <xacro:property name="origin_xyz" value="1.5"/>\n  <xacro:part ', "${width * origin_xyz + 2}"),
        ("${width * 1.5 + 2}", 'name="origin_xyz" value="${width * 1.5 + 2}"/>', 'xyz="0 0 ${origin_xyz}"'),
        ("007", None, None),
        ("true", None, None),
        ("1e-1", 'value="1e-1"', 'rpy="0 0 ${origin_rpy}"'),
        ("01.5", 'value="01.5"', 'value="${mass_value}"'),
        ("insert_block", None, None),
        ("where", None, None),
        ('r" xmlns', None, None),
    ],
)  # fmt: skip
def test_a_property_for_what_is_selected(mark: str, property_: str | None, use: str | None) -> None:
    if property_ is None or use is None:
        start = TAGS.index(mark)
        assert offered(TAGS, start, start + len(mark))[2] == []
        return
    after = result(TAGS, mark)
    assert property_ in after
    assert use in after


def test_a_property_in_a_condition_stays_there() -> None:
    after = result(TAGS, "01.5", whole=False)
    assert '<xacro:if value="true">\n    <xacro:property name="mass_value" value="01.5"/>\n    <link' in after


def test_a_macro_gets_the_parameters_that_it_reads() -> None:
    after = result(TAGS, '<geometry><box size="${width} 0.50 0.1"/></geometry>')
    assert '<xacro:macro name="geometry_macro">\n    <geometry><box ' in after
    assert "        <xacro:geometry_macro/>\n" in after
    after = result(TAGS, '<gazebo reference="${name}"><static>true</static></gazebo>')
    assert '<xacro:macro name="gazebo_macro" params="name">\n    <gazebo ' in after
    assert '    <xacro:gazebo_macro name="${name}"/>\n  </xacro:macro>' in after


def test_a_macro_of_several_elements_at_the_top() -> None:
    text = TAGS.replace("  <xacro:if", '  <link name="a"/>\n  <link name="b"/>\n  <xacro:if')
    after = result(text, '<link name="a"/>\n  <link name="b"/>')
    definition = '<xacro:macro name="a_macro">\n    <link name="a"/>\n    <link name="b"/>\n  </xacro:macro>'
    assert f"  {definition}\n  <xacro:a_macro/>\n" in after


@pytest.mark.parametrize(
    "mark",
    [
        '<xacro:insert_block name="where"/>',
        '<xacro:property name="width" value="0.2"/>',
        '<origin xyz="0 0 ${width * 1.5 + 2}" rpy="0 0 1e-1"/>',
        "<visual>",
        '<link name="tip"><inertial>',
    ],
)
def test_no_macro_of_what_would_mean_something_else_there(mark: str) -> None:
    start = TAGS.index(mark)
    assert [each for each in offered(TAGS, start, start + len(mark))[2] if "macro" in each.title] == []


def test_names_are_free() -> None:
    taken = TAGS.replace('name="width"', 'name="box_size"').replace("${width", "${box_size")
    assert 'name="box_size_2" value="0.50"' in result(taken, "0.50")


@pytest.mark.parametrize("name", ["r.urdf", "r.urdf.xacro"])
def test_nothing_in_a_plain_robot(name: str) -> None:
    text = '<robot name="r"><link name="a"/></robot>'
    workspace, buffer = opened(text, Path("there") / name)
    document = workspace.document(buffer.path)
    assert document is not None
    assert not list(extractions(document, buffer.source.span(23, 24)))


def test_a_change_of_the_expansion_is_noticed() -> None:
    workspace, buffer = opened(ROBOT)
    place = ROBOT.index("0.5")
    try:
        edit = next(extractions(buffer.document, buffer.source.span(place, place))).edits[0]
        assert keeps_expansion(workspace, buffer, [edit])
        wrong = edit._replace(span=buffer.source.span(place, place + 3), text="0.6")
        assert not keeps_expansion(workspace, buffer, [wrong])
        assert not keeps_expansion(workspace, buffer, [wrong._replace(text="${nothing}")])
    finally:
        workspace.close()


@pytest.mark.parametrize("path", XACRO, ids=lambda path: path.name)
def test_every_extraction_from_real_files_keeps_their_expansion(
    path: Path, copied: Callable[[Path], Path]
) -> None:
    path = copied(path)
    workspace = Workspace()
    buffer = workspace.open(path.as_uri(), path, path.read_text(), 1)
    document = workspace.document(path)
    assert document is not None
    spans = document.spans
    places = [spans.whole(element) for element in document.elements[1:]]
    for element in document.elements:
        places += [spans.attribute_value(element, name) for name in element.attributes]
        places += [spans.text(element)] if element.content else []
    count = 0
    try:
        for place in places[:: max(1, len(places) // 60)]:
            for start, end in {(place.start, place.end), (place.start, place.start), (place.end, place.end)}:
                for found in extractions(document, buffer.source.span(start, end)):
                    count += 1
                    assert keeps_expansion(workspace, buffer, found.edits), (found, place)
    finally:
        workspace.close()
    assert count or len(document.elements) < 5
