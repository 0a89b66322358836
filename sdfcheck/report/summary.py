"""The closing line of the text formats."""

from __future__ import annotations

from collections.abc import Iterable

from sdfcheck.lint.diagnostic import Severity
from sdfcheck.lint.run import Run
from sdfcheck.lint.wording import counted, listed


def closing_line(run: Run) -> str:
    """One line that sums a run up."""
    fixed = f"Fixed {_of_all(run)}. " if run.fixed else ""
    files = counted(len(run.files), "file")
    if run.diagnostics:
        kinds = (Severity.ERROR, Severity.WARNING, Severity.INFO)
        counts = [counted(run.count(kind), kind.value) for kind in kinds if run.count(kind)]
        return f"{fixed}Found {listed(counts)} in {files}{_fixes(run)}."
    # Only a clean result can be mistaken for more than was looked at.
    unseen = [counted(len(run.skipped), "file") + " skipped"] if run.skipped else []
    if not run.files:
        return f"{fixed}No files to lint{_in_brackets(unseen)}."
    if run.suppressed:
        unseen.insert(0, f"{run.suppressed} suppressed")
    return f"{fixed}All clear: {files}, no findings{_in_brackets(unseen)}."


def _fixes(run: Run) -> str:
    safe = run.fixable
    unsafe = sum(diagnostic.fix is not None for diagnostic in run.diagnostics) - safe
    if not safe:
        return _in_brackets([f"{unsafe} fixable with --fix --unsafe-fixes"] if unsafe else [])
    more = [f"{unsafe} more with --unsafe-fixes"] if unsafe else []
    return _in_brackets([f"{safe} fixable with --fix", *more])


def _of_all(run: Run) -> str:
    """How many findings were fixed, and of how many where some are left."""
    everything = run.fixed + len(run.diagnostics)
    return (f"{run.fixed} of " if run.diagnostics else "") + counted(everything, "finding")


def _in_brackets(parts: Iterable[str]) -> str:
    inside = ", ".join(parts)
    return f" ({inside})" if inside else ""
