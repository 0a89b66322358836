"""Standard elements inside custom ones: moved there, or only of the same name."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.formats.sdf.survey import Survey, survey
from sdfcheck.formats.urdf.survey import survey as urdf_survey
from sdfcheck.source.document import read

IN_MODEL = '<sdf version="1.12" xmlns:p="urn:p"><model name="m"><link name="base"/>{}</model></sdf>'
IN_WORLD = '<sdf version="1.12" xmlns:p="urn:p"><world name="w">{}</world></sdf>'
IN_LINK = '<sdf version="1.12" xmlns:p="urn:p"><model name="m"><link name="base">{}</link></model></sdf>'
JOINT = '<joint name="j" type="fixed"><parent>world</parent><child>base</child></joint>'
BOX = "<geometry><box><size>1 1 1</size></box></geometry>"


def surveyed(text: str) -> Survey:
    return survey(read(text.encode(), Path("example.sdf")))


def displaced(text: str) -> list[tuple[str, list[str]]]:
    """Custom elements and the titles of the standard ones in them that could be beside them."""
    found = surveyed(text).noted.displaced
    return [(custom.name, [each.element.title for each in elements]) for custom, elements in found.items()]


@pytest.mark.parametrize(
    ("scaffold", "inner", "name"),
    [
        (IN_MODEL, '<link name="L1"/>', "link"),
        (IN_MODEL, '<link name="L1"><pose>0 0 1 0 0 0</pose></link>', "link"),
        (IN_MODEL, JOINT, "joint"),
        (IN_MODEL, '<frame name="f"/>', "frame"),
        (IN_MODEL, "<include><uri>model://arm</uri></include>", "include"),
        (IN_WORLD, '<model name="m"><link name="l"/></model>', "model"),
        (IN_WORLD, '<light name="l" type="point"/>', "light"),
        (IN_LINK, f'<visual name="v">{BOX}</visual>', "visual"),
        (IN_LINK, f'<collision name="v">{BOX}</collision>', "collision"),
        (IN_LINK, "<inertial><mass>1</mass></inertial>", "inertial"),
        (IN_LINK, '<sensor name="s" type="imu"/>', "sensor"),
    ],
)
def test_a_wrapped_standard_element(scaffold: str, inner: str, name: str) -> None:
    found = surveyed(scaffold.replace("{}", f"<p:group>{inner}</p:group>")).noted.displaced
    ((custom, ((element, is_needed),)),) = found.items()
    assert is_needed
    assert (element.name, custom.name) == (name, "p:group")
    assert element.parent == custom


VISUAL = '<visual name="v">{}</visual>'
AXIS = '<joint name="j" type="revolute"><parent>world</parent><child>base</child><axis>{}</axis></joint>'


@pytest.mark.parametrize(
    ("scaffold", "name", "inner", "is_needed"),
    [
        (IN_MODEL, "static", "<static>true</static>", False),
        (IN_LINK.replace("{}", "<inertial>{}</inertial>"), "mass", "<mass>3</mass>", False),
        (IN_LINK.replace("{}", VISUAL), "geometry", BOX, True),
        (IN_LINK.replace("{}", VISUAL), "material", "<material><diffuse>1 0 0 1</diffuse></material>", False),
        (IN_LINK.replace("{}", VISUAL.replace("{}", "<geometry>{}</geometry>")), "box", BOX[10:-11], True),
        (IN_MODEL.replace("{}", AXIS), "xyz", "<xyz>1 0 0</xyz>", True),
    ],
)
def test_a_wrapped_setting(scaffold: str, name: str, inner: str, is_needed: bool) -> None:
    found = surveyed(scaffold.replace("{}", f"<p:group>{inner}</p:group>"))
    ((element, needed),) = next(iter(found.noted.displaced.values()))
    assert (element.name, needed) == (name, is_needed)
    # That it is missing where it belongs is the same mistake.
    assert found.problems == []


ROBOT = '<robot name="r" xmlns:p="urn:p"><link name="a"/><link name="b">{}</link>{}</robot>'
HELD = '<joint name="j" type="{}"><parent link="a"/><child link="b"/>{}</joint>'


@pytest.mark.parametrize(
    ("in_link", "beside", "names"),
    [
        ("", '<p:g><link name="c"/></p:g>', ["link"]),
        ("<inertial><p:g><mass value='3'/></p:g></inertial>", "", ["mass"]),
        ("", HELD.format("fixed", "<p:g><origin xyz='0 0 1'/></p:g>"), ["origin"]),
        ("", HELD.format("fixed", "<p:g><origin xyz='up'/></p:g>"), []),
        ("", HELD.format("fixed", "<p:g><origin xyz='0 0 1'/></p:g><origin/>"), []),
        ("", "<p:joint name='k'><parent link='a'/><child link='b'/><origin xyz='0 0 1'/></p:joint>", []),
        ("", "<p:g><transmission name='t'><type>x</type></transmission></p:g>", []),
    ],
)
def test_urdf(in_link: str, beside: str, names: list[str]) -> None:
    document = read(ROBOT.format(in_link, beside).encode(), Path("r.urdf"))
    found = urdf_survey(document).displaced.values()
    assert [each.element.name for elements in found for each in elements] == names


def test_every_wrapped_element_is_displaced_and_nothing_in_it() -> None:
    text = IN_MODEL.replace("{}", '<p:g><link name="a"><pose/></link><link name="b"/></p:g>')
    assert displaced(text) == [("p:g", ["link `a`", "link `b`"])]


def test_custom_elements_in_custom_elements_are_looked_into() -> None:
    text = IN_MODEL.replace("{}", '<p:g><p:h><link name="a"/></p:h></p:g>')
    assert displaced(text) == [("p:g", ["link `a`"])]


def test_shapes_that_no_link_has_are_displaced() -> None:
    shapes = f'<collision name="c">{BOX}</collision><visual name="v">{BOX}</visual>{BOX}'
    for scaffold in (IN_MODEL, IN_WORLD):
        found = displaced(scaffold.replace("{}", f"<p:g>{shapes}</p:g>"))
        assert found == [("p:g", ["collision `c`", "visual `v`", "`geometry`"])]


@pytest.mark.parametrize(
    ("scaffold", "custom"),
    [
        (IN_MODEL, '<p:joint name="j"><p:child>base</p:child></p:joint>'),
        (IN_MODEL, '<p:g><joint name="j"><interface>effort</interface></joint></p:g>'),
        (IN_MODEL, "<p:g><joint>j</joint></p:g>"),
        (IN_MODEL, "<p:g><link>base</link></p:g>"),
        (IN_MODEL, '<p:g><link name="a" weight="3"/></p:g>'),
        (IN_MODEL, '<p:g><link name="base"/></p:g>'),
        (IN_MODEL, "<p:g mode='2d'><static>1</static></p:g>"),
        (IN_MODEL, "<p:g><static>1</static><gain>3</gain></p:g>"),
        (IN_MODEL, "<p:g>when <static>1</static></p:g>"),
        (IN_MODEL, "<static>0</static><p:g><static>1</static></p:g>"),
        (IN_MODEL, "<p:g><pose>0 0.0 0 0 0 0</pose><static>0</static></p:g>"),
        (IN_MODEL, "<p:g><static>perhaps</static></p:g>"),
        (IN_LINK, "<inertial><p:g><mass unit='g'>2</mass></p:g></inertial>"),
        (IN_LINK, f'<visual name="v">{BOX}<p:g>{BOX}</p:g></visual>'),
        (IN_MODEL, f'<p:g mode="2d"><visual name="v">{BOX}</visual></p:g>'),
        (IN_MODEL, '<p:g><visual name="v"><color>red</color></visual></p:g>'),
        (IN_WORLD, '<p:g><link name="a"/></p:g>'),
        (IN_WORLD, '<plugin name="g" filename="g"><model name="a"/></plugin>'),
        (IN_LINK, "<p:inertial><mass>1</mass></p:inertial>"),
        (IN_LINK, "<p:g><inertial>no</inertial></p:g>"),
    ],
)
def test_content_that_only_borrows_a_name(scaffold: str, custom: str) -> None:
    assert displaced(scaffold.replace("{}", custom)) == []
    assert surveyed(scaffold.replace("{}", custom)).problems == []


CYLINDER = '<visual name="v"><geometry><cylinder>{}</cylinder></geometry></visual>'


def test_a_custom_element_in_the_place_of_a_required_one() -> None:
    cylinder = CYLINDER.format("<p:diameter>2</p:diameter><length>1</length>")
    found = surveyed(IN_LINK.replace("{}", cylinder))
    assert [(custom.name, names) for custom, names in found.noted.replaced.items()] == [
        ("p:diameter", ["radius"])
    ]
    assert found.problems == []


def test_a_custom_element_beside_the_required_one() -> None:
    cylinder = CYLINDER.format("<p:diameter>2</p:diameter><radius>1</radius><length>1</length>")
    found = surveyed(IN_LINK.replace("{}", cylinder))
    assert (found.noted.replaced, found.problems) == ({}, [])
