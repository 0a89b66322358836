"""Frames: references to nothing, rings, models without links."""

from __future__ import annotations

import time
from pathlib import Path

import pytest

from sdfcheck.files.library import Library
from sdfcheck.robot import frames
from sdfcheck.source.document import read

NESTED = '<model name="n"><pose relative_to="f"/><link name="l"/></model>'


def found(text: str, version: str = "1.12") -> list[frames.Problem]:
    whole = f'<sdf version="{version}">{text}</sdf>'
    return frames.problems(read(whole.encode(), Path("example.sdf")))


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
    (problem,) = found(model(text))
    assert isinstance(problem, frames.UnknownFrame)
    assert problem.role == role


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
def test_what_is_no_reference_or_a_sound_one(text: str) -> None:
    assert found(model(text)) == []


def test_the_old_spelling_of_references() -> None:
    text = model('<link name="l"><pose frame="q"/></link>')
    assert [type(problem) for problem in found(text, "1.6")] == [frames.UnknownFrame]
    assert found(text, "1.7") == []


def test_what_was_meant() -> None:
    inner = '<model name="n"><link name="palm"/></model>'
    (near,) = found(model('<frame name="f" attached_to="Base"/>'))
    (deeper,) = found(model(f'{inner}<frame name="f" attached_to="palm"/>'))
    (outside,) = found(model('<model name="n"><link name="l"><pose relative_to="base"/></link></model>'))
    itself = found(model('<frame name="frame1" attached_to="frame2"/>'))
    assert isinstance(near, frames.UnknownFrame)
    assert near.suggestion == "base"
    assert isinstance(deeper, frames.UnknownFrame)
    assert deeper.suggestion == "n::palm"
    assert isinstance(outside, frames.UnknownFrame)
    assert outside.suggestion is None
    assert outside.outside is not None
    assert outside.outside.title == "link `base`"
    assert isinstance(itself[0], frames.UnknownFrame)
    assert itself[0].suggestion is None


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
def test_a_ring_is_told_once(text: str, names: tuple[str, ...]) -> None:
    (problem,) = found(model(text))
    assert isinstance(problem, frames.FrameCycle)
    assert problem.names == names


def test_placement_frames_lead_nowhere() -> None:
    assert (
        found(model('<model name="n" placement_frame="l"><pose relative_to="base"/><link name="l"/></model>'))
        == []
    )


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
    told = [p.element.attributes["name"] for p in found(text) if isinstance(p, frames.ModelWithoutLink)]
    assert told == bare


@pytest.mark.parametrize(("name", "kind"), [("q", None), ("f", "frame"), ("n", "model")])
def test_canonical_links_are_links(name: str, kind: str | None) -> None:
    text = '<frame name="f"/><model name="n"><link name="l"/></model>'
    (problem,) = found(model(text, f' canonical_link="{name}"'))
    assert isinstance(problem, frames.UnknownCanonicalLink)
    assert problem.found == kind
    assert found(model(text, ' canonical_link="n::l"')) == []


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
    document = Library().document(file)
    assert document is not None
    (problem,) = frames.problems(document)
    assert isinstance(problem, frames.UnknownPlacementFrame)
    assert problem.value.text == "foot"


def test_poses_at_the_top_of_the_file() -> None:
    (problem,) = found('<model name="m"><pose relative_to="world"/><link name="l"/></model>')
    assert isinstance(problem, frames.TopLevelPose)


def test_thousands_of_unknown_names_take_no_minute() -> None:
    text = "".join(f'<frame name="frame_{n}" attached_to="nothing_{n}"/>' for n in range(3000))
    start = time.perf_counter()
    assert len(found(model(text))) == 3000
    assert time.perf_counter() - start < 20
