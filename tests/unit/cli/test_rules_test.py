"""``sdfcheck rules --test``: the examples of a pack as tests."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.cli.main import main
from sdfcheck.testing import PackError, check_pack, examples

RULE = """
from sdfcheck import IN_MODEL, Bad, Good, Rule, Severity, replace


class BadName(Rule):
    '''A link is called «bad».'''

    code = "TST001"
    name = "bad-name"
    severity = Severity.WARNING
    selects = ("sdf:link",)
    scaffold = IN_MODEL
    bad = (
        Bad('<link name="«bad»"/>', fixed='<link name="good"/>', says="called `bad`"),
        BAD,
    )
    good = (
        GOOD,
    )

    def check(self, link):
        name = link.attribute("name")
        if name and name.text == "bad":
            yield self.diagnostic(name, "called `bad`", fix=replace(name, "good", "call it good"))
"""


@pytest.fixture(autouse=True)
def here(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(tmp_path)


def pack(bad: str = "Bad('<link name=\"«bad»\"/>')", good: str = "Good('<link name=\"fine\"/>')") -> None:
    Path("checks").mkdir()
    Path("checks", "rules.py").write_text(RULE.replace("BAD,", f"{bad},").replace("GOOD,", f"{good},"))


def outcome_of(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, list[str]]:
    code = main(["rules", "--test", "checks", *arguments])
    return code, capsys.readouterr().out.splitlines()


def test_a_sound_pack_passes(capsys: pytest.CaptureFixture[str]) -> None:
    pack()
    assert outcome_of(capsys) == (0, ["3 examples of 1 rule: all as expected"])
    check_pack(Path("checks"))
    assert [str(example) for example in examples(Path("checks"))] == [
        "TST001-bad-1",
        "TST001-bad-2",
        "TST001-good-1",
    ]


@pytest.mark.parametrize("written", ["bad = MORE", "bad = (*MORE,)"])
def test_examples_that_are_made_elsewhere_are_where_they_are_assigned(
    capsys: pytest.CaptureFixture[str], written: str
) -> None:
    pack()
    rules = Path("checks", "rules.py")
    before, _, rest = rules.read_text().partition("    bad = (\n")
    after = rest.partition("    )\n")[2]
    rules.write_text(
        f"{before}    MORE = (Bad('<link name=\"«bad»\"/>'), Bad('<link/>'))\n    {written}\n{after}"
    )
    code, (found, _) = outcome_of(capsys)
    assert code == 1
    assert found.startswith("checks/rules.py:14: TST001 bad-name, bad example 2: "), found


def test_one_example_fails_alone() -> None:
    pack(good="Good('<link name=\"bad\"/>')")
    *sound, faulty = examples(Path("checks"))
    for example in sound:
        example.check()
    with pytest.raises(AssertionError, match="TST001 bad-name, good example 1: expected no diagnostic"):
        faulty.check()


@pytest.mark.parametrize(
    ("bad", "reason"),
    [
        ("Bad('<link name=\"«fine»\"/>')", "expected one diagnostic at `fine` (line 1, column 68), got none"),
        (
            "Bad('<link «name»=\"bad\"/>')",
            "expected a diagnostic at `name` (line 1, column 62), got one at `bad`",
        ),
        ("Bad('<link name=\"bad\"/>')", "expected «» around what is reported"),
        (
            "Bad('<link name=\"«bad»\"/>', says='worse')",
            "expected a message with “worse”, got “called `bad`”",
        ),
        ("Bad('<link name=\"«bad»\"/>', also=('TST9',))", "expected a diagnostic of TST9, too, got none"),
        (
            "Bad('<link name=\"«bad»\"/>', fixed='<link name=\"x\"/>')",
            "expected the fix to give `<sdf version",
        ),
        (
            "Bad('<link name=\"«bad»\"/>', fixed='<link name=\"good\"/>', unsafe=True)",
            "expected an unsafe fix, got a safe one",
        ),
        (
            'Bad(\'<link name="«bad»"/><link name="bad"/>\')',
            "got “called `bad`” at `bad` (line 1, column 68); “called `bad`” at",
        ),
        ("Bad('<link nam=\"«bad»\"/>')", "got none (but "),
    ],
)
def test_a_bad_example_that_fails(capsys: pytest.CaptureFixture[str], bad: str, reason: str) -> None:
    pack(bad=bad)
    code, (line, summary) = outcome_of(capsys)
    assert code == 1
    assert line.startswith("checks/rules.py:15: TST001 bad-name, bad example 2: "), line
    assert reason in line
    assert summary == "3 examples of 1 rule: 1 failed"
    with pytest.raises(AssertionError) as caught:
        check_pack(Path("checks"))
    assert str(caught.value) == line
    failing = next(example for example in examples(Path("checks")) if str(example) == "TST001-bad-2")
    with pytest.raises(AssertionError):
        failing.check()


def test_a_good_example_that_fails(capsys: pytest.CaptureFixture[str]) -> None:
    pack(good="Good('<link name=\"bad\"/>')")
    code, (line, _) = outcome_of(capsys)
    assert code == 1
    assert line.startswith(
        "checks/rules.py:18: TST001 bad-name, good example 1: expected no diagnostic, got "
    )


def test_a_rule_that_cannot_be_loaded_fails(capsys: pytest.CaptureFixture[str]) -> None:
    pack()
    text = (
        RULE.replace("BadName", "Odd")
        .replace("TST001", "tst")
        .replace("BAD,", "")
        .replace("GOOD,", "Good(''),")
    )
    Path("checks", "odd.py").write_text(text)
    code, (line, summary) = outcome_of(capsys)
    assert code == 1
    assert line.startswith("checks/odd.py:8: Odd: `code` should be capitals and three digits")
    assert summary == "3 examples of 1 rule: all as expected; 1 fault in the pack"
    first = examples(Path("checks"))[0]
    assert str(first) == "checks/odd.py:8"
    with pytest.raises(AssertionError, match="`code` should be"):
        first.check()


def test_a_failing_check_is_named_with_its_place(capsys: pytest.CaptureFixture[str]) -> None:
    pack()
    path = Path("checks", "rules.py")
    path.write_text(path.read_text().replace("if name and", "if name.gone and"))
    code, lines = outcome_of(capsys)
    assert code == 1
    assert len(lines) == 4
    assert all(
        "rule TST001 bad-name failed at checks/rules.py:23: AttributeError" in line for line in lines[:3]
    )


def test_a_rule_that_cannot_be_tested_is_wrong_usage(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["rules", "--test", "gone"]) == 2
    assert main(["rules", "--test", "./gone"]) == 2
    pack()
    assert main(["rules", "--test", "checks", "NOPE"]) == 2
    assert main(["rules", "--test", "checks", "--output-format", "json"]) == 2
    errors = capsys.readouterr().err.splitlines()
    assert [line.partition(":")[0] for line in errors] == ["error"] * 4
    with pytest.raises(PackError):
        check_pack("gone")
