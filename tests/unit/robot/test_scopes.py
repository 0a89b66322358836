"""Scopes: which names a reference can reach."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.files.library import Library
from sdfcheck.robot.graph import Model, Scope
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document, read

NESTED = """<sdf version="1.12"><world name="w">
  <model name="m"><link name="a"/><frame name="f"/>
    <model name="n"><static>1</static><link name="b"/><joint name="j" type="fixed"/></model></model>
  <frame name="g"/></world></sdf>"""


def document(text: str) -> Document:
    return read(text.encode(), Path("example.sdf"))


def first(text: str) -> Scope:
    return root_of(document(text)).scopes[0]


@pytest.mark.parametrize(
    ("reference", "kind"),
    [
        ("world", "world"),
        ("m", "model"),
        ("g", "frame"),
        ("m::a", "link"),
        ("m::n::j", "joint"),
        ("m::__model__", "model"),
        ("m::world", None),
        ("a", None),
        ("__model__", None),
        ("m::n::", None),
        ("::m", None),
    ],
)
def test_references_reach_down(reference: str, kind: str | None) -> None:
    found = first(NESTED).resolve(reference)
    assert (found.kind if found else None) == kind


def test_references_do_not_reach_up() -> None:
    world = first(NESTED)
    (model,) = world.models
    (nested,) = model.models
    assert nested.resolve("a") is None
    assert nested.resolve("__model__") is nested
    assert model.resolve("world") is None


def test_names_are_listed_with_their_scopes() -> None:
    assert list(first(NESTED).names()) == ["m", "m::a", "m::f", "m::n", "m::n::b", "m::n::j", "g"]


def test_the_innermost_scope_of_an_element() -> None:
    parsed = document(NESTED)
    found = root_of(parsed)
    assert parsed.root is not None
    scope = found.scope_of(found.scopes[0].resolve("m::n::j").element)  # type: ignore[union-attr]
    assert scope is not None
    assert scope.name == "n"
    assert found.scope_of(parsed.root) is None
    assert [scope.name for scope in found.all_scopes()] == ["w", "m", "n"]


def test_the_first_of_one_name_counts() -> None:
    scope = first('<sdf version="1.12"><model name="m"><link name="a"/><frame name="a"/></model></sdf>')
    assert scope.nodes["a"].kind == "link"


def test_a_part_that_cannot_be_read_may_hold_anything(tmp_path: Path) -> None:
    file = tmp_path / "model.sdf"
    file.write_text(
        '<sdf version="1.12"><model name="m"><link name="a"/>'
        "<include><uri>not_here.sdf</uri><name>n</name></include></model></sdf>"
    )
    parsed = Library().document(file)
    assert parsed is not None
    scope = root_of(parsed).scopes[0]
    assert scope.may_hold("n::x")
    assert not scope.may_hold("x")
    assert not scope.may_hold("a::x")


def test_included_models_are_scopes(tmp_path: Path) -> None:
    (tmp_path / "arm.sdf").write_text(
        '<sdf version="1.12"><model name="arm"><link name="hand"/></model></sdf>'
    )
    file = tmp_path / "model.sdf"
    file.write_text(
        '<sdf version="1.12"><model name="m"><include><uri>arm.sdf</uri></include>'
        '<include merge="true"><uri>arm.sdf</uri><name>other</name></include></model></sdf>'
    )
    parsed = Library().document(file)
    assert parsed is not None
    scope = root_of(parsed).scopes[0]
    assert list(scope.nodes) == ["arm", "hand", "_merged__other__model__"]
    found = scope.resolve("arm::hand")
    assert found is not None
    assert isinstance(found.scope, Model)
    assert found.scope.include is not None


def test_before_1_7_the_later_of_two_kinds_gets_another_name() -> None:
    links = '<link name="a"/><link name="b"/>'
    text = f'<sdf version="{{}}"><model name="m"><joint name="b" type="fixed"/>{links}</model></sdf>'
    for version, expected in (("1.6", {"a", "b", "b_joint"}), ("1.7", {"a", "b"})):
        (scope,) = root_of(document(text.format(version))).scopes
        assert set(scope.nodes) == expected
