"""The text of a finding where a build service shows it beside the line."""

from __future__ import annotations

from sdfcheck.lint.diagnostic import Diagnostic
from sdfcheck.source.visible import visible


def annotation(diagnostic: Diagnostic) -> str:
    """The message, the title of the fix and the help, one line each."""
    lines = [diagnostic.message]
    if diagnostic.fix is not None:
        lines.append(f"help: {diagnostic.fix.title} ({diagnostic.fix.applicability.value} fix)")
    if diagnostic.help:
        lines.append(f"help: {diagnostic.help}")
    return "\n".join(map(visible, lines))
