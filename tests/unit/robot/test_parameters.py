"""The parameters of includes: what they do to the model, and what is wrong with them."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.formats.problems import MissingAttribute, WrongComponentCount
from sdfcheck.robot.graph import Model
from sdfcheck.robot.includes.included import InvalidParameter, problems
from sdfcheck.robot.includes.included import ParameterFault as Fault
from sdfcheck.robot.root import root_of
from tests.unit.robot.files import MODEL, WORLD, document

BOX = "<geometry><box><size>{}</size></box></geometry>"
SHAPE = "<geometry><sphere><radius>1</radius></sphere></geometry>"


def with_parameters(entries: str, uri: str = "arm.sdf") -> str:
    return WORLD.format(
        f"<include><uri>{uri}</uri><experimental:params>{entries}</experimental:params></include>"
    )


def faults(folder: Path, entries: str, **files: str) -> list[Fault]:
    found = list(problems(document(folder, with_parameters(entries), **files)))
    assert all(isinstance(problem, InvalidParameter) for problem in found), found
    return [problem.fault for problem in found if isinstance(problem, InvalidParameter)]


@pytest.mark.parametrize(
    ("entry", "fault"),
    [
        ('<link action="remove"/>', Fault.NO_ID),
        ('<link element_id="base::" action="remove"/>', Fault.OPEN_END),
        ('<link element_id="base" action="delete"/>', Fault.UNKNOWN_ACTION),
        ('<link element_id="" action="add"/>', Fault.NO_NAME),
        ('<link element_id="" name="" action="add"/>', Fault.EMPTY_NAME),
        ('<link element_id="" name="base" action="add"/>', Fault.TAKEN),
        (f'<visual element_id="base" name="skin" action="add">{SHAPE}</visual>', Fault.TAKEN),
        ('<link element_id="bass" action="remove"/>', Fault.NOTHING),
        ('<link element_id="" action="remove"/>', Fault.NOTHING),
        ('<link element_id="base::skin" action="remove"/>', Fault.OTHER_KIND),
        ('<link element_id="nowhere" name="l" action="add"/>', Fault.NO_PARENT),
        ('<wheel element_id="base" name="l" action="add"/>', Fault.UNKNOWN_ENTRY),
        ('<link element_id="base"><gravity>0</gravity></link>', Fault.NO_CHILD_ACTION),
        ('<link element_id="base"><gravity action="set">0</gravity></link>', Fault.UNKNOWN_ACTION),
        ('<link element_id="base"><gravity action="remove"/></link>', Fault.ABSENT_CHILD),
        ('<link element_id="base"><gravity action="modify">0</gravity></link>', Fault.ABSENT_CHILD),
        ('<link element_id="base"><gravity action="replace">0</gravity></link>', Fault.ABSENT_CHILD),
        ('<link element_id="base"><visual name="skim" action="remove"/></link>', Fault.ABSENT_CHILD),
        ('<link element_id="base"><axis action="add"/></link>', Fault.UNKNOWN_CHILD),
        ('<link element_id="base" action="modify" size="1"/>', Fault.UNKNOWN_ATTRIBUTE),
        ('<link element_id="base" action="modify"><gravity>0</gravity></link>', Fault.ABSENT_CHILD),
        ('<link element_id="base" action="remove"><gravity/></link>', Fault.ABSENT_CHILD),
        (
            '<link element_id="base"><visual name="skin" action="remove"><pose/></visual></link>',
            Fault.ABSENT_CHILD,
        ),
        ('<link element_id="base"><visual action="remove"/></link>', Fault.NAME_ASSUMED),
        ('<visual element_id="base::skin" action="modify"><geometry/></visual>', Fault.NO_CHANGE),
        ('<link element_id="base"/>', Fault.NO_CHANGE),
    ],
)
def test_faults(tmp_path: Path, entry: str, fault: Fault) -> None:
    assert faults(tmp_path, entry) == [fault]


@pytest.mark.parametrize(
    "entries",
    [
        '<visual element_id="base::skin" action="remove"/>',
        '<link element_id="" name="extra" action="add"/>',
        f'<visual element_id="base::skin" name="skin" action="replace">{SHAPE}</visual>',
        f'<visual element_id="base::skin" action="modify">{BOX.format("2 2 2")}</visual>',
        '<link element_id="base"><gravity action="add">0</gravity></link>',
        '<link element_id="base" action="remove"><visual name="skin"/></link>',
        '<link element_id="base" action="modify" my:note="x"/>',
        '<plugin element_id="" name="p" filename="f" action="add"/>' * 2,
        '<link element_id="base" action="remove"/><link element_id="" name="base" action="add"/>',
        '<link element_id="" name="extra" action="add"/><link element_id="extra" action="remove"/>',
        '<link element_id="base" action="modify" name="foot"/><link element_id="foot" action="remove"/>',
    ],
)
def test_sound_entries(tmp_path: Path, entries: str) -> None:
    assert faults(tmp_path, entries) == []


@pytest.mark.parametrize(
    ("entry", "kind"),
    [
        ('<sensor element_id="base" name="s" action="add"/>', MissingAttribute),
        ('<joint element_id="elbow" name="elbow" action="replace"/>', MissingAttribute),
        ('<visual element_id="base::skin"><plugin action="add"/></visual>', MissingAttribute),
        ('<frame element_id="" name="f" action="add"><pose>1 2</pose></frame>', WrongComponentCount),
        (f'<visual element_id="base::skin" action="modify">{BOX.format("1")}</visual>', WrongComponentCount),
    ],
)  # fmt: skip
def test_an_addition_has_to_fit_the_format(tmp_path: Path, entry: str, kind: type) -> None:
    found = list(problems(document(tmp_path, with_parameters(entry))))
    assert kind in {type(problem) for problem in found}
    assert not any(isinstance(problem, InvalidParameter) for problem in found)


def test_the_longest_name_goes_first_and_others_after_it(tmp_path: Path) -> None:
    inner = (
        '<sdf version="1.7"><model name="i"><model name="a"><link name="b::c"/><link name="d"/></model>'
        '<link name="a::b"/></model></sdf>'
    )
    entries = "".join(f'<link element_id="{i}" action="remove"/>' for i in ("a::b::c", "a::b", "a::d"))
    found = document(tmp_path, with_parameters(entries, "inner.sdf"), inner=inner)
    assert list(problems(found)) == []


def test_ids_reach_into_included_and_merged_models(tmp_path: Path) -> None:
    inner = (
        '<sdf version="1.12"><model name="i"><include><uri>arm.sdf</uri><name>left</name></include>'
        '<include merge="true"><uri>arm.sdf</uri></include></model></sdf>'
    )
    entries = (
        '<visual element_id="left::base::skin" action="remove"/><link element_id="tip" action="remove"/>'
    )
    found = document(tmp_path, with_parameters(entries, "inner.sdf"), inner=inner)
    assert list(problems(found)) == []
    (frame,) = root_of(found).scopes[0].nodes.values()
    assert isinstance(frame, Model)
    assert frame.resolve("tip") is None
    assert frame.resolve("left::tip") is not None, "the other one stays"


def test_of_an_unknown_model_only_the_entries_themselves_are_judged(tmp_path: Path) -> None:
    entries = '<link element_id="x" action="remove"/><link element_id="y" action="burn"/>'
    found = document(tmp_path, with_parameters(entries, "nowhere.sdf"))
    faults = [problem.fault for problem in problems(found) if isinstance(problem, InvalidParameter)]
    assert faults == [Fault.UNKNOWN_ACTION]


def names(folder: Path, entries: str) -> set[str]:
    found = document(folder, with_parameters(entries))
    (frame,) = root_of(found).scopes[0].nodes.values()
    assert isinstance(frame, Model)
    return set(frame.names())


@pytest.mark.parametrize(
    ("entries", "there"),
    [
        ("", {"base", "tip", "elbow", "grip"}),
        ('<link element_id="tip" action="remove"/>', {"base", "elbow", "grip"}),
        ('<frame element_id="" name="top" action="add"/>', {"base", "tip", "elbow", "grip", "top"}),
        ('<frame element_id="grip" name="hold" action="replace"/>', {"base", "tip", "elbow", "hold"}),
        ('<link element_id="tip" name="end" action="modify"/>', {"base", "end", "elbow", "grip"}),
        (
            '<model element_id="" name="n" action="add"><link name="l"/></model>',
            {"base", "tip", "elbow", "grip", "n", "n::l"},
        ),
    ],
)
def test_scopes_see_the_model_as_it_is_changed(tmp_path: Path, entries: str, there: set[str]) -> None:
    assert names(tmp_path, entries) == there


def test_another_include_of_the_same_file_is_untouched(tmp_path: Path) -> None:
    changed = '<experimental:params><link element_id="tip" action="remove"/></experimental:params>'
    text = WORLD.format(
        f"<include><uri>arm.sdf</uri><name>a</name>{changed}</include>"
        "<include><uri>arm.sdf</uri><name>b</name></include>"
    )
    scope = root_of(document(tmp_path, text)).scopes[0]
    assert scope.resolve("a::tip") is None
    assert scope.resolve("b::tip") is not None


def test_children_are_removed_one_by_one(tmp_path: Path) -> None:
    entry = '<model element_id="n" action="remove"><link name="a"/></model>'
    nested = MODEL.format('<link name="l"/><model name="n"><link name="a"/><link name="b"/></model>')
    found = document(tmp_path, with_parameters(entry, "nested.sdf"), nested=nested)
    (frame,) = root_of(found).scopes[0].nodes.values()
    assert isinstance(frame, Model)
    assert set(frame.names()) == {"l", "n", "n::b"}


@pytest.mark.parametrize(
    ("action", "faults_of_it"), [("modify", []), ("remove", [Fault.ABSENT_CHILD])], ids=["modify", "remove"]
)
def test_only_what_is_modified_may_get_another_name(
    tmp_path: Path, action: str, faults_of_it: list[Fault]
) -> None:
    entry = f'<link element_id="base"><visual name="other" action="{action}"/></link>'
    assert faults(tmp_path, entry) == faults_of_it
