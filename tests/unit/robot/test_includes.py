"""Includes: what each brings, and what can be wrong with it."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

import sdfcheck
from sdfcheck.formats.problems import MissingElement
from sdfcheck.robot.includes.included import Included, Obstacle, included, includes_of, problems
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from tests.posix import make_pipe
from tests.unit.robot.files import ARM, CONFIG, MODEL, WORLD, codes, document, opened, reported, write


def include(uri: str, more: str = "", merge: str = "") -> str:
    attribute = f' merge="{merge}"' if merge else ""
    return f"<include{attribute}><uri>{uri}</uri>{more}</include>"


def first(found: Document) -> Included:
    return included(found, includes_of(found)[0])


def kinds(found: Document) -> list[type]:
    return [type(problem) for problem in problems(found)]


def test_the_content_of_an_include(tmp_path: Path) -> None:
    brought = first(document(tmp_path, WORLD.format(include("arm.sdf"))))
    assert brought.model is not None
    assert (brought.kind, brought.name, brought.obstacle) == ("model", "arm", None)
    assert brought.model.document.path == tmp_path / "arm.sdf"


def test_its_own_name_counts(tmp_path: Path) -> None:
    assert first(document(tmp_path, WORLD.format(include("arm.sdf", "<name>left</name>")))).name == "left"


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ('<sdf version="1.12"><light name="x" type="point"/></sdf>', "light"),
        ('<sdf version="1.12"><actor name="x"><script/></actor></sdf>', "actor"),
        ('<sdf version="1.12"><light name="l" type="point"/><model name="x"/></sdf>', "model"),
        ('<robot name="x"><link name="l"/></robot>', "model"),
    ],
)
def test_kinds(tmp_path: Path, text: str, kind: str) -> None:
    brought = first(document(tmp_path, WORLD.format(include("other.sdf")), other=text))
    assert (brought.kind, brought.name) == (kind, "x")


def test_a_folder_says_which_file_it_means(tmp_path: Path) -> None:
    write(tmp_path, {"models/arm/model.config": CONFIG, "models/arm/model.sdf": ARM})
    found = document(tmp_path, WORLD.format(include("model://arm")))
    assert first(found).file == tmp_path / "models/arm/model.sdf"
    assert codes(found) == []


def test_each_file_is_read_once(tmp_path: Path) -> None:
    other = os.path.join("..", tmp_path.name, "arm.sdf")
    text = include("arm.sdf", "<name>a</name>") + include(other, "<name>b</name>")
    found = document(tmp_path, WORLD.format(text))
    left, right = (included(found, element) for element in includes_of(found))
    assert left.document is right.document


@pytest.mark.parametrize(
    ("uri", "code"),
    [
        ("nowhere.sdf", "RES002"),
        ("model://nowhere", "RES002"),
        ("https://example.org/arm", "RES002"),
        ("Arm.sdf", "RES005"),
        ("model:/arm", "RES004"),
        ("folder", "RES002"),
        ("old", "RES007"),
    ],
)
def test_uris_that_lead_nowhere(tmp_path: Path, uri: str, code: str) -> None:
    write(tmp_path, {"folder/arm.sdf": ARM, "old/manifest.xml": CONFIG, "old/model.sdf": ARM})
    assert codes(document(tmp_path, WORLD.format(include(uri)))) == [code]


def test_an_absolute_path_is_one_problem_only_where_it_leads_somewhere(tmp_path: Path) -> None:
    assert codes(document(tmp_path, WORLD.format(include(str(tmp_path / "arm.sdf"))))) == ["RES006"]
    assert codes(document(tmp_path, WORLD.format(include(str(tmp_path / "no.sdf"))))) == ["RES002"]


def test_findings_elsewhere_are_reported_once(tmp_path: Path) -> None:
    (diagnostic,) = reported(document(tmp_path, WORLD.format(include("model://lost_arm") * 3)))
    assert diagnostic.message.endswith("(3 includes)")


@pytest.mark.parametrize("inside", ["/left", "/right", "/model.sdf"])
def test_the_folder_of_a_submodule_is_missing_once(tmp_path: Path, inside: str) -> None:
    (tmp_path / "arms").mkdir()
    text = WORLD.format(include(f"model://arms{inside}", "<name>a</name>") + include("model://arms/left"))
    (diagnostic,) = reported(document(tmp_path, text))
    assert (diagnostic.code, diagnostic.severity.value) == ("RES002", "warning")
    assert diagnostic.message == (
        "folder `arms` is empty: it may be a submodule that is not checked out (2 includes)"
    )


def test_a_missing_mass_is_said_once_where_it_has_a_unit() -> None:
    link = '<link name="l"><inertial><mass_kg>1</mass_kg></inertial></link>'
    text = f'<sdf version="1.9"><model name="m">{link}</model></sdf>'
    run = sdfcheck.lint(text, name="m.sdf", isolated=True)
    assert [each.code for each in run.diagnostics] == ["NS002"]


@pytest.mark.parametrize(
    ("text", "obstacle"),
    [
        ('<sdf version="1.12"><world name="w"/></sdf>', Obstacle.NO_MODEL),
        ('<sdf version="1.12"/>', Obstacle.NO_MODEL),
        ("<COLLADA/>", Obstacle.FOREIGN),
        ('<robot name="r"><xacro:leg/></robot>', Obstacle.XACRO),
    ],
)
def test_files_that_hold_nothing_to_include(tmp_path: Path, text: str, obstacle: Obstacle) -> None:
    found = document(tmp_path, WORLD.format(include("other.sdf")), other=text)
    assert first(found).obstacle is obstacle
    assert codes(found) == ["RES012"]


@pytest.mark.parametrize("text", ["", "<", "\x00\x01", "no markup"])
def test_files_that_are_not_xml_are_not_quoted(tmp_path: Path, text: str) -> None:
    found = document(tmp_path, WORLD.format(include("other.sdf")), other=text)
    assert codes(found) == ([] if not text else ["RES012"])
    assert first(found).obstacle is (Obstacle.FOREIGN if text else Obstacle.BROKEN)


def test_a_file_without_end_is_not_read(tmp_path: Path) -> None:
    make_pipe(tmp_path / "pipe")
    with (tmp_path / "huge.sdf").open("wb") as file:
        file.truncate(257 * 1024 * 1024)
    for uri in ("pipe", "huge.sdf"):
        found = document(tmp_path, WORLD.format(include(uri)))
        assert first(found).obstacle is Obstacle.UNREADABLE
        assert codes(found) == ["RES012"]


@pytest.mark.parametrize("setting", ["<name/>", "<static> </static>", "<pose/><placement_frame/>"])
def test_empty_settings(tmp_path: Path, setting: str) -> None:
    assert codes(document(tmp_path, WORLD.format(include("arm.sdf", setting)))) == ["RES012"]


def test_a_placement_frame_needs_a_pose(tmp_path: Path) -> None:
    placed = "<placement_frame>grip</placement_frame>"
    (problem,) = problems(document(tmp_path, WORLD.format(include("arm.sdf", placed))))
    assert isinstance(problem, MissingElement)
    assert problem.child == "pose"
    assert kinds(document(tmp_path, WORLD.format(include("arm.sdf", f"<pose/>{placed}")))) == []


# Cycles


def cycle(found: Document) -> list[str] | None:
    rings = [d for d in reported(found) if d.code == "RES003"]
    return [span.source.path.name for d in rings for span in (d.span, *(at.span for at in d.labels))] or None


def test_a_file_that_includes_itself(tmp_path: Path) -> None:
    found = document(tmp_path, MODEL.format('<link name="l"/>' + include("main.sdf", "<name>x</name>")))
    assert cycle(found) == ["main.sdf"]


def test_a_ring_is_reported_in_its_first_file(tmp_path: Path) -> None:
    ring = {name: MODEL.format(include(f"{to}.sdf", "<name>x</name>")) for name, to in ("ab", "bc", "ca")}
    write(tmp_path, {f"{name}.sdf": text for name, text in ring.items()})
    cycles = {name: cycle(opened(tmp_path / f"{name}.sdf")) for name in ring}
    assert cycles == {"a": ["a.sdf", "b.sdf", "c.sdf"], "b": None, "c": None}


def test_the_way_to_a_ring_is_none(tmp_path: Path) -> None:
    itself = MODEL.format(include("other.sdf", "<name>x</name>"))
    assert cycle(document(tmp_path, WORLD.format(include("other.sdf")), other=itself)) is None


# Merging

LAMP = '<sdf version="1.12"><light name="lamp" type="point"/></sdf>'
ACTOR = '<sdf version="1.12"><actor name="x"><script/></actor></sdf>'
GRIPPER = MODEL.format('<link name="l"/><gripper name="g"><gripper_link>l</gripper_link></gripper>')
SHELL = MODEL.format('<model name="n"><link name="l"/></model><frame name="f"/>')


@pytest.mark.parametrize(
    ("text", "kind", "parts"),
    [
        (LAMP, "light", ()),
        (ACTOR, "actor", ()),
        (ARM, "model", ("link `base`", "link `tip`")),
        (GRIPPER, "model", ("link `l`", "gripper `g`")),
    ],
)
def test_parts_that_a_world_cannot_merge(
    tmp_path: Path, text: str, kind: str, parts: tuple[str, ...]
) -> None:
    found = document(tmp_path, WORLD.format(include("other.sdf", merge="true")), other=text)
    (merged,) = root_of(found).includes
    assert merged.found.kind == kind
    assert not parts or [f"{kind} `{name}`" for kind, name in merged.merged_parts][: len(parts)] == [*parts]
    assert codes(found) == ["RES009"]


@pytest.mark.parametrize(("outer", "text"), [(WORLD, SHELL), (MODEL, ARM), (MODEL, GRIPPER)])
def test_parts_that_merge(tmp_path: Path, outer: str, text: str) -> None:
    assert codes(document(tmp_path, outer.format(include("other.sdf", merge="1")), other=text)) == []


def test_a_parameter_may_remove_what_a_world_cannot_take(tmp_path: Path) -> None:
    remove = "".join(f'<link element_id="{name}" action="remove"/>' for name in ("base", "tip"))
    more = f"<experimental:params>{remove}</experimental:params>"
    assert codes(document(tmp_path, WORLD.format(include("arm.sdf", more, merge="true")))) == []


def test_nothing_merges_into_a_frame(tmp_path: Path) -> None:
    text = '<link name="l"/><frame name="f">' + include("arm.sdf", merge="true") + "</frame>"
    (diagnostic,) = reported(document(tmp_path, MODEL.format(text)))
    assert diagnostic.message == "nothing can be merged into frame `f`"


def test_without_a_library_nothing_is_looked_up(tmp_path: Path) -> None:
    found = document(tmp_path, WORLD.format(include("nowhere.sdf") + include("folder", merge="true")))
    found.library = None
    assert codes(found) == []
    assert kinds(found) == []


@pytest.mark.parametrize("merged", ['<robot name="r">{}</robot>', MODEL])
def test_names_of_a_merged_model_are_those_of_the_model_around_it(tmp_path: Path, merged: str) -> None:
    text = MODEL.format('<link name="base"/>' + include("other.sdf", merge="true"))
    found = document(tmp_path, text, other=merged.format('<link name="base"/>'))
    (diagnostic,) = reported(found, "NAM")
    assert diagnostic.message == "there is another link `base` in model `m`"


def test_the_way_to_a_file_that_includes_itself_has_one_step(tmp_path: Path) -> None:
    write(
        tmp_path,
        {
            "main.sdf": WORLD.format(include("a.sdf", "<static>1</static>")),
            "a.sdf": WORLD.format(include("a.sdf")),
        },
    )
    run = sdfcheck.lint(tmp_path / "main.sdf", isolated=True, select=("RES003",))
    (diagnostic,) = run.diagnostics
    assert diagnostic.message == "a.sdf includes itself"
    assert [origin.span.source.path.name for origin in diagnostic.origins] == ["main.sdf"]
