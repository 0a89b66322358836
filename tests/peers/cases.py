"""Compares sdfcheck with libsdformat on small documents, each made for one of its conditions.

``python -m tests.peers.cases [--families XML,SCH] [--all]`` lists the documents on which we disagree:
rejected ones of which we report no error, warned-about ones and real mistakes that libsdformat
calls valid (``weak``) of which we report nothing, valid ones that we report as errors.
"""

from __future__ import annotations

import argparse
import json
from collections import Counter
from collections.abc import Iterator, Sequence
from enum import Enum
from pathlib import Path
from typing import NamedTuple

from sdfcheck.lint.diagnostic import Severity
from tests.peers.findings import SHARED, Finding, findings

FOLDER = SHARED / "peer-cases"
CATALOGUE = SHARED / "facts" / "libsdformat" / "catalogue.json"

GROUPS = {
    "XML": ("FILE",),
    "SCH": ("GEO", "MAT", "OBJ", "ROOT", "SCH", "SEN", "VAL", "VER", "WLD"),
    "NAM": ("NAM",),
    "FRM": ("FRM", "MOD"),
    "JNT": ("JNT",),
    "INR": ("INR",),
    "RES": ("INC", "MRG", "PRM"),
    "URD": ("URD",),
}
"""Our family → the groups of libsdformat's conditions that fall to it."""


class Expected(Enum):
    OK = "ok"
    WARNING = "warning"
    ERROR = "error"
    WEAK = "weak"


class Case(NamedTuple):
    path: Path
    expected: Expected
    what: str
    """The peer's error code, or the mistake in words."""
    groups: frozenset[str]


class Outcome(NamedTuple):
    case: Case
    findings: list[Finding]

    @property
    def agrees(self) -> bool:
        worst = {finding.severity for finding in self.findings}
        if self.case.expected is Expected.OK:
            return Severity.ERROR not in worst
        if self.case.expected is Expected.ERROR:
            return Severity.ERROR in worst
        return bool(worst & {Severity.ERROR, Severity.WARNING})


def cases(families: Sequence[str] = ()) -> Iterator[Case]:
    """The documents; with ``families``, those of their groups, the valid and the weak ones."""
    wanted = {group for family in families for group in GROUPS.get(family, ())}
    groups = _groups()
    for entry in _index("cases"):
        case = Case(
            FOLDER / "cases" / entry["file"],
            Expected(entry["expected"]),
            entry["code"],
            frozenset(groups.get(entry["file"], ())),
        )
        if not families or case.groups & wanted or case.expected is Expected.OK:
            yield case
    for entry in _index("weak"):
        yield Case(FOLDER / "weak" / entry["file"], Expected.WEAK, entry["mistake"], frozenset())


def _index(folder: str) -> list[dict[str, str]]:
    entries: list[dict[str, str]] = json.loads((FOLDER / folder / "index.json").read_text(encoding="utf-8"))
    return entries


def _groups() -> dict[str, set[str]]:
    found: dict[str, set[str]] = {}
    for condition in json.loads(CATALOGUE.read_text(encoding="utf-8")):
        for file in condition["cases"]:
            found.setdefault(file, set()).add(condition["group"])
    return found


def outcomes(families: Sequence[str] = ()) -> list[Outcome]:
    return [Outcome(case, findings(case.path)) for case in cases(families)]


def show(found: Sequence[Outcome], *, everything: bool = False) -> Iterator[str]:
    for expected in (Expected.ERROR, Expected.WARNING, Expected.WEAK, Expected.OK):
        group = [outcome for outcome in found if outcome.case.expected is expected]
        agreed = sum(outcome.agrees for outcome in group)
        yield f"## {expected.value}: agree on {agreed} of {len(group)}"
        for outcome in group:
            if everything or not outcome.agrees:
                said = "; ".join(f"{f.line}: {f.code} {f.message}" for f in outcome.findings)
                mark = " " if outcome.agrees else "!"
                what = "/".join(filter(None, (*sorted(outcome.case.groups), outcome.case.what)))
                yield f" {mark} {outcome.case.path.name} ({what}): {said or 'nothing'}"
    codes = Counter(finding.code for outcome in found for finding in outcome.findings)
    yield "\n" + ", ".join(f"{code} {count}" for code, count in sorted(codes.items()))


def main() -> None:
    parser = argparse.ArgumentParser(description="Compare sdfcheck with libsdformat on small documents.")
    parser.add_argument("--families", default="", help="only the documents that fall to these, as in XML,NS")
    parser.add_argument("--all", action="store_true", help="also where we agree")
    options = parser.parse_args()
    families = [family for family in options.families.split(",") if family]
    for line in show(outcomes(families), everything=options.all):
        print(line)


if __name__ == "__main__":
    main()
