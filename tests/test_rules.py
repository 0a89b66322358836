"""Every rule's examples run: the exact place, the fix, and silence where all is well."""

from __future__ import annotations

import inspect
import re
import sys
from pathlib import Path

import pytest

from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.engine import OF_BODIES
from sdfcheck.lint.example import Bad, fill, unmark
from sdfcheck.lint.rule import Rule
from sdfcheck.lint.rulebook.conditions import is_current, render
from sdfcheck.lint.rulebook.pack import CONDITIONS, summary
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.lint.rulebook.plugins import find_pack
from sdfcheck.lint.rulebook.trial import Bench, Trial
from sdfcheck.lint.run import BUILT_IN
from sdfcheck.lint.subjects import Subjects
from sdfcheck.lint.suppress.rules import MalformedSuppression, UnusedSuppression
from sdfcheck.source.document import Document

# A rule that reports an omission would report it in every snippet that shows something else.
OF_ABSENCE = {"INR004"}
INDEX = load_index()
STRICT = {facts.code for facts in INDEX.facts if facts.default} - OF_ABSENCE
BENCH = Bench(BUILT_IN, strict=STRICT)
LONGEST_ADVICE = 101
IMPERATIVES = frozenset(
    (
        "Add Ask Bind Call Change Check Choose Close Compare Complete Compute Convert Correct Declare Define "
        "Divide Download Exchange Expand Export Give Include Keep Leave Let List Make Move Name Place Put "
        "Read Remove Rename Replace Save Say Separate Swap Turn Use Widen Write"
    ).split()
)
RULES = BENCH.rules
TRIALS = BENCH.trials


@pytest.mark.parametrize("rule", RULES, ids=lambda r: r.code)
def test_metadata(rule: type[Rule]) -> None:
    module = rule.__module__.rsplit(".", 1)[-1]
    assert rule.name.replace("-", "_") == module
    assert rule.__name__.lower() == module.replace("_", "")
    looks = bool(rule.looks_at or rule.selects)
    assert not (looks and rule.explains), "a rule decides or explains"
    assert looks or rule.applies is Rule.applies, "a problem has been decided on"
    first = (rule.__doc__ or "").strip().partition("\n\n")[0]
    assert first.endswith("."), "the manual begins with a sentence that states the defect"
    assert rule.code.rstrip("0123456789").lower() == rule.__module__.split(".")[-2]


@pytest.mark.parametrize(
    "rule", [r for r in RULES if r.code.rstrip("0123456789") in OF_BODIES], ids=lambda r: r.code
)
def test_rules_about_bodies_find_errors_only_by_their_own_severity(rule: type[Rule]) -> None:
    if rule.severity is not Severity.ERROR:
        assert "Severity.ERROR" not in inspect.getsource(sys.modules[rule.__module__])


def test_codes_and_names_are_unique() -> None:
    assert len({rule.code for rule in RULES}) == len({rule.name for rule in RULES}) == len(RULES)


def test_rules_are_sound() -> None:
    assert BENCH.faults == ()


@pytest.mark.parametrize("trial", TRIALS, ids=repr)
def test_examples(trial: Trial) -> None:
    trial.check()


@pytest.mark.parametrize("trial", [trial for trial in TRIALS if trial.kind == "bad"], ids=repr)
def test_a_finding_is_in_house_style_and_says_what_to_do(trial: Trial, tmp_path: Path) -> None:
    example = trial.example
    assert isinstance(example, Bad)
    found = BENCH.lint(unmark(fill(trial.rule.scaffold, example))[0], example, tmp_path)
    (own,) = (each for each in found if each.code == trial.rule.code)
    assert own.message[:1] != own.message[:1].upper() or not own.message[0].isalpha(), own.message
    assert not own.message.endswith(".")
    assert own.fix is not None or own.help, own.message
    for each in found:
        if "did you mean" in each.message:
            assert each.fix is not None, each.message
            assert each is not own or example.fixed is not None, each.message


@pytest.mark.parametrize("rule", [*RULES, UnusedSuppression, MalformedSuppression], ids=lambda r: r.code)
def test_the_first_sentence_of_a_remedy_is_an_imperative(rule: type[Rule]) -> None:
    sentence = re.split(r"(?<=\.)\s", rule.remedy, maxsplit=1)[0]
    assert sentence.endswith(".")
    assert len(sentence) <= LONGEST_ADVICE
    assert sentence.split()[0] in IMPERATIVES
    advice, defect = (set(re.findall(r"\w+", text.lower())) for text in (sentence, summary(rule)))
    assert len(advice & defect) < len(advice | defect) / 2, "it repeats the defect"


@pytest.mark.parametrize(
    "trial", [trial for trial in TRIALS if trial.rule.applies is not Rule.applies], ids=repr
)
def test_a_part_that_a_condition_applies_to_is_reported(
    trial: Trial, monkeypatch: pytest.MonkeyPatch
) -> None:
    rule, example = trial.rule, trial.example
    facts = next(facts for facts in BENCH.facts if facts.code == rule.code)

    def spy(self: Subjects, document: Document, tables: list[Path]) -> list[object]:
        found = find(self, document, tables)
        for subject in found if (self.looks_at, self.selects) == (facts.looks_at, facts.selects) else ():
            applies = rule.applies(subject)
            assert bool(INDEX.condition(facts)(subject)) is bool(applies), subject
            assert not applies or list(rule().check(subject)), f"nothing to report about {subject}"
        return found

    find = Subjects.of
    monkeypatch.setattr(Subjects, "of", spy)
    BENCH.lint(unmark(fill(rule.scaffold, example))[0], example)


def test_the_conditions_are_up_to_date() -> None:
    pack = find_pack(BUILT_IN)
    assert is_current(pack.folder / f"{CONDITIONS}.py", render(pack)), "run `make rules/conditions.py`"
