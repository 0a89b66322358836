"""How to speak of names that are not defined."""

from sdfcheck import Diagnostic, Fix, Origin, Rule, problems, used, write_instead
from sdfcheck_rules.xac.unreached import unless_reached

SHOWN = 3
"""Other uses that are pointed at."""


def report(rule: Rule, problem: problems.UndefinedName, what: str) -> Diagnostic:
    """One diagnostic at the first use, with others beside it."""
    reason = problem.reason
    guess = f"; did you mean `{problem.near}`?" if problem.near else ""
    if reason is not None:
        guess = f": {reason.words}"
    here = " here" if reason is not None and reason.place is not None else ""
    labels = dict.fromkeys(problem.others[:SHOWN], "also here")
    if reason is not None and reason.place is not None:
        labels[reason.place] = reason.label
    return rule.diagnostic(
        problem.span,
        f"{what} `{problem.name}` is not defined{here}{used(1 + len(problem.others))}{guess}",
        labels=labels,
        fix=_fix(problem),
        origins=tuple(Origin(*step) for step in problem.origins),
        cause=None if reason is None else reason.cause,
        **unless_reached(is_dormant=problem.is_dormant, help=None if reason is None else reason.help),
    )


def _fix(problem: problems.UndefinedName) -> Fix | None:
    """The name that was meant at all uses, where all of them are written in this file as they are."""
    places = (problem.span, *problem.others, *problem.ends)
    is_literal = all(place.source is problem.span.source and place.text == problem.name for place in places)
    return write_instead(problem.near, *places) if is_literal else None
