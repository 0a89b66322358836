"""Frames: references to nothing, rings, models without links."""

from __future__ import annotations

from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.robot.root import Root, root_of
from sdfcheck.source.document import read
from tests.unit.robot.files import document

NESTED = '<model name="n"><pose relative_to="f"/><link name="l"/></model>'


def root(text: str, version: str = "1.12") -> Root:
    whole = f'<sdf version="{version}">{text}</sdf>'
    return root_of(read(whole.encode(), Path("example.sdf")))


def unresolved(text: str, version: str = "1.12") -> list[tuple[str, str]]:
    references = root(text, version).frame_references
    return [(reference.role, reference.name) for reference in references if reference.is_unresolved]


def reported(text: str, code: str) -> list[sdfcheck.Diagnostic]:
    run = sdfcheck.lint(f'<sdf version="1.12">{text}</sdf>', isolated=True, name="model.sdf")
    return [diagnostic for diagnostic in run.diagnostics if diagnostic.code == code]


def model(text: str, attributes: str = "") -> str:
    return f'<model name="m"{attributes}><link name="base"/>{text}</model>'


@pytest.mark.parametrize(
    ("text", "role"),
    [
        ('<frame name="f" attached_to="q"/>', "attached_to"),
        ('<frame name="f" attached_to="__root__"/>', "attached_to"),
        ('<frame name="f"><pose relative_to="q"/></frame>', "relative_to"),
        ('<link name="l"><sensor name="s" type="imu"><pose relative_to="q"/></sensor></link>', "relative_to"),
        ('<link name="l"><light name="s" type="point"><pose relative_to="q"/></light></link>', "relative_to"),
        (
            '<joint name="j" type="revolute"><axis><xyz expressed_in="q">0 0 1</xyz></axis></joint>',
            "expressed_in",
        ),
    ],
)
def test_unknown_frames(text: str, role: str) -> None:
    ((found, _),) = unresolved(model(text))
    assert found == role


@pytest.mark.parametrize(
    "text",
    [
        '<link name="l"><inertial><pose relative_to="q"/></inertial></link>',
        '<plugin filename="p" name="p"><pose relative_to="q"/></plugin>',
        '<link name="l"><p:visual xmlns:p="https://example.org/p"><pose relative_to="q"/></p:visual></link>',
        '<frame name="f"><pose relative_to=" base "/></frame>',
        '<frame name="f" attached_to="::base"/>',
    ],
)
def test_a_value_that_is_not_a_reference_or_a_sound_one(text: str) -> None:
    assert unresolved(model(text)) == []


def test_the_old_spelling_of_references() -> None:
    text = model('<link name="l"><pose frame="q"/></link>')
    assert unresolved(text, "1.6") == [("relative_to", "q")]
    assert unresolved(text, "1.7") == []


def test_references_know_what_they_name() -> None:
    inner = '<model name="n"><link name="palm"/><frame name="f" attached_to="palm"/></model>'
    first, second = root(model(f'{inner}<frame name="g" attached_to="n::f"/>')).frame_references
    assert first.scope is not None
    assert (first.scope.name, first.target, first.owner.name) == ("n", first.scope.nodes["palm"], "f")
    assert second.target is first.owner


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ('<frame name="f" attached_to="Base"/>', "did you mean `base`?"),
        (
            '<model name="n"><link name="palm"/></model><frame name="f" attached_to="palm"/>',
            "there is `n::palm`",
        ),
        (
            '<model name="n"><link name="l"><pose relative_to="base"/></link></model>',
            "it is defined outside, out of reach",
        ),
        ('<frame name="frame1" attached_to="frame2"/>', "is not a frame of model `m`"),
    ],
)
def test_the_intended_name(text: str, says: str) -> None:
    (diagnostic,) = reported(model(text), "FRM001")
    assert diagnostic.message.endswith(says)


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ('<frame name="a" attached_to="b"/><frame name="b" attached_to="a"/>', ("a", "b")),
        ('<frame name="z" attached_to="a"/><frame name="a" attached_to="a"/>', ("a",)),
        (f'{NESTED}<frame name="f" attached_to="n"/>', ("n", "f")),
        (f'{NESTED}<frame name="f" attached_to="n::l"/>', ("n", "f")),
        (
            '<link name="a"><pose relative_to="b"/></link><link name="b"><pose relative_to="a"/></link>',
            ("a", "b"),
        ),
    ],
)
def test_a_ring_is_reported_once(text: str, names: tuple[str, ...]) -> None:
    (ring,) = root(model(text)).rings
    assert ring.names == names


def test_placement_frames_lead_nowhere() -> None:
    inner = '<model name="n" placement_frame="l"><pose relative_to="base"/><link name="l"/></model>'
    assert root(model(inner)).rings == ()


def test_a_ring_by_way_of_an_included_file(tmp_path: Path) -> None:
    include = '<include><uri>arm.sdf</uri><pose relative_to="arm::grip"/></include>'
    (ring,) = root_of(document(tmp_path, f'<sdf version="1.12">{model(include)}</sdf>')).rings
    assert (ring.role, ring.names[0]) == ("relative_to", "arm")


def test_a_ring_of_an_included_file_is_reported_there(tmp_path: Path) -> None:
    ring = '<frame name="a" attached_to="b"/><frame name="b" attached_to="a"/>'
    other = f'<sdf version="1.12"><model name="other"><link name="l"/>{ring}</model></sdf>'
    text = model('<include><uri>other.sdf</uri></include><frame name="f" attached_to="other::a"/>')
    found = root_of(document(tmp_path, f'<sdf version="1.12">{text}</sdf>', other=other))
    assert [reference.target is not None for reference in found.frame_references] == [True]
    assert found.rings == ()


@pytest.mark.parametrize(
    ("text", "bare"),
    [
        ('<model name="m"/>', ["m"]),
        ('<model name="m"><static>true</static></model>', []),
        ('<model name="m"><static>true</static><model name="n"/></model>', ["n"]),
        ('<model name="m"><model name="n"><static>1</static></model></model>', []),
        ('<model name="m"><link/></model>', []),
        ('<world name="w"><model name="m"><frame name="f"/></model></world>', ["m"]),
        ('<world name="w"><model name="m"><include/></model></world>', []),
    ],
)
def test_models_without_links(text: str, bare: list[str]) -> None:
    assert [diagnostic.message.split("`")[1] for diagnostic in reported(text, "FRM005")] == bare


@pytest.mark.parametrize(("name", "kind"), [("q", None), ("f", "frame"), ("n", "model")])
def test_canonical_links_are_links(name: str, kind: str | None) -> None:
    text = '<frame name="f"/><model name="n"><link name="l"/></model>'
    (diagnostic,) = reported(model(text, f' canonical_link="{name}"'), "FRM003")
    assert diagnostic.message == (
        f"`{name}` is a {kind}, not a link" if kind else "`q` is not a link of model `m`"
    )
    assert reported(model(text, ' canonical_link="n::l"'), "FRM003") == []


def test_placement_frames_of_includes(tmp_path: Path) -> None:
    (tmp_path / "arm.sdf").write_text(
        '<sdf version="1.12"><model name="arm"><link name="hand"/></model></sdf>'
    )
    file = tmp_path / "world.sdf"
    include = (
        "<include><uri>arm.sdf</uri><name>{0}</name><pose/><placement_frame>{0}</placement_frame></include>"
    )
    parts = "".join(include.format(name) for name in ("hand", "foot"))
    file.write_text(f'<sdf version="1.12"><world name="w">{parts}</world></sdf>')
    run = sdfcheck.lint(file, isolated=True, select=["FRM004"])
    assert [diagnostic.span.text for diagnostic in run.diagnostics] == ["foot"]


def test_poses_at_the_top_of_the_file() -> None:
    text = '<model name="m"><pose relative_to="world"/><link name="l"/></model>'
    assert [diagnostic.code for diagnostic in reported(text, "FRM009")] == ["FRM009"]
    assert unresolved(text) == []


def test_thousands_of_unknown_names_are_reported() -> None:
    text = "".join(f'<frame name="frame_{n}" attached_to="nothing_{n}"/>' for n in range(3000))
    assert len(reported(model(text), "FRM001")) == 3000


@pytest.mark.parametrize(("frame", "count"), [("a", 0), ("x", 1)])
def test_frames_that_blocks_of_urdf_name(frame: str, count: int) -> None:
    sensor = f'<sensor name="s" type="imu"><pose relative_to="{frame}">0 0 0 0 0 0</pose></sensor>'
    text = f'<robot name="r"><link name="a"/><gazebo reference="a">{sensor}</gazebo></robot>'
    run = sdfcheck.lint(text, isolated=True, select=("FRM001",))
    assert len(run.diagnostics) == count
