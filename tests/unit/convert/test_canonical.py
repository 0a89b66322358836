"""Canonical form: one way to write, the same robot, and nothing left to do the second time."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.convert.canonical import CanonicalStyle, CanonicalText, NumberStyle, canonical
from sdfcheck.convert.file_difference import compare_files
from sdfcheck.source.altered import Xml
from sdfcheck.source.errors import WrongUsage
from tests.unit.robot.files import ARM, CONFIG, opened, write

ROBOTS = Path(__file__).parents[3] / "fixtures" / "robots"
SDF = '<sdf version="{}"><model name="m"><link name="a">{}</link></model></sdf>'
EXPANDED = CanonicalStyle(expand_includes=True)
BOX = "<collision name='c'><geometry><box><size>1 2 3</size></box></geometry></collision>"


def printed(
    folder: Path, text: str, style: CanonicalStyle | None = None, name: str = "main.sdf"
) -> CanonicalText:
    """The canonical form, which is the canonical form of itself."""
    style = style or CanonicalStyle()
    write(folder, {name: text})
    result = canonical(opened(folder / name), style)
    write(folder, {name: result.text})
    assert canonical(opened(folder / name), style).text == result.text
    return result


def link(folder: Path, content: str, numbers: NumberStyle | None = None, version: str = "1.9") -> str:
    """The rewritten content of a link, without indentation."""
    result = printed(folder, SDF.format(version, content), CanonicalStyle(numbers or NumberStyle()))
    inside = result.text.partition('<link name="a">')[2].rpartition("</link>")[0]
    return "".join(line.strip() for line in inside.splitlines())


@pytest.mark.parametrize("name", ["two_link_arm/model.sdf", "diff_drive/model.sdf"])
def test_a_canonical_text_stays(name: str) -> None:
    document = opened(ROBOTS / name)
    assert canonical(document, CanonicalStyle()).text == document.source.text


def test_indentation_comments_and_gaps(tmp_path: Path) -> None:
    text = (
        "<!-- first --><sdf version='1.9'>\n\n\n<model name='m'><!-- inside -->\n"
        "<link name='a'/> <!-- beside -->\n\n\n\n      <!-- below\n  of two lines -->\n"
        "<link name='b'>\n</link></model></sdf>"
    )
    assert printed(tmp_path, text).text.splitlines() == [
        '<?xml version="1.0"?>',
        "<!-- first -->",
        '<sdf version="1.9">',
        '  <model name="m"> <!-- inside -->',
        '    <link name="a"/> <!-- beside -->',
        "",
        "    <!-- below",
        "  of two lines -->",
        '    <link name="b"/>',
        "  </model>",
        "</sdf>",
    ]


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("<pose>1.0  -0.0\n 0.50 0 0 1e-3</pose>", "<pose>1 0 0.5 0 0 0.001</pose>"),
        ("<inertial><mass>1.10</mass></inertial>", "<inertial><mass>1.1</mass></inertial>"),
        ("<pose>1 2 x 0 0 0</pose>", None),
        ("<plugin filename='f' name='n'><gain>1.0</gain></plugin>",
         '<plugin filename="f" name="n"><gain>1.0</gain></plugin>'),
        ("<my:gain xmlns:my='u'>1.0</my:gain>", '<my:gain xmlns:my="u">1.0</my:gain>'),
        ("<pose degrees='true'>0 0 0 90.0 0 0</pose>", '<pose degrees="true">0 0 0 90 0 0</pose>'),
        ("<pose rotation_format='quat_xyzw'>0 0 0 0.0 0 0 1.0</pose>",
         '<pose rotation_format="quat_xyzw">0 0 0 0 0 0 1</pose>'),
    ],
)  # fmt: skip
def test_numbers(tmp_path: Path, before: str, after: str | None) -> None:
    assert link(tmp_path, before) == (before if after is None else after)


def test_angles_in_degrees_and_back(tmp_path: Path) -> None:
    pose = "<pose>0 0 1 0 0 1.5707963267948966</pose>"
    in_degrees = '<pose degrees="true">0 0 1 0 0 90</pose>'
    assert link(tmp_path, pose, NumberStyle(degrees=True)) == in_degrees
    for degrees in ("true", "True", "1"):
        written = in_degrees.replace("true", degrees)
        assert link(tmp_path, written, NumberStyle(degrees=False)) == pose


def test_versions_without_degrees(tmp_path: Path) -> None:
    with pytest.raises(WrongUsage, match=r"1\.8 has no poses in degrees"):
        link(tmp_path, "", NumberStyle(degrees=True), version="1.8")
    with pytest.raises(WrongUsage, match="URDF has no poses in degrees"):
        printed(tmp_path, '<robot name="r"/>', CanonicalStyle(NumberStyle(degrees=True)), "r.urdf")


def test_snapping(tmp_path: Path) -> None:
    pose = "<pose>0 0 0 1.57 0.01 3.14159</pose>"
    in_degrees = link(tmp_path, pose, NumberStyle(degrees=True, snap=0.1, precision=6))
    assert in_degrees == '<pose degrees="true">0 0 0 90 0.572958 180</pose>'
    in_radians = link(tmp_path, pose, NumberStyle(snap=0.1))
    assert in_radians == "<pose>0 0 0 1.5707963267948966 0.01 3.141592653589793</pose>"


def test_precision(tmp_path: Path) -> None:
    assert (
        link(tmp_path, "<pose>0.123456 0 0 0 0 0</pose>", NumberStyle(precision=3))
        == "<pose>0.123 0 0 0 0 0</pose>"
    )


def test_urdf(tmp_path: Path) -> None:
    urdf = (
        '<robot name="r"><link name="a"><visual><origin rpy="0 0 -0.0" xyz="1.0 0 0"/><geometry>'
        '<box size="1.0 1 1"/></geometry></visual></link><gazebo reference="a"><mu1 value="1.0"/></gazebo></robot>'
    )
    text = printed(tmp_path, urdf, name="r.urdf").text
    assert '<origin rpy="0 0 0" xyz="1 0 0"/>' in text
    assert '<box size="1 1 1"/>' in text
    assert '<mu1 value="1.0"/>' in text


def test_a_text_that_is_not_well_formed_is_repaired(tmp_path: Path) -> None:
    text = printed(tmp_path, SDF.format("1.9", "<drake:thing a='1 & 2'/>")).text
    assert '<drake:thing a="1 &amp; 2"/>' in text


@pytest.mark.parametrize(
    "text",
    [
        SDF.format("1.9", "<pose>0 0 0 0 0 0"),
        SDF.format("1.9", "<visual name='v' name='w'/>"),
        SDF.format("1.9", "") + "<sdf version='1.9'/>",
    ],
)
def test_a_broken_text_is_refused(tmp_path: Path, text: str) -> None:
    with pytest.raises(WrongUsage, match=r"main\.sdf:1:\d+: the text is broken here"):
        printed(tmp_path, text)


def test_automatic_inertias(tmp_path: Path) -> None:
    content = f"<inertial auto='true'><density>2</density><!-- kept --></inertial>{BOX}"
    result = printed(tmp_path, SDF.format("1.11", content), CanonicalStyle(expand_auto_inertials=True))
    assert "<mass>12</mass>" in result.text
    assert "<ixx>13</ixx>" in result.text
    assert "<!-- kept -->" in result.text
    assert "auto" not in result.text
    assert result.notes == ()


def test_an_automatic_inertia_that_cannot_be_computed_stays(tmp_path: Path) -> None:
    style = CanonicalStyle(expand_auto_inertials=True)
    result = printed(tmp_path, SDF.format("1.11", "<inertial auto='true'/>"), style)
    assert '<inertial auto="true"/>' in result.text
    assert "no collision" in result.notes[0]


def world(include: str, version: str = "1.12") -> str:
    return f'<sdf version="{version}"><world name="w">{include}</world></sdf>'


def expanded(folder: Path, text: str, **files: str) -> CanonicalText:
    """The expansion of a file, which is the same robots as the file."""
    write(folder, {"arm/model.sdf": ARM, "arm/model.config": CONFIG, "arm/skin.stl": ""})
    write(folder, {**files, "source.sdf": text})
    result = printed(folder, text, EXPANDED)
    assert not compare_files(
        opened(folder / "source.sdf"), opened(folder / "main.sdf"), across_formats=True
    ).changes
    return result


def test_an_include_is_replaced(tmp_path: Path) -> None:
    include = (
        "<include><!-- why --><uri>model://arm</uri><name>left</name><pose>0 1 0 0 0 0</pose><static>true</static>"
        "<placement_frame>tip</placement_frame><plugin filename='f' name='n'/></include>"
    )
    text = expanded(tmp_path, world(include)).text
    assert "<include>" not in text
    assert '<model name="left" placement_frame="tip">' in text
    assert "<static>true</static>" in text
    assert "<pose>0 1 0 0 0 0</pose>" in text
    assert '<plugin filename="f" name="n"/>' in text
    assert "<!-- why -->" in text


def test_includes_are_kept_unless_asked_for(tmp_path: Path) -> None:
    write(tmp_path, {"arm/model.sdf": "<sdf version='1.9'/>"})
    assert (
        "<uri>model://arm</uri>" in printed(tmp_path, world("<include><uri>model://arm</uri></include>")).text
    )


def test_a_merged_model_leaves_a_frame(tmp_path: Path) -> None:
    model = '<sdf version="1.12"><model name="m"><link name="own"/>{}</model></sdf>'
    include = "<include merge='true'><uri>model://arm</uri><pose>0 1 0 0 0 0</pose>{}</include>"
    text = expanded(tmp_path, model.format(include.format(""))).text
    assert '<frame name="_merged__arm__model__" attached_to="base">' in text
    assert '<pose relative_to="__model__">0 1 0 0 0 0</pose>' in text
    assert '<pose relative_to="_merged__arm__model__">0 0 0 0 0 0</pose>' in text
    expanded(tmp_path, model.format(include.format("<placement_frame>grip</placement_frame>")))


def test_a_merged_models_own_frame_is_renamed(tmp_path: Path) -> None:
    part = (
        '<sdf version="1.12"><model name="part"><pose>0 0 2 0 0 0</pose><link name="p"/>'
        '<frame name="f"><pose relative_to="__model__">1 0 0 0 0 0</pose></frame>'
        '<model name="n"><link name="q"><pose relative_to="__model__">1 0 0 0 0 0</pose></link></model>'
        '<joint name="j" type="revolute"><parent>p</parent><child>n::q</child>'
        '<axis><xyz expressed_in="__model__">0 1 0</xyz></axis></joint></model></sdf>'
    )
    text = '<sdf version="1.12"><model name="m"><link name="own"/>{}</model></sdf>'
    include = "<include merge='true'><uri>part.sdf</uri></include>"
    result = expanded(tmp_path, text.format(include), **{"part.sdf": part}).text
    assert 'expressed_in="_merged__part__model__"' in result
    assert '<frame name="f" attached_to="_merged__part__model__">' in result
    assert '<pose relative_to="__model__">1 0 0 0 0 0</pose>' in result, "of the nested model's own frame"


def test_includes_of_includes_and_their_files(tmp_path: Path) -> None:
    skin = (
        '<sdf version="1.12"><model name="skinned"><link name="a"><visual name="v"><geometry><mesh>'
        "<uri>skin.stl</uri></mesh></geometry></visual></link></model></sdf>"
    )
    outer = (
        '<sdf version="1.12"><model name="outer"><link name="a"/>'
        "<include><uri>model://arm/skinned.sdf</uri></include></model></sdf>"
    )
    files = {"arm/skinned.sdf": skin, "sub/outer.sdf": outer}
    text = expanded(tmp_path, world("<include><uri>sub/outer.sdf</uri></include>"), **files).text
    assert "<uri>model://arm/skin.stl</uri>" in text
    assert "<include>" not in text


def test_an_included_file_of_another_version(tmp_path: Path) -> None:
    old = (
        '<sdf version="1.4"><model name="old"><link name="a"/><link name="b"><pose>0 0 0 0 0 1</pose></link>'
        '<joint name="j" type="revolute"><parent>a</parent><child>b</child><axis><xyz>1 0 0</xyz></axis></joint>'
        "</model></sdf>"
    )
    text = expanded(tmp_path, world("<include><uri>old.sdf</uri></include>"), **{"old.sdf": old}).text
    assert "<include>" not in text


def test_an_include_that_cannot_be_expanded_stays(tmp_path: Path) -> None:
    result = expanded(tmp_path, world("<include><uri>model://nowhere</uri></include>"))
    assert "<uri>model://nowhere</uri>" in result.text
    (note,) = result.notes
    assert "main.sdf:" in note
    assert "`model://nowhere` brings nothing" in note


def test_a_ring_of_includes_ends(tmp_path: Path) -> None:
    ring = '<sdf version="1.12"><model name="m"><link name="a"/><include><uri>main.sdf</uri></include></model></sdf>'
    write(tmp_path, {"main.sdf": ring})
    result = canonical(opened(tmp_path / "main.sdf"), EXPANDED)
    assert "includes itself" in result.notes[0]


def test_prefixes_that_the_included_file_declares(tmp_path: Path) -> None:
    part = '<sdf version="1.12" xmlns:my="u"><model name="part"><link name="p"><my:x/></link></model></sdf>'
    text = expanded(tmp_path, world("<include><uri>part.sdf</uri></include>"), **{"part.sdf": part}).text
    assert '<model name="part" xmlns:my="u">' in text


def test_the_text_of_an_element_is_that_before_its_first_child() -> None:
    element = Xml("a")
    element.add("b").tail = "after"
    assert element.content == ""
    element.write("first")
    assert element.content == "first"
    element.write("other")
    assert (element.text, element.nodes[0].tail) == ("other", "after")


def test_words_between_elements_keep_their_blanks_in_plugins_only(tmp_path: Path) -> None:
    words = "one  <b/>  two"
    text = SDF.format("1.9", f"<plugin name='p' filename='f'>{words}</plugin>")
    assert words in printed(tmp_path, text).text
    assert words not in printed(tmp_path, SDF.format("1.9", words)).text
