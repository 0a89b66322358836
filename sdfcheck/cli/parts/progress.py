"""Beside the report: notices of a run, and how far it has come, in one line of a terminal."""

from __future__ import annotations

import time
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from sdfcheck.cli.parts.terminal import say
from sdfcheck.lint.session import Level, Notice
from sdfcheck.source.visible import visible

if TYPE_CHECKING:
    from rich.progress import Progress as Bar


_BAR = 12


class Notifier:
    """Says notices on stderr when the run is over, so that they do not mix with its progress."""

    def __init__(self, *, quiet: bool) -> None:
        self.failed = False
        self._quiet = quiet
        self._lines: list[str] = []

    def __call__(self, notice: Notice) -> None:
        self.failed |= notice.level is Level.FAILURE
        line = f"{notice.level.value}: {notice.text}"
        # Linting again reports the same again.
        if line not in self._lines and (notice.level is Level.FAILURE or not self._quiet):
            self._lines.append(line)

    def flush(self) -> bool:
        """Write the notices; was one of them a failure?"""
        for line in self._lines:
            say(line)
        self._lines.clear()
        return self.failed


class Progress:
    """Shows a bar once a run takes noticeably long: files, files a second, the time that is left."""

    DELAY = 1.0
    INTERVAL = 0.1

    def __init__(self, stream: TextIO, width: int | None = None) -> None:
        self._stream = stream
        self._width = width
        self._next = time.monotonic() + self.DELAY
        self._bar: Bar | None = None

    def __call__(self, done: int, total: int, path: Path) -> None:
        now = time.monotonic()
        if now < self._next:
            return
        self._next = now + self.INTERVAL
        if self._bar is None:
            self._bar = _bar(self._stream, self._width)
            self._bar.add_task("", total=total, file="")
            self._bar.start()
        self._bar.update(self._bar.task_ids[0], completed=done, total=total, file=visible(str(path)))
        self._bar.refresh()

    def clear(self) -> None:
        """Remove the line."""
        if self._bar is not None:
            self._bar.stop()
            self._bar = None


def _bar(stream: TextIO, width: int | None) -> Bar:
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        ProgressColumn,
        Task,
        TextColumn,
        TimeRemainingColumn,
    )
    from rich.progress import Progress as Drawn
    from rich.table import Column
    from rich.text import Text

    class Rate(ProgressColumn):
        def render(self, task: Task) -> Text:
            return Text(f"{task.speed:.0f} files/s" if task.speed else "")

    console = Console(file=stream, force_terminal=True, width=width, highlight=False)
    return Drawn(
        BarColumn(bar_width=_BAR),
        MofNCompleteColumn(table_column=Column(no_wrap=True)),
        Rate(table_column=Column(no_wrap=True)),
        TimeRemainingColumn(table_column=Column(no_wrap=True)),
        TextColumn(
            "{task.fields[file]}",
            markup=False,
            table_column=Column(no_wrap=True, overflow="ellipsis", ratio=1),
        ),
        console=console,
        auto_refresh=False,
        transient=True,
        expand=True,
        get_time=time.monotonic,
    )
