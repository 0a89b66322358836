"""The line that closes a run, and how much of the run is shown."""

from __future__ import annotations

from collections.abc import Iterable

from sdfcheck.files.discover import FAULTY
from sdfcheck.lint.diagnostic import Diagnostic, Severity, counted, listed
from sdfcheck.lint.run import Run
from sdfcheck.source.record import NamedTuple


class View(NamedTuple):
    """How much of a run the text formats show; the other formats always show all of it.

    ``least``: what is less severe is only counted. ``folds``: repeated findings are shown
    once, and those about this computer together. ``most``: so many are shown at most.
    ``width``: the cells of the terminal that shows them, if one does; ``links``: it knows
    links, and the codes of rules lead to their pages.
    """

    least: Severity = Severity.INFO
    folds: bool = False
    most: int | None = None
    width: int | None = None
    links: bool = False

    def singles(self, run: Run) -> list[Diagnostic]:
        """The findings of a run, but for those that are shown together."""
        return [each for each in run.diagnostics if not (self.folds and each.missing is not None)]

    def shown(self, run: Run) -> list[Diagnostic]:
        """Those of them that are severe enough to be shown."""
        return [each for each in self.singles(run) if each.severity >= self.least]

    def missing(self, run: Run) -> list[Diagnostic]:
        """The findings about this computer, if they are shown together."""
        return [each for each in run.diagnostics if self.folds and each.missing is not None]


EVERYTHING = View()


def closing_line(run: Run, view: View = EVERYTHING) -> str:
    """One line that sums a run up."""
    fixed = f"Fixed {_of_all(run, view)}. " if run.fixed else ""
    files = counted(len(run.files), "file")
    if run.diagnostics:
        kinds = (Severity.ERROR, Severity.WARNING, Severity.INFO)
        singles = view.singles(run)
        numbers = {kind: sum(each.severity is kind for each in singles) for kind in kinds}
        counts = [counted(number, kind.value) for kind, number in numbers.items() if number]
        if not counts:
            return f"{fixed}Nothing else found in {files}."
        hidden = any(number and not kind >= view.least for kind, number in numbers.items())
        unseen = [f"infos are shown with --min-severity {Severity.INFO.value}"] if hidden else []
        if faulty := sum(reason == FAULTY for _, reason in run.skipped):
            unseen.append(f"{counted(faulty, 'test')} of faulty files left out")
        return f"{fixed}Found {listed(counts)} in {files}{_in_brackets([*_fixes(run), *unseen])}."
    # Only a clean result can be mistaken for more than was looked at.
    unseen = [counted(len(run.skipped), "file") + " skipped"] if run.skipped else []
    if not run.files:
        return f"{fixed}No files to lint{_in_brackets(unseen)}."
    if run.suppressed:
        unseen.insert(0, f"{run.suppressed} suppressed")
    return f"{fixed}All clear: {files}, no findings{_in_brackets(unseen)}."


def _fixes(run: Run) -> list[str]:
    safe = run.fixable
    unsafe = sum(diagnostic.fix is not None for diagnostic in run.diagnostics) - safe
    if not safe:
        return [f"{unsafe} fixable with --fix --unsafe-fixes"] if unsafe else []
    more = [f"{unsafe} more with --unsafe-fixes"] if unsafe else []
    return [f"{safe} fixable with --fix", *more]


def _of_all(run: Run, view: View) -> str:
    """How many findings were fixed, and of how many where some are left."""
    everything = run.fixed + len(view.singles(run))
    return (f"{run.fixed} of " if run.diagnostics else "") + counted(everything, "finding")


def _in_brackets(parts: Iterable[str]) -> str:
    inside = ", ".join(parts)
    return f" ({inside})" if inside else ""
