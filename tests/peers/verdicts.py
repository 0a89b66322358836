"""Compares sdfcheck's verdicts on real files with another consumer's.

``python -m tests.peers.verdicts [--consumer R] [--kind sdf|urdf|all] [--families XML,NS] [--all]``
lists the files where the two disagree. Errors on a file that the consumer takes without a
word are false alarms until somebody shows otherwise; a file that the consumer rejects and
we accept is a miss.
"""

from __future__ import annotations

import argparse
import json
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from sdfcheck.lint.diagnostic import Severity
from tests.peers.findings import SHARED, Finding, findings

CORPUS = SHARED / "corpus"


class Verdict(NamedTuple):
    """The verdict of a consumer on a file: does it load, with how many warnings, which error comes first."""

    path: Path
    accepted: bool
    warnings: int
    first: str


class Comparison(NamedTuple):
    verdict: Verdict
    findings: list[Finding]

    @property
    def errors(self) -> list[Finding]:
        return [finding for finding in self.findings if finding.severity is Severity.ERROR]

    @property
    def is_false_alarm(self) -> bool:
        return self.verdict.accepted and not self.verdict.warnings and bool(self.errors)

    @property
    def is_miss(self) -> bool:
        return not self.verdict.accepted and not self.errors


def verdicts(consumer: str = "libsdformat", kind: str = "sdf") -> Iterator[Verdict]:
    """The stored verdicts of one consumer on the files of one kind."""
    for entry in json.loads((CORPUS / "verdicts.json").read_text(encoding="utf-8")):
        said, path = entry.get(consumer), CORPUS / entry["file"]
        if said and path.is_file() and kind in ("all", path.suffix[1:]):
            yield Verdict(path, said["ok"], said.get("warnings", 0), said.get("first") or "")


def compare(
    consumer: str = "libsdformat", kind: str = "sdf", families: Sequence[str] = ()
) -> list[Comparison]:
    return [Comparison(verdict, findings(verdict.path, families)) for verdict in verdicts(consumer, kind)]


def show(comparisons: Sequence[Comparison], *, everything: bool = False) -> Iterator[str]:
    """The report: false alarms by rule, misses by the consumer's first error, counts."""
    alarms = [comparison for comparison in comparisons if comparison.is_false_alarm]
    yield f"## Accepted in silence, but we report errors: {len(alarms)} files"
    yield from _by_rule([(alarm, alarm.errors) for alarm in alarms], everything)
    misses = [comparison for comparison in comparisons if comparison.is_miss]
    yield f"\n## Rejected, but we report no error: {len(misses)} files"
    for first, count in sorted(Counter(miss.verdict.first for miss in misses).items()):
        yield f"{count:4} {first or '(no code)'}"
        yield from (f"       {_name(miss)}" for miss in misses if miss.verdict.first == first)
    silent = [comparison for comparison in comparisons if comparison.verdict.accepted]
    yield "\n## Warnings on accepted files"
    warnings = [(c, [f for f in c.findings if f.severity is Severity.WARNING]) for c in silent]
    yield from _by_rule(warnings, everything)
    yield "\n## Counts"
    counts = Counter((comparison.verdict.accepted, not comparison.errors) for comparison in comparisons)
    yield "             we accept  we reject"
    for accepted, word in ((True, "accepts"), (False, "rejects")):
        yield f"consumer {word}  {counts[accepted, True]:7}  {counts[accepted, False]:9}"


def _by_rule(files: Sequence[tuple[Comparison, list[Finding]]], everything: bool) -> Iterator[str]:
    """Per code: how many findings in how many files, and one sample (or all of them)."""
    codes = Counter(finding.code for _, found in files for finding in found)
    for code, count in codes.most_common():
        samples = [
            f"{_name(comparison)}:{finding.line}: {finding.message}"
            for comparison, found in files
            for finding in found
            if finding.code == code
        ]
        number = sum(any(finding.code == code for finding in found) for _, found in files)
        yield f"{count:5} {code} in {number} files"
        yield from (f"       {sample}" for sample in (samples if everything else samples[:1]))


def _name(comparison: Comparison) -> str:
    return comparison.verdict.path.relative_to(CORPUS).as_posix()


def main() -> None:
    parser = argparse.ArgumentParser(description="Compare sdfcheck's verdicts with another consumer's.")
    parser.add_argument("--consumer", choices=("libsdformat", "drake"), default="libsdformat")
    parser.add_argument("--kind", choices=("sdf", "urdf", "all"), default="sdf")
    parser.add_argument("--families", default="", help="count only the findings of these, as in XML,NS")
    parser.add_argument("--all", action="store_true", help="every finding, not one sample a rule")
    options = parser.parse_args()
    families = [family for family in options.families.split(",") if family]
    for line in show(compare(options.consumer, options.kind, families), everything=options.all):
        print(line)


if __name__ == "__main__":
    main()
