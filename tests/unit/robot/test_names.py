"""Names: taken, reserved, unsound."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.robot.naming.names import Names
from sdfcheck.robot.root import root_of
from tests.unit.only import only
from tests.unit.robot.files import MODEL, WORLD, document

FAMILY = "NAM"


def linted(text: str | Path, name: str = "model.sdf") -> list[sdfcheck.Diagnostic]:
    run = sdfcheck.lint(text, isolated=True, name=name)
    return [diagnostic for diagnostic in run.diagnostics if diagnostic.code.startswith(FAMILY)]


def found(text: str, version: str = "1.12") -> list[sdfcheck.Diagnostic]:
    return linted(f'<sdf version="{version}">{text}</sdf>')


def in_model(text: str, version: str = "1.12") -> list[str]:
    return [diagnostic.name for diagnostic in found(f'<model name="m">{text}</model>', version)]


@pytest.mark.parametrize(
    ("name", "reserved"),
    [
        ("world", True),
        ("__model__", True),
        ("____", True),
        ("___", False),
        ("__a", False),
        ("a__", False),
        ("W", False),
    ],
)
def test_reserved_names(name: str, reserved: bool) -> None:
    assert in_model(f'<link name="{name}"/>') == (["reserved-name"] if reserved else [])


def test_names_that_nobody_compares_with_the_reserved_ones() -> None:
    assert in_model('<plugin name="__p__" filename="p"/><gripper name="world"/>') == []


def test_duplicates_of_one_kind() -> None:
    (diagnostic,) = found('<model name="m"><link name="a"/><link name=" a "/></model>')
    assert diagnostic.message == "there is another link `a` in model `m`"
    assert diagnostic.labels[0].span.start < diagnostic.span.start


def test_other_scopes_are_other_names() -> None:
    assert in_model('<link name="a"><visual name="a"/></link><model name="n"><link name="a"/></model>') == []


def test_plugins_may_share_a_name() -> None:
    assert in_model('<plugin name="a" filename="p"/><plugin name="a" filename="q"/><link name="a"/>') == []


@pytest.mark.parametrize(
    ("text", "version", "severity", "renamed"),
    [
        ('<link name="a"/><joint name="a" type="fixed"/>', "1.7", "error", False),
        ('<link name="a"/><joint name="a" type="fixed"/>', "1.6", "warning", True),
        ('<link name="a"/><gripper name="a"/>', "1.6", "error", False),
        ('<link name="a"/><p:a name="a"/>', "1.12", "warning", False),
        ('<link name="l"><visual name="v"/><collision name="v"/></link>', "1.12", "warning", False),
    ],
)
def test_clashes_of_kinds(text: str, version: str, severity: str, renamed: bool) -> None:
    diagnostic = only(found(f'<model name="m">{text}</model>', version), sdfcheck.Diagnostic)
    assert (diagnostic.name, diagnostic.severity.value) == ("clashing-name", severity)
    assert ("renames it" in diagnostic.message) is renamed


def test_a_second_root_element_is_not_reported_twice() -> None:
    assert found('<model name="a"/><model name="a"/>') == []
    assert [each.name for each in found('<world name="a"/><world name="a"/>')] == ["duplicate-name"]


def test_plain_names_are_not_listed() -> None:
    text = '<sdf version="1.12"><model name="m"><link name="a"/><frame name="b"/></model></sdf>'
    names: Names = root_of(sdfcheck.parse(text).document).names
    assert (names.special, names.shared) == ((), ())


# URDF


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('<link name="a"/><link name="b"/><joint name="b"/>', [("clashing-name", "b")]),
        ('<link name="a"/><link name="a"/>', [("duplicate-name", "a")]),
        ('<link name="a"/><joint name="j"/><joint name="j"/>', [("duplicate-name", "j")]),
        ('<link name="a"/><material name="a"/>', []),
        ('<link name="a"/><material name="m"/><material name="m"/>', [("duplicate-name", "m")]),
        (
            '<link name="a"/><joint name="a"/><joint name="a"/>',
            [("clashing-name", "a"), ("duplicate-name", "a")],
        ),
        ('<link name="world"/>', []),
        ('<link name="__a__"/>', [("reserved-name", "__a__")]),
        ('<link name="a::b"/>', [("delimiter-in-name", "a::b")]),
        ('<link name="a"/><material name="__a::b__"/>', []),
        ('<link name=" "/>', [("empty-name", "")]),
    ],
)
def test_names_of_urdf(text: str, expected: list[tuple[str, str]]) -> None:
    diagnostics = linted(f'<robot name="r">{text}</robot>', "robot.urdf")
    assert [(each.name, each.span.text.strip()) for each in diagnostics] == expected


def test_a_robot_without_a_name() -> None:
    assert [each.name for each in linted('<robot name=""><link name="a"/></robot>', "robot.urdf")] == [
        "empty-name"
    ]


# Includes


def test_included_names_are_names() -> None:
    include = "<include><uri>https://example.org/{0}</uri><name>{1}</name></include>"
    text = (
        f'<world name="w"><model name="a"/>{include.format("x", "a")}{include.format("y", "__b__")}</world>'
    )
    assert [(each.name, each.span.text) for each in found(text)] == [
        ("duplicate-name", "a"),
        ("reserved-name", "__b__"),
    ]


def test_merged_models_leave_their_name_in_a_frame() -> None:
    include = '<include merge="true"><uri>https://example.org/x</uri><name>a</name></include>'
    assert in_model(f'<link name="a"/>{include}') == []
    (diagnostic,) = found(f'<model name="m">{include}{include}</model>')
    assert "`_merged__a__model__`" in diagnostic.message


def test_names_from_included_files(tmp_path: Path) -> None:
    (tmp_path / "arm.sdf").write_text('<sdf version="1.9"><model name="arm"><link name="l"/></model></sdf>')
    world = '<world name="w"><model name="arm"/><include><uri>arm.sdf</uri></include></world>'
    path = tmp_path / "world.sdf"
    path.write_text(f'<sdf version="1.9">{world}</sdf>')
    assert [(each.name, each.span.text) for each in linted(path)] == [("duplicate-name", "arm.sdf")]


def include(uri: str, more: str = "", merge: str = "false") -> str:
    return f'<include merge="{merge}"><uri>{uri}</uri>{more}</include>'


@pytest.mark.parametrize(
    ("beside", "kinds"),
    [
        ('<link name="base"/>', ("link", "link")),
        ('<frame name="elbow"/>', ("frame", "joint")),
        (include("other.sdf", "<name>tip</name>"), ("model", "link")),
        (include("other.sdf", merge="true"), ("link", "link")),
    ],
)
def test_names_that_a_merged_model_brings(tmp_path: Path, beside: str, kinds: tuple[str, str]) -> None:
    other = '<sdf version="1.12"><model name="o"><link name="base"/></model></sdf>'
    text = MODEL.format(beside + include("arm.sdf", merge="true"))
    ((first, later),) = root_of(document(tmp_path, text, other=other)).names.shared
    assert (first.kind, later.kind, later.is_merged) == (*kinds, True)
    assert later.value.text == "arm.sdf"


def test_the_root_frame_places_nothing(tmp_path: Path) -> None:
    path = tmp_path / "world.sdf"
    placed = include("arm.sdf", "<pose/><placement_frame>__root__</placement_frame>")
    document(tmp_path, WORLD.format(placed))
    path.write_text(WORLD.format(placed))
    assert [(each.name, each.span.text) for each in linted(path)] == [("reserved-name", "__root__")]


# Delimiters


@pytest.mark.parametrize(("version", "severity"), [("1.7", "info"), ("1.8", "error")])
def test_delimiters_in_names(version: str, severity: str) -> None:
    (diagnostic,) = found('<model name="m"><link name="a::b"/></model>', version)
    assert (diagnostic.name, diagnostic.severity.value) == ("delimiter-in-name", severity)


def test_delimiters_that_are_free() -> None:
    assert in_model('<plugin name="a::b" filename="p"/><p:a name="a::b"/>') == []


JOINT = '<joint name="A::j" type="revolute"><parent>{}</parent><child>{}</child>{}</joint>'


@pytest.mark.parametrize(
    ("text", "foreign"),
    [
        ('<frame name="A::f" attached_to="b"/>', "b"),
        ('<frame name="A::f" attached_to="A::x"/>', None),
        ('<frame name="A::f"><pose relative_to="b"/></frame>', None),
        (JOINT.format("A::x", "A::y", ""), None),
        (JOINT.format("world", "A::y", ""), "world"),
        (JOINT.format("A::x", "A::y", '<axis><xyz expressed_in="b">1 0 0</xyz></axis>'), "b"),
        (JOINT.format("A::x", "A::y", "<axis/>"), "axis"),
        ('<link name="A::l"><visual name="v"><pose relative_to="b"/></visual></link>', "b"),
        ('<link name="A::l"><sensor name="s"><camera><pose relative_to="b"/></camera></sensor></link>', "b"),
    ],
)
def test_references_that_cannot_be_unfolded(text: str, foreign: str | None) -> None:
    for inside in (text, f'<model name="n">{text}</model>'):
        (diagnostic,) = found(f'<world name="w"><model name="m">{inside}</model></world>', "1.7")
        assert diagnostic.name == "delimiter-in-name"
        assert [label.span.text for label in diagnostic.labels] == ([] if foreign is None else [foreign])


def test_only_worlds_are_unfolded() -> None:
    (diagnostic,) = found('<model name="m"><frame name="A::f" attached_to="b"/></model>', "1.7")
    assert diagnostic.labels == ()


# References


@pytest.mark.parametrize(
    ("reference", "malformed"),
    [("a::b", False), ("::b", True), ("a::", True), ("a::::b", True), ("a", False)],
)
def test_references(reference: str, malformed: bool) -> None:
    texts = (
        f'<frame name="f" attached_to="{reference}"/>',
        f'<joint name="j" type="fixed"><parent>{reference}</parent><child>l</child></joint>',
        f'<gripper name="g"><palm_link>{reference}</palm_link></gripper>',
    )
    for text in texts:
        assert in_model(text) == (["malformed-scoped-name"] if malformed else []), text


def test_the_root_frame_of_an_imu() -> None:
    rotation = (
        '<orientation_reference_frame><custom_rpy parent_frame="__root__"/></orientation_reference_frame>'
    )
    text = f'<link name="l"><sensor name="s" type="imu"><imu>{rotation}</imu></sensor></link>'
    assert in_model(text) == ["reserved-name"]
