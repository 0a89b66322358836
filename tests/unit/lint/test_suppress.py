import re
from pathlib import Path

import pytest

from sdfcheck import lint
from sdfcheck.lint.diagnostic import Diagnostic, Label, Origin, Severity
from sdfcheck.lint.example import Bad, unmark
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.suppress.rules import FACTS, MalformedSuppression, OwnRule, UnusedSuppression
from sdfcheck.lint.suppress.suppression import Comment, Filtered, directives, suppress
from sdfcheck.source.text import Source


def rule(code: str, name: str) -> RuleFacts:
    return RuleFacts(code, name, code[:3], Severity.ERROR, "", "", True, (), (), {}, "")


RULES = (rule("AAA001", "first-flaw"), rule("AAA002", "second-flaw"), rule("BBB001", "third-flaw"))
CODES = frozenset(facts.code for facts in RULES)
FLAW = {"!": "AAA001", "?": "AAA002", "#": "BBB001"}
"""In the texts below these characters mean a diagnostic of a rule."""


def comments(source: Source) -> list[Comment]:
    """The comments of a text whose elements are ``<a…>`` (with content) and ``<leaf…>…</leaf>``."""
    found = []
    for match in re.finditer(r"<!--.*?-->", source.text, re.DOTALL):
        element = re.compile(r"<leaf.*?</leaf>|<\w.*?>", re.DOTALL).search(source.text, match.end())
        target = source.span(*element.span()) if element else None
        found.append(Comment(source.span(*match.span()), target))
    return found


def diagnostics(source: Source) -> list[Diagnostic]:
    return [
        Diagnostic(FLAW[match[0]], "", Severity.ERROR, match[0], source.span(*match.span()))
        for match in re.finditer(r"[!?#]", re.sub(r"!--|\?xml", "---", source.text))
    ]


def silence(text: str, active: frozenset[str] = CODES) -> tuple[str, Filtered]:
    """The flaws that are kept, as characters, and all of the result."""
    source = Source(Path("a.sdf"), text)
    result = suppress(diagnostics(source), directives(comments(source), RULES).known, active)
    return "".join(diagnostic.message for diagnostic in result.kept), result


@pytest.mark.parametrize(
    ("text", "kept"),
    [
        ("<!-- sdfcheck: ignore[AAA001] why not -->\n<a !><leaf !></leaf></a>", "!"),
        ("<!--sdfcheck:ignore[first-flaw]--><leaf !>!</leaf><leaf !></leaf>", "!"),
        ("<!-- sdfcheck: ignore[AAA001, third-flaw] --><leaf ! ? #></leaf>", "?"),
        ("<!-- sdfcheck: ignore[AAA] --><leaf ! ? #></leaf>", "#"),
        ("<!-- sdfcheck: ignore[ALL] --><leaf ! ? #></leaf>", ""),
        ("<!-- sdfcheck: ignore[AAA001] --><!-- prose --><a !></a>", ""),
        ("<!-- sdfcheck: ignore[AAA001] --><!-- sdfcheck: ignore[AAA002] --><a ! ?></a>", ""),
        (
            "!<!-- sdfcheck: disable[AAA001] -->!<a !><leaf>! ?</leaf></a><!-- sdfcheck: enable[AAA001] -->!",
            "!?!",
        ),
        ("<!-- sdfcheck: disable[AAA] -->!?<!-- sdfcheck: enable[AAA001] -->!?", "!"),
        ("<!-- sdfcheck: disable[AAA] -->!?<!-- sdfcheck: enable -->!?", "!?"),
        ("!<!-- sdfcheck: disable[AAA001] -->!\n!", "!"),
        ("!<!-- sdfcheck: ignore-file[AAA001] -->!?", "?"),
        ("!<!-- sdfcheck: ignore-file -->!?#", ""),
        ("<!-- sdfcheck is fine --><a !>", "!"),
    ],
)
def test_the_silenced_findings(text: str, kept: str) -> None:
    left, result = silence(text)
    assert left == kept
    assert result.suppressed == len(diagnostics(Source(Path("a"), text))) - len(kept)
    assert not result.unused


def test_a_comment_before_an_element_that_a_label_names_counts() -> None:
    source = Source(Path("a.sdf"), "<!-- sdfcheck: ignore[AAA001] --><a><leaf !></leaf></a><a !></a>")
    around, other = source.span(33, 36), source.span(0, 0)
    found = diagnostics(source)
    named = [found[0]._replace(labels=(Label(other, "other"), Label(around, "in this")))]
    result = suppress([*named, found[1]], directives(comments(source), RULES).known, CODES)
    assert (result.kept, result.suppressed, result.unused) == ((found[1],), 1, ())


def test_a_comment_is_not_judged_where_its_rule_looks_at_nothing() -> None:
    source = Source(Path("a.sdf"), "<!-- sdfcheck: ignore[AAA001, AAA002] --><leaf></leaf>")
    known = directives(comments(source), RULES).known
    idle = suppress([], known, CODES, is_idle=lambda directive, code: code == "AAA001")
    assert [each.span.text for each in idle.unused] == ["AAA002"]
    assert suppress([], known, CODES, is_idle=lambda directive, code: True).unused == ()


@pytest.mark.parametrize(
    ("inertial", "unused"),
    [
        ("", 0),
        (
            '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>',
            1,
        ),
    ],
)
def test_the_rule_of_a_comment_looks_at_what_is_in_the_element(inertial: str, unused: int) -> None:
    comment = "<!-- sdfcheck:ignore[impossible-inertia] measured -->"
    run = lint(f'<robot name="r">{comment}<link name="a">{inertial}</link></robot>', isolated=True)
    assert sum(each.code == "SUP001" for each in run.diagnostics) == unused


def test_a_macro_call_answers_for_what_it_brings() -> None:
    caller = Source(Path("a.xacro"), "<!-- sdfcheck: ignore[AAA001] --><xacro:leg/><xacro:leg/>")
    body = Source(Path("leg.xacro"), "<link !>")
    calls = [caller.span(place.start(), place.end()) for place in re.finditer("<xacro:leg/>", caller.text)]
    found = [
        Diagnostic("AAA001", "", Severity.ERROR, "", body.span(6, 7), origins=(Origin(call, "called from"),))
        for call in calls
    ]
    result = suppress(found, directives(comments(caller), RULES).known, CODES)
    assert [diagnostic.origins[0].span for diagnostic in result.kept] == calls[1:]


@pytest.mark.parametrize(
    ("text", "place", "message", "fixed"),
    [
        (
            "<a>\n  <!-- sdfcheck: ignore[AAA001] why -->\n  <leaf/></a>",
            "sdfcheck: ignore[AAA001]",
            "unused suppression of `AAA001`",
            "<a>\n  <leaf/></a>",
        ),
        (
            "<a><!-- sdfcheck: ignore[AAA001, third-flaw] --><leaf/></a>",
            "sdfcheck: ignore[AAA001, third-flaw]",
            "unused suppression of `AAA001` and `third-flaw`",
            "<a><leaf/></a>",
        ),
        (
            "<!-- sdfcheck: ignore[AAA001, BBB001] --><a !>",
            "BBB001",
            "unused suppression of `BBB001`",
            "<!-- sdfcheck: ignore[AAA001] --><a !>",
        ),
        (
            "<!-- sdfcheck: ignore[BBB001 , AAA001] --><a !>",
            "BBB001",
            "unused suppression of `BBB001`",
            "<!-- sdfcheck: ignore[AAA001] --><a !>",
        ),
        (
            "<a></a><!-- sdfcheck: ignore[AAA001] -->",
            "sdfcheck: ignore[AAA001]",
            "unused suppression of `AAA001`: no element follows",
            "<a></a>",
        ),
        ("<!-- sdfcheck: ignore-file -->", "sdfcheck: ignore-file", "this file has nothing to silence", ""),
        (
            "<!-- sdfcheck: enable[AAA001] -->",
            "sdfcheck: enable[AAA001]",
            "`AAA001` is not disabled here",
            "",
        ),
        ("<!-- sdfcheck: enable -->", "sdfcheck: enable", "nothing is disabled here", ""),
        (
            "<!-- sdfcheck: disable[AAA001] -->!<!-- sdfcheck: disable[AAA001] -->!",
            "sdfcheck: disable[AAA001]",
            "unused suppression of `AAA001`",
            "<!-- sdfcheck: disable[AAA001] -->!!",
        ),
    ],
)
def test_useless_directives_are_reported_and_removed(text: str, place: str, message: str, fixed: str) -> None:
    _, result = silence(text)
    (report,) = result.unused
    assert (report.code, report.span.text) == (UnusedSuppression.code, place)
    assert message in report.message
    assert report.fix
    assert report.fix.is_safe
    (edit,) = report.fix.edits
    assert text[: edit.span.start] + edit.text + text[edit.span.end :] == fixed


def test_words_for_rules_that_did_not_run_are_not_judged() -> None:
    text = (
        "<!-- sdfcheck: ignore[AAA001] --><!-- sdfcheck: ignore[AAA] --><!-- sdfcheck: ignore[AAA002] --><a/>"
    )
    _, result = silence(text, frozenset({"AAA002"}))
    assert [report.span.text for report in result.unused] == ["sdfcheck: ignore[AAA002]"]


@pytest.mark.parametrize(
    ("text", "place", "message"),
    [
        (
            "<!-- sdfcheck: ignored[AAA001] -->",
            "ignored",
            "unknown directive `ignored`; did you mean `ignore`?",
        ),
        ("<!-- sdfcheck: ignore AAA001 -->", "ignore", "`ignore` names no rule"),
        ("<!-- sdfcheck: disable -->", "disable", "`disable` names no rule"),
        ("<!-- sdfcheck: ignore[] -->", "ignore", "`ignore` names no rule"),
        ("<!-- sdfcheck: ignore[AAA001 -->", "[", "`[` is never closed"),
        ("<!-- sdfcheck ignore[AAA001] -->", "sdfcheck ignore[AAA001]", "`:` is missing"),
        (
            "<!-- sdfcheck: ignore[frist-flaw] -->",
            "frist-flaw",
            "unknown rule `frist-flaw`; did you mean `first-flaw`?",
        ),
        ("<!-- sdfcheck: ignore[AAA001; AAA002] -->", "AAA001; AAA002", "unknown rule"),
    ],
)
def test_unknown_settings_are_reported(text: str, place: str, message: str) -> None:
    source = Source(Path("a.sdf"), text + "<a/>")
    (report,) = directives(comments(source), RULES).malformed
    assert (report.code, report.span.text) == (MalformedSuppression.code, place)
    assert message in report.message


def test_directives_of_other_files_silence_and_are_not_judged() -> None:
    library = Source(
        Path("library.xacro"), "<!-- sdfcheck: ignore[AAA] --><a !></a><!-- sdfcheck: ignore[BBB] --><b/>"
    )
    foreign = directives(comments(library), RULES).known
    result = suppress(diagnostics(library), [], CODES, foreign=foreign)
    assert (result.kept, result.suppressed, result.unused) == ((), 1, ())


@pytest.mark.parametrize(
    ("text", "unused"),
    [
        ("<!-- sdfcheck: ignore[AAA] --><include></include><a></a>", 0),
        ("<!-- sdfcheck: ignore[AAA] --><a></a><include></include>", 1),
        ("<!-- sdfcheck: disable[AAA] --><a></a><include></include>", 0),
        ("<!-- sdfcheck: disable[AAA] --><a></a><!-- sdfcheck: enable --><include></include>", 1),
        ("<!-- sdfcheck: ignore-file[AAA] --><a></a><include></include>", 0),
    ],
)
def test_problems_that_only_includes_show_are_seen_elsewhere(text: str, unused: int) -> None:
    source = Source(Path("a.sdf"), text)
    include = source.span(text.index("<include>"), text.index("</include>"))
    result = suppress([], directives(comments(source), RULES).known, CODES, outward=[include])
    assert len(result.unused) == unused


def test_the_understood_words_still_count() -> None:
    left, result = silence("<!-- sdfcheck: ignore[nonsense, AAA001] --><a ! ?></a>")
    assert left == "?"
    assert not result.unused


def test_a_comment_with_a_word_that_is_not_understood_is_not_removed() -> None:
    text = "<!-- sdfcheck: ignore[AAA001, nonsense] --><a></a>"
    (report,) = silence(text)[1].unused
    assert report.fix
    (edit,) = report.fix.edits
    assert edit.span.text == "AAA001, "


@pytest.mark.parametrize(
    ("code", "example"),
    [(own.code, bad) for own in (UnusedSuppression, MalformedSuppression) for bad in own.bad],
)
def test_the_documented_examples_hold(code: str, example: Bad) -> None:
    text, start, end = unmark(example.text)
    source = Source(Path("a.urdf"), text)
    rules = (*RULES, rule("INT001", "internal-error"))
    found = directives(comments(source), rules)
    (report,) = (*found.malformed, *suppress([], found.known, CODES | {"INT001"}).unused)
    assert (report.code, report.span.start, report.span.end) == (code, start, end)
    assert example.says in report.message
    if report.code == MalformedSuppression.code and example.fixed is not None:
        assert report.fix is not None
        (edit,) = report.fix.edits
        assert f"{text[: edit.span.start]}{edit.text}{text[edit.span.end :]}" == example.fixed
    assert (report.fix is None) is (example.fixed is None)


def test_the_facts_are_complete() -> None:
    rules: tuple[OwnRule, ...] = (UnusedSuppression, MalformedSuppression)
    for facts, own in zip(FACTS, rules, strict=True):
        assert (facts.code, facts.name, facts.severity) == (own.code, own.name, own.severity)
        assert facts.summary
        assert "\n" not in facts.summary
    assert [facts.fixable for facts in FACTS] == ["safe", "unsafe"]
