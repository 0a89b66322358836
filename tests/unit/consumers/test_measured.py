"""The table of reactions, and how it is measured."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

import pytest

from sdfcheck.consumers.engines import RUN_BY, Answer, Engine, Limits, Outcome, Question
from sdfcheck.consumers.measured import AS_PARSER, FILE, TAKEN, Place, Table, always_known, table
from sdfcheck.consumers.reaction import READS, Consumer, Manner, Reaction
from sdfcheck.lint.rulebook import reactions
from sdfcheck.lint.rulebook.packs import load_index
from tests.test_rules import RULES


def test_the_table_is_well_formed() -> None:
    codes = {rule.code for rule in RULES}
    for place, said in table():
        assert place.code in codes, place
        assert place.dialect in READS[Consumer(place.consumer)], place
        if said not in (TAKEN, AS_PARSER):
            reaction = Reaction.of(said)
            assert reaction.manner is not Manner.UNMEASURED, place
            assert reaction.words == reaction.words.strip() != "", place
    assert table().render() == FILE.read_text(encoding="utf-8")


def test_each_consumer_has_a_version() -> None:
    assert table().versions.keys() == {consumer.value for consumer in RUN_BY}
    assert all(version.split()[1:] for version in table().versions.values())


def test_most_rows_are_measured() -> None:
    assert len(table().unmeasured) * 2 < sum(1 for _ in table())


def test_the_table_is_the_one_place() -> None:
    assert [rule.code for rule in RULES if rule.affects] == []
    for facts in load_index().facts:
        assert facts.affects == always_known(facts.code)


KNOWN = "".join(
    "\t".join(row) + "\n"
    for row in (
        ("ABC001", "drake", "sdf", "reject", "aborts"),
        ("ABC001", "drake", "urdf", "accept", ""),
        ("ABC001", "gazebo", "sdf", "drop", "drops the link", "not measured"),
        ("ABC001", "ros", "urdf", "as urdfdom", ""),
    )
)


def test_a_row_says_manner_words_and_what_is_not_measured() -> None:
    text = f"# drake: drake 1.51.1\n{KNOWN}"
    read = Table(text)
    assert read.rows["ABC001"]["gazebo"]["sdf"] == "drop: drops the link"
    assert Reaction.of(read.rows["ABC001"]["gazebo"]["sdf"]).is_loss
    assert read.unmeasured == {Place("ABC001", "gazebo", "sdf")}
    assert read.versions == {"drake": "drake 1.51.1"}
    assert read.render() == text


def answering(refused: Iterable[str]) -> Callable[..., Iterator[Answer]]:
    """An engine that refuses documents with one of some texts in them."""

    def ask_all(engine: Engine, questions: Iterable[Question], limits: Limits) -> Iterator[Answer]:
        for question in questions:
            text = question.path.read_text(encoding="utf-8")
            is_refused = any(one in text for one in refused)
            yield Answer(engine, Outcome.REFUSED if is_refused else Outcome.ACCEPTED, "9.9")

    return ask_all


@pytest.mark.parametrize(
    ("refused", "row", "is_measured", "printed"),
    [
        (('canonical_link="bsae"', 'canonical_link="tool"'), "reject: refuses the file", True, ""),
        ((), "reject: refuses the file", False, "accepts it, unexpectedly"),
        (("<sdf",), "reject: refuses the file", False, ""),
    ],
    ids=["as expected", "otherwise", "the counterpart as well"],
)
def test_a_row_counts_as_measured_if_the_consumer_does_so(
    refused: tuple[str, ...],
    row: str,
    is_measured: bool,
    printed: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    (rule,) = (rule for rule in RULES if rule.name == "unknown-canonical-link")
    monkeypatch.setattr(reactions, "ask_all", answering(refused))
    monkeypatch.setattr(reactions, "is_installed", lambda engine: True)
    place = Place(rule.code, "drake", "sdf")
    after = reactions.again([rule], table(), [Consumer.DRAKE])
    assert after.rows[rule.code]["drake"]["sdf"] == row
    assert (place not in after.unmeasured) is is_measured
    assert after.versions["drake"] == "drake 9.9"
    assert after.versions["gazebo"] == table().versions["gazebo"]
    output = capsys.readouterr().out
    assert printed in output
    assert bool(output) is bool(printed)


def test_an_acceptance_is_written_down(monkeypatch: pytest.MonkeyPatch) -> None:
    (rule,) = (rule for rule in RULES if rule.name == "zero-limit")
    monkeypatch.setattr(reactions, "ask_all", answering(()))
    monkeypatch.setattr(reactions, "is_installed", lambda engine: True)
    after = reactions.again([rule], Table(""), [Consumer.URDFDOM, Consumer.ROS, Consumer.ISAAC])
    assert after.rows[rule.code] == {
        "isaac": {"urdf": "accept: takes it as it is"},
        "ros": {"urdf": AS_PARSER},
        "urdfdom": {"urdf": TAKEN},
    }
    assert not after.unmeasured
