"""Names: taken, reserved, unsound."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from sdfcheck.files.library import Library
from sdfcheck.robot import names
from sdfcheck.source.document import read
from tests.unit.only import only


def found(text: str, version: str = "1.12") -> list[Any]:
    return names.problems(read(f'<sdf version="{version}">{text}</sdf>'.encode(), Path("example.sdf")))


def in_model(text: str, version: str = "1.12") -> list[Any]:
    return found(f'<model name="m">{text}</model>', version)


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
    assert names.is_reserved(name) is reserved
    kinds = [type(p) for p in in_model(f'<link name="{name}"/>')]
    assert kinds == ([names.ReservedName] if reserved else [])


def test_names_that_nobody_compares_with_the_reserved_ones() -> None:
    assert in_model('<plugin name="__p__" filename="p"/><gripper name="world"/>') == []


def test_duplicates_of_one_kind() -> None:
    problem = only(in_model('<link name="a"/><link name=" a "/>'), names.DuplicateName)
    assert (problem.name, problem.kind, problem.parent.name) == ("a", "link", "model")
    assert problem.first.span.start < problem.value.span.start


def test_other_scopes_are_other_names() -> None:
    assert in_model('<link name="a"><visual name="a"/></link><model name="n"><link name="a"/></model>') == []


def test_plugins_may_share_a_name() -> None:
    assert in_model('<plugin name="a" filename="p"/><plugin name="a" filename="q"/><link name="a"/>') == []


@pytest.mark.parametrize(
    ("text", "version", "makes_frame", "renamed"),
    [
        ('<link name="a"/><joint name="a" type="fixed"/>', "1.7", True, False),
        ('<link name="a"/><joint name="a" type="fixed"/>', "1.6", True, True),
        ('<link name="a"/><gripper name="a"/>', "1.12", True, False),
        ('<link name="a"/><p:a name="a"/>', "1.12", False, False),
    ],
)
def test_clashes_of_kinds(text: str, version: str, makes_frame: bool, renamed: bool) -> None:
    problem = only(in_model(text, version), names.ClashingName)
    assert (problem.makes_frame, problem.renamed) == (makes_frame, renamed)
    assert problem.first_kind == "link"


def test_visuals_and_collisions_make_no_frames() -> None:
    problem = only(
        in_model('<link name="l"><visual name="v"/><collision name="v"/></link>'), names.ClashingName
    )
    assert not problem.makes_frame


def test_what_only_one_may_stand_at_the_root_is_not_told_twice() -> None:
    assert found('<model name="a"/><model name="a"/>') == []
    only(found('<world name="a"/><world name="a"/>'), names.DuplicateName)


# Includes


def test_included_names_are_names() -> None:
    include = "<include><uri>https://example.org/{0}</uri><name>{1}</name></include>"
    text = (
        f'<world name="w"><model name="a"/>{include.format("x", "a")}{include.format("y", "__b__")}</world>'
    )
    taken, reserved = sorted(found(text), key=lambda p: p.value.span.start)
    assert isinstance(taken, names.DuplicateName)
    assert isinstance(reserved, names.ReservedName)
    assert (taken.value.span.text, reserved.value.span.text) == ("a", "__b__")


def test_merged_models_leave_their_name_in_a_frame() -> None:
    include = '<include merge="true"><uri>https://example.org/x</uri><name>a</name></include>'
    assert in_model(f'<link name="a"/>{include}') == []
    assert only(in_model(include + include), names.DuplicateName).name == "_merged__a__model__"


def test_names_from_included_files(tmp_path: Path) -> None:
    (tmp_path / "arm.sdf").write_text('<sdf version="1.9"><model name="arm"><link name="l"/></model></sdf>')
    world = '<world name="w"><model name="arm"/><include><uri>arm.sdf</uri></include></world>'
    path = tmp_path / "world.sdf"
    path.write_text(f'<sdf version="1.9">{world}</sdf>')
    document = Library().document(path)
    assert document is not None
    problem = only(list(names.problems(document)), names.DuplicateName)
    assert (problem.name, problem.value.span.text) == ("arm", "arm.sdf")


# Delimiters


@pytest.mark.parametrize(("version", "refused"), [("1.7", False), ("1.8", True)])
def test_delimiters_in_names(version: str, refused: bool) -> None:
    problem = only(in_model('<link name="a::b"/>', version), names.DelimiterInName)
    assert (problem.refused, problem.foreign) == (refused, None)


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
        ('<link name="A::l"><visual name="v"><pose relative_to="b"/></visual></link>', "b"),
        ('<link name="A::l"><sensor name="s"><camera><pose relative_to="b"/></camera></sensor></link>', "b"),
    ],
)
def test_references_that_cannot_be_unfolded(text: str, foreign: str | None) -> None:
    problem = only(
        found(f'<world name="w"><model name="m">{text}</model></world>', "1.7"), names.DelimiterInName
    )
    assert (problem.foreign.text if problem.foreign is not None else None) == foreign


def test_an_axis_without_direction_cannot_be_unfolded() -> None:
    text = JOINT.format("A::x", "A::y", "<axis/>")
    problem = only(
        found(f'<world name="w"><model name="m">{text}</model></world>', "1.6"), names.DelimiterInName
    )
    assert problem.foreign.name == "axis"


def test_only_worlds_are_unfolded() -> None:
    problem = only(in_model('<frame name="A::f" attached_to="b"/>', "1.7"), names.DelimiterInName)
    assert problem.foreign is None


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
        kinds = [type(p) for p in in_model(text)]
        assert kinds == ([names.MalformedScopedName] if malformed else []), text


def test_the_root_frame_of_an_imu() -> None:
    rotation = (
        '<orientation_reference_frame><custom_rpy parent_frame="__root__"/></orientation_reference_frame>'
    )
    text = f'<link name="l"><sensor name="s" type="imu"><imu>{rotation}</imu></sensor></link>'
    assert only(in_model(text), names.ReservedName).is_reference
