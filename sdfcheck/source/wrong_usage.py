"""The exception for what a person has to change before anything can run."""

from __future__ import annotations

REPORT_IT = "this is a bug in sdfcheck, please report it with the file and what SDFCHECK_DEBUG=1 shows"


class WrongUsage(Exception):
    """A run cannot start: a path is missing, a configuration or an option is wrong (exit code 2).

    The message is one line that says what, and where it helps, what to write instead.
    """
