"""The exceptions of the library: for what a person has to change, and for a description that cannot be understood."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from sdfcheck.source.document import Element


# The exception for what a person has to change before anything can run.

REPORT_IT = "this is a bug in sdfcheck, please report it with the file and what SDFCHECK_DEBUG=1 shows"


class WrongUsage(Exception):
    """A run cannot start: a path is missing, a configuration or an option is wrong (exit code 2).

    The message is one line that says what, and where it helps, what to write instead.
    """


# Errors that keep a description from being understood.


class DescriptionError(ValueError):
    """A description from which something cannot be worked out; ``element`` is where."""

    def __init__(self, message: str, element: Element) -> None:
        super().__init__(message)
        self.element = element
