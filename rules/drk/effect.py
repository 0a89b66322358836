"""What Drake does about something, as a reaction and in words."""

from sdfcheck import Consumer, Reaction, Severity, Value, Verdict, ignores, refuses

ABORTS = refuses("aborts")
CRASHES = refuses("crashes")
IGNORES = ignores("it")


def does(reaction: Reaction) -> str:
    """What Drake does, as the second half of a sentence."""
    return f"Drake {reaction.words}"


def affects(reaction: Reaction) -> dict[Consumer, Reaction]:
    """The same, for a verdict on the file."""
    return {Consumer.DRAKE: reaction}


def severity(reaction: Reaction) -> Severity:
    """An error where Drake does not get to the end of the file, otherwise a warning."""
    return Severity.ERROR if reaction.verdict is Verdict.REJECT else Severity.WARNING


def above(name: str, low: Value, high: Value) -> str:
    """That a value of Drake's is above another that it must not exceed."""
    return f"`{name}` is {low.text.strip()} and above `{high.element.name}`, {high.text.strip()}"
