"""How values are read: the tables of facts about libsdformat 17, literal by literal."""

from __future__ import annotations

import pytest

from sdfcheck.formats.reading import Cause, Outcome, Reading
from sdfcheck.formats.sdf.values import floats, number, read
from sdfcheck.formats.table import Range

FINE = Outcome.AS_WRITTEN
BAD = Outcome.MALFORMED
MISREAD = Outcome.MISREAD


@pytest.mark.parametrize(
    ("kind", "text"),
    [
        *(("bool", text) for text in ("true", "false", "True", "FALSE", "tRuE", "1", "0")),
        *(("int", text) for text in ("0", "-5", "+7", "010", "0x1F", "2147483647", "5.0", "5.", "1e0")),
        *(("unsigned int", text) for text in ("0", "4294967295", "0xFF", "+3")),
        *(
            ("double", text)
            for text in ("1", "1.", ".5", "-.5e-3", "1E+5", "+1", "1e5", "0.0", "1.79769e+308")
        ),
        *(("float", text) for text in ("1", "3.4e38", "-1e-37")),
        *(("string", text) for text in ("1,5", "true", "a b", "${x}")),
        ("char", "a"),
        ("time", "1 2"),
        ("time", "-1 500000000"),
        ("angle", "1.57"),
        ("vector2i", "1 -2"),
        ("vector2d", "1 2"),
        ("vector3", "1 2 3"),
        ("vector3", "1.\n\t.5\r\n  -1e3"),
        ("quaternion", "0 0 1.57"),
        ("color", "1 0 0"),
        ("color", "0.1 .2 1.0 0"),
        ("pose", "0 0 0 0 0 0"),
        ("pose", "  1 2 3\n 0 0 1.57 "),
    ],
)
def test_read_as_written(kind: str, text: str) -> None:
    assert read(kind, text) == Reading(FINE)
    assert read(kind, f"\n  {text}\t") == Reading(FINE)


@pytest.mark.parametrize(
    ("kind", "text", "read_as", "cause"),
    [
        ("int", "12abc", "12", Cause.TRAILING),
        ("int", "1.9", "1", Cause.FRACTION),
        ("int", "1e3", "1", Cause.EXPONENT),
        ("int", "1,000", "1", Cause.COMMA),
        ("int", "true", "1", Cause.TRUTH_VALUE),
        ("int", "-0x10", "0", Cause.HEXADECIMAL),
        ("unsigned int", "-1", "4294967295", Cause.NEGATIVE),
        ("unsigned int", "4294967296", "0", Cause.TOO_LARGE),
        ("unsigned int", "1.5", "1", Cause.FRACTION),
        ("double", "0x10", "16", Cause.HEXADECIMAL),
        ("double", "0x1p3", "8", Cause.HEXADECIMAL),
        ("double", "1.0kg", "1", Cause.TRAILING),
        ("double", "1.5kg", "1.5", Cause.TRAILING),
        ("double", "1,5", "1", Cause.COMMA),
        ("double", "1d0", "1", Cause.TRAILING),
        ("double", "1e", "1", Cause.TRAILING),
        ("double", "1_000", "1", Cause.TRAILING),
        ("double", "true", "1", Cause.TRUTH_VALUE),
        ("double", "False", "0", Cause.TRUTH_VALUE),
        ("char", "abc", "a", Cause.TRAILING),
        ("angle", "1.5deg", "1.5", Cause.TRAILING),
    ],
)
def test_accepted_and_read_as_something_else(kind: str, text: str, read_as: str, cause: Cause) -> None:
    reading = read(kind, f" {text}\n")
    assert (reading.outcome, reading.read_as, reading.cause) == (MISREAD, read_as, cause)
    assert (reading.start, reading.end, reading.refused) == (1, 1 + len(text), False)


@pytest.mark.parametrize(
    ("kind", "text", "part", "read_as", "cause"),
    [
        ("double", "1 2", "2", "1", Cause.EXTRA),
        ("double", "1 kg", "kg", "1", Cause.EXTRA),
        ("int", "1 2", "2", "1", Cause.EXTRA),
        ("time", "0 1.5", "1.5", "1", Cause.FRACTION),
        ("vector2i", "1 2.5", "2.5", "2", Cause.FRACTION),
        ("vector3", "1 2 3abc", "3abc", "3", Cause.TRAILING),
        ("vector3", "0 0 0x10", "0x10", "0", Cause.HEXADECIMAL),
        ("vector3", "1-2 3", "1-2", "1", Cause.GLUED),
        ("vector3", "0 0 1e-400", "1e-400", "0", Cause.TOO_SMALL),
        ("vector2d", "1 2,5", "2,5", "2", Cause.COMMA),
        ("pose", "1m 2 3 0 0 0", "1m", "1", Cause.TRAILING),
        ("pose", "1 2,5 3 0 0 0", "2,5", "2", Cause.COMMA),
        ("color", "nan 0 0 1", "nan", "0", Cause.NOT_FINITE),
        ("color", "1 0x1 0 1", "0x1", "1", Cause.HEXADECIMAL),
    ],
)
def test_one_part_is_read_as_something_else(
    kind: str, text: str, part: str, read_as: str, cause: Cause
) -> None:
    reading = read(kind, text)
    assert (reading.outcome, reading.read_as, reading.cause) == (MISREAD, read_as, cause)
    assert text[reading.start : reading.end] == part
    assert not reading.refused


@pytest.mark.parametrize(
    ("kind", "text", "part", "cause"),
    [
        *(("bool", text, text, Cause.NOT_A_BOOLEAN) for text in ("yes", "on", "2", "1.0", "01")),
        ("bool", "${static}", "${static}", Cause.EXPRESSION),
        ("int", "abc", "abc", Cause.NOT_A_NUMBER),
        ("int", ".5", ".5", Cause.FRACTION),
        ("int", "2147483648", "2147483648", Cause.TOO_LARGE),
        ("int", "9" * 5000, "9" * 5000, Cause.TOO_LARGE),
        ("unsigned int", "18446744073709551616", "18446744073709551616", Cause.TOO_LARGE),
        ("unsigned int", "abc", "abc", Cause.NOT_A_NUMBER),
        *(("double", text, text, Cause.NOT_A_NUMBER) for text in ("abc", "--1", "-", ".", "kg 1"[:2])),
        ("double", "${x + 1}", "${x + 1}", Cause.EXPRESSION),
        ("double", "1e400", "1e400", Cause.TOO_LARGE),
        ("double", "1e-400", "1e-400", Cause.TOO_SMALL),
        ("double", "4.9e-324", "4.9e-324", Cause.TOO_SMALL),
        ("float", "1e39", "1e39", Cause.TOO_LARGE),
        ("float", "1e-46", "1e-46", Cause.TOO_SMALL),
        ("time", "1.5 0", "1.5", Cause.FRACTION),
        ("time", "3000000000 0", "3000000000", Cause.TOO_LARGE),
        ("angle", "inf", "inf", Cause.NOT_FINITE),
        ("vector2i", "1.5 2", "1.5", Cause.FRACTION),
        ("vector2i", "0x10 2", "0x10", Cause.HEXADECIMAL),
        ("vector2d", "1 inf", "inf", Cause.NOT_FINITE),
        ("vector3", "nan 0 0", "nan", Cause.NOT_FINITE),
        ("vector3", "1,2,3", "1,2,3", Cause.COMMA),
        ("vector3", "1, 2, 3", "1,", Cause.COMMA),
        ("vector3", "1 2abc 3", "2abc", Cause.NOT_A_NUMBER),
        ("vector3", "0x10 0 0", "0x10", Cause.HEXADECIMAL),
        ("vector3", "1e400 0 0", "1e400", Cause.TOO_LARGE),
        ("vector3", "1 2 3e", "3e", Cause.NOT_A_NUMBER),
        ("vector3", "1 ${y} 3", "1 ${y} 3", Cause.EXPRESSION),
        ("color", "1,0,0,1", "1,0,0,1", Cause.COMMA),
        ("color", "red", "red", Cause.NOT_A_NUMBER),
        ("color", "inf 0 0", "inf", Cause.NOT_FINITE),
        ("color", "1e39 0 0", "1e39", Cause.TOO_LARGE),
        ("pose", "1e-400 0 0 0 0 0", "1e-400", Cause.TOO_SMALL),
        ("pose", "1e400 0 0 0 0 0", "1e400", Cause.TOO_LARGE),
        ("pose", "0 0 0 0 0 inf", "inf", Cause.NOT_FINITE),
        ("pose", "0 0 x 0 0 0", "x", Cause.NOT_A_NUMBER),
    ],
)
def test_refused(kind: str, text: str, part: str, cause: Cause) -> None:
    reading = read(kind, text)
    assert (reading.outcome, reading.cause, reading.refused) == (BAD, cause, True)
    assert text[reading.start : reading.end] == part


@pytest.mark.parametrize(
    ("kind", "text", "part", "wanted", "got", "refused"),
    [
        ("time", "1", "1", (2,), 1, True),
        ("time", "1 2 3", "3", (2,), 3, False),
        ("vector2d", "1", "1", (2,), 1, True),
        ("vector3", "1 2", "1 2", (3,), 2, True),
        ("vector3", "1 2 3 4", "4", (3,), 4, False),
        ("quaternion", "1 2", "1 2", (3,), 2, True),
        ("quaternion", "0 0 0 1", "1", (3,), 4, False),
        ("color", "1 0", "1 0", (3, 4), 2, True),
        ("color", "1 1 1 1 1 0", "1 0", (3, 4), 6, True),
        ("pose", "1 2 3", "1 2 3", (6,), 3, True),
        ("pose", "1 2 3 0 0 0 1", "1", (6,), 7, True),
    ],
)
def test_too_few_or_too_many_numbers(
    kind: str, text: str, part: str, wanted: tuple[int, ...], got: int, refused: bool
) -> None:
    reading = read(kind, text)
    assert (reading.outcome, reading.wanted, reading.got) == (Outcome.WRONG_COUNT, wanted, got)
    assert (text[reading.start : reading.end], reading.refused) == (part, refused)


def test_a_pose_with_a_quaternion_has_seven_numbers() -> None:
    assert read("pose", "0 0 0 0 0 0 1", rotation_format="quat_xyzw").is_fine
    assert read("pose", "0 0 0 0 0 0", rotation_format="quat_xyzw").wanted == (7,)
    assert read("pose", "1,2 3 0 0 0 0 0", rotation_format="quat_xyzw").read_as == "1"
    assert read("pose", "", rotation_format="quat_xyzw").outcome is Outcome.DEFAULT


@pytest.mark.parametrize("kind", ["bool", "int", "double", "string", "time", "vector3", "color", "pose"])
@pytest.mark.parametrize("text", ["", " \n\t"])
def test_empty_is_the_default_unless_required(kind: str, text: str) -> None:
    assert read(kind, text).outcome is Outcome.DEFAULT
    required = read(kind, text, required=True)
    assert (required.outcome, required.refused) == (Outcome.EMPTY, True)


@pytest.mark.parametrize("text", ["inf", "-inf", "Infinity", "INF", "+inf"])
def test_infinity_is_fine_where_it_has_a_meaning(text: str) -> None:
    assert read("double", text, infinite=True) == Reading(FINE)
    assert read("double", text).outcome is Outcome.NOT_FINITE


def test_nan_has_no_meaning_anywhere() -> None:
    assert read("double", "NaN", infinite=True).outcome is Outcome.NOT_FINITE


@pytest.mark.parametrize(
    ("kind", "text", "part"),
    [("double", "-0.1", "-0.1"), ("int", " 2", "2"), ("vector3", "0 1 -3 ", "-3")],
)
def test_ranges(kind: str, text: str, part: str) -> None:
    share = Range(0.0, 1.0)
    reading = read(kind, text, bounds=share)
    assert (reading.outcome, reading.range) == (Outcome.OUT_OF_RANGE, share)
    assert text[reading.start : reading.end] == part
    assert read(kind, "0 1 0" if kind == "vector3" else "1", bounds=share).is_fine
    assert str(share) == "from 0 to 1"


@pytest.mark.parametrize(("text", "part"), [("2 0 0 1", "2"), ("-0.1 0 0 1", "-0.1"), ("0 0 255", "255")])
def test_parts_of_a_color_lie_between_0_and_1(text: str, part: str) -> None:
    reading = read("color", text)
    assert (reading.outcome, reading.refused) == (Outcome.OUT_OF_RANGE, True)
    assert text[reading.start : reading.end] == part


@pytest.mark.parametrize("text", ["-5 1 1", "inf", "0x10", "-5kg"])
def test_a_number_outside_of_a_refused_range_is_refused_for_that_first(text: str) -> None:
    reading = read("double", text, bounds=Range(0.0, 1.0))
    assert (reading.outcome, reading.refused) == (Outcome.OUT_OF_RANGE, True)


def test_an_open_range_excludes_its_end() -> None:
    above = Range(0.0, float("inf"), (True, False))
    assert read("double", "0", bounds=above).outcome is Outcome.OUT_OF_RANGE
    assert read("double", "1e-9", bounds=above).is_fine
    assert str(above) == "above 0"


@pytest.mark.parametrize(
    ("kind", "words"),
    [
        ("double", "a number"),
        ("int", "a whole number"),
        ("bool", "true or false"),
        ("vector3", "3 numbers"),
        ("pose", "6 numbers"),
        ("color", "3 or 4 numbers from 0 to 1"),
    ],
)
def test_the_expected_type_is_given_in_words(kind: str, words: str) -> None:
    assert read(kind, "x").expected == words


def test_a_no_break_space_is_no_blank() -> None:
    assert read("vector3", "1\u00a02 3").outcome is BAD


def test_typed_reads() -> None:
    assert floats(" 1 2.5\n-3e2 ") == (1.0, 2.5, -300.0)
    assert [floats(text) for text in ("", "1,5", "1 x", "1_0", "\u0661")] == [None] * 5
    assert (number("-1e3"), number("1 2"), number("")) == (-1000.0, None, None)
    assert number("inf") == float("inf")
