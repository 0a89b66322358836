"""The result of one run: what reporters render."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.consumers.reaction import Reaction


class RuleFacts(NamedTuple):
    """What can be said of a rule without importing it (the index holds it)."""

    code: str
    name: str
    family: str
    severity: Severity
    summary: str
    """First sentence of the rule's documentation."""
    fixable: str
    """"safe", "unsafe" or "" (derived from the rule's examples)."""
    default: bool
    """False: off unless selected."""
    selects: tuple[str, ...]
    """Selectors of the elements that the rule looks at."""
    explains: tuple[str, ...]
    """Names of the kinds of problem that the rule puts into words."""
    affects: Mapping[str, Mapping[str, str]]
    """Reader → dialect → what it does: a :class:`~sdfcheck.consumers.reaction.Reaction` as text."""
    module: str
    """Module that holds the rule's class."""
    looks_at: tuple[str, ...] = ()
    """Names of the classes of the robot that the rule looks at."""


def reactions(
    facts: RuleFacts, dialect: str, special: Iterable[tuple[str, Reaction]] = ()
) -> tuple[tuple[str, Reaction], ...]:
    """What each reader does about a rule's defect in a document, sorted by reader; ``special`` comes first."""
    from sdfcheck.consumers.reaction import READS, Consumer, Reaction

    told = {reader: by[dialect] for reader, by in facts.affects.items() if dialect in by}
    found = {reader: Reaction.of(said) for reader, said in told.items()}
    found.update((reader, said) for reader, said in special if dialect in READS[Consumer(reader)])
    return tuple(sorted(found.items(), key=lambda item: item[0]))


class Run(NamedTuple):
    """One finished run. Diagnostics are sorted; nothing here changes afterwards.

    ``files`` are the linted files, also the clean ones; ``skipped`` those that were
    found but not linted, with the reason. ``suppressed`` counts silenced diagnostics,
    ``fixed`` applied fixes.
    """

    diagnostics: tuple[Diagnostic, ...]
    files: tuple[Path, ...]
    skipped: tuple[tuple[Path, str], ...] = ()
    suppressed: int = 0
    fixed: int = 0
    rules: tuple[RuleFacts, ...] = ()
    """Facts of every rule that was selected, sorted by code."""

    def count(self, severity: Severity) -> int:
        return sum(d.severity is severity for d in self.diagnostics)

    @property
    def fixable(self) -> int:
        return sum(d.fix is not None and d.fix.is_safe for d in self.diagnostics)
