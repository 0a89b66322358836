"""Notices of a run, kept until it is over."""

from __future__ import annotations

from sdfcheck.cli.parts.terminal import say
from sdfcheck.lint.session import Level, Notice


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
