from __future__ import annotations

import pytest

from sdfcheck.formats.near_names import distance, suggest, with_another_word, without_unit


@pytest.mark.parametrize(
    ("name", "candidates", "expected"),
    [
        ("Radius", ["radius"], "radius"),
        ("raduis", ["box", "radius"], "radius"),
        ("lenght", ["length", "link"], "length"),
        ("lnik", ["link"], "link"),
        ("colision", ["collision"], "collision"),
        ("inital_position", ["initial_position"], "initial_position"),
        ("self-collide", ["self_collide"], "self_collide"),
        ("canonicalLink", ["canonical_link"], "canonical_link"),
        ("izx", ["ixx", "ixz", "izz"], "ixz"),
        ("visul", ["visual"], "visual"),
        ("uri", ["url"], "url"),
        ("mu1", ["mu2", "mu"], "mu"),
        ("xz", ["x", "z"], None),
        ("far", ["fdir1", "near"], None),
        ("wheel", ["link", "joint"], None),
        ("m_f_rate", ["frame"], None),
        ("hvisuol", ["visual"], None),
        ("vsuall", ["visual"], "visual"),
        ("orlision", ["collision"], "collision"),
        ("", ["link"], None),
        ("link", [], None),
    ],
)
def test_near_misses(name: str, candidates: list[str], expected: str | None) -> None:
    assert suggest(name, candidates) == expected
    assert suggest(name, reversed(candidates)) == expected


@pytest.mark.parametrize(
    ("one", "other", "edits"),
    [
        ("", "", 0),
        ("", "ab", 2),
        ("ab", "ba", 1),
        ("abc", "ab", 1),
        ("abc", "axc", 1),
        ("kitten", "sitting", 3),
    ],
)
def test_distance(one: str, other: str, edits: int) -> None:
    assert distance(one, other) == distance(other, one) == edits


@pytest.mark.parametrize(
    ("name", "expected"), [("mass_kg", "mass"), ("mass", None), ("mass_mg", None), ("weight_kg", None)]
)
def test_a_unit_of_the_format_behind_a_name(name: str, expected: str | None) -> None:
    assert without_unit(name, {"mass", "pose"}) == expected


def test_a_word_that_is_left_out() -> None:
    names = ["bias_mean", "dynamic_bias_stddev", "dynamic_bias_correlation_time"]
    assert with_another_word("bias_correlation_time", names) == "dynamic_bias_correlation_time"
    assert with_another_word("time", names) is None
    assert with_another_word("correlation_time", names) is None
    assert with_another_word("a_b", ["c_a_b", "d_a_b"]) is None
