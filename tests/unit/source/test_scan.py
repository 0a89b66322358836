"""One mistake, one defect, where a person would edit, and the rest of the text is read as it was meant."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import etree

from sdfcheck.lint.example import unmark
from sdfcheck.source.document import read
from sdfcheck.source.problems import (
    CommentHyphens,
    ContentAfterRoot,
    LateDeclaration,
    SyntaxDefect,
    SyntaxKind,
)
from sdfcheck.source.scanner.full_scan import scan
from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.text import Source

ROBOT = """<?xml version="1.0"?>
<sdf version="1.12">
  <model name="m">
    <link name="a">
      <pose>0 0 0 0 0 0</pose>
      <visual name="v">
        <geometry><sphere><radius>1</radius></sphere></geometry>
      </visual>
    </link>
    <link name="b"/>
  </model>
</sdf>
"""
NAMES = ["sdf", "model", "link", "pose", "visual", "geometry", "sphere", "radius", "link"]
WITHOUT_VISUAL = [name for name in NAMES if name != "visual"]


def scanned(text: str) -> Scan:
    return scan(Source(Path("example.sdf"), text))


def names(result: Scan) -> list[str]:
    """The elements of what was written anew, which a strict parser must accept."""
    return [element.tag for element in etree.fromstring(result.wellformed.encode()).iter(etree.Element)]


def edited(old: str, new: str) -> str:
    assert ROBOT.count(old) == 1, old
    return ROBOT.replace(old, new)


def test_a_sound_text_is_kept() -> None:
    result = scanned(ROBOT)
    assert result.problems == []
    assert result.doubtful == []
    assert result.wellformed == ROBOT.partition("\n")[2].strip()
    assert all(ROBOT.startswith(f"<{name}", start) for name, start in zip(NAMES, result.starts, strict=True))
    assert names(result) == NAMES


def test_places_of_tags() -> None:
    text = "<a>\r\n\t<b c='>'\r\n/><!-- <d> --><![CDATA[<e>]]></a  >\n"
    result = scanned(text)
    assert [text[slice(*result.place(n)[:2])] for n in range(2)] == ["<a>", "<b c='>'\r\n/>"]
    assert text[slice(*result.place(0)[2:])] == "</a  >"
    assert result.place(1)[2] == result.place(1)[3] == result.place(1)[1]
    assert [text[start:end] for start, end in result.comments] == ["<!-- <d> -->"]


MISTAKES = [
    # an end tag is missing
    (
        edited("    </link>\n", "").replace('<link name="b"/>', '«<link name="b"/>»'),
        SyntaxKind.UNCLOSED_ELEMENT,
        NAMES,
    ),
    (edited("    </link>\n", "«    »\n"), SyntaxKind.UNCLOSED_ELEMENT, NAMES),
    (edited("0 0 0 0 0 0</pose>", "«0 0 0 0 0 0»"), SyntaxKind.UNCLOSED_ELEMENT, NAMES),
    (edited("</sphere></geometry>", "«</geometry>»"), SyntaxKind.UNCLOSED_ELEMENT, NAMES),
    (edited('<link name="b"/>', '<«link» name="b">'), SyntaxKind.UNCLOSED_ELEMENT, NAMES),
    # or wrong
    (edited("</visual>", "</«visaul»>"), SyntaxKind.MISMATCHED_END_TAG, NAMES),
    (edited("</visual>", "</«collision»>"), SyntaxKind.MISMATCHED_END_TAG, NAMES),
    (edited("</visual>", "</«link»>"), SyntaxKind.MISMATCHED_END_TAG, NAMES),
    (edited("</link>", "</«Link»>"), SyntaxKind.MISMATCHED_END_TAG, NAMES),
    (edited("</sdf>", "</«sfd»>"), SyntaxKind.MISMATCHED_END_TAG, NAMES),
    (edited("<visual ", "<«visaul» "), SyntaxKind.MISMATCHED_END_TAG, NAMES),
    (edited("</pose>", "«<pose>»"), SyntaxKind.MISSING_SLASH, NAMES),
    (edited("</pose>", "«<pose/>»"), SyntaxKind.MISSING_SLASH, NAMES),
    (edited("</model>", "«<model>»"), SyntaxKind.MISSING_SLASH, NAMES),
    (edited("</sdf>", "«<sdf>»"), SyntaxKind.MISSING_SLASH, NAMES),
    (edited("</pose>", "«<ose>»"), SyntaxKind.MISSING_SLASH, NAMES),
    (edited("</pose>", "«/pose>»"), SyntaxKind.MISSING_ANGLE, NAMES),
    (edited("    </link>", "    «/link>»"), SyntaxKind.MISSING_ANGLE, NAMES),
    (edited("</pose>", "«</pose»"), SyntaxKind.UNCLOSED_TAG, NAMES),
    (edited("</pose>", "«</ pose»>"), SyntaxKind.BLANK_IN_TAG, NAMES),
    (edited("</pose>", "«< /pose»>"), SyntaxKind.BLANK_IN_TAG, NAMES),
    (edited("</pose>", "«</>»"), SyntaxKind.MALFORMED_NAME, NAMES),
    (edited("</link>", '</link «name="a"»>'), SyntaxKind.CROWDED_END_TAG, NAMES),
    # or too many
    (edited("</pose>", "</pose>«</pose>»"), SyntaxKind.EXTRA_END_TAG, NAMES),
    (edited("</link>\n", "</link>\n«</joint>»\n"), SyntaxKind.EXTRA_END_TAG, NAMES),
    (
        edited("<geometry>", "<geometry/>").replace("</geometry>", "«</geometry>»"),
        SyntaxKind.EXTRA_END_TAG,
        NAMES,
    ),
    # or a start tag is missing
    (edited('      <visual name="v">', "«      »"), SyntaxKind.MISSING_START_TAG, WITHOUT_VISUAL),
    (
        edited('      <visual name="v">\n', "").replace("<geometry>", "«<geometry>»"),
        SyntaxKind.MISSING_START_TAG,
        WITHOUT_VISUAL,
    ),
    (edited("<radius>1", "«1»"), SyntaxKind.MISSING_START_TAG, [name for name in NAMES if name != "radius"]),
    # crossed
    (
        edited("</sphere></geometry>", "«</geometry>»</sphere>"),
        SyntaxKind.UNCLOSED_ELEMENT,
        NAMES,
    ),
    # a start tag is broken
    (edited("<pose>", "«pose>»"), SyntaxKind.MISSING_ANGLE, NAMES),
    (edited('    <link name="a">', '    «link name="a">»'), SyntaxKind.MISSING_ANGLE, NAMES),
    (edited("<pose>", "<«pose»"), SyntaxKind.UNCLOSED_TAG, NAMES),
    (edited('<link name="a">', '<link «name="a"»'), SyntaxKind.UNCLOSED_TAG, NAMES),
    (edited("<pose>", "«< pose»>"), SyntaxKind.BLANK_IN_TAG, NAMES),
    (edited('"a"', '«"a»'), SyntaxKind.UNCLOSED_VALUE, NAMES),
    (edited("<pose>", "«<»<pose>"), SyntaxKind.STRAY_ANGLE, NAMES),
    # comments and sections
    (edited("<pose>", "<!-- c «->»<pose>"), SyntaxKind.MISSPELT_MARK, NAMES),
    (edited("<pose>", "<!-- c «--!>»<pose>"), SyntaxKind.MISSPELT_MARK, NAMES),
    (edited("<pose>", "<!-- c «-- >»<pose>"), SyntaxKind.MISSPELT_MARK, NAMES),
    (edited("      <pose>", "«<!--» c\n      <pose>"), SyntaxKind.UNCLOSED_COMMENT, NAMES),
    (edited("      <pose>", "<!-- c\n  «d e»\n      <pose>"), SyntaxKind.UNCLOSED_COMMENT, NAMES),
    (
        edited("      <pose>", "«<!--» c\n      <pose>").replace("</link>", "</link><!-- d -->"),
        SyntaxKind.UNCLOSED_COMMENT,
        NAMES,
    ),
    (edited("<pose>", "<!-- c «<!--» d --> e --><pose>"), SyntaxKind.NESTED_COMMENT, NAMES),
    (edited("<pose>", "«<!-» c -><pose>"), SyntaxKind.MISSPELT_MARK, NAMES),
    (edited("<pose>", "«<--» c --><pose>"), SyntaxKind.MISSPELT_MARK, NAMES),
    (edited("<pose>", "<pose>«<[CDATA[»0]]>"), SyntaxKind.MISSPELT_MARK, NAMES),
    (edited("<pose>", "<pose>«<![CDTA[»0]]>"), SyntaxKind.MISSPELT_MARK, NAMES),
    (edited("<pose>", "<pose>«<!CDATA[»0"), SyntaxKind.MISSPELT_MARK, NAMES),
    (edited("<pose>", "<pose>«<![CDATA[»"), SyntaxKind.UNCLOSED_SECTION, NAMES),
    (edited("<pose>", "<pose>«<![CDATA[»]>"), SyntaxKind.UNCLOSED_SECTION, NAMES),
    (edited("0 0 0 0 0 0", "0 «]]>» 0"), SyntaxKind.SECTION_END_IN_TEXT, NAMES),
    # declarations
    (edited('<?xml version="1.0"?>', '«<?»xml version="1.0">'), SyntaxKind.UNCLOSED_SECTION, NAMES),
    (edited('<?xml version="1.0"?>', '«<xml version="1.0"?>»'), SyntaxKind.MALFORMED_INSTRUCTION, NAMES),
    (edited('<?xml version="1.0"?>', "«<?xml version=1.0?>»"), SyntaxKind.MALFORMED_INSTRUCTION, NAMES),
    (edited('<?xml version="1.0"?>', '<?xml version="«0.0»" ?>'), SyntaxKind.ODD_VERSION, NAMES),
    (edited("<pose>", '«<?xml version="1.0"?>»<pose>'), SyntaxKind.SECOND_DECLARATION, NAMES),
    (edited("<sdf ", '«<?xml version="1.0"?>»<sdf '), SyntaxKind.SECOND_DECLARATION, NAMES),
    (edited("<sdf ", "«<!DOCTYPE» sdf [\n<sdf "), SyntaxKind.UNCLOSED_SECTION, NAMES),
    (edited("<pose>", "«<!»ELEMENT a><pose>"), SyntaxKind.OTHER, NAMES),
    # around the root
    ("«hello»\n" + ROBOT, SyntaxKind.TEXT_OUTSIDE_ROOT, NAMES),
    ("«</sdf>»\n" + ROBOT.partition("\n")[2], SyntaxKind.EXTRA_END_TAG, NAMES),
    (ROBOT.rstrip()[:-6].rstrip()[:-1] + "«>»", SyntaxKind.TRUNCATED, NAMES),
    # elsewhere
    (edited("0 0 0 0 0 0", "0 0 0«\x00» 0 0 0"), SyntaxKind.ILLEGAL_CHARACTER, NAMES),
    (
        edited(
            '    <link name="b"/>\n', '«<<<<<<<» HEAD\n    <link name="b"/>\n=======\n<joint>\n>>>>>>> x\n'
        ),
        SyntaxKind.MERGE_CONFLICT,
        NAMES,
    ),
    (
        edited(
            '    <link name="b"/>\n',
            '«<<<<<<<» HEAD\n    <link name="b"/>\n||||||| old\n=======\n>>>>>>> x\n',
        ),
        SyntaxKind.MERGE_CONFLICT,
        NAMES,
    ),
]


@pytest.mark.parametrize(
    ("marked", "kind", "elements"),
    MISTAKES,
    ids=[f"{n}-{kind.value}" for n, (_, kind, _) in enumerate(MISTAKES)],
)
def test_one_mistake_is_one_defect(marked: str, kind: SyntaxKind, elements: list[str]) -> None:
    text, start, end = unmark(marked)
    result = scanned(text)
    assert [p.kind for p in result.problems if isinstance(p, SyntaxDefect)] == [kind]
    (problem,) = result.problems
    assert (problem.span.start, problem.span.end) == (start, end), problem.span.text
    assert names(result) == elements
    assert len(result.starts) == len(elements)


def test_a_tag_that_is_being_typed_is_one_defect() -> None:
    inside = '    <link name="a"\n    <link name="b"/>\n    <frame name="f"/>\n'
    text = f'<sdf>\n  <model name="m">\n{inside}  </model>\n</sdf>'
    result = scanned(text)
    assert [problem.kind for problem in result.problems if isinstance(problem, SyntaxDefect)] == [
        SyntaxKind.UNCLOSED_TAG
    ]
    assert names(result) == ["sdf", "model", "link", "link", "frame"]
    (model,) = etree.fromstring(result.wellformed.encode())
    assert [child.get("name") for child in model] == ["a", "b", "f"]


def test_every_kind_of_syntax_defect_is_found_somewhere() -> None:
    from tests.unit.source.test_start_tag import BROKEN

    shown = {kind for _, kind, _ in MISTAKES} | {kind for _, kind, _ in BROKEN}
    assert shown | {SyntaxKind.NO_ELEMENT, SyntaxKind.TOO_LONG, SyntaxKind.TOO_MANY} == set(SyntaxKind)


@pytest.mark.parametrize("text", ["", "  \n", "<!-- c -->", '<?xml version="1.0"?>'])
def test_a_text_without_element(text: str) -> None:
    (problem,) = scanned(text).problems
    assert isinstance(problem, SyntaxDefect)
    assert problem.kind is SyntaxKind.NO_ELEMENT


def test_the_other_party_is_named() -> None:
    def other(text: str) -> str:
        (problem,) = scanned(text).problems
        assert isinstance(problem, SyntaxDefect)
        assert problem.other is not None
        return problem.other.text

    assert other(edited("    </link>\n", "")) == "link"
    assert other(edited("</sphere>", "")) == "sphere"
    assert other(edited('<link name="b"/>', '<link name="b">')) == "</model>"
    assert other(edited("</visual>", "</visaul>")) == "visual"
    assert other(edited("</link>\n", "</link></joint>\n")) == "model"
    assert other(edited("<geometry>", "<geometry/>")) == "geometry"
    assert other(edited("<pose>", "<!-- c <!-- d --> e --><pose>")) == "-->"
    assert other(ROBOT[:-7]) == "sdf"


@pytest.mark.parametrize(
    "comment",
    [
        '<!--link name="c"/>\n  <!-- a note -->',
        '<!--link name="c">\n <pose>0 0 0 0 0 0</pose>\n</link>\n<!-- a note -->',
        '<!--joint name="j" type="fixed">\n <parent link="a"/>\n <!-- a note -->',
        "<!--/joint>\n<pose/> <!-- a note -->",
        '<!--origin xyz="0 0 0"/>\n</joint>\n<!-- a note -->',
    ],
)
def test_an_element_that_is_switched_off_ends_at_the_comment_in_it(comment: str) -> None:
    result = scanned(edited("      <pose>", f"      {comment}<pose>"))
    assert [type(problem) for problem in result.problems] == [CommentHyphens]
    assert names(result) == NAMES


def test_a_nested_element_that_took_the_end_tag_of_its_parent_is_at_fault() -> None:
    text = "<sdf>\n <model>\n  <model>\n   <link/>\n </model>\n</sdf>"
    (problem,) = scanned(text).problems
    assert isinstance(problem, SyntaxDefect)
    assert (problem.span.text, problem.span.begin.line) == ("</model>", 5)
    assert problem.other is not None
    assert problem.other.begin.line == 3


def test_where_nothing_is_indented_the_swallowed_part_is_doubtful() -> None:
    text = '<sdf><model name="m"><link name="a"><link name="b"/></model></sdf>'
    result = scanned(text)
    (problem,) = result.problems
    assert problem.span.text == "</model>"
    assert any(start <= text.index('<link name="b') < end for start, end in result.doubtful)


@pytest.mark.parametrize(
    "extra", ["<sdf/>", "</sdf>", "hello", "<![CDATA[x]]>", "\u00a0", '<?xml version="1.0"?>']
)
def test_only_the_first_thing_after_the_root_is_reported(extra: str) -> None:
    result = scanned(ROBOT + extra + "<a & b <c>" * 3)
    (problem,) = result.problems
    assert isinstance(problem, ContentAfterRoot)
    assert problem.span.text in extra
    assert problem.root.text == "sdf"
    assert names(result) == NAMES


@pytest.mark.parametrize("extra", ["\n\n", "<!-- c -->", "<?target x?>", "\0\0\0"])
def test_comments_may_follow_the_root(extra: str) -> None:
    assert not [p for p in scanned(ROBOT + extra).problems if isinstance(p, ContentAfterRoot)]


def test_places_of_all_defects_lie_in_the_text() -> None:
    text = (
        '<sdf <l me="t" >\n  <link>\n    <i</>\n      <n1</ms>\n/link>\n'
        "    <name=   <i  <po0</po  </m  </m\n</sdf>\n"
    )
    problems = scanned(text).problems
    assert len(problems) > 5
    for problem in problems:
        for span in (problem.span, getattr(problem, "other", None)):
            assert span is None or 0 <= span.start <= span.end <= len(text), problem


def test_a_late_declaration_knows_the_text_before_it() -> None:
    (problem,) = scanned("<!-- c -->\n" + ROBOT).problems
    assert isinstance(problem, LateDeclaration)
    assert problem.span.text == "<!-- c -->\n"
    assert problem.declaration.text == '<?xml version="1.0"?>'


def test_names_keep_their_colons() -> None:
    text = '<a xmlns="u" xmlns:p="v" p:b="1"><p:c::d p:e="2"/><p:f></p:f></a>'
    result = scanned(text)
    assert result.problems == []
    document = read(result.wellformed.encode(), Path("a.sdf"))
    assert [element.name for element in document.elements] == ["a", "p:c::d", "p:f"]
    assert document.root is not None
    assert document.root.declared == {"": "u", "p": "v"}
    assert document.elements[1].namespaces == {"": "u", "p": "v"}
    assert [element.attributes for element in document.elements] == [{"p:b": "1"}, {"p:e": "2"}, {}]
