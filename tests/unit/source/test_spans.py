"""From elements to characters: exact, whatever is between and around."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.source.document import Document, Element, read


def document(text: str) -> Document:
    return read(text.encode(), Path("example.sdf"))


def first(found: Document, name: str) -> Element:
    assert found.root is not None
    return next(e for e in found.elements if e.name == name)


SOUND = '<sdf\tversion="1.12"><model\r\n    name = "m"\r\n\tp:x=\'1 2\'\n>\r\n<pose>\r\n  1 2\t3 </pose></model></sdf>'
FAULTY = SOUND.replace("</sdf>", "<!-- -- --></sdf>")


@pytest.mark.parametrize("text", [SOUND, FAULTY], ids=["sound", "faulty"])
def test_a_tag_of_several_lines(text: str) -> None:
    found = document(text)
    model, spans = first(found, "model"), found.spans
    assert model.span.text == "model"
    assert tuple(model.span.begin) == (1, 22)
    assert spans.attribute_name(model, "name").text == "name"
    assert tuple(spans.attribute_name(model, "name").begin) == (2, 5)
    assert spans.attribute_value(model, "name").text == "m"
    assert spans.attribute_whole(model, "name").text == '\r\n    name = "m"'
    assert spans.attribute_whole(model, "p:x").text == "\r\n\tp:x='1 2'"
    assert tuple(spans.attribute_value(model, "p:x").begin) == (3, 7)
    assert spans.whole(model).text == text[text.index("<model") : text.index("</model>") + 8]
    assert (end := spans.end_name(model)) is not None
    assert end.text == "model"


@pytest.mark.parametrize("text", [SOUND, FAULTY], ids=["sound", "faulty"])
def test_words_of_a_text(text: str) -> None:
    found = document(text)
    pose = first(found, "pose")
    assert pose.own_value.span.text == "1 2\t3"
    assert [pose.own_value.part(n).text for n in range(3)] == ["1", "2", "3"]
    assert tuple(pose.own_value.part(2).begin) == (6, 7)
    assert pose.own_value.part(3) == pose.own_value.span


def test_an_element_without_end_tag_has_no_end_name() -> None:
    found = document("<sdf><model/></sdf>")
    assert found.spans.end_name(first(found, "model")) is None


@pytest.mark.parametrize(
    ("content", "cut"),
    [
        (" 1 ", "1"),
        ("<!-- 0 -->1", "1"),
        ("<!-- 0 --> 1 <!-- 2 --> 3", "1"),
        ("<![CDATA[ 1 ]]>", "1"),
        ("<?pi 0?>1", "1"),
        ("\n<![CDATA[]]><!-- > --> 1\n", "1"),
        ("a&amp;b", "a&amp;b"),
        ("", "mass"),
        ("<b/>1", "mass"),
        ("<!-- 1 -->", "mass"),
    ],
)
def test_the_text_that_consumers_take(content: str, cut: str) -> None:
    found = document(f"<sdf><mass>{content}</mass></sdf>")
    assert first(found, "mass").own_value.span.text == cut


def test_an_empty_value_points_at_its_name() -> None:
    found = document('<sdf><model name=""/></sdf>')
    assert found.spans.attribute_value(first(found, "model"), "name").text == "name"


def test_an_attribute_that_is_not_there_points_at_the_element() -> None:
    found = document("<sdf><model/></sdf>")
    model, spans = first(found, "model"), found.spans
    for place in (spans.attribute_value, spans.attribute_name, spans.attribute_whole):
        assert place(model, "name").text == "model"


def test_references_in_values_do_not_shift_what_follows() -> None:
    found = document('<sdf><model name="a&amp;b" x="1&#50;"/><link/></sdf>')
    model = first(found, "model")
    assert model.attributes == {"name": "a&b", "x": "12"}
    assert found.spans.attribute_value(model, "x").text == "1&#50;"
    assert first(found, "link").span.text == "link"


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_lines_past_what_parsers_count(end: str) -> None:
    lines = 70_000
    found = document(f"<sdf>{end * (lines - 1)}<model>{end}</model></sdf>")
    assert tuple(first(found, "model").span.begin) == (lines, 2)


def test_columns_are_characters_and_not_bytes() -> None:
    found = document('<sdf><!-- größer 🤖 --><model name="ä" x="1"/></sdf>')
    model = first(found, "model")
    place = found.spans.attribute_value(model, "x")
    assert place.begin.column == len('<sdf><!-- größer 🤖 --><model name="ä" x="1')
    assert place.text == "1"


def test_broken_tags_have_places_too() -> None:
    found = document("<sdf><model name=m><link name='a' x><pose>0</pose></link></model></sdf>")
    assert found.spans.attribute_value(first(found, "model"), "name").text == "m"
    assert found.spans.attribute_value(first(found, "link"), "name").text == "a"
    assert first(found, "pose").own_value.span.text == "0"


def test_a_tag_without_its_bracket_has_places_too() -> None:
    found = document("<sdf><model>pose>0 0</pose></model></sdf>")
    pose = first(found, "pose")
    assert pose.span.text == "pose"
    assert pose.span.start == 12
    assert pose.own_value.span.text == "0 0"
