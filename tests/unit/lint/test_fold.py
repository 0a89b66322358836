"""One diagnostic for what a macro does in every call."""

from __future__ import annotations

from pathlib import Path

from sdfcheck.lint.diagnostic import Diagnostic, Origin, Severity
from sdfcheck.lint.fix import Fix, TextEdit
from sdfcheck.lint.fold import fold
from sdfcheck.source.text import Source

SOURCE = Source(Path("leg.xacro"), "abcdefghij" * 5)


def said(
    at: int,
    origin: int,
    message: str = "bad",
    code: str = "A001",
    fix: str = "",
    severity: Severity = Severity.ERROR,
) -> Diagnostic:
    span = SOURCE.span(at, at + 2)
    origins = (Origin(SOURCE.span(origin, origin + 1), "in macro `m`, called here"),)
    repair = Fix("fix_files", (TextEdit(span, fix),)) if fix else None
    return Diagnostic(code, "name", severity, message, span, fix=repair, origins=origins)


def test_calls_are_counted_and_the_first_represents_all() -> None:
    (one,) = fold([said(0, 20, "left is bad"), said(0, 30, "right is bad"), said(0, 40, "third is bad")])
    assert one.message == "left is bad (in 3 expansions)"
    assert one.origins[0].span.start == 20


def test_other_places_and_other_rules_stay_apart() -> None:
    found = fold([said(0, 20), said(4, 20), said(0, 20, code="B001")])
    assert [(d.span.start, d.code, d.message) for d in found] == [
        (0, "A001", "bad"),
        (0, "B001", "bad"),
        (4, "A001", "bad"),
    ]


def test_two_things_said_in_each_call_stay_two() -> None:
    found = fold([said(0, at, message) for at in (20, 30) for message in ("one", "two")])
    assert [d.message for d in found] == ["one (in 2 expansions)", "two (in 2 expansions)"]


def test_an_error_is_not_one_of_the_infos_at_its_place() -> None:
    found = fold(
        [said(0, 20, "shown", severity=Severity.INFO), said(0, 30, "refused"), said(0, 40, "refused")]
    )
    assert [(d.severity, d.message) for d in found] == [
        (Severity.ERROR, "refused (in 2 expansions)"),
        (Severity.INFO, "shown"),
    ]


def test_the_same_twice_is_once() -> None:
    assert fold([said(0, 20), said(0, 20)]) == [said(0, 20)]


def test_a_fix_stays_if_all_agree() -> None:
    (same,) = fold([said(0, 20, fix="x"), said(0, 30, fix="x")])
    assert same.fix is not None
    (other,) = fold([said(0, 20, fix="x"), said(0, 30, fix="y")])
    assert other.fix is None
