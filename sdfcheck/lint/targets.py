"""Which consumer accepts a file, and which of its errors stop a conversion."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path

from sdfcheck.consumers.measured import is_measured
from sdfcheck.consumers.reaction import ON_REQUEST, READS, Consumer, Reaction, Verdict
from sdfcheck.consumers.urdf_readers import is_for_drake
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.run import Run
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind

# Which consumer accepts a file: what the diagnostics say of consumers, turned around.

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


def without_sdf(consumer: Consumer) -> Row | None:
    """The row for an SDFormat file of a consumer that does not read SDFormat, or whose reading nobody measured."""
    if "sdf" in READS[consumer]:
        return None
    if consumer is Consumer.PYBULLET:
        return Row(consumer, Verdict.UNMEASURED, (), "nobody has measured what its loadSDF does")
    return Row(consumer, Verdict.UNREAD, (), "it does not know SDFormat")


def _row(run: Run, kind: Kind, path: Path, consumer: Consumer) -> Row:
    if kind is Kind.SDF and (row := without_sdf(consumer)) is not None:
        return row
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
    if consumer is Consumer.DRAKE and kind is not Kind.XACRO and path.suffix.lower() not in _DRAKE_ENDINGS:
        return "it goes by the name of the file, which must end in .sdf or .urdf"
    return ""


def _rank(reason: Reason) -> int:
    return _WORST_FIRST.index(reason.reaction.verdict)


# Which errors stop a conversion: those for which the format's own parser refuses the file.
#
# The own parser is urdfdom for URDF and xacro, libsdformat (Gazebo's) for SDFormat, and Drake for a
# URDF file with joints that Drake alone reads. A file that it refuses is not a robot yet, and a
# converter would have to guess which one was meant. A file that it reads is one, even with other
# errors: a missing mesh, an inertia that no body has, a feature that another consumer lacks.

ELSEWHERE = frozenset({"RES"})
"""Families whose errors are about other files, which a conversion can do without."""
OWN_CONSUMER: Mapping[Kind, Consumer] = {
    Kind.SDF: Consumer.GAZEBO,
    Kind.URDF: Consumer.URDFDOM,
    Kind.XACRO: Consumer.URDFDOM,
}


def own_consumer(document: Document) -> Consumer | None:
    """Whose file it is."""
    return Consumer.DRAKE if is_for_drake(document) else OWN_CONSUMER.get(document.kind)


def errors(document: Document) -> list[Diagnostic]:
    """The errors of a document, by the rules that run by default."""
    from sdfcheck.lint.config.settings import Settings
    from sdfcheck.lint.engine import lint_document
    from sdfcheck.lint.rulebook.rulebook import RuleBook

    found = lint_document(document, RuleBook().dispatch(Settings(), document.path))
    return [one for one in found if one.severity is Severity.ERROR]


def refusals(document: Document) -> list[Diagnostic]:
    """The errors that stop a conversion of a document, by the rules that run by default."""
    return obstacles(errors(document), own_consumer(document), ELSEWHERE)


def obstacles(
    found: Iterable[Diagnostic], consumer: Consumer | None, elsewhere: frozenset[str] = frozenset()
) -> list[Diagnostic]:
    """The errors among ``found`` that stop a conversion of a file that has an own parser.

    Those of the families ``elsewhere`` do not: they are about other files.
    """
    return [
        diagnostic
        for diagnostic in found
        if diagnostic.severity is Severity.ERROR
        and diagnostic.code.rstrip("0123456789") not in elsewhere
        and (consumer is None or _refused(diagnostic, consumer))
    ]


def _refused(diagnostic: Diagnostic, consumer: Consumer) -> bool:
    reaction = dict(diagnostic.affects).get(consumer.value)
    return reaction is not None and reaction.verdict is Verdict.REJECT
