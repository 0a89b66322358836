"""How to say what Drake does."""

from typing import Any

from sdfcheck import Severity

_WORDS = {
    "error": "Drake refuses the file",
    "abort": "Drake aborts",
    "crash": "Drake crashes",
    "ignored": "Drake ignores it",
}


def consequence(effect: Any) -> str:
    """What Drake does, as the second half of a sentence."""
    return _WORDS[effect.outcome.value]


def severity(effect: Any) -> Severity:
    """An error where Drake does not get to the end of the file, otherwise a warning."""
    return Severity.ERROR if effect.refused else Severity.WARNING
