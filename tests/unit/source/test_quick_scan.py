"""On well-formed texts the quick scan finds what the tolerant one finds, and lxml reads the same tree."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from sdfcheck.source.document import read
from sdfcheck.source.scanner.full_scan import scan
from sdfcheck.source.scanner.scan import quick_scan
from sdfcheck.source.text import Source

NAME = st.sampled_from(["a", "link", "p:joint", "größe", "x-1", "_y.z"])
BLANK = st.sampled_from(["", " ", "\n", "\r\n\t", "  \r"])
VALUE = st.one_of(
    st.sampled_from(['"1"', "'2'", '">"', "'/>'", '"a\nb"', "'\"'", '"&lt;"', "''"]),
    st.text("ab /=>-", max_size=5).map(lambda text: f'"{text}"'),
)
MISC = st.sampled_from(["<!-- c -->", "<!-- <a> ' -->", "<?t x > ?>", "<!---->", "<?t?>"])
TEXT = st.sampled_from(
    ["text", " > \" ' / ", "1 2 3", "&amp;", "<![CDATA[<a b='>]]>", "<![CDATA[]]>", "\r\n\t", "="]
)


@st.composite
def tag(draw: st.DrawFn, content: str | None) -> str:
    name = draw(NAME)
    keys = draw(st.lists(st.sampled_from(["b", "c", "name", "p:d"]), unique=True, max_size=3))
    text = f"<{name}"
    for key in keys:
        text += " " + draw(BLANK) + key + draw(BLANK) + "=" + draw(BLANK) + draw(VALUE)
    text += draw(BLANK)
    return f"{text}/>" if content is None else f"{text}>{content}</{name}{draw(BLANK)}>"


ELEMENTS = st.recursive(
    st.one_of(tag(None), tag("")),
    lambda inner: st.lists(st.one_of(inner, MISC, TEXT), max_size=4).flatmap(
        lambda parts: tag("".join(parts))
    ),
    max_leaves=12,
)
DOCUMENTS = st.tuples(
    st.sampled_from(["", '<?xml version="1.0"?>', "<?xml version='1.0' encoding='UTF-8'?>\r\n"]),
    st.lists(MISC, max_size=2).map("".join),
    ELEMENTS,
    st.lists(MISC, max_size=2).map("".join),
).map("".join)


@given(DOCUMENTS)
def test_both_scans_agree_and_so_does_lxml(text: str) -> None:
    source = Source(Path("t"), text)
    quick, thorough = quick_scan(source), scan(source)
    assert thorough.problems == []
    for field in ("starts", "ends", "closes", "close_ends", "comments"):
        assert getattr(quick, field) == getattr(thorough, field), field
    document = read(text.encode(), Path("t.sdf"))
    assert document.is_wellformed
    assert len(document.elements) == len(quick.starts)
    # Without declarations lxml leaves prefixes in the names, too.
    theirs = etree.fromstring(text.encode(), etree.XMLParser(recover=True)).iter(etree.Element)
    written = [(each.tag, dict(each.items()), each.text or "", each.tail or "") for each in theirs]
    assert [(e.name, e.attributes, e.text, e.tail) for e in document.elements] == written


@given(DOCUMENTS)
def test_rewritten_text_means_the_same(text: str) -> None:
    written = scan(Source(Path("t"), text)).wellformed
    before, after = (read(each.encode(), Path("t.sdf")).elements for each in (text, written))
    assert [e.name for e in before] == [e.name for e in after] or not text.isascii()
    assert [(e.text, e.tail, len(e.nodes)) for e in before] == [(e.text, e.tail, len(e.nodes)) for e in after]


def test_letters_of_the_world_are_kept() -> None:
    text = '<sdf><größe 変数="1"/><😀:a \ua4fd="2">x</😀:a></sdf>'
    document = read(text.encode(), Path("t.sdf"))
    assert document.problems == []
    assert [e.name for e in document.elements] == ["sdf", "größe", "😀:a"]
    assert [e.attributes for e in document.elements] == [{}, {"変数": "1"}, {"\ua4fd": "2"}]


@pytest.mark.parametrize("text", ["<a", "<a b='", "<!-- ", "<a><b>", "", "< >", '<a b="><c>'])
def test_a_faulty_text_ends_all_the_same(text: str) -> None:
    quick_scan(Source(Path("t"), text * 2000))
