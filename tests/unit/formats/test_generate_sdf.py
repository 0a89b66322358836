"""The committed tables are what the generator makes of the facts."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.formats.table import at, spans
from tables.sdf import DATA, Merged, ranges, render

FACTS = Path(__file__).parents[4] / "shared" / "facts" / "sdf"


@pytest.mark.skipif(not FACTS.is_dir(), reason="the facts that the tables are made of are not here")
def test_committed_tables_are_up_to_date() -> None:
    for name, text in render(FACTS).items():
        assert (DATA / name).read_text("utf-8") == text, f"{name} is stale"


def test_a_fact_is_written_once_as_long_as_it_holds() -> None:
    merged = Merged("mu")
    for minor, value in ((2, "-1"), (3, "-1"), (4, "1"), (5, "1"), (6, "")):
        merged.note(minor, default=value)
    assert merged.timed("default") == "-1|4:1|6:"
    assert [at(merged.timed("default"), minor) for minor in (2, 3, 4, 5, 6, 12)] == [
        "-1",
        "-1",
        "1",
        "1",
        "",
        "",
    ]


def test_a_life_is_written_as_spans() -> None:
    assert list(ranges([2, 3, 4, 6, 10, 11, 12])) == ["2-4", "6", "10-"]
    assert spans("2-4,6,10-12") == ((2, 4), (6, 6), (10, 12))
    merged = Merged("joint")
    merged.note(2)
    assert (merged.life([2]), merged.life([2, 3])) == ("", "2")
