"""Start tags: the places of their parts, and what is said of broken ones."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.lint.example import unmark
from sdfcheck.source.problems import RepeatedAttribute, SyntaxDefect, SyntaxKind
from sdfcheck.source.scanner.scan import parse_start_tag
from sdfcheck.source.scanner.start_tag import START, StartTag
from sdfcheck.source.text import Source


def parts(text: str) -> tuple[StartTag, list[tuple[str, str]]]:
    """The tag at the start of a text, and the names and values of its attributes, cut from the text."""
    tag, problems = parse_start_tag(Source(Path("t"), text), 0)
    assert problems == []
    assert text[tag.name_start : tag.name_end] == tag.name
    pairs = []
    for place in tag.attributes:
        assert text[place.name_start : place.name_end] == place.name
        pairs.append((place.name, text[place.value_start : place.value_end]))
    return tag, pairs


@pytest.mark.parametrize(
    ("text", "name", "attributes", "empty"),
    [
        ("<a>", "a", [], False),
        ("<a/>", "a", [], True),
        ("<a  \n/>", "a", [], True),
        ('<a b="c"/>', "a", [("b", "c")], True),
        ("<a b='\"c\"'>", "a", [("b", '"c"')], False),
        ('<a\tb = "c"\r\n  d="">', "a", [("b", "c"), ("d", "")], False),
        ('<p:a p:b="1"\n     c="2\n3" >', "p:a", [("p:b", "1"), ("c", "2\n3")], False),
        ('<a b="/>" c=">">', "a", [("b", "/>"), ("c", ">")], False),
        ('<größe ü="1"/>', "größe", [("ü", "1")], True),
        ("<a、b/>", "a、b", [], True),
    ],
)
def test_sound_tags(text: str, name: str, attributes: list[tuple[str, str]], empty: bool) -> None:
    tag, pairs = parts(text + "rest<b>")
    assert (tag.name, pairs, tag.empty) == (name, attributes, empty)
    assert tag.end == len(text)


def test_a_tag_amid_a_text() -> None:
    source = Source(Path("t"), '<a><b c="d"/></a>')
    tag, _ = parse_start_tag(source, 3)
    assert (tag.name_start, tag.attributes[0].value_start, tag.end) == (4, 9, 13)


def test_an_attribute_given_twice_names_the_first() -> None:
    _, (problem,) = parse_start_tag(Source(Path("t"), '<a b="1" c="2" b="3">'), 0)
    assert isinstance(problem, RepeatedAttribute)
    assert (problem.span.start, problem.first.start) == (15, 3)


def test_doubled_declarations_of_prefixes_are_left_to_the_namespaces() -> None:
    assert parse_start_tag(Source(Path("t"), '<a xmlns:p="1" xmlns:p="2" xmlns="" xmlns="">'), 0)[1] == []
    assert len(parse_start_tag(Source(Path("t"), '<a xmlnsp="1" xmlnsp="2">'), 0)[1]) == 1


BROKEN = [
    ("<a b=«1»>", SyntaxKind.UNQUOTED_VALUE, [("b", "1")]),
    ("<a b=«x/y»/>", SyntaxKind.UNQUOTED_VALUE, [("b", "x/y")]),
    ("<a b=«1 2\"» c='3'>", SyntaxKind.UNQUOTED_VALUE, [("b", "1 2"), ("c", "3")]),
    ('<a b=«\\"1\\"»>', SyntaxKind.UNQUOTED_VALUE, [("b", "1")]),
    ("<a b=«“1 2”» c='3'>", SyntaxKind.CURLY_QUOTES, [("b", "1 2"), ("c", "3")]),
    ('<a b=«"1»/>', SyntaxKind.UNCLOSED_VALUE, [("b", "1")]),
    ('<a b=«"1» c="2">', SyntaxKind.UNCLOSED_VALUE, [("b", "1"), ("c", "2")]),
    ('<a b=«"1»>\n<c d="e">', SyntaxKind.UNCLOSED_VALUE, [("b", "1")]),
    ("<a b=«\"1»'>", SyntaxKind.UNCLOSED_VALUE, [("b", "1")]),
    ('<a b="1«<»2">', SyntaxKind.ANGLE_IN_VALUE, [("b", "1<2")]),
    ('<a b="«<»!-- c -->">', SyntaxKind.ANGLE_IN_VALUE, [("b", "<!-- c -->")]),
    ("<a «b»>", SyntaxKind.VALUELESS_ATTRIBUTE, []),
    ("<a «b»=>", SyntaxKind.VALUELESS_ATTRIBUTE, []),
    ('<a «b»"1" c="2">', SyntaxKind.MISSING_EQUALS, [("b", "1"), ("c", "2")]),
    ('<a b="1"«c»="2">', SyntaxKind.MISSING_SPACE, [("b", "1"), ("c", "2")]),
    ('<a b="1"«,» c="2">', SyntaxKind.MALFORMED_ATTRIBUTE, [("b", "1"), ("c", "2")]),
    ('<a b="1"«"»>', SyntaxKind.MALFORMED_ATTRIBUTE, [("b", "1")]),
    ('<a b="1«"»x" c">', SyntaxKind.MALFORMED_ATTRIBUTE, [("b", "1")]),
    ("<a «/»/>", SyntaxKind.MALFORMED_ATTRIBUTE, []),
    ('<a b="1"«\\»>', SyntaxKind.MALFORMED_ATTRIBUTE, [("b", "1")]),
    ("<«1a»>", SyntaxKind.MALFORMED_NAME, []),
    ("<«a$»>", SyntaxKind.MALFORMED_NAME, []),
    ("<«a²»>", SyntaxKind.MALFORMED_NAME, []),
    ('<a «1b»="1">', SyntaxKind.MALFORMED_NAME, [("1b", "1")]),
    ("<a«\u00a0»b='1'>", SyntaxKind.ODD_BLANK, [("b", "1")]),
    ("<a «<!-- c -->» b='1'>", SyntaxKind.COMMENT_IN_TAG, [("b", "1")]),
    ("«< a» b='1'>", SyntaxKind.BLANK_IN_TAG, [("b", "1")]),
    ("<a «b='1'»<c>", SyntaxKind.UNCLOSED_TAG, [("b", "1")]),
    ("<«a»\n<c>", SyntaxKind.UNCLOSED_TAG, []),
    ("<a b='1'«/»\n<c>", SyntaxKind.UNCLOSED_TAG, [("b", "1")]),
    ("<«a» 0 0 0</a>", SyntaxKind.UNCLOSED_TAG, []),
    ("«<a b='1»", SyntaxKind.TRUNCATED, [("b", "1")]),
    ("«<a»", SyntaxKind.TRUNCATED, []),
]


@pytest.mark.parametrize(("marked", "kind", "attributes"), BROKEN, ids=[text for text, _, _ in BROKEN])
def test_broken_tags_have_one_defect_in_place(
    marked: str, kind: SyntaxKind, attributes: list[tuple[str, str]]
) -> None:
    text, start, end = unmark(marked)
    tag, (problem,) = parse_start_tag(Source(Path("t"), text), 0)
    assert isinstance(problem, SyntaxDefect)
    assert problem.kind is kind
    assert (problem.span.start, problem.span.end) == (start, end)
    assert [(a.name, text[a.value_start : a.value_end]) for a in tag.attributes] == attributes
    assert 0 < tag.end <= len(text)


def test_two_mistakes_that_do_not_confuse_each_other_are_both_reported() -> None:
    _, problems = parse_start_tag(Source(Path("t"), "<a b=1 c=2>"), 0)
    assert [p.span.text for p in problems] == ["1", "2"]


def test_a_value_stuck_to_the_name_is_the_element_s() -> None:
    tag, _ = parse_start_tag(Source(Path("t"), "<mass1.5</mass>"), 0)
    assert (tag.name, tag.end) == ("mass", 5)


def test_a_long_run_of_blanks_takes_no_long_time() -> None:
    for text in ('<a b="x' + " " * 100_000, "<a" + " " * 100_000 + "b", "<a b" + " " * 100_000 + "c"):
        tag, problems = parse_start_tag(Source(Path("t"), text), 0)
        assert tag.name == "a"
        assert problems


def test_the_strict_pattern_wants_blanks_that_xml_knows() -> None:
    assert START.match("<a b='1'>")
    assert not START.match("<a\u2003b='1'>")
