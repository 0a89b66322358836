"""Which errors stop a conversion: those for which the format's own reader refuses the file.

The own reader is urdfdom for URDF and xacro, libsdformat (Gazebo's) for SDFormat. What it
refuses is no robot yet, and a converter would have to guess which one was meant. What it
reads is one, whatever else is wrong with it: a mesh that is not there, an inertia
that no body has, something that another reader cannot do.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sdfcheck.consumers.reaction import Consumer, Verdict
from sdfcheck.lint.diagnostic import Diagnostic, Severity
from sdfcheck.source.sniff import Kind

OWN_READER: Mapping[Kind, Consumer] = {
    Kind.SDF: Consumer.GAZEBO,
    Kind.URDF: Consumer.URDFDOM,
    Kind.XACRO: Consumer.URDFDOM,
}


def obstacles(
    found: Iterable[Diagnostic], kind: Kind, elsewhere: frozenset[str] = frozenset()
) -> list[Diagnostic]:
    """The errors among ``found`` that stop a conversion from a kind of file.

    Those of the families ``elsewhere`` do not: they are about other files.
    """
    reader = OWN_READER.get(kind)
    return [
        diagnostic
        for diagnostic in found
        if diagnostic.severity is Severity.ERROR
        and diagnostic.code.rstrip("0123456789") not in elsewhere
        and (reader is None or _refused(diagnostic, reader))
    ]


def _refused(diagnostic: Diagnostic, reader: Consumer) -> bool:
    reaction = dict(diagnostic.affects).get(reader.value)
    return reaction is not None and reaction.verdict is Verdict.REJECT
