"""``params`` is taken apart as xacro does it, in a time that grows with its length only."""

from __future__ import annotations

import random
from collections.abc import Callable
from typing import Any, cast

import pytest
import xacro

from sdfcheck.xacro.language import ArgumentParser, parameters

Parser = Callable[[Any], tuple[str, object, object]]
PIECES = ("a", "b", " ", "  ", "'", '"', "${", "}", "$(", ")", ":=", "=", ":", "^", "|", "^|", "*", "x")
CASES = (
    "a",
    "*a **b c",
    "a:=1 b=2",
    "a:='x y' b",
    "a:='x'y\"z w\" b",
    "a:=${x + 1} b:=$(find p) c",
    "a:=${x}y b:=${z} c",
    "a:=^ b:=^|1 c:=^|'x",
    "a:= b",
    "a:= 'b",
    "a : = b",
    "a:='b'c' d",
    'a:="it\'s" b',
)


def taken_apart(parse: Parser, text: str) -> list[tuple[str, object]]:
    found, rest = [], cast("object", text)
    while str(rest).strip():
        name, default, rest = parse(rest)
        assert bool(rest) == bool(str(rest))
        found.append((name, default))
    return found


@pytest.mark.parametrize("text", CASES)
def test_like_xacro(text: str) -> None:
    assert taken_apart(ArgumentParser(), text) == taken_apart(xacro.parse_macro_arg, text)


def test_like_xacro_whatever_is_written() -> None:
    chance = random.Random(1)
    for _ in range(5000):
        text = "".join(chance.choices(PIECES, k=chance.randint(1, 12)))
        assert taken_apart(ArgumentParser(), text) == taken_apart(xacro.parse_macro_arg, text), text


def test_places_and_defaults() -> None:
    text = "prefix:='left_' *origin side:=^|1 scale"
    found = list(parameters(text))
    assert [text[one.start : one.end] for one in found] == ["prefix", "*origin", "side", "scale"]
    assert [one.default for one in found] == ["'left_'", None, "1", None]
    assert [one.forwards for one in found] == [False, False, True, False]
    assert [one.is_block for one in found] == [False, True, False, False]


def test_a_quote_that_is_left_over_ends() -> None:
    (parameter,) = parameters("prefix:=left_arm_shoulder_pan_link_frame" * 1000 + "'")
    assert parameter.default is None
