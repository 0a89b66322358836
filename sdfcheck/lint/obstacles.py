"""Which errors stop a conversion: those for which the format's own parser refuses the file.

The own parser is urdfdom for URDF and xacro, libsdformat (Gazebo's) for SDFormat, and Drake for a
URDF file with joints that Drake alone reads. A file that it refuses is not a robot yet, and a
converter would have to guess which one was meant. A file that it reads is one, even with other
errors: a missing mesh, an inertia that no body has, a feature that another consumer lacks.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sdfcheck.consumers.reaction import Consumer, Verdict
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.source.document import Document
from sdfcheck.source.sniff import Kind

ELSEWHERE = frozenset({"RES"})
"""Families whose errors are about other files, which a conversion can do without."""
OWN_CONSUMER: Mapping[Kind, Consumer] = {
    Kind.SDF: Consumer.GAZEBO,
    Kind.URDF: Consumer.URDFDOM,
    Kind.XACRO: Consumer.URDFDOM,
}


def own_consumer(document: Document) -> Consumer | None:
    """Whose file it is."""
    root = document.root
    if document.kind is Kind.URDF and root is not None and root.has("drake:joint"):
        return Consumer.DRAKE
    return OWN_CONSUMER.get(document.kind)


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
