from __future__ import annotations

import pytest

from sdfcheck.formats.near_names import did_you_mean, nearest


@pytest.mark.parametrize(
    ("name", "candidates", "meant"),
    [
        ("panda_description", ["gen_description"], None),
        ("gen_descripton", ["gen_description", "panda_description"], "gen_description"),
        ("gne_description", ["gen_description"], None),
        ("left_wheel", ["right_wheel"], None),
        ("left_whel", ["right_wheel", "left_wheel"], "left_wheel"),
        ("wheel_l", ["wheel_r"], None),
        ("wheel_r", ["wheel_rl"], None),
        ("d415", ["d435"], None),
        ("link7", ["link1", "link2"], None),
        ("JNT05", ["JNT005", "JNT015"], "JNT005"),
        ("jibb", ["jib"], None),
        ("lft", ["lift"], "lift"),
        ("Jib", ["jib"], "jib"),
        ("baselink", ["base_link"], "base_link"),
        ("ignore-next-line", ["ignore-file"], None),
        ("od-flaw", ["odd-flaw"], "odd-flaw"),
    ],
)
def test_the_words_in_which_names_differ_are_compared(
    name: str, candidates: list[str], meant: str | None
) -> None:
    assert nearest(name, candidates) == meant


def test_a_name_that_only_looks_nearer_does_not_hide_the_one_that_was_meant() -> None:
    assert nearest("right_elbw", ["light_elbow", "right_elbow"]) == "right_elbow"


def test_the_question() -> None:
    assert did_you_mean("gazbo", ["gazebo", "drake"]) == "; did you mean `gazebo`?"
    assert did_you_mean("bullet", ["gazebo", "drake"]) == ""
