"""Which consumer accepts a file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from sdfcheck import parse
from sdfcheck.cli.parts.descriptions import SearchContext
from sdfcheck.cli.targets import verdicts
from sdfcheck.consumers.reaction import (
    ON_REQUEST,
    READS,
    REFUSES,
    Affects,
    Consumer,
    Reaction,
    Verdict,
    by_dialect,
    ignores,
    lines,
)
from sdfcheck.lint.call import lint
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.config.settings import UNSET
from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.example import fill, unmark
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.lint.rulebook.trial import file_name
from sdfcheck.lint.session import Options, run
from sdfcheck.lint.targets import ELSEWHERE, OWN_CONSUMER, matrix, own_consumer, refusals
from sdfcheck.source.sniff import Kind, sniff
from tests.test_rules import TRIALS

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'

SPHERICAL = '<joint name="j" type="spherical"><parent link="a"/><child link="b"/></joint>'
CONTACT = '<contact><lateral_friction value="abc"/><lateral_friction value="1"/></contact>'
PAINT = '<material name="{}"><color rgba="1 0 0 1"/></material>'
PAINTED = f'<visual><geometry><sphere radius="1"/></geometry>{PAINT.format("m")}{PAINT.format("n")}</visual>'
TEXTURED = (
    '<visual><geometry><sphere radius="1"/></geometry><material name="m"><texture/></material></visual>'
)


STATED = tuple(consumer for consumer in Consumer if consumer.value not in ON_REQUEST)
"""The consumers whose reactions rules state."""
EVERYBODY = [consumer.value for consumer in Consumer]


def judged(text: str, name: str, folder: Path, *consumers: Consumer) -> dict[str, str]:
    file = folder / name
    file.write_text(text, encoding="utf-8")
    rows = verdicts(file, consumers or STATED, SearchContext(Configuration(isolated=True)))
    return {row.consumer.value: row.verdict.value for row in rows}


def test_the_reactions_of_rules_are_well_formed() -> None:
    for facts in load_index().facts:
        for consumer, reactions in facts.affects.items():
            assert reactions.keys() <= set(READS[Consumer(consumer)]), facts.code
            for said in reactions.values():
                reaction = Reaction.of(said)
                assert str(reaction) == said, facts.code
                assert reaction.words == reaction.words.strip() != "", facts.code


def test_a_pack_s_rules_say_it_in_short() -> None:
    affects: Affects = {
        Consumer.URDFDOM: REFUSES,
        Consumer.GAZEBO: ignores("it"),
        Consumer.DRAKE: {"urdf": REFUSES, "sdf": ignores("it")},
    }
    judged = by_dialect(affects)
    assert judged == {
        "drake": {"sdf": "ignore: ignores it", "urdf": "reject: refuses the file"},
        "gazebo": {"sdf": "ignore: ignores it", "urdf": "ignore: ignores it"},
        "urdfdom": {"urdf": "reject: refuses the file"},
    }
    assert list(lines(judged)) == [
        "drake, SDF: ignores it",
        "drake, URDF: refuses the file",
        "gazebo: ignores it",
        "urdfdom: refuses the file",
    ]


def test_a_sound_file(tmp_path: Path) -> None:
    text = f'<robot name="r"><link name="base">{INERTIAL}</link></robot>'
    assert judged(text, "r.urdf", tmp_path) == dict.fromkeys(
        ("drake", "gazebo", "mujoco", "urdfdom"), "accept"
    )


def test_a_format_that_is_not_theirs(tmp_path: Path) -> None:
    text = '<sdf version="1.9"><model name="m"><static>true</static><link name="l"/></model></sdf>'
    assert judged(text, "m.sdf", tmp_path) == {
        "drake": "accept",
        "gazebo": "accept",
        "mujoco": "not read",
        "urdfdom": "not read",
    }


def test_consumers_differ(tmp_path: Path) -> None:
    text = (
        '<sdf version="1.9"><model name="m"><static>true</static><link name="l"><foo/></link></model></sdf>'
    )
    assert judged(text, "m.sdf", tmp_path, Consumer.DRAKE, Consumer.GAZEBO) == {
        "drake": "reject",
        "gazebo": "warn",
    }


def test_rules_off_by_default_count(tmp_path: Path) -> None:
    text = (
        '<sdf version="1.9"><model name="m"><static>true</static><link name="l"/>'
        '<plugin name="a" filename="libgazebo_ros_imu.so"/></model></sdf>'
    )
    assert judged(text, "m.sdf", tmp_path, Consumer.GAZEBO) == {"gazebo": "warn"}


def test_an_undeclared_prefix_is_no_reason(tmp_path: Path) -> None:
    text = (
        '<sdf version="1.9"><model name="m"><static>true</static><link name="l"><p:a/></link></model></sdf>'
    )
    assert judged(text, "m.sdf", tmp_path, Consumer.GAZEBO) == {"gazebo": "accept"}


def test_a_call_without_prefix_brings_no_reasons(tmp_path: Path) -> None:
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="moments">'
        '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></xacro:macro>'
        f'<link name="a"/><link name="b">{INERTIAL.replace("</inertial>", "<{}moments/></inertial>")}</link>'
        '<joint name="j" type="continuous"><parent link="a"/><child link="b"/></joint></robot>'
    )
    assert judged(text.format("xacro:"), "r.urdf.xacro", tmp_path, Consumer.MUJOCO) == {"mujoco": "reject"}
    assert judged(text.format(""), "r.urdf.xacro", tmp_path, Consumer.MUJOCO) == {"mujoco": "warn"}


@pytest.mark.parametrize(("text", "verdict"), [("<robot/>", "reject"), ('<robot name="r"/>', "accept")])
def test_drake_wants_a_name_of_an_empty_robot(tmp_path: Path, text: str, verdict: str) -> None:
    assert judged(text, "r.urdf", tmp_path, Consumer.DRAKE) == {"drake": verdict}


@pytest.mark.parametrize(
    ("definition", "verdict"),
    [
        ('<xacro:macro name="leg" params="n"><link name="${n}"/></xacro:macro><xacro:leg n="a"/>', "accept"),
        ('<macro name="leg" params="n"><link name="${n}"/></macro><xacro:leg n="a"/>', "reject"),
        ('<macro name="leg" params="n"/><link name="a"/>', "warn"),
        (
            '<macro name="leg" params="n"/><xacro:include filename="$(find nowhere)/a.xacro"/><link name="a"/>',
            "warn",
        ),
    ],
    ids=["with prefix", "called", "not called", "package that is not here"],
)
def test_a_missing_prefix_of_xacro_stops_what_asks_for_it(
    definition: str, verdict: str, tmp_path: Path
) -> None:
    text = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{definition}</robot>'
    assert judged(text, "r.urdf.xacro", tmp_path, Consumer.URDFDOM) == {"urdfdom": verdict}


def test_drake_goes_by_the_name_of_the_file(tmp_path: Path) -> None:
    text = '<sdf version="1.9"><world name="w"/></sdf>'
    assert judged(text, "w.world", tmp_path, Consumer.DRAKE, Consumer.GAZEBO) == {
        "drake": "not read",
        "gazebo": "accept",
    }


TWO_NAMES = (
    f'<robot name="r"><link name="base">{INERTIAL}</link><link name="arm">{INERTIAL}</link>'
    '<joint name="arm" type="fixed"><parent link="base"/><child link="arm"/></joint></robot>'
)


def test_the_dialect_decides(tmp_path: Path) -> None:
    sdf = (
        '<sdf version="1.9"><model name="m"><link name="base"/><link name="arm"/>'
        '<joint name="arm" type="fixed"><parent>base</parent><child>arm</child></joint></model></sdf>'
    )
    assert judged(sdf, "m.sdf", tmp_path, Consumer.DRAKE) == {"drake": "reject"}
    assert judged(TWO_NAMES, "r.urdf", tmp_path) == {
        "drake": "accept",
        "gazebo": "reject",
        "mujoco": "warn",
        "urdfdom": "accept",
    }


@pytest.mark.parametrize(("consumer", "codes"), [("gazebo", {"NAM002"}), ("drake", set())])
def test_a_target_leaves_out_what_it_takes(consumer: str, codes: set[str], tmp_path: Path) -> None:
    file = tmp_path / "r.urdf"
    file.write_text(TWO_NAMES, encoding="utf-8")
    done = run([file], Options(Configuration(isolated=True, given=UNSET._replace(target=(consumer,)))))
    assert {d.code for d in done.diagnostics if d.code.startswith("NAM")} == codes


@pytest.mark.parametrize(
    ("inside", "refusing"),
    [
        ("", {"gazebo", "urdfdom"}),
        (
            f'<link name="a">{INERTIAL}</link><link name="b">{INERTIAL}</link>' + SPHERICAL,
            {"drake", "gazebo", "urdfdom"},
        ),
        (
            f'<link name="a">{INERTIAL}{TEXTURED}</link>',
            {"drake"},
        ),
        (f'<link name="a">{INERTIAL}{CONTACT}</link>', set()),
        (f'<link name="a">{INERTIAL}</link><frame name="f"/>', {"drake"}),
        (f'<link name="a">{INERTIAL}{PAINTED}</link>', {"mujoco"}),
    ],
)
def test_elements_that_only_some_consumers_of_urdf_take(
    inside: str, refusing: set[str], tmp_path: Path
) -> None:
    verdict = judged(f'<robot name="r">{inside}</robot>', "r.urdf", tmp_path)
    assert {consumer for consumer, word in verdict.items() if word == "reject"} == refusing


INERTIA = '<inertia ixx="{}" iyy="{}" izz="{}" ixy="0" ixz="0" iyz="0"/>'
BODY = f'<link name="{{}}"><inertial><mass value="{{}}"/>{INERTIA}</inertial></link>'
HELD = '<joint name="j" type="{}"><parent link="a"/><child link="b"/></joint>'


@pytest.mark.parametrize(
    ("base", "link", "joint", "verdict"),
    [
        ((1, 9, 9, 9), (1, 1, 1, 9), "fixed", "accept"),
        ((1, 1, 1, 1), (1, 1, 1, 9), "fixed", "reject"),
        ((1, 9, 9, 9), (1, 1, 1, 9), "continuous", "reject"),
        ((1, 9, 9, 9), (0, 1, 1, 9), "fixed", "accept"),
        ((1, 1, 1, 1), (0, 1, 1, 9), "fixed", "reject"),
        ((3, 9, 9, 9), (-1, 1, 1, 1), "fixed", "accept"),
        ((1, 9, 9, 9), (-3, 1, 1, 1), "fixed", "reject"),
        ((1, 9, 9, 9), ("1e-7", 1, 1, 9), "continuous", "reject"),
        ((1, 9, 9, 9), (-3, 1, 1, 1), "continuous", "warn"),
    ],
)
def test_gazebo_judges_links_once_merged(
    base: tuple[float, ...], link: tuple[float, ...], joint: str, verdict: str, tmp_path: Path
) -> None:
    parts = (BODY.format("a", *base), BODY.format("b", *link), HELD.format(joint))
    text = f'<robot name="r">{"".join(parts)}</robot>'
    assert judged(text, "r.urdf", tmp_path, Consumer.GAZEBO) == {"gazebo": verdict}


def severities(text: str, folder: Path, *targets: str, **given: object) -> dict[str, str]:
    """Code → severity under some targets."""
    file = folder / "r.urdf"
    file.write_text(text, encoding="utf-8")
    done = run([file], Options(Configuration(isolated=True, given=UNSET._replace(target=targets), **given)))  # type: ignore[arg-type]
    return {found.code: found.severity.value for found in done.diagnostics}


def test_a_file_that_a_target_refuses_is_an_error(tmp_path: Path) -> None:
    text = '<robot name="r"><link name="base"/></robot>'
    assert severities(text, tmp_path)["URD013"] == "info"
    assert severities(text, tmp_path, "gazebo")["URD013"] == "error"
    assert severities(text, tmp_path, "gazebo", "urdfdom")["URD013"] == "error"
    assert "URD013" not in severities(text, tmp_path, "urdfdom")


def test_a_value_that_a_target_reads_in_another_way_keeps_its_severity(tmp_path: Path) -> None:
    text = (
        f'<robot name="r"><link name="a">{INERTIAL}</link><link name="b">{INERTIAL}</link>'
        '<joint name="j" type="continuous"><parent link="a"/><child link="b"/>'
        '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>'
    )
    assert severities(text, tmp_path, "drake")["JNT011"] == "warning"


def test_a_target_hides_nothing_of_its_own_elements(tmp_path: Path) -> None:
    text = (
        '<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="a"/><link name="b"/>'
        '<drake:joint name="j" type="fixed"><parent link="a"/><child link="b"/></drake:joint></robot>'
    )
    assert severities(text, tmp_path)["DRK008"] == "error"
    assert severities(text, tmp_path, "drake")["DRK008"] == "error"


CORPUS = Path(__file__).parents[4] / "shared" / "corpus"
NOT_STOPPING = {
    "NAM002": "the checker of libsdformat alone refuses two shapes of one name",
    "SCH015": "a ball joint, which MuJoCo and PyBullet read, is a loss of the conversion",
    "XML007": "urdfdom from version 4 on reads a file with a document type",
}
"""Warnings with which an own consumer refuses a file in some versions or some of its parts: conversions go on."""


def documents(step: int) -> Iterator[tuple[str, Path, Kind]]:
    """Robots to be judged alone: each ``step``-th of the rules' examples, and of the real files if they are there."""
    for trial in [trial for trial in TRIALS if trial.kind == "bad" and trial.example.files is None][::step]:
        text = unmark(fill(trial.rule.scaffold, trial.example))[0]
        path = Path(file_name(text, trial.example))
        yield text, path, sniff(text.encode(), path)
    for path in sorted(CORPUS.rglob("*.*"))[:: step * 4]:
        yield path.read_text(encoding="utf-8", errors="replace"), path, sniff(path.read_bytes(), path)


@pytest.mark.parametrize("consumer", Consumer)
def test_severity_targets_and_conversions_agree(consumer: Consumer, request: pytest.FixtureRequest) -> None:
    """``lint --target``, ``targets`` and what stops a conversion follow from one table of reactions."""
    differing: list[tuple[object, ...]] = []
    gates = 0
    for text, path, kind in documents(1 if request.config.getoption("--all-examples") else 8):
        if kind not in (Kind.SDF, Kind.URDF) or kind.value not in READS[consumer]:
            continue
        [row] = matrix(lint(text, name=path, isolated=True, target=EVERYBODY), kind, path, [consumer])
        found = lint(text, name=path, isolated=True, target=[consumer.value]).diagnostics
        errors = [each for each in found if each.severity is Severity.ERROR]
        refusing = {each.code for each in errors}
        if row.verdict is not Verdict.UNREAD and bool(refusing) is not (row.verdict is Verdict.REJECT):
            differing.append((path.name, row.verdict, refusing))
        document = parse(text, path).document
        if own_consumer(document) is consumer:
            gates += 1
            stopping = {each.code for each in refusals(document)} - NOT_STOPPING.keys()
            here = {each.code for each in errors if each.span.source.path == path}  # not in what it includes
            refusing = {code for code in here - NOT_STOPPING.keys() if code[:3] not in ELSEWHERE}
            if bool(stopping) is not bool(refusing):
                differing.append((path.name, f"conversions stop at {stopping}", refusing))
    assert differing == []
    assert (gates > 10) is (consumer in OWN_CONSUMER.values())
