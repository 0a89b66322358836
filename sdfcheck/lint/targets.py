"""Which consumer accepts a file: what the diagnostics say of consumers, turned around."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from sdfcheck.consumers.measured import is_measured
from sdfcheck.consumers.reaction import ON_REQUEST, READS, Consumer, Reaction, Verdict
from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.lint.run import Run
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

_DRAKE_ENDINGS = (".sdf", ".urdf")
_WORST_FIRST = tuple(reversed(Verdict))


class Reason(NamedTuple):
    reaction: Reaction
    diagnostic: Diagnostic


class Row(NamedTuple):
    """One consumer's verdict, and the reasons for it, the weightiest first."""

    consumer: Consumer
    verdict: Verdict
    reasons: tuple[Reason, ...]
    note: str = ""
    """Why the consumer does not read the file at all."""


def matrix(
    run: Run, kind: Kind, path: Path, consumers: Iterable[Consumer] = tuple(Consumer)
) -> tuple[Row, ...]:
    """The consumers' verdicts on a file that was linted, sorted by consumer.

    The run must have asked for the rules of all ``consumers``.
    """
    return tuple(
        _row(run, kind, path, consumer)
        for consumer in sorted(set(consumers), key=lambda consumer: consumer.value)
    )


def _row(run: Run, kind: Kind, path: Path, consumer: Consumer) -> Row:
    if unread := _unread(kind, path, consumer):
        return Row(consumer, Verdict.UNREAD, (), unread)
    reasons = [
        Reason(reaction, diagnostic)
        for diagnostic in run.diagnostics
        for name, reaction in diagnostic.affects
        if name == consumer.value and not reaction.is_harmless
    ]
    reasons.sort(key=lambda reason: (_rank(reason), reason.diagnostic.sort_key))
    if reasons:
        return Row(consumer, reasons[0].reaction.verdict, tuple(reasons))
    if consumer.value in ON_REQUEST and not is_measured(consumer):
        return Row(consumer, Verdict.UNMEASURED, (), "nobody has measured what it does")
    return Row(consumer, Verdict.ACCEPT, ())


def _unread(kind: Kind, path: Path, consumer: Consumer) -> str:
    """Why a consumer does not even open a file; of xacro, what counts is what it expands to."""
    if kind is Kind.SDF and "sdf" not in READS[consumer]:
        return "it does not know SDFormat"
    if consumer is Consumer.DRAKE and kind is not Kind.XACRO and path.suffix.lower() not in _DRAKE_ENDINGS:
        return "it goes by the name of the file, which must end in .sdf or .urdf"
    return ""


def _rank(reason: Reason) -> int:
    return _WORST_FIRST.index(reason.reaction.verdict)
