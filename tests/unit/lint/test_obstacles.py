"""Errors stop a conversion where the format's own reader refuses the file."""

from __future__ import annotations

from pathlib import Path

import pytest

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.obstacles import obstacles
from sdfcheck.lint.run import RuleFacts
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import Source


def stops(
    affects: dict[str, str],
    kind: Kind,
    severity: Severity = Severity.ERROR,
    mended: frozenset[str] = frozenset(),
) -> bool:
    span = Source(Path("r"), "<robot/>").span(0, 0)
    facts = RuleFacts("XYZ001", "odd-flaw", "XYZ", severity, "", "", True, (), (), affects, "")
    diagnostic = Diagnostic(facts.code, facts.name, severity, "odd", span)
    return bool(obstacles([diagnostic], [facts], kind, mended))


@pytest.mark.parametrize(
    ("affects", "urdf", "sdf"),
    [
        ({}, True, True),
        ({"drake": "refuses the file"}, False, False),
        ({"urdfdom": "refuses the file", "gazebo": "refuses the file"}, True, True),
        ({"urdfdom": "takes it", "gazebo": "refuses the model"}, False, True),
        ({"urdfdom": "drops the rest of the link"}, False, False),
    ],
)
def test_the_own_reader_decides(affects: dict[str, str], urdf: bool, sdf: bool) -> None:
    assert stops(affects, Kind.URDF) is urdf
    assert stops(affects, Kind.SDF) is sdf


def test_warnings_and_what_is_mended_do_not_stop() -> None:
    assert not stops({}, Kind.URDF, Severity.WARNING)
    assert not stops({}, Kind.URDF, mended=frozenset({"XYZ"}))
    assert stops({}, Kind.URDF, mended=frozenset({"XY"}))
