"""How to speak of names that are not defined."""

from sdfcheck import Diagnostic, Origin, Rule, problems, used
from sdfcheck_rules.xac.unreached import unless_reached

SHOWN = 3
"""Other uses that are pointed at."""


def report(rule: Rule, problem: problems.UndefinedName, what: str) -> Diagnostic:
    """One diagnostic at the first use, with others beside it."""
    guess = f"; did you mean `{problem.near}`?" if problem.near else ""
    return rule.diagnostic(
        problem.span,
        f"{what} `{problem.name}` is not defined{used(1 + len(problem.others))}{guess}",
        labels=dict.fromkeys(problem.others[:SHOWN], "also here"),
        origins=tuple(Origin(*step) for step in problem.origins),
        **unless_reached(is_dormant=problem.is_dormant),
    )
