"""Scopes with included models in them; however often models include each other, they end."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.robot.graph import Model
from sdfcheck.robot.includes.included import problems
from sdfcheck.robot.root import root_of
from tests.unit.robot.files import MODEL, WORLD, document, opened, write


def nested(uri: str, name: str, merge: str = "false") -> str:
    return f'<include merge="{merge}"><uri>{uri}</uri><name>{name}</name></include>'


def test_references_reach_into_included_models(tmp_path: Path) -> None:
    scope = root_of(document(tmp_path, WORLD.format(nested("arm.sdf", "left")))).scopes[0]
    assert scope.resolve("left::tip") is not None
    assert scope.resolve("left::toe") is None
    assert not scope.may_hold("left::toe")


def test_merged_models_give_their_frames(tmp_path: Path) -> None:
    scope = root_of(document(tmp_path, MODEL.format(nested("arm.sdf", "left", "true")))).scopes[0]
    assert set(scope.nodes) == {"base", "tip", "elbow", "grip", "_merged__left__model__"}


def test_a_urdf_gives_its_links_and_joints(tmp_path: Path) -> None:
    robot = '<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed"/></robot>'
    scope = root_of(document(tmp_path, WORLD.format(nested("robot.sdf", "r")), robot=robot)).scopes[0]
    assert [name for name in ("r::a", "r::b", "r::j") if scope.resolve(name) is None] == []


def test_an_include_that_could_not_be_read_may_hold_anything(tmp_path: Path) -> None:
    named, merged = (
        root_of(document(tmp_path, MODEL.format(nested("gone.sdf", "x", merge)))).scopes[0]
        for merge in ("0", "1")
    )
    assert named.may_hold("x::link")
    assert not named.may_hold("y")
    assert merged.may_hold("y")


def test_a_merged_model_moves_with_a_link_that_it_merges_itself(tmp_path: Path) -> None:
    inner = '<link name="tip"/>'
    (tmp_path / "inner.sdf").write_text(f'<sdf version="1.12"><model name="inner">{inner}</model></sdf>')
    outer = '<include merge="true"><uri>inner.sdf</uri></include>'
    (tmp_path / "outer.sdf").write_text(f'<sdf version="1.12"><model name="outer">{outer}</model></sdf>')
    text = MODEL.format('<link name="base"/><include merge="true"><uri>outer.sdf</uri></include>')
    scope = root_of(document(tmp_path, text)).scopes[0]
    for name in ("outer", "inner"):
        carrier = scope.nodes[f"_merged__{name}__model__"].carrier
        assert carrier is not None
        assert carrier.name == "tip"


def test_an_include_may_make_a_model_static(tmp_path: Path) -> None:
    text = WORLD.format("<include><uri>arm.sdf</uri><static>true</static></include>")
    (frame,) = root_of(document(tmp_path, text)).scopes[0].nodes.values()
    assert isinstance(frame, Model)
    assert frame.is_static


@pytest.mark.parametrize("merge", ["false", "true"])
def test_a_model_in_itself_ends(tmp_path: Path, merge: str) -> None:
    found = document(tmp_path, MODEL.format('<link name="l"/>' + nested("main.sdf", "again", merge)))
    assert len(list(root_of(found).scopes[0].names())) < 500
    assert not any(reference.is_unresolved for reference in root_of(found).frame_references)
    assert not root_of(found).rings
    list(problems(found))


@pytest.mark.parametrize("merge", ["false", "true"])
def test_models_that_multiply_end(tmp_path: Path, merge: str) -> None:
    for n in range(40):
        two = nested(f"{n + 1}.sdf", "a", merge) + nested(f"{n + 1}.sdf", "b", merge)
        write(tmp_path, {f"{n}.sdf": MODEL.format(two)})
    write(tmp_path, {"40.sdf": MODEL.format("")})
    remove = '<experimental:params><link element_id="a::nowhere" action="remove"/></experimental:params>'
    write(tmp_path, {"main.sdf": WORLD.format(f"<include><uri>0.sdf</uri>{remove}</include>")})
    found = opened(tmp_path / "main.sdf")
    assert not any(reference.is_unresolved for reference in root_of(found).frame_references)
    assert not root_of(found).rings
    assert len(list(problems(found))) < 3


def test_a_long_chain_of_models_ends(tmp_path: Path) -> None:
    for n in range(400):
        write(tmp_path, {f"{n}.sdf": MODEL.format(nested(f"{n + 1}.sdf", "a"))})
    write(tmp_path, {"400.sdf": MODEL.format('<link name="l"/>')})
    found = opened(tmp_path / "0.sdf")
    assert not any(reference.is_unresolved for reference in root_of(found).frame_references)
    assert not root_of(found).rings
    assert list(problems(found)) == []
