"""The intended names of references that are not resolved."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.robot.root import root_of
from sdfcheck.source.document import read

NESTED = """<sdf version="1.12"><world name="w"><frame name="outer"/>
  <model name="robot"><link name="base_link"/><joint name="base_lint" type="fixed"/>
    <model name="arm"><link name="hand"/><frame name="grip"/></model>
    <model name="other"><frame name="grip"/></model></model></world></sdf>"""


@pytest.mark.parametrize(
    ("reference", "but", "kind", "meant", "outside"),
    [
        ("base_lnk", (), "", "base_link", None),
        ("base_lint", (), "link", "base_link", None),
        ("base_lnk", ("base_link",), "", None, None),
        ("hand", (), "", "arm::hand", None),
        ("grip", (), "", None, None),
        ("outer", (), "", None, "outer"),
        ("nothing_like_it", (), "", None, None),
    ],
)
def test_guesses(
    reference: str, but: tuple[str, ...], kind: str, meant: str | None, outside: str | None
) -> None:
    root = root_of(read(NESTED.encode(), Path("example.sdf")))
    guess = root.worlds[0].model("robot").guess(reference, but, kind)
    assert guess.meant == meant
    assert (guess.outside.attributes["name"] if guess.outside is not None else None) == outside
