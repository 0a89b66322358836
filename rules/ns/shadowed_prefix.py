from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems


class ShadowedPrefix(Rule):
    """A prefix is bound to another name inside its own scope, or two prefixes to one name.

    XML allows both. libsdformat and Drake go by the prefix alone, so that two meanings
    of one prefix, or two spellings of one meaning, are a mistake in waiting.
    """

    code = "NS011"
    name = "shadowed-prefix"
    severity = Severity.WARNING
    explains = (problems.ShadowedPrefix, problems.SynonymousPrefix)

    bad = (
        Bad(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:kind="2d">'
            '<light name="l" type="point" «xmlns:p»="https://example.org/q" p:kind="2d"/></world></sdf>',
            says="prefix `p` gets another name inside its own scope",
        ),
        Bad(
            '<sdf version="1.12" xmlns:p="https://example.org/p" «xmlns:q»="https://example.org/p">'
            '<world name="w" p:kind="2d" q:size="3"/></sdf>',
            says="prefix `q` stands for the same namespace as `p`",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:kind="2d">'
            '<light name="l" type="point" xmlns:p="https://example.org/p" p:kind="2d"/></world></sdf>',
            why="declared again with the same name",
        ),
    )

    def check(self, problem: problems.ShadowedPrefix | problems.SynonymousPrefix) -> Iterator[Diagnostic]:
        if isinstance(problem, problems.ShadowedPrefix):
            message = f"prefix `{problem.prefix}` gets another name inside its own scope"
            yield self.diagnostic(
                problem.span, message, labels={problem.outer: "declared with another name here"}
            )
        else:
            message = f"prefix `{problem.prefix}` stands for the same namespace as `{problem.first_prefix}`"
            yield self.diagnostic(problem.span, message, labels={problem.first: "the other prefix"})
