"""Any bytes become a document: with problems, without exceptions, soon."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import sdfcheck
from sdfcheck.source.document import Document, _unexplained, problems, read
from sdfcheck.source.problems import ContentAfterRoot, SyntaxDefect, UnknownEntity, UnrecognizedDocument
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source

PATH = Path("example.sdf")
SMALL = (
    '<?xml version="1.0"?>\n<sdf version="1.12" xmlns:p="urn:p">\n  <!-- a - b -->\n  <model name="m">\n'
    "    <link name='l'><pose>0 0 0 &lt; 0</pose><p:x><![CDATA[<]]></p:x></link>\n  </model>\n</sdf>\n"
)


def document(text: str) -> Document:
    return read(text.encode("utf-8", "surrogatepass"), PATH)


def check(found: Document) -> None:
    """Properties of every document."""
    size = len(found.source.text)
    for problem in problems(found):
        assert 0 <= problem.span.start <= problem.span.end <= max(size, 1)
    if found.root is None:
        assert problems(found)
        return
    assert len(found.elements) == len(found.scan.starts)
    assert list(found.root.walk()) == found.elements
    for element in found.elements:
        found.spans.whole(element)
        assert 0 <= element.span.start < element.span.end <= size
        if not found.is_doubtful(element.span):
            assert element.span.text == element.name
        for name in element.attributes:
            assert found.spans.attribute_value(element, name).end <= size


def test_a_sound_text_is_not_scanned() -> None:
    found = document(SMALL)
    assert found.problems == []
    assert found._scan is None


MARKUP = st.lists(
    st.sampled_from(
        [
            *(
                "<",
                ">",
                "/",
                "</",
                "/>",
                "<!--",
                "-->",
                "--",
                "<![CDATA[",
                "]]>",
                "<?",
                "?>",
                "<?xml ",
                "<!DOCTYPE ",
            ),
            *(
                '"',
                "'",
                "=",
                " ",
                "\n",
                "\r\n",
                "\t",
                "&",
                ";",
                "&amp;",
                "&#0;",
                "[",
                "]",
                ":",
                "xmlns",
                "xmlns:p",
            ),
            *(
                "a",
                "b",
                "sdf",
                "version",
                "<a>",
                "</a>",
                "<b c='d'>",
                "<p:q/>",
                "<<<<<<< ",
                "=======\n",
                ">>>>>>> x\n",
            ),
            *("\0", "\x0b", "\ud800", "\u00a0", "\ufeff", "²", "é", "、", "\ua4fd", "1"),
        ]
    ),
    max_size=40,
).map("".join)


@given(
    st.one_of(
        MARKUP, MARKUP.map(lambda text: f"<sdf>{text}</sdf>"), MARKUP.map(lambda text: f"<sdf {text}/>")
    )
)
@example("<a b='1'<!-->")
@example("<a><!----></a>")
@example("<:><a\u3000b='c'/></:>")
def test_any_text_is_read(text: str) -> None:
    check(document(text))


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ('<sdf><a\ua4fdb \ua4fd="1"/></sdf>', ["sdf", "a\ua4fdb", "\ua4fd"]),
        ('<p:\ua4fd q:\ua4fd-="1" \ua4fd.="2"/>', ["p:\ua4fd", "q:\ua4fd-", "\ua4fd."]),
        ("<\ua4fd><a:b></\ua4fd>", ["\ua4fd", "a:b"]),
    ],
)
def test_a_letter_that_looks_like_a_colon_is_a_letter(text: str, names: list[str]) -> None:
    root = document(text).root
    assert root is not None
    elements = [root, *root.children()]
    assert [name for e in elements for name in (e.name, *e.attributes)] == names


@pytest.mark.parametrize("text", ["<sdf \ua4fd/>", '<sdf \ua4fd="1"/>'])
def test_the_letter_is_looked_up_as_it_is_written(text: str) -> None:
    assert sdfcheck.lint(text, isolated=True).diagnostics
    found = document(text)
    assert found.root is not None
    assert ":" not in found.root.name + "".join(found.root.attributes)


@given(st.binary(max_size=300))
def test_any_bytes_are_read(data: bytes) -> None:
    check(read(data, PATH))


@given(MARKUP)
@example("<?\xb2?>")
def test_rewritten_text_is_well_formed(text: str) -> None:
    found = document(f"<sdf>{text}</sdf>")
    written = found.scan.wellformed
    if written:
        again = read(written.encode(), PATH)
        assert again.is_wellformed
        assert len(again.elements) == len(found.scan.starts)


@pytest.mark.parametrize("size", range(len(SMALL) - 1))
def test_a_file_that_breaks_off_has_one_problem(size: int) -> None:
    found = document(SMALL[:size])
    check(found)
    assert len(problems(found)) == 1


def test_a_character_that_is_missing_gives_one_problem_at_most() -> None:
    for at in range(len(SMALL)):
        found = document(SMALL[:at] + SMALL[at + 1 :])
        check(found)
        assert len(problems(found)) <= 1, problems(found)


def test_a_file_of_nul_bytes() -> None:
    (problem,) = problems(read(b"\0" * 1000, Path("a.urdf")))
    assert isinstance(problem, UnrecognizedDocument)


def test_a_fault_that_only_the_parser_knows_is_reported_in_its_words() -> None:
    (problem,) = _unexplained(Source(PATH, "<sdf>\n<a></sdf>"))
    assert isinstance(problem, SyntaxDefect)
    assert problem.detail.startswith("opening and ending tag mismatch")
    assert _unexplained(Source(PATH, "<sdf>\n<a/></sdf>")) == []


@pytest.mark.parametrize(
    ("text", "name", "kind"),
    [
        ("<sdf version='1.12'/>", "a", Kind.SDF),
        ("<robot name='r'/>", "a", Kind.URDF),
        ("<model><name>m</name><sdf>m.sdf</sdf></model>", "model.config", Kind.MODEL_CONFIG),
        ("<robot xmlns:xacro='x'><xacro:a/></robot>", "a.xacro", Kind.XACRO),
        ("<world name='w'/>", "a.world", Kind.SDF),
        ("<html/>", "a.sdf", Kind.OTHER_XML),
        ("", "a.sdf", Kind.EMPTY),
    ],
)
def test_the_kind_is_recognized_by_the_text(text: str, name: str, kind: Kind) -> None:
    given = Kind.XACRO if kind is Kind.XACRO else None
    assert read(text.encode(), Path(name), given).kind is kind


@pytest.mark.parametrize(
    ("text", "looks_like", "root", "suggestion", "place"),
    [
        ("<robt><a></robt>", "a robot description with a misspelled root element", "robt", "robot", "robt"),
        ("<html><br></html>", "XML of another kind", "html", None, "html"),
        ("<mujoco/>", "MJCF (MuJoCo)", None, None, "mujoco"),
        ("\n hello\nworld", "plain text", None, None, "hello"),
        ("<!-- c -->", "XML without any element", None, None, "<!-- c -->"),
        ("", "an empty file", None, None, ""),
        (
            "m\n p\n\n  9  8  0     0  0  0  0  0  0999 V2000\n",
            "a chemical structure-data file",
            None,
            None,
            "m",
        ),
    ],
)
def test_a_text_that_is_not_a_robot_description_has_this_problem_only(
    text: str, looks_like: str, root: str | None, suggestion: str | None, place: str
) -> None:
    (problem,) = problems(document(text))
    assert isinstance(problem, UnrecognizedDocument)
    assert (problem.looks_like, problem.root, problem.suggestion) == (looks_like, root, suggestion)
    assert problem.span.text == place


def test_references_that_xml_does_not_define() -> None:
    found = document(
        '<sdf version="1&2"><a>&nbsp; &amp; &#7; &#x41; &#99999999; & &lt</a><!-- & --><b><![CDATA[&]]></b></sdf>'
    )
    names = [problem.name for problem in problems(found) if isinstance(problem, UnknownEntity)]
    assert names == ["", "nbsp", "#7", "#99999999", "", ""]
    assert found.root is not None
    assert found.root.find("a").content == "&nbsp; & &#7; A &#99999999; & &lt"  # type: ignore[union-attr]
    assert found.root.find("b").content == "&"  # type: ignore[union-attr]


def test_views_are_computed_once() -> None:
    found = document(SMALL)
    calls = []

    def view(seen: Document) -> int:
        calls.append(seen)
        return 7

    assert (found.view(view), found.view(view), calls) == (7, 7, [found])


def test_doubt_is_where_the_text_was_guessed_at() -> None:
    found = document('<sdf version="1.12"><world name=w><light name="l"/></world></sdf>')
    assert found.root is not None
    world = found.root.find("world")
    assert world is not None
    assert found.is_doubtful(world.span)
    assert not found.is_doubtful(world.find("light").span)  # type: ignore[union-attr]
    assert not document(SMALL).is_doubtful(world.span)


@pytest.mark.parametrize("text", ["<a><p:b/></a><c/>", "<a><p:b/></a><a/>", "<p:a/></b>", "<a><p:b/></a> c"])
def test_text_after_the_root_is_reported_also_after_an_undeclared_prefix(text: str) -> None:
    found = read(text.encode(), Path("model.sdf"))
    assert any(isinstance(each, ContentAfterRoot | SyntaxDefect) for each in found.problems)
