"""``--baseline`` of ``sdfcheck lint``."""

from __future__ import annotations

from pathlib import Path

from sdfcheck.cli.parts.output import deliver
from sdfcheck.cli.parts.terminal import say
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Level, Notice, Notify
from sdfcheck.lint.suppress.baseline import hold, read, render
from sdfcheck.lint.wording import counted


def write(done: Run, path: Path, *, quiet: bool) -> int:
    """Write a baseline; returns the exit code."""
    deliver(render(done, path), path)
    if not quiet:
        say(f"{path} holds {counted(len(done.diagnostics), 'finding')}.")
    return 0


def without_known(done: Run, path: Path, notify: Notify) -> Run:
    """The run without what the baseline knows."""
    held = hold(done, read(path), path)
    if held.gone:
        verb, them = ("is", "it") if held.gone == 1 else ("are", "them")
        known = counted(held.gone, "finding")
        notify(Notice(Level.NOTE, f"{known} of {path} {verb} gone; --write-baseline forgets {them}"))
    return held.run
