"""The refusals that the manuals name, against those in the rules."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from sdfcheck.cli.parts.descriptions import SearchContext
from sdfcheck.cli.targets import verdicts
from sdfcheck.consumers.reaction import Consumer, Reaction
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.rule import Rule
from sdfcheck.lint.rulebook.pack import describe
from tests.peers.test_affects import examples
from tests.test_rules import RULES

NAMES = {
    "libsdformat": Consumer.GAZEBO,
    "Gazebo": Consumer.GAZEBO,
    "Drake": Consumer.DRAKE,
    "urdfdom": Consumer.URDFDOM,
    "MuJoCo": Consumer.MUJOCO,
}
_NAME = f"(?:{'|'.join(NAMES)})(?: \\d+)?"
_REFUSAL = re.compile(rf"({_NAME}(?:(?:, | and |, and ){_NAME})*) (?:refuses?|aborts?|crash(?:es)?)\b")


def refusing(rule: type[Rule]) -> set[Consumer]:
    """The consumers of which the manual of a rule says that they refuse something."""
    prose = " ".join((rule.__doc__ or "").split())
    subjects = [match[1] for match in _REFUSAL.finditer(prose)]
    return {consumer for name, consumer in NAMES.items() if any(name in subject for subject in subjects)}


CLAIMING = {rule.code: refusing(rule) for rule in RULES if refusing(rule)}


def test_manuals_speak_of_consumers() -> None:
    assert len(CLAIMING) > 20


@pytest.mark.parametrize("code", sorted(CLAIMING))
def test_a_consumer_that_refuses_in_prose_does_so_in_an_example(code: str, tmp_path: Path) -> None:
    (rule,) = (rule for rule in RULES if rule.code == code)
    unseen = {consumer for consumer in CLAIMING[code] if not _is_in_the_table(rule, consumer)}
    for file in examples(tmp_path, [rule]) if unseen else ():
        for row in verdicts(file, tuple(unseen), SearchContext(Configuration(isolated=True))):
            own = (reason.reaction for reason in row.reasons if reason.diagnostic.code == code)
            if any(map(_refuses, own)):
                unseen.discard(row.consumer)
    assert not unseen


def _is_in_the_table(rule: type[Rule], consumer: Consumer) -> bool:
    return any(map(_refuses, map(Reaction.of, describe(rule).affects.get(consumer.value, {}).values())))


def _refuses(reaction: Reaction) -> bool:
    """Does it, in some version at least?"""
    return reaction.is_refusal or "refuses" in reaction.words
