from __future__ import annotations

import re
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.fix import Applicability, Fix, TextEdit
from sdfcheck.lint.fix.fixer import TRIALS, FixedFile, Refused, edited, fix_file, harmless, together
from sdfcheck.lint.one_file import Selected
from sdfcheck.source.decode import decode
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source

PATH = Path("a.sdf")
TEXT = '<sdf version="1.9">{}</sdf>'
Changes = Callable[[Source], list[tuple[TextEdit, ...]]]


def swap(pattern: str, new: str) -> Changes:
    """One fix for each match."""

    def changes(source: Source) -> list[tuple[TextEdit, ...]]:
        return [(TextEdit(source.span(*m.span()), new),) for m in re.finditer(pattern, source.text)]

    return changes


def fixed_file(
    data: bytes | str, *rules: Changes, unsafe: bool = False, applicability: str = "safe"
) -> FixedFile:
    def lint(file: Selected) -> tuple[list[Diagnostic], int]:
        source, _ = decode(file.data, file.path)
        found = [
            Diagnostic(
                "A1",
                "a",
                Severity.ERROR,
                "m",
                edits[0].span,
                fix=Fix("t", edits, Applicability(applicability)),
            )
            for rule in rules
            for edits in rule(source)
        ]
        return found, 0

    given = data.encode() if isinstance(data, str) else data
    return fix_file(Selected(PATH, given, Kind.SDF), lint, unsafe=unsafe)


def body(result: FixedFile) -> str:
    return result.after.decode().removeprefix('<sdf version="1.9">').removesuffix("</sdf>")


def test_all_fixes_apply_at_once_and_then_again_until_stable() -> None:
    result = fixed_file(TEXT.format("aaa"), swap("a(?!s)", "b"), swap("b", "c"))
    assert (body(result), result.fixed, result.refusal) == ("ccc", 6, "")


def test_overlapping_fixes_wait_for_the_next_round() -> None:
    result = fixed_file(TEXT.format("xyz"), swap("xy", "q"), swap("yz", "r"))
    assert (body(result), result.fixed) == ("qz", 1)


def test_more_insertions_at_one_place_than_rounds() -> None:
    words = [f"w{number:02}" for number in range(25)]

    def rule(word: str) -> Changes:
        return lambda source: [] if word in source.text else [(TextEdit(source.span(19, 19), f"<{word}/>"),)]

    result = fixed_file(TEXT.format(""), *map(rule, words))
    assert result.fixed == 25
    assert all(word in body(result) for word in words)


def test_an_edit_that_two_fixes_share_is_done_once() -> None:
    source = Source(PATH, "abc")
    shared = TextEdit(source.span(0, 0), "+")
    first = Fix("t", (shared, TextEdit(source.span(1, 2), "B")))
    second = Fix("t", (shared, TextEdit(source.span(2, 3), "C")))
    third = Fix("t", (TextEdit(source.span(0, 2), "Z"),))
    edits, applied = together([first, second, third])
    assert [(edit.span.start, edit.text) for edit in edits] == [(0, "+"), (1, "B"), (2, "C")]
    assert len(applied) == 2


def test_a_fix_is_applied_whole_or_not_at_all() -> None:
    source = Source(PATH, "abcd")
    first = Fix("t", (TextEdit(source.span(2, 3), "C"),))
    second = Fix("t", (TextEdit(source.span(0, 1), "A"), TextEdit(source.span(1, 3), "Z")))
    third = Fix("t", (TextEdit(source.span(0, 2), "Y"),))
    edits, applied = together([first, second, third])
    assert ([edit.text for edit in edits], len(applied)) == (["Y", "C"], 2)


def test_unsafe_fixes_only_on_request() -> None:
    rule = swap("a", "b")
    assert fixed_file(TEXT.format("a"), rule, applicability="unsafe").fixed == 0
    assert fixed_file(TEXT.format("a"), rule, applicability="unsafe", unsafe=True).fixed == 1


def test_fixes_of_other_files_are_left_alone() -> None:
    def elsewhere(_: Source) -> list[tuple[TextEdit, ...]]:
        return [(TextEdit(Source(Path("b.sdf"), "a").span(0, 1), "b"),)]

    assert fixed_file(TEXT.format("a"), elsewhere).fixed == 0


@pytest.mark.parametrize(
    ("rules", "reason"),
    [
        ((swap("b", "a"), swap("a", "b")), "undo one another"),
        ((swap("$", " "),), "undo one another"),
        ((swap("</sdf>", ""),), "would break it"),
        ((swap("sdf", "robot"),), "would break it"),
    ],
)
def test_fixes_that_do_no_good_are_refused(rules: tuple[Changes, ...], reason: str) -> None:
    text = TEXT.format("a").encode()
    result = fixed_file(text, *rules)
    assert result.after == text
    assert reason in result.refusal
    assert result.fixed == 0


def test_fixes_that_cannot_be_written_are_refused() -> None:
    data = '<?xml version="1.0" encoding="latin-1"?><sdf>ä</sdf>'.encode("latin-1")
    assert "no character for '€'" in fixed_file(data, swap("ä", "€")).refusal
    assert "other characters" in fixed_file(data, swap("latin-1", "cp437")).refusal
    assert fixed_file(data, swap("ä", "ö")).after == data.replace(
        "ä".encode("latin-1"), "ö".encode("latin-1")
    )


@settings(deadline=None)
@given(st.lists(st.tuples(st.integers(0, 12), st.integers(0, 4), st.text("xy", max_size=2)), max_size=8))
def test_edits_never_overlap(wanted: list[tuple[int, int, str]]) -> None:
    source = Source(PATH, "." * 16)
    fixes = [Fix("t", (TextEdit(source.span(at, at + length), text),)) for at, length, text in wanted]
    edits, applied = together(fixes)
    places = [(edit.span.start, edit.span.end) for edit in edits]
    assert places == sorted(places)
    assert all(one[1] <= two[0] and one[0] < two[0] for one, two in pairwise(places))
    assert bool(applied) is bool(wanted)


def test_edits_that_leave_nothing_are_refused() -> None:
    text = '<sdf version="1.9"/>'
    source = Source(Path("a.sdf"), text)
    file = Selected(Path("a.sdf"), text.encode(), Kind.SDF)
    with pytest.raises(Refused):
        edited(file, [TextEdit(source.span(0, len(text)), "")])


def found_in(text: str, rules: tuple[Changes, ...], bad: str) -> tuple[list[Diagnostic], int]:
    """The fixes of the rules, and an error for each of some words."""
    source = Source(PATH, text)
    fixes = [
        Diagnostic("A1", "a", Severity.INFO, "m", edits[0].span, fix=Fix("t", edits))
        for rule in rules
        for edits in rule(source)
    ]
    errors = [
        Diagnostic("B1", "bad-word", Severity.ERROR, "m", source.span(*m.span()))
        for m in re.finditer(bad, text)
    ]
    return fixes + errors, text.count("sdfcheck:")


def on_trial(text: str, *rules: Changes, bad: str) -> FixedFile:
    file = Selected(PATH, text.encode(), Kind.SDF)
    return fix_file(file, lambda now: found_in(now.data.decode(), rules, bad), unsafe=False)


def test_a_fix_that_brings_in_an_error_is_left_out_and_the_others_are_made() -> None:
    result = on_trial(
        TEXT.format("P Q R S T U V W"), *(swap(f"{x}(?!!)", f"{x}!") for x in "PQRSTUVW"), bad="S!"
    )
    assert body(result) == "P! Q! R! S T! U! V! W!"
    assert (result.fixed, result.refusal) == (7, "the edits would bring in `bad-word`")


def test_two_fixes_that_only_together_do_harm() -> None:
    result = on_trial(TEXT.format("p q"), swap("p(?!!)", "p!"), swap("q(?!!)", "q!"), bad="p! q!")
    assert (body(result), result.fixed) == ("p! q", 1)
    assert result.refusal == "the edits would bring in `bad-word`"


def test_a_fix_that_another_one_makes_harmless_is_made_after_it() -> None:
    rules = swap("p(?!!)", "p!"), swap("q(?!!)", "q!"), swap("(?<=q! )x", "y")
    result = on_trial(TEXT.format("p q x"), *rules, bad="p!.*x(?=<)")
    assert (body(result), result.fixed, result.refusal) == ("p! q! y", 3, "")


def test_an_error_that_was_there_before_stops_no_fix() -> None:
    result = on_trial(TEXT.format("x p"), swap("p", "q"), bad="x")
    assert (body(result), result.refusal) == ("x q", "")


def test_a_comment_for_the_linter_is_not_taken_away() -> None:
    text = TEXT.format("<!-- sdfcheck: ignore[A1] -->P")

    def hides(source: Source) -> list[tuple[TextEdit, ...]]:
        start, end = source.text.find("<!--"), source.text.find("P")
        return [(TextEdit(source.span(start, start), "<![CDATA["), TextEdit(source.span(end, end), "]]>"))]

    result = on_trial(text, hides, swap("P", "Q"), bad="nothing")
    assert result.refusal == "the edits would take away a comment for sdfcheck"
    assert body(result) == "<!-- sdfcheck: ignore[A1] -->Q"


def test_a_fix_that_ends_a_suppression_is_left_out() -> None:
    def lint(file: Selected) -> tuple[list[Diagnostic], int]:
        text = file.data.decode()
        source = Source(PATH, text)
        place = source.span(22, 23)
        note = Diagnostic("A1", "a", Severity.INFO, "m", place, fix=Fix("t", (TextEdit(place, "b"),)))
        shown = Diagnostic("B1", "shown", Severity.INFO, "m", place)
        return ([shown], 0) if ">b<" in text else ([note], 1)

    text = '<sdf version="1.9"><x>a</x></sdf>'
    result = fix_file(Selected(PATH, text.encode(), Kind.SDF), lint, unsafe=False)
    assert (result.fixed, result.refusal) == (0, "the edits would bring in `shown`")


def test_trials_end() -> None:
    runs = 0

    def lint(file: Selected) -> tuple[list[Diagnostic], int]:
        nonlocal runs
        runs += 1
        return found_in(file.data.decode(), (swap("p", "q"),), "q")

    text = TEXT.format("p" * 500)
    result = fix_file(Selected(PATH, text.encode(), Kind.SDF), lint, unsafe=False)
    assert result.fixed == 0
    assert runs <= 2 * TRIALS


def test_harmless_fixes_are_offered() -> None:
    text = TEXT.format("p s")
    rules = (swap("p", "p!"), swap("s", "s!"))
    file = Selected(PATH, text.encode(), Kind.SDF)
    fixes = [each.fix for each in found_in(text, rules, "s!")[0] if each.fix is not None]
    found = harmless(file, fixes, lambda now: found_in(now.data.decode(), rules, "s!"))
    assert [fix.edits[0].span.text for fix in found] == ["p"]
