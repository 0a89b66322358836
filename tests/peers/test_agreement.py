"""How far sdfcheck agrees with other readers, on small cases and on real files."""

from __future__ import annotations

from typing import NamedTuple

import pytest

from tests.peers import cases, verdicts
from tests.peers.cases import Expected
from tests.peers.findings import SHARED

pytestmark = [
    pytest.mark.peers,
    pytest.mark.skipif(not SHARED.is_dir(), reason="the files to compare on are not here"),
]

AGREED = {Expected.ERROR: 0.0, Expected.WARNING: 0.0, Expected.WEAK: 0.0, Expected.OK: 0.95}
"""The share of small cases on which we must agree, by the peer's verdict."""

OF_OTHER_READERS = frozenset({"missing-axis", "undeclared-prefix"})
"""Errors that are none for this reader, but for another one: no false alarms."""


class Bounds(NamedTuple):
    """How many files may be false alarms, and what share of the rejected ones may be missed."""

    alarms: int
    missed: float


BOUNDS = {
    ("libsdformat", "sdf"): Bounds(alarms=0, missed=1.0),
    ("libsdformat", "urdf"): Bounds(alarms=0, missed=1.0),
    ("drake", "sdf"): Bounds(alarms=0, missed=1.0),
    ("drake", "urdf"): Bounds(alarms=0, missed=1.0),
}


@pytest.mark.parametrize("expected", Expected, ids=lambda expected: expected.value)
def test_small_cases(expected: Expected) -> None:
    found = [outcome for outcome in cases.outcomes() if outcome.case.expected is expected]
    agreed = sum(outcome.agrees for outcome in found)
    assert found
    assert agreed >= AGREED[expected] * len(found), "\n".join(cases.show(found))


@pytest.mark.parametrize(("reader", "kind"), BOUNDS, ids="-".join)
def test_real_files(reader: str, kind: str) -> None:
    compared = verdicts.compare(reader, kind)
    alarms = [
        comparison
        for comparison in compared
        if comparison.is_false_alarm and {finding.name for finding in comparison.errors} - OF_OTHER_READERS
    ]
    rejected = [comparison for comparison in compared if not comparison.verdict.accepted]
    missed = sum(comparison.is_miss for comparison in compared)
    assert compared
    report = "\n".join(verdicts.show(compared))
    assert len(alarms) <= BOUNDS[reader, kind].alarms, report
    assert missed <= BOUNDS[reader, kind].missed * len(rejected), report
