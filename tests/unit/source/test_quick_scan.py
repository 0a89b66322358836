"""On well-formed texts the quick scan finds what the tolerant one finds, and lxml what both find."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from lxml import etree

from sdfcheck.source.rewritten import written_name
from sdfcheck.source.scanner.full_scan import scan
from sdfcheck.source.scanner.quick_scan import quick_scan
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
    tree = etree.fromstring(text.encode(), etree.XMLParser(recover=True))
    written = [re.match(r"[^\s/>]+", text[start + 1 :])[0] for start in quick.starts]  # type: ignore[index]
    assert [element.tag for element in tree.iter(etree.Element)] == written


@given(DOCUMENTS)
def test_rewritten_text_means_the_same(text: str) -> None:
    def content(tree: etree._Element) -> list[tuple[str, dict[str, str], str | None, str | None]]:
        return [
            (
                written_name(str(e.tag), None),
                {written_name(str(k), None): str(v) for k, v in e.items()},
                e.text,
                e.tail,
            )
            for e in tree.iter(etree.Element)
        ]

    written = scan(Source(Path("t"), text)).wellformed
    before = etree.fromstring(text.encode(), etree.XMLParser(recover=True))
    assert content(etree.fromstring(written.encode())) == content(before)


@pytest.mark.parametrize("text", ["<a", "<a b='", "<!-- ", "<a><b>", "", "< >", '<a b="><c>'])
def test_a_faulty_text_ends_all_the_same(text: str) -> None:
    quick_scan(Source(Path("t"), text * 2000))
