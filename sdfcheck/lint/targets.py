"""Which reader accepts a file: what the rules say of readers, turned around."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from enum import Enum

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.rule import Consumer
from sdfcheck.lint.run import Run
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

READS = {
    Kind.SDF: frozenset((Consumer.GAZEBO, Consumer.DRAKE)),
    Kind.URDF: frozenset(Consumer),
    Kind.XACRO: frozenset(Consumer),
}
"""Kind of file → who reads it (of xacro, what it expands to)."""

_REFUSALS = ("aborts", "crashes", "gets no", "loads an empty", "refuses the")
_TAKEN = ("exchanges", "normalizes", "reads it", "takes it")


class Verdict(Enum):
    """How a reader stands to a file, the worst last."""

    ACCEPT = "accept"
    WARN = "warn"
    """It reads the file, though not all of it, or not as it was meant."""
    REJECT = "reject"
    UNREAD = "not read"
    """It does not know the format."""


class Reason(NamedTuple):
    verdict: Verdict
    effect: str
    """What the reader does; empty where the rule does not say."""
    diagnostic: Diagnostic


class Row(NamedTuple):
    """One reader's verdict, and the reasons for it, the weightiest first."""

    reader: Consumer
    verdict: Verdict
    reasons: tuple[Reason, ...]


def matrix(run: Run, kind: Kind, readers: Iterable[Consumer] = tuple(Consumer)) -> tuple[Row, ...]:
    """The readers' verdicts on the files of a run, sorted by reader.

    The run must have asked for the rules of all ``readers``.
    """
    affects = {facts.code: facts.affects for facts in run.rules}
    rows = []
    for reader in sorted(set(readers), key=lambda reader: reader.value):
        if reader not in READS.get(kind, frozenset(Consumer)):
            rows.append(Row(reader, Verdict.UNREAD, ()))
            continue
        judged = [
            reason(diagnostic, affects.get(diagnostic.code, {}), reader) for diagnostic in run.diagnostics
        ]
        reasons = [one for one in judged if one.verdict is not Verdict.ACCEPT]
        reasons.sort(key=lambda one: (-_weight(one.verdict), one.diagnostic.sort_key))
        rows.append(Row(reader, reasons[0].verdict if reasons else Verdict.ACCEPT, tuple(reasons)))
    return tuple(rows)


def reason(diagnostic: Diagnostic, affects: Mapping[str, str], reader: Consumer) -> Reason:
    """What a diagnostic of a rule that ``affects`` readers so means to one of them."""
    effect = affects.get(reader.value, "")
    if affects and not effect:
        return Reason(Verdict.ACCEPT, "", diagnostic)
    return Reason(judge(effect, diagnostic.severity), effect, diagnostic)


def judge(effect: str, severity: Severity) -> Verdict:
    """The verdict that an effect amounts to; where only the severity is known, that.

    What a reader does only sometimes counts as refusal for errors.
    """
    if not effect:
        return {Severity.ERROR: Verdict.REJECT, Severity.WARNING: Verdict.WARN}.get(severity, Verdict.ACCEPT)
    if effect.startswith(_REFUSALS):
        sometimes = ", or " in effect or " in some " in effect or " in older " in effect
        return Verdict.WARN if sometimes and severity is not Severity.ERROR else Verdict.REJECT
    return Verdict.ACCEPT if effect.startswith(_TAKEN) and ":" not in effect else Verdict.WARN


def _weight(verdict: Verdict) -> int:
    return list(Verdict).index(verdict)
