"""Prints of rules go to stderr: stdout carries the report."""

from __future__ import annotations

import io
import sys
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout


class Aside(io.TextIOBase):
    """A stream to stderr that says once whose prints these are."""

    def __init__(self, whose: str) -> None:
        self._whose = whose
        self._is_named = False

    def write(self, text: str) -> int:
        """Write to stderr."""
        if not self._is_named and text:
            self._is_named = True
            sys.stderr.write(f"warning: {self._whose} prints; this is not part of the report:\n")
        return sys.stderr.write(text)

    def flush(self) -> None:
        """Nothing is held back."""
        sys.stderr.flush()


@contextmanager
def aside(name: str) -> Iterator[None]:
    """While this lasts, what is printed is the plugin's."""
    with redirect_stdout(Aside(f"plugin {name}")):
        yield
