"""Every rule's examples run: the exact place, the fix, and silence where all is well."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.files.library import Library
from sdfcheck.lint import engine
from sdfcheck.lint.conditions import is_current, render
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.engine import Dispatch, Xacro, lint_source
from sdfcheck.lint.example import Bad, Good, fill, unmark
from sdfcheck.lint.packs import BUILT_IN, CONDITIONS, find_pack, import_pack, load_index, rule_classes
from sdfcheck.lint.rule import Rule
from sdfcheck.lint.select import ActiveRules
from sdfcheck.lint.subjects import subjects
from sdfcheck.source.document import Document
from sdfcheck.source.element import Element
from sdfcheck.source.sniff import Kind
from sdfcheck.xacro.expansion import Expander

INDEX = load_index()
DISPATCH = Dispatch(INDEX, ActiveRules(INDEX.facts, {}))
XACRO = Xacro(Expander())
RULES = sorted(
    (rule for module in import_pack(find_pack(BUILT_IN)) for rule in rule_classes(module)),
    key=lambda r: r.code,
)
# What speaks of something left out would speak in every snippet that shows something else.
OF_ABSENCE = {"INR004"}
MIXED: dict[str, str] = {}
"""Code → why a rule both looks at objects and explains problems."""
DEFAULT = {rule.code for rule in RULES if rule.default} - OF_ABSENCE


def lint(text: str, example: Bad | Good, folder: Path) -> list[Diagnostic]:
    """Lint a text as the example's file, among the example's other files."""
    kind = {".xacro": Kind.XACRO, ".config": Kind.MODEL_CONFIG}.get(Path(example.file).suffix)
    path, library = Path(example.file or "example"), None
    if example.files is not None:
        for name, content in example.files.items():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            (folder / name).write_text(content, encoding="utf-8")
        path, library = folder / path, Library()
    return lint_source(text.encode(), path, kind, DISPATCH, library, XACRO).diagnostics


def examples(kind: str) -> list[object]:
    return [
        pytest.param(rule, example, id=f"{rule.code}-{number}")
        for rule in RULES
        for number, example in enumerate(getattr(rule, kind))
    ]


@pytest.mark.parametrize("rule", RULES, ids=lambda r: r.code)
def test_metadata(rule: type[Rule]) -> None:
    module = rule.__module__.rsplit(".", 1)[-1]
    assert rule.name.replace("-", "_") == module
    assert rule.__name__.lower() == module.replace("_", "")
    assert rule.bad, "a rule shows what it reports"
    assert rule.good, "a rule shows what it leaves alone"
    looks = bool(rule.looks_at or rule.selects)
    assert looks or rule.explains, "a rule looks at something"
    assert not (looks and rule.explains) or rule.code in MIXED, "a rule decides or explains"
    assert rule.selects or Element not in rule.looks_at, "selectors say which elements"
    assert looks or rule.applies is Rule.applies, "a problem has been decided on"
    first = (rule.__doc__ or "").strip().partition("\n\n")[0]
    assert first.endswith("."), "the manual begins with a sentence that states the defect"
    assert (
        rule.code[: -len(rule.code.lstrip("ABCDEFGHIJKLMNOPQRSTUVWXYZ"))].lower()
        == rule.__module__.split(".")[-2]
    )


def test_codes_and_names_are_unique() -> None:
    assert len({rule.code for rule in RULES}) == len({rule.name for rule in RULES}) == len(RULES)


@pytest.mark.parametrize(("rule", "example"), examples("bad"))
def test_bad_examples_are_reported_in_place(rule: type[Rule], example: Bad, tmp_path: Path) -> None:
    text, start, end = unmark(fill(rule.scaffold, example))
    found = lint(text, example, tmp_path)
    own = [d for d in found if d.code == rule.code]
    assert len(own) == 1, [f"{d.code} {d.message}" for d in found]
    span = own[0].span
    assert (span.start, span.end) == (start, end), f"reported at {span.text!r}"
    assert example.says in own[0].message, own[0].message
    assert own[0].message[:1] != own[0].message[:1].upper() or not own[0].message[0].isalpha(), own[0].message
    assert not own[0].message.endswith(".")
    others = {d.code for d in found if d.severity >= Severity.WARNING} & DEFAULT - {rule.code}
    assert others == set(example.also), [f"{d.code} {d.message}" for d in found]


@pytest.mark.parametrize(("rule", "example"), examples("good"))
def test_good_examples_are_left_alone(rule: type[Rule], example: Good, tmp_path: Path) -> None:
    found = lint(fill(rule.scaffold, example), example, tmp_path)
    assert [d.message for d in found if d.code == rule.code] == []


@pytest.mark.parametrize(
    ("rule", "example"),
    [
        pytest.param(rule, example, id=f"{rule.code}-{number}")
        for rule in RULES
        if rule.applies is not Rule.applies
        for number, example in enumerate((*rule.bad, *rule.good))
    ],
)
def test_what_a_condition_applies_to_is_reported(
    rule: type[Rule], example: Bad | Good, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    facts = next(facts for facts in INDEX.facts if facts.code == rule.code)
    seen: list[object] = []

    def spy(document: Document, looks_at: tuple[str, ...], selects: tuple[str, ...]) -> list[object]:
        found = subjects(document, looks_at, selects)
        seen.extend(found if (looks_at, selects) == (facts.looks_at, facts.selects) else ())
        return found

    monkeypatch.setattr(engine, "subjects", spy)
    lint(unmark(fill(rule.scaffold, example))[0], example, tmp_path)
    for subject in seen:
        applies = rule.applies(subject)
        assert bool(INDEX.condition(facts)(subject)) is bool(applies), subject
        assert not applies or list(rule().check(subject)), f"nothing to report about {subject}"


def test_the_conditions_are_up_to_date() -> None:
    pack = find_pack(BUILT_IN)
    assert is_current(pack.folder / f"{CONDITIONS}.py", render(pack)), "run `make generate`"


@pytest.mark.parametrize(("rule", "example"), examples("bad"))
def test_fixes_give_what_the_example_shows(rule: type[Rule], example: Bad, tmp_path: Path) -> None:
    text, _, _ = unmark(fill(rule.scaffold, example))
    (diagnostic,) = (d for d in lint(text, example, tmp_path) if d.code == rule.code)
    if example.fixed is None:
        return
    assert diagnostic.fix is not None, "the example shows a fix"
    assert diagnostic.fix.is_safe is not example.unsafe
    for edit in sorted(diagnostic.fix.edits, key=lambda e: -e.span.start):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    expected = fill(rule.scaffold, example._replace(text=example.fixed))
    assert text == expected
    assert [d.message for d in lint(text, example, tmp_path) if d.code == rule.code] == []
