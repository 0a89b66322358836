"""The help that findings get from their rule."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.rule import Rule, replace
from sdfcheck.lint.suppress.rules import MalformedSuppression, report
from sdfcheck.source.text import Source, Span


class Silent(Rule):
    """A rule without advice."""

    code = "TST001"
    name = "silent"
    severity = Severity.WARNING


class Helpful(Silent):
    """A rule with advice."""

    remedy = """Write `a.b` into
    the `name`, or 1.5. The rest is for
    the page.
    """


@pytest.fixture
def span() -> Span:
    return Source(Path("robot.sdf"), "<sdf/>").span(1, 4)


def test_the_first_sentence_is_the_help(span: Span) -> None:
    assert Helpful().diagnostic(span, "wrong").help == "write `a.b` into the `name`, or 1.5"


def test_there_is_no_help_without_a_remedy(span: Span) -> None:
    assert Silent().diagnostic(span, "wrong").help is None


def test_the_help_of_the_finding_is_kept(span: Span) -> None:
    assert Helpful().diagnostic(span, "wrong", help="do this").help == "do this"


def test_a_message_may_say_what_to_do(span: Span) -> None:
    assert Helpful().diagnostic(span, "write `b`", help="").help is None


def test_a_fix_that_may_not_be_made_is_advice(span: Span) -> None:
    found = Helpful().diagnostic(span, "wrong", fix=replace(span, "b", "write `b`")).without_fix
    assert (found.fix, found.help) == (None, "write `b`")
    assert found.without_fix is found


def test_a_fix_says_what_to_do(span: Span) -> None:
    assert Helpful().diagnostic(span, "wrong", fix=replace(span, "b", "write `b`")).help is None
    assert Helpful().diagnostic(span, "wrong", meant="b").help is None


def test_a_name_that_cannot_be_written_gets_the_help(span: Span) -> None:
    found = Helpful().diagnostic(span, "wrong", meant="a<b")
    assert found.fix is None
    assert found.help is not None


def test_rules_of_the_engine_do_so_too(span: Span) -> None:
    found = report(MalformedSuppression, span, "wrong")
    assert found.help == (
        "write it as `<!-- sdfcheck:ignore[name-of-the-rule] reason -->`, directly before the element"
    )
    assert report(MalformedSuppression, span, "wrong", help="so").help == "so"
    assert report(MalformedSuppression, span, "wrong", fix=replace(span, "b", "write `b`")).help is None
