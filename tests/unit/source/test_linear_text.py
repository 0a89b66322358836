"""Texts that make a careless regular expression try everything: four times as much takes about four times as long."""

from __future__ import annotations

import time
from collections.abc import Callable

import pytest

from sdfcheck.files import packages
from sdfcheck.lint.call import lint

SDF = '<sdf version="1.9"><model name="m"><link name="l"/>{}</model></sdf>'
URDF = '<robot name="a"><link name="l"/>{}</robot>'
XACRO = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="a">{}</robot>'
MACRO = XACRO.format('<xacro:macro name="m" params="{}"><link name="b"/></xacro:macro>')

ATTACKS: dict[str, tuple[str, str, Callable[[int], str]]] = {
    # Scanning: comments, sections and instructions without end, and text that only looks like a tag.
    "unclosed comments": ("a.sdf", SDF, lambda n: "<!--" * n),
    "unclosed comments in URDF": ("a.urdf", URDF, lambda n: "<!--" * n),
    "unclosed sections": ("a.sdf", SDF, lambda n: "<![CDATA[" * n),
    "unclosed instructions": ("a.sdf", SDF, lambda n: "<?a " * n),
    "instructions with one end": ("a.sdf", SDF, lambda n: "<?a ><b " * n + "?>"),
    "comments in a document type": ("a.sdf", "<!DOCTYPE x [{}]>" + SDF.format(""), lambda n: "<!--" * n),
    "spaces in a tag": ("a.sdf", SDF, lambda n: '<link name="x"' + " " * n + "!>"),
    "lines in a value": ("a.sdf", SDF, lambda n: '<link name="<' + "\n" * n + '"/>'),
    "unclosed values": ("a.sdf", SDF, lambda n: "<link " + 'a="b ' * n + "x>"),
    "unquoted values": ("a.sdf", SDF, lambda n: "<link " + "a=b " * n + "x>"),
    "quotes": ("a.sdf", SDF, lambda n: "<a " + '"' * n + "'" * n),
    "tags without angle": ("a.sdf", SDF, lambda n: 'a b="c" ' * n),
    "end tags": ("a.sdf", SDF, lambda n: "</a" * n),
    "angles": ("a.sdf", SDF, lambda n: "< " * n),
    "ampersands": ("a.sdf", SDF, lambda n: "&" * n),
    # Names and namespaces.
    "colons in a name": ("a.sdf", SDF, lambda n: "<a" + ":" * n + "(/>"),
    "colons in a text": ("a.sdf", SDF, lambda n: ":" * n + "("),
    # Values.
    "digits": ("a.sdf", SDF, lambda n: "<pose>" + "0" * n + "x 0 0 0 0 0</pose>"),
    "spaces in an address": (
        "a.sdf",
        SDF,
        lambda n: "<include><uri>model://a" + " " * n + "b</uri></include>",
    ),
    # Comments that address the linter.
    "spaces in a comment": ("a.sdf", SDF, lambda n: "<!-- sdfcheck" + " " * n + "-->"),
    "words in a comment": ("a.sdf", SDF, lambda n: "<!-- sdfcheck: ignore[" + "a " * n + "-->"),
    # xacro.
    "a quote after a word": ("a.xacro", MACRO, lambda n: "a:=" + "x" * n + "'"),
    "a quote after quotes": ("a.xacro", MACRO, lambda n: "a:=" + "''" * n + "x'"),
    "dollars": ("a.xacro", XACRO, lambda n: '<link name="' + "$" * n + '"/>'),
    "open expressions": ("a.xacro", XACRO, lambda n: '<link name="' + "${" * n + '"/>'),
    "open substitutions": ("a.xacro", XACRO, lambda n: '<link name="' + "$(" * n + '"/>'),
}
SIZE = 3000


@pytest.mark.parametrize("name", ATTACKS)
def test_time_grows_with_the_size(name: str) -> None:
    file, frame, attack = ATTACKS[name]

    def took(size: int) -> float:
        text = frame.format(attack(size))
        begin = time.process_time()
        lint(text, name=file, isolated=True)
        return time.process_time() - begin

    took(10)
    once, four_times = took(SIZE), took(4 * SIZE)
    # Quadratic work takes 16 times as long, and minutes; work too short to measure is fast enough.
    # On a busy machine a run may be slow by chance: then both are measured again.
    for _ in range(3):
        if four_times < 10 * max(once, 0.05):
            break
        once, four_times = took(SIZE), min(four_times, took(4 * SIZE))
    assert four_times < 10 * max(once, 0.05)


def test_a_package_file_is_read_in_time() -> None:
    def took(size: int) -> float:
        begin = time.process_time()
        packages._COMMENT.sub("", "<!--" * size)
        return time.process_time() - begin

    assert any(took(200_000) < 10 * max(took(50_000), 0.05) for _ in range(4))
