"""How to speak of what is newer than the version that a file declares."""

from sdfcheck import Diagnostic, Rule, Span, problems, replace, used

SHOWN = 3
"""Other uses that are pointed at."""


def report(
    rule: Rule, problem: problems.TooNewElement | problems.TooNewAttribute, name: str, uses: tuple[Span, ...]
) -> Diagnostic:
    """One diagnostic at the first use, with the others and the declaration beside it."""
    since, declaration = problem.since, problem.declaration
    return rule.diagnostic(
        uses[0],
        f"`{name}`{used(len(uses))} came with version {since}, and the file declares {declaration.text}",
        labels={declaration: "declared here", **dict.fromkeys(uses[1 : SHOWN + 1], "also here")},
        fix=replace(declaration, str(since), f"declare version {since}", unsafe=True),
    )
