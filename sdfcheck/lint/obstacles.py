"""Which errors stop a conversion: those for which the format's own reader refuses the file.

The own reader is urdfdom for URDF and xacro, libsdformat (Gazebo's) for SDFormat. What it
refuses is no robot yet, and a converter would have to guess which one was meant. What it
reads is one, whatever else is wrong with it: a mesh that is not there, an inertia
that no body has, something that another reader cannot do.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.lint.rule import Consumer
from sdfcheck.lint.run import RuleFacts
from sdfcheck.lint.targets import Verdict, reason
from sdfcheck.source.sniff import Kind

OWN_READER: Mapping[Kind, Consumer] = {
    Kind.SDF: Consumer.GAZEBO,
    Kind.URDF: Consumer.URDFDOM,
    Kind.XACRO: Consumer.URDFDOM,
}


def obstacles(
    found: Iterable[Diagnostic], rules: Iterable[RuleFacts], kind: Kind, mended: frozenset[str] = frozenset()
) -> list[Diagnostic]:
    """The errors among ``found`` that stop a conversion from a kind of file.

    Those of the families ``mended`` do not: the converter deals with them itself.
    """
    facts = {one.code: one for one in rules}
    reader = OWN_READER.get(kind)
    stopping = []
    for diagnostic in found:
        rule = facts.get(diagnostic.code)
        if diagnostic.severity is not Severity.ERROR or (rule is not None and rule.family in mended):
            continue
        affects = rule.affects if rule is not None else {}
        if reader is None or reason(diagnostic, affects, reader).verdict is Verdict.REJECT:
            stopping.append(diagnostic)
    return stopping
