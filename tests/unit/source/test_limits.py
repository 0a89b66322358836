"""Nothing in a file costs more than its size, and nothing in it reaches out of it."""

from __future__ import annotations

import time
import tracemalloc
from pathlib import Path

import pytest
from lxml import etree

from sdfcheck.source.document import Document, problems, read
from sdfcheck.source.problems import DocumentType, SyntaxDefect, SyntaxKind, TooDeep
from sdfcheck.source.scanner.full_scan import scan
from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.text import Source

PATH = Path("example.sdf")


def document(text: str) -> Document:
    return read(text.encode(), PATH)


def scanned(text: str) -> Scan:
    return scan(Source(PATH, text))


def names(result: Scan) -> list[str]:
    return [element.tag for element in etree.fromstring(result.wellformed.encode()).iter(etree.Element)]


def test_nesting_past_the_limit_is_reported_once_and_left_out() -> None:
    deep = "<a>" * 300 + "<b/>" + "</a>" * 300
    result = scanned(deep)
    (problem,) = result.problems
    assert isinstance(problem, TooDeep)
    assert problem.span.start == 256 * 3 + 1
    assert len(names(result)) == len(result.starts) == 256


def test_a_text_that_is_too_long_for_parsers_is_cut() -> None:
    for text in ("<a><b>" + "x" * 10_000_001 + "</b></a>", '<a><b c="' + "x" * 10_000_001 + '"/></a>'):
        result = scanned(text)
        (problem,) = result.problems
        assert isinstance(problem, SyntaxDefect)
        assert problem.kind is SyntaxKind.TOO_LONG
        assert len(problem.span.text) < 2
        assert names(result) == ["a", "b"]


def test_the_list_of_defects_ends_somewhere() -> None:
    assert len(scanned("<a b=1>" * 1000 + "</x>" * 1000).problems) < 150


def test_three_hundred_levels() -> None:
    found = document("<sdf>" + "<a>" * 300 + "</a>" * 300 + "</sdf>")
    (problem,) = problems(found)
    assert isinstance(problem, TooDeep)


def test_an_entity_bomb_is_not_set_off() -> None:
    entities = "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10}">' for n in range(1, 12))
    bomb = f'<!DOCTYPE sdf [<!ENTITY e0 "boom">{entities}]><sdf version="1.12"><world name="&e11;">&e11;</world></sdf>'
    found = document(bomb)
    (problem,) = problems(found)
    assert isinstance(problem, DocumentType)
    assert problem.entities == tuple(f"e{n}" for n in range(12))
    assert found.root is not None
    assert found.root.find("world").attributes == {"name": "&e11;"}  # type: ignore[union-attr]


@pytest.mark.parametrize(
    "text",
    [
        '<!DOCTYPE sdf [<!ENTITY x SYSTEM "{uri}">]><sdf version="1.12"><world name="w">&x;</world></sdf>',
        '<!DOCTYPE sdf [<!ENTITY % x SYSTEM "{uri}"> %x;]><sdf version="1.12"><world name="w">&y;</world></sdf>',
        '<!DOCTYPE sdf SYSTEM "{uri}"><sdf version="1.12"><world name="w">&y;</world></sdf>',
        '<sdf version="1.12" xmlns:xi="http://www.w3.org/2001/XInclude"><xi:include parse="text" href="{uri}"/></sdf>',
    ],
)
def test_no_other_file_is_loaded(text: str, tmp_path: Path) -> None:
    secret = tmp_path / "secret.txt"
    secret.write_text('<!ENTITY y "hunter2">', encoding="utf-8")
    found = read(text.replace("{uri}", secret.as_uri()).encode(), tmp_path / "a.sdf")
    assert found.root is not None
    assert "hunter2" not in str([(e.attributes, e.text, e.tail) for e in found.elements])


def test_fifty_megabytes_in_one_value() -> None:
    data = b'<sdf version="1.12"><world name="' + b"a" * 50_000_000 + b'"/></sdf>'
    tracemalloc.start()
    try:
        found = read(data, PATH)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    (problem,) = problems(found)
    assert problem.span.text == "name"
    assert peak < 10 * len(data)


@pytest.mark.parametrize(
    "piece",
    [
        *(
            "<",
            "</",
            "<!--",
            "<![CDATA[",
            "<?",
            "<!DOCTYPE [",
            '<a b="',
            "<a ",
            "&",
            "<a>",
            "</a>",
            "<a></b>",
        ),
        *("<<<<<<< \n", "<!-- <!-- --> ", "<a>/a>", "pose>", "<a b='<", "<1>", "<a><b></a></b>", "]]>"),
    ],
)
def test_time_grows_with_size_only(piece: str) -> None:
    def duration(count: int) -> float:
        start = time.process_time()
        document("<sdf>" + piece * count)
        return time.process_time() - start

    duration(100)
    # Quadratic work takes 64 times as long. A busy machine may slow one run down: then both are measured again.
    assert any(duration(8_000) < 40 * duration(1_000) + 0.5 for _ in range(4))


@pytest.mark.parametrize(
    "attributes",
    [
        [f'a{n}="1"' for n in range(20_000)],
        [f'xmlns:p{n}="urn:{n}"' for n in range(20_000)],
        [f'p{n}:a="1"' for n in range(20_000)],
    ],
)
@pytest.mark.parametrize("comment", ["", " a -- b "])
def test_attributes_past_the_limit_are_reported_once_and_left_out(
    attributes: list[str], comment: str
) -> None:
    found = document(f"<sdf version='1.9'><!--{comment}--><model {' '.join(attributes)}/></sdf>")
    (problem,) = (each for each in problems(found) if isinstance(each, SyntaxDefect))
    assert problem.kind is SyntaxKind.TOO_MANY
    assert problem.span.text == attributes[1000].partition("=")[0]
    assert found.root is not None
    assert len(found.elements[1].attributes) <= 1000
