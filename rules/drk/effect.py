"""How to say what Drake does."""

from typing import Any

from sdfcheck import Consumer, Reaction, Severity, by_effect

_WORDS = {
    "error": "Drake refuses the file",
    "abort": "Drake aborts",
    "crash": "Drake crashes",
    "ignored": "Drake ignores it",
}


def consequence(effect: Any) -> str:
    """What Drake does, as the second half of a sentence."""
    return _WORDS[effect.outcome.value]


def affects(effect: Any) -> dict[Consumer, Reaction]:
    """The same, for a verdict on the file."""
    return {Consumer.DRAKE: by_effect(effect)}


def severity(effect: Any) -> Severity:
    """An error where Drake does not get to the end of the file, otherwise a warning."""
    return Severity.ERROR if effect.refused else Severity.WARNING
