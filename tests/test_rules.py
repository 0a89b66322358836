"""Every rule's examples run: the exact place, the fix, which leaves nothing to fix, and silence where all is well."""

from __future__ import annotations

import inspect
import re
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.engine import OF_BODIES
from sdfcheck.lint.example import Bad, Good, fill, unmark
from sdfcheck.lint.fix.fixer import applicable, fix_file
from sdfcheck.lint.one_file import Selected
from sdfcheck.lint.rule import Rule
from sdfcheck.lint.rulebook.conditions import is_current, render
from sdfcheck.lint.rulebook.pack import CONDITIONS, summary
from sdfcheck.lint.rulebook.packs import load_index
from sdfcheck.lint.rulebook.plugins import find_pack
from sdfcheck.lint.rulebook.trial import Bench, Trial, file_name
from sdfcheck.lint.run import BUILT_IN
from sdfcheck.lint.subjects import Subjects
from sdfcheck.lint.suppress.rules import MalformedSuppression, UnusedSuppression
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind, sniff
from tests.each import each

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
KNOWN = {Kind.SDF, Kind.URDF, Kind.XACRO, Kind.MODEL_CONFIG}
REVEALS = {"DRK001-bad-1", "DRK017-bad-1", "RES004-bad-7", "URD001-bad-2"}
"""Unsafe fixes after which something that was not read is read, and an error is found in it."""
pytestmark = pytest.mark.usefixtures("elsewhere")
LINT = BENCH.lint


def test_metadata() -> None:
    each(RULES, metadata)


def metadata(rule: type[Rule]) -> None:
    module = rule.__module__.rsplit(".", 1)[-1]
    assert rule.name.replace("-", "_") == module
    assert rule.__name__.lower() == module.replace("_", "")
    looks = bool(rule.looks_at or rule.selects)
    assert not (looks and rule.explains), "a rule decides or explains"
    assert looks or rule.applies is Rule.applies, "a problem has been decided on"
    first = (rule.__doc__ or "").strip().partition("\n\n")[0]
    assert first.endswith("."), "the manual begins with a sentence that states the defect"
    family = rule.code.rstrip("0123456789")
    assert family.lower() == rule.__module__.split(".")[-2]
    if family in OF_BODIES and rule.severity is not Severity.ERROR:
        source = inspect.getsource(sys.modules[rule.__module__])
        assert "Severity.ERROR" not in source, "rules about bodies find errors only by their own severity"


def test_codes_and_names_are_unique() -> None:
    assert len({rule.code for rule in RULES}) == len({rule.name for rule in RULES}) == len(RULES)


def test_rules_are_sound() -> None:
    assert BENCH.faults == ()


def test_the_first_sentence_of_a_remedy_is_an_imperative() -> None:
    each([*RULES, UnusedSuppression, MalformedSuppression], remedy)


def remedy(rule: type[Rule]) -> None:
    sentence = re.split(r"(?<=\.)\s", rule.remedy, maxsplit=1)[0]
    assert sentence.endswith(".")
    assert len(sentence) <= LONGEST_ADVICE
    assert sentence.split()[0] in IMPERATIVES
    advice, defect = (set(re.findall(r"\w+", text.lower())) for text in (sentence, summary(rule)))
    assert len(advice & defect) < len(advice | defect) / 2, "it repeats the defect"


def once(folder: Path) -> Callable[[str, Bad | Good], list[Diagnostic]]:
    """Lints each text of an example once, for all that is expected of it, among the other files in a folder."""
    done: dict[str, list[Diagnostic]] = {}

    def lint(text: str, example: Bad | Good) -> list[Diagnostic]:
        if text not in done:
            done[text] = LINT(text, example, folder)
        return done[text]

    return lint


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.code)
def test_examples(rule: type[Rule], tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def check(trial: Trial) -> None:
        # The project of a file may be the folder above it, which examples would share.
        folder = tmp_path / repr(trial) / "test"
        folder.mkdir(parents=True)
        monkeypatch.setattr(BENCH, "lint", once(folder))
        if rule.applies is not Rule.applies:
            parts_that_the_condition_applies_to_are_reported(trial)
        trial.check()
        if trial.kind == "bad":
            the_finding_is_in_house_style_and_says_what_to_do(trial)
            fixing_comes_to_rest(trial, folder)

    each([trial for trial in TRIALS if trial.rule is rule], check)


def text_of(trial: Trial) -> str:
    return unmark(fill(trial.rule.scaffold, trial.example))[0]


def parts_that_the_condition_applies_to_are_reported(trial: Trial) -> None:
    rule = trial.rule
    facts = next(facts for facts in BENCH.facts if facts.code == rule.code)

    def spy(self: Subjects, document: Document, tables: list[Path]) -> list[object]:
        found = find(self, document, tables)
        for subject in found if (self.looks_at, self.selects) == (facts.looks_at, facts.selects) else ():
            applies = rule.applies(subject)
            assert bool(INDEX.condition(facts)(subject)) is bool(applies), subject
            assert not applies or list(rule().check(subject)), f"nothing to report about {subject}"
        return found

    find = Subjects.of
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Subjects, "of", spy)
        BENCH.lint(text_of(trial), trial.example)


def the_finding_is_in_house_style_and_says_what_to_do(trial: Trial) -> None:
    example = trial.example
    assert isinstance(example, Bad)
    found = BENCH.lint(text_of(trial), example)
    (own,) = (each for each in found if each.code == trial.rule.code)
    assert own.message[:1] != own.message[:1].upper() or not own.message[0].isalpha(), own.message
    assert not own.message.endswith(".")
    assert own.fix is not None or own.help, own.message
    for one in found:
        if "did you mean" in one.message:
            assert one.fix is not None, one.message
            assert one is not own or example.fixed is not None, one.message


def fixing_comes_to_rest(trial: Trial, folder: Path) -> None:
    example, text = trial.example, text_of(trial)
    assert isinstance(example, Bad)
    data, path = text.encode(), Path(file_name(text, example))
    if example.files is not None:
        path = folder / path

    def again(file: Selected) -> tuple[list[Diagnostic], int]:
        return BENCH.lint(file.data.decode(), example), 0

    fixed = fix_file(selected(data, path), again, unsafe=True)
    if repr(trial) in REVEALS:
        assert fixed.refusal.startswith("the edits would bring in `")
        return
    assert not fixed.refusal
    assert (fixed.after != data) is (fixed.fixed > 0)
    assert fixed.fixed or example.fixed is None
    left = BENCH.lint(fixed.after.decode(), example)
    assert applicable(left, path, unsafe=True) == []
    if example.fixed is not None:
        assert [d.message for d in left if d.code == trial.rule.code] == []


def selected(data: bytes, path: Path) -> Selected:
    # A broken text may be anything; the parser decides.
    kind = sniff(data, path)
    return Selected(path, data, kind if kind in KNOWN else Kind.BROKEN_XML)


def test_the_conditions_are_up_to_date() -> None:
    pack = find_pack(BUILT_IN)
    assert is_current(pack.folder / f"{CONDITIONS}.py", render(pack)), "run `make rules/conditions.py`"
