"""The exception for what a person has to change before anything can run."""

from __future__ import annotations

REPORT_IT = "this is a bug in sdfcheck, please report it with the file and what SDFCHECK_DEBUG=1 shows"


class WrongUsage(Exception):
    """A run cannot start: a path is missing, a configuration or an option is wrong (exit code 2).

    The message is one line that says what, and where it helps, what to write instead.
    """


def suggestion(word: str, choices: tuple[str, ...]) -> str:
    """``, did you mean `x`?`` for the nearest choice, or nothing."""
    near = nearest_choice(word, choices)
    return f", did you mean `{near}`?" if near else ""


def nearest_choice(word: str, choices: tuple[str, ...]) -> str | None:
    """The choice that looks most like a word, if one does."""
    import difflib

    by_fold = {choice.casefold(): choice for choice in choices}
    near = difflib.get_close_matches(word.casefold(), by_fold, n=1)
    return by_fold[near[0]] if near else None
