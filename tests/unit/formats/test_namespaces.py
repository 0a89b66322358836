"""Prefixes: declared, in scope, used, and spelled as "Namespaces in XML" requires."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

import sdfcheck
from sdfcheck.formats.namespaces import declarations, names, prefixes
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.source.document import Document, read
from sdfcheck.source.sniff import Kind
from tests.unit.robot.files import reported

DEFAULT, BELOW, UNUSED, SHADOWED = "NS005", "NS006", "NS007", "NS011"
UNDECLARED, REDECLARED, MALFORMED, EMPTY, RESERVED = "NS003", "NS004", "NS008", "NS012", "NS013"
OF_PREFIXES = {
    DEFAULT,
    BELOW,
    UNUSED,
    SHADOWED,
    UNDECLARED,
    REDECLARED,
    MALFORMED,
    EMPTY,
    RESERVED,
}


def document(text: str, kind: Kind | None = None) -> Document:
    return read(text.encode(), Path("example.sdf"), kind)


def found(text: str, kind: Kind | None = None) -> list[Diagnostic]:
    """The reports of the rules about prefixes."""
    return [d for d in reported(document(text, kind), "NS") if d.code in OF_PREFIXES]


def only(text: str, code: str) -> Diagnostic:
    """The one diagnostic, which has that code."""
    (diagnostic,) = found(text)
    assert diagnostic.code == code
    return diagnostic


def codes(text: str, kind: Kind | None = None) -> list[str]:
    return [diagnostic.code for diagnostic in found(text, kind)]


def edits(diagnostic: Diagnostic) -> list[tuple[str, str]]:
    """The text that the fix replaces, and the new one."""
    assert diagnostic.fix is not None
    return [(edit.span.text, edit.text) for edit in diagnostic.fix.edits]


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
        '<sdf xmlns:xml="http://www.w3.org/XML/1998/namespace" xml:lang="en"/>',
    ],
)
def test_sound_prefixes(text: str) -> None:
    assert found(text) == []


def test_other_documents_are_not_looked_at() -> None:
    other = document('<html xmlns="http://www.w3.org/1999/xhtml"/>')
    assert [*declarations(other), *names(other), *prefixes(other)] == []


# Reading


def test_declarations_on_a_root_that_has_them_all() -> None:
    one, other = declarations(document('<sdf xmlns:p="u"\n xmlns:q = "v"><q:a/></sdf>'))
    assert (one.prefix, one.namespace, one.is_used, one.span.text) == ("p", "u", False, "xmlns:p")
    assert (other.prefix, other.namespace, other.is_used) == ("q", "v", True)
    assert other.whole.text == '\n xmlns:q = "v"'
    assert one.is_on_root
    assert one.beside == [one, other]


def test_the_names_are_those_that_declarations_are_looked_up_for() -> None:
    one, other = names(document(inside('<a xmlns:p="u" p:b="1"/><plugin><c::d/></plugin>')))
    assert (one.name, one.prefix, one.local, one.is_in_plugin) == ("p:b", "p", "b", False)
    assert (other.name, other.prefix, other.local, other.is_in_plugin) == ("c::d", "c", ":d", True)


def test_a_prefix_has_its_declarations_and_the_uses_out_of_their_scope() -> None:
    (prefix,) = prefixes(document(inside('<a xmlns:p="u"/><p:b/><c xmlns:p="u"/>')))
    assert [d.is_used for d in prefix.declarations] == [True, True]
    assert [span.text for span in prefix.undeclared] == ["p"]


# Undeclared prefixes


def test_uses_of_an_undeclared_prefix_are_gathered() -> None:
    text = inside('<p:a p:b="1"><p:c/></p:a>')
    diagnostic = only(text, UNDECLARED)
    assert "used 3 times" in diagnostic.message
    assert diagnostic.span.start == text.index("p:a")
    (prefix,) = prefixes(document(text))
    assert [use.text for use in prefix.undeclared] == ["p", "p", "p"]
    assert prefix.insertion.start == prefix.insertion.end == len('<sdf version="1.12"')


def test_each_prefix_is_reported_once() -> None:
    assert [d.span.text for d in found(inside("<p:a/><q:a/><p:b/>"))] == ["p", "q"]


def test_a_declaration_ends_with_its_element() -> None:
    diagnostic = only(inside('<a xmlns:p="u">\n<p:b/>\n</a>\n<p:c/>'), UNDECLARED)
    (label,) = diagnostic.labels
    assert (label.span.text, label.text) == ("xmlns:p", "declared here, in scope until line 3")
    assert edits(diagnostic) == [("", ' xmlns:p="u"')]
    assert diagnostic.span.begin.line == 4


def test_a_declaration_holds_for_its_own_start_tag() -> None:
    assert codes(inside('<p:a p:b="1" xmlns:p="u"/>')) == [BELOW]


def test_an_empty_element_is_its_own_scope() -> None:
    text = inside('<a xmlns:p="u"/><p:b/>')
    assert only(text, UNDECLARED)
    assert declarations(document(text))[0].scope_end.text == ""


def test_a_sibling_before_the_declaration_is_out_of_scope() -> None:
    diagnostic = only(inside('<p:b/><a xmlns:p="u" p:c="1"/>'), UNDECLARED)
    assert [label.span.text for label in diagnostic.labels] == ["xmlns:p"]


def test_the_root_without_attributes_takes_a_declaration_after_its_name() -> None:
    assert prefixes(document("<sdf><p:a/></sdf>"))[0].insertion.start == 4


def test_xacro_itself_stops_at_its_own_undeclared_prefix() -> None:
    text = "<robot><xacro:a/><p:b/></robot>"
    assert [d.span.text for d in found(text, Kind.XACRO)] == ["p"]
    assert [d.span.text for d in found(text, Kind.URDF)] == ["xacro", "p"]


# Declarations


def test_a_prefix_declared_twice_on_one_element() -> None:
    diagnostic = only('<sdf xmlns:p="u" xmlns:p="v"><p:a/></sdf>', REDECLARED)
    assert ([label.span.start for label in diagnostic.labels], diagnostic.span.start) == ([5], 17)


def test_default_namespaces() -> None:
    diagnostic = only('<sdf version="1.12"\n xmlns = "u" />', DEFAULT)
    assert diagnostic.span.text == "xmlns"
    assert edits(diagnostic) == [('\n xmlns = "u"', "")]


def test_a_declaration_below_the_root_can_move_there() -> None:
    diagnostic = only(inside('<a\n  xmlns:p="u"  b="1"><p:c/></a>'), BELOW)
    assert edits(diagnostic) == [("", ' xmlns:p="u"'), ('\n  xmlns:p="u"', "")]


def test_declarations_that_agree_are_reported_together() -> None:
    diagnostic = only(inside('<a xmlns:p="u" p:b="1"/><c xmlns:p="u" p:b="1"/>'), BELOW)
    assert [text for text, _ in edits(diagnostic)] == ["", ' xmlns:p="u"', ' xmlns:p="u"']


def test_a_declaration_that_the_root_has_already() -> None:
    diagnostic = only('<sdf xmlns:p="u"><a p:c="1" xmlns:p="u" p:b="1"/><p:d/></sdf>', BELOW)
    assert edits(diagnostic) == [(' xmlns:p="u"', "")]


def test_declarations_that_disagree_stay_where_they_are() -> None:
    one, other = found(inside('<a xmlns:p="u" p:b="1"/><c xmlns:p="v" p:b="1"/>'))
    assert one.code == other.code == BELOW
    assert one.fix is other.fix is None


def test_an_unused_prefix() -> None:
    diagnostic = only('<sdf xmlns:p="u" xmlns:q="v"><q:a/></sdf>', UNUSED)
    assert "`p` is declared and not used" in diagnostic.message
    assert edits(diagnostic) == [(' xmlns:p="u"', "")]


def test_unused_prefixes_are_reported_once_for_each_element() -> None:
    root, inner = found('<sdf xmlns:p="u" xmlns:q="v"><b xmlns:r="w"/></sdf>')
    assert "`p` and `q`" in root.message
    assert "`r`" in inner.message
    assert edits(root) == [(' xmlns:p="u"', ""), (' xmlns:q="v"', "")]


def test_a_declaration_in_a_xacro_file_may_be_for_others() -> None:
    assert found('<robot xmlns:p="u"/>', Kind.XACRO) == []


def test_a_shadowed_prefix() -> None:
    diagnostics = found('<sdf xmlns:p="u" p:a="1"><b xmlns:p="v" p:a="1"/></sdf>')
    shadowed = next(d for d in diagnostics if d.code == SHADOWED)
    assert (shadowed.span.start, [label.span.start for label in shadowed.labels]) == (28, [5])


def test_declaring_again_with_the_same_name_shadows_nothing() -> None:
    assert codes('<sdf xmlns:p="u" p:a="1"><b xmlns:p="u" p:a="1"/></sdf>') == [BELOW]


def test_two_prefixes_for_one_name() -> None:
    diagnostic = only('<sdf xmlns:p="u" xmlns:q="u"><p:a/><q:a/></sdf>', SHADOWED)
    assert "`q` is bound to the same namespace as `p`" in diagnostic.message
    assert [label.span.start for label in diagnostic.labels] == [5]


def test_two_prefixes_out_of_each_other_s_scope() -> None:
    assert set(codes(inside('<a xmlns:p="u" p:b="1"/><a xmlns:q="u" q:b="1"/>'))) == {BELOW}


def test_an_empty_namespace_name() -> None:
    assert "`p`" in only('<sdf xmlns:p=""><p:a/></sdf>', EMPTY).message


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
    assert only(text, RESERVED).span.text == place


# Names


@pytest.mark.parametrize("name", ["a:b:c", ":a", "a:", "::", "a::b"])
def test_malformed_names(name: str) -> None:
    assert only(inside(f"<{name}/>"), MALFORMED).span.text == name
    assert only(inside(f'<a {name}="1"/>'), MALFORMED).span.text == name


@pytest.mark.parametrize("name", ["xmlns:", "xmlns:a:b"])
def test_malformed_declarations(name: str) -> None:
    assert only(f'<sdf {name}="u"/>', MALFORMED).span.text == name


def test_plugins_may_have_names_with_two_colons() -> None:
    assert found(inside('<plugin name="p" filename="p"><gz::a>1</gz::a></plugin>')) == []
    assert only(inside('<plugin name="p" filename="p"/><gz::a/>'), MALFORMED)


def test_names_in_a_faulty_text_are_judged_as_well() -> None:
    assert only(inside("<p:a/><!-- -- -->"), UNDECLARED).span.text == "p"


NAMES = st.sampled_from(["a", "p:a", "q:a", "p:q:a", ":a", "xmlns:a", "xml:a", "plugin"])
KEYS = st.sampled_from(["b", "p:b", "q:b", "xmlns", "xmlns:p", "xmlns:q", "xmlns:xml", "xmlns:", "p:"])


@st.composite
def element(draw: st.DrawFn, inner: st.SearchStrategy[str]) -> str:
    name, keys = draw(NAMES), draw(st.lists(KEYS, max_size=3))
    attributes = "".join(f' {key}="{draw(st.sampled_from(["u", "v", ""]))}"' for key in keys)
    return f"<{name}{attributes}>{''.join(draw(st.lists(inner, max_size=3)))}</{name}>"


@given(st.recursive(st.builds("<{}/>".format, NAMES), element, max_leaves=8))
def test_places_lie_in_the_text_and_no_problem_is_reported_twice(content: str) -> None:
    text = f"<sdf>{content}</sdf>"
    diagnostics = found(text)
    assert len({(d.code, d.span) for d in diagnostics}) == len(diagnostics)
    for diagnostic in diagnostics:
        assert 0 < diagnostic.span.start < diagnostic.span.end < len(text)


def test_the_prefix_of_xacro_in_a_world_that_it_made_is_for_information() -> None:
    world = '<sdf version="1.6" xmlns:xacro="http://www.ros.org/wiki/xacro"><world name="w"/></sdf>'
    made = f"<!-- This document was autogenerated by xacro from w.xacro -->\n{world}"
    shown = [sdfcheck.lint(text, isolated=True).diagnostics[0].severity.value for text in (world, made)]
    assert shown == ["warning", "info"]
