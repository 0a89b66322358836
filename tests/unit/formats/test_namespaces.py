"""Prefixes: declared, in scope, used, and spelt as "Namespaces in XML" wants them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sdfcheck.formats import namespace_problems as kinds
from sdfcheck.formats.namespaces import problems
from sdfcheck.source.document import read
from sdfcheck.source.sniff import Kind
from tests.unit.only import only


def found(text: str, kind: Kind | None = None) -> list[Any]:
    return sorted(
        problems(read(text.encode(), Path("example.sdf"), kind)), key=lambda problem: problem.span.start
    )


def inside(content: str) -> str:
    return f'<sdf version="1.12"><world name="w">{content}</world></sdf>'


@pytest.mark.parametrize(
    "text",
    [
        '<sdf version="1.12"/>',
        '<sdf version="1.12"><a b="c:d">model://e</a></sdf>',
        '<sdf version="1.12" xml:lang="en"/>',
        '<sdf xmlns:p="u" version="1.12"><p:a/></sdf>',
        '<sdf xmlns:p="u" version="1.12" p:b="1"/>',
        '<p:sdf xmlns:p="u"/>',
        '<sdf xmlns:p="u" xmlns:q="v"><p:a q:b="1"/></sdf>',
        "<sdf><!-- <p:a/> --><![CDATA[<p:a/>]]></sdf>",
    ],
)
def test_sound_prefixes(text: str) -> None:
    assert [p for p in found(text) if not isinstance(p, kinds.DeclaredBelowRoot)] == []


def test_other_documents_are_not_looked_at() -> None:
    assert found('<html xmlns="http://www.w3.org/1999/xhtml"/>') == []


# Undeclared prefixes


def test_uses_of_an_undeclared_prefix_are_gathered() -> None:
    problem = only(found(inside('<p:a p:b="1"><p:c/></p:a>')), kinds.UndeclaredPrefix)
    assert [use.text for use in problem.uses] == ["p", "p", "p"]
    assert problem.span == problem.uses[0]
    assert (problem.prefix, problem.namespace, problem.elsewhere) == ("p", "", None)
    assert problem.root.start == problem.root.end == len('<sdf version="1.12"')


def test_each_prefix_is_told_once() -> None:
    assert [p.prefix for p in found(inside("<p:a/><q:a/><p:b/>"))] == ["p", "q"]


def test_a_declaration_ends_with_its_element() -> None:
    text = inside('<a xmlns:p="u">\n<p:b/>\n</a>\n<p:c/>')
    problem = only(found(text), kinds.UndeclaredPrefix)
    assert problem.elsewhere.text == "xmlns:p"
    assert problem.scope_end.text == "</a>"
    assert problem.scope_end.begin.line == 3
    assert problem.namespace == "u"
    assert problem.span.begin.line == 4


def test_a_declaration_holds_for_its_own_start_tag() -> None:
    (problem,) = found(inside('<p:a p:b="1" xmlns:p="u"/>'))
    assert isinstance(problem, kinds.DeclaredBelowRoot)


def test_an_empty_element_is_its_own_scope() -> None:
    assert only(found(inside('<a xmlns:p="u"/><p:b/>')), kinds.UndeclaredPrefix).scope_end.text == ""


def test_a_sibling_before_the_declaration_is_out_of_scope() -> None:
    assert (
        only(found(inside('<p:b/><a xmlns:p="u" p:c="1"/>')), kinds.UndeclaredPrefix).elsewhere.text
        == "xmlns:p"
    )


def test_the_root_without_attributes_takes_a_declaration_behind_its_name() -> None:
    assert only(found("<sdf><p:a/></sdf>"), kinds.UndeclaredPrefix).root.start == 4


def test_xacro_itself_stops_at_its_own_undeclared_prefix() -> None:
    text = "<robot><xacro:a/><p:b/></robot>"
    assert [p.prefix for p in found(text, Kind.XACRO)] == ["p"]
    assert [p.prefix for p in found(text, Kind.URDF)] == ["xacro", "p"]


# Declarations


def test_a_prefix_declared_twice_on_one_element() -> None:
    problem = only(found('<sdf xmlns:p="u" xmlns:p="v"><p:a/></sdf>'), kinds.RedeclaredPrefix)
    assert (problem.first.start, problem.span.start) == (5, 17)


def test_default_namespaces() -> None:
    problem = only(found('<sdf version="1.12"\n xmlns = "u" />'), kinds.DefaultNamespace)
    assert problem.span.text == "xmlns"
    assert problem.whole.text == '\n xmlns = "u"'
    assert problem.namespace == "u"


def test_a_declaration_below_the_root_can_move_there() -> None:
    problem = only(found(inside('<a\n  xmlns:p="u"  b="1"><p:c/></a>')), kinds.DeclaredBelowRoot)
    assert [whole.text for whole in problem.wholes] == ['\n  xmlns:p="u"']
    assert problem.declaration == 'xmlns:p="u"'


def test_declarations_that_agree_are_told_together() -> None:
    problem = only(found(inside('<a xmlns:p="u" p:b="1"/><c xmlns:p="u" p:b="1"/>')), kinds.DeclaredBelowRoot)
    assert len(problem.wholes) == 2


def test_a_declaration_that_the_root_has_already() -> None:
    problem = only(
        found('<sdf xmlns:p="u"><a p:c="1" xmlns:p="u" p:b="1"/><p:d/></sdf>'), kinds.DeclaredBelowRoot
    )
    assert problem.declaration == ""


def test_declarations_that_disagree_stay_where_they_are() -> None:
    one, other = found(inside('<a xmlns:p="u" p:b="1"/><c xmlns:p="v" p:b="1"/>'))
    assert type(one) is type(other) is kinds.DeclaredBelowRoot
    assert one.wholes == other.wholes == ()


def test_an_unused_prefix() -> None:
    problem = only(found('<sdf xmlns:p="u" xmlns:q="v"><q:a/></sdf>'), kinds.UnusedPrefix)
    assert (problem.prefixes, [whole.text for whole in problem.wholes]) == (("p",), [' xmlns:p="u"'])


def test_unused_prefixes_are_told_once_for_each_element() -> None:
    root, inner = found('<sdf xmlns:p="u" xmlns:q="v"><b xmlns:r="w"/></sdf>')
    assert (root.prefixes, inner.prefixes) == (("p", "q"), ("r",))
    assert [whole.text for whole in root.wholes] == [' xmlns:p="u"', ' xmlns:q="v"']


def test_what_a_xacro_file_declares_may_be_for_others() -> None:
    assert found('<robot xmlns:p="u"/>', Kind.XACRO) == []


def test_a_shadowed_prefix() -> None:
    problems = found('<sdf xmlns:p="u" p:a="1"><b xmlns:p="v" p:a="1"/></sdf>')
    shadowed = next(p for p in problems if isinstance(p, kinds.ShadowedPrefix))
    assert (shadowed.span.start, shadowed.outer.start) == (28, 5)


def test_declaring_again_with_the_same_name_shadows_nothing() -> None:
    problems = found('<sdf xmlns:p="u" p:a="1"><b xmlns:p="u" p:a="1"/></sdf>')
    assert [type(p) for p in problems] == [kinds.DeclaredBelowRoot]


def test_two_prefixes_for_one_name() -> None:
    problem = only(found('<sdf xmlns:p="u" xmlns:q="u"><p:a/><q:a/></sdf>'), kinds.SynonymousPrefix)
    assert (problem.prefix, problem.first_prefix, problem.first.start) == ("q", "p", 5)


def test_two_prefixes_out_of_each_other_s_scope() -> None:
    problems = found(inside('<a xmlns:p="u" p:b="1"/><a xmlns:q="u" q:b="1"/>'))
    assert {type(p) for p in problems} == {kinds.DeclaredBelowRoot}


def test_an_empty_namespace_name() -> None:
    assert only(found('<sdf xmlns:p=""><p:a/></sdf>'), kinds.EmptyNamespaceName).prefix == "p"


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ('<sdf xmlns:xml="u"/>', "xmlns:xml"),
        ('<sdf xmlns:xmlns="u"/>', "xmlns:xmlns"),
        ('<sdf xmlns:p="http://www.w3.org/XML/1998/namespace"/>', "xmlns:p"),
        ('<sdf xmlns:p="http://www.w3.org/2000/xmlns/"><p:a/></sdf>', "xmlns:p"),
        ("<sdf><xmlns:a/></sdf>", "xmlns"),
    ],
)
def test_reserved_prefixes(text: str, place: str) -> None:
    assert only(found(text), kinds.ReservedPrefix).span.text == place


def test_xml_may_be_declared_as_what_it_is() -> None:
    assert [
        type(p) for p in found('<sdf xmlns:xml="http://www.w3.org/XML/1998/namespace" xml:lang="en"/>')
    ] == []


# Names


@pytest.mark.parametrize("name", ["a:b:c", ":a", "a:", "::", "a::b"])
def test_malformed_names(name: str) -> None:
    assert only(found(inside(f"<{name}/>")), kinds.MalformedQualifiedName).span.text == name
    assert only(found(inside(f'<a {name}="1"/>')), kinds.MalformedQualifiedName).name == name


@pytest.mark.parametrize("name", ["xmlns:", "xmlns:a:b"])
def test_malformed_declarations(name: str) -> None:
    assert only(found(f'<sdf {name}="u"/>'), kinds.MalformedQualifiedName).name == name


def test_plugins_may_have_names_with_two_colons() -> None:
    assert found(inside('<plugin name="p" filename="p"><gz::a>1</gz::a></plugin>')) == []
    assert only(found(inside('<plugin name="p" filename="p"/><gz::a/>')), kinds.MalformedQualifiedName)


def test_names_in_a_faulty_text_are_judged_as_well() -> None:
    assert only(found(inside("<p:a/><!-- -- -->")), kinds.UndeclaredPrefix).prefix == "p"


NAMES = st.sampled_from(["a", "p:a", "q:a", "p:q:a", ":a", "xmlns:a", "xml:a", "plugin"])
KEYS = st.sampled_from(["b", "p:b", "q:b", "xmlns", "xmlns:p", "xmlns:q", "xmlns:xml", "xmlns:", "p:"])


@st.composite
def element(draw: st.DrawFn, inner: st.SearchStrategy[str]) -> str:
    name, keys = draw(NAMES), draw(st.lists(KEYS, max_size=3))
    attributes = "".join(f' {key}="{draw(st.sampled_from(["u", "v", ""]))}"' for key in keys)
    return f"<{name}{attributes}>{''.join(draw(st.lists(inner, max_size=3)))}</{name}>"


@given(st.recursive(st.builds("<{}/>".format, NAMES), element, max_leaves=8))
def test_places_lie_in_the_text_and_no_problem_is_told_twice(content: str) -> None:
    text = f"<sdf>{content}</sdf>"
    problems = found(text)
    assert len({(type(p), p.span) for p in problems}) == len(problems)
    for problem in problems:
        assert 0 < problem.span.start < problem.span.end < len(text)
