from __future__ import annotations

import pytest

from sdfcheck.report.manual import laid_out


def test_elements_with_children_are_broken_into_lines() -> None:
    text = '<sdf version="1.12"><model name="m"><link name="«a»"/><pose>1 2</pose></model></sdf>'
    assert laid_out(text) == (
        '<sdf version="1.12">\n'
        '  <model name="m">\n    <link name="«a»"/>\n    <pose>1 2</pose>\n  </model>\n'
        "</sdf>\n"
    )


def test_long_elements_are_broken_at_each_level() -> None:
    text = '<robot name="r"><link name="base"><visual><geometry><box size="1 1 1"/></geometry></visual></link></robot>'
    assert laid_out(text) == (
        '<robot name="r">\n'
        '  <link name="base">\n'
        "    <visual>\n"
        '      <geometry><box size="1 1 1"/></geometry>\n'
        "    </visual>\n"
        "  </link>\n"
        "</robot>\n"
    )


def test_texts_between_elements_keep_their_place() -> None:
    text = "<a><b>one <i>two</i> three and a good deal more than what fits into one short line</b></a>"
    assert laid_out(text).split("\n")[1] == f"  {text[3:-4]}"


@pytest.mark.parametrize("text", ["<a><b></a>", "<a>1 < 2</a>", "no element", "<a>\n  <b/>\n</a>", ""])
def test_an_example_that_cannot_or_need_not_be_laid_out_is_left_alone(text: str) -> None:
    assert laid_out(text).rstrip("\n") == text


def test_marks_inside_tags_do_not_matter() -> None:
    text = (
        '<sdf version="1.12"><world name="w"><«gz»:note>a note with some length to it</gz:note></world></sdf>'
    )
    assert "\n    <«gz»:note>a note" in laid_out(text)
