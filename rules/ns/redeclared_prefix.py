from collections.abc import Iterator

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems


class RedeclaredPrefix(Rule):
    """One element declares the same prefix twice.

    This breaks the uniqueness rule of "Namespaces in XML", which the custom-elements
    proposal asks to comply with. It is an attribute given twice as well, for which
    every reader refuses the file.
    """

    code = "NS004"
    name = "redeclared-prefix"
    severity = Severity.ERROR
    affects = dict.fromkeys(Consumer, REFUSES)
    explains = (problems.RedeclaredPrefix,)

    bad = (
        Bad(
            '<sdf version="1.12">'
            '<model name="m" xmlns:p="https://example.org/p" «xmlns:p»="https://example.org/q">'
            '<link name="l" p:colour="red"/></model></sdf>',
            says="prefix `p` is declared twice",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12"><world name="w">'
            '<light name="a" type="point" xmlns:p="https://example.org/p" p:kind="1"/>'
            '<light name="b" type="point" xmlns:p="https://example.org/p" p:kind="2"/></world></sdf>',
            why="on two elements, with scopes of their own",
        ),
    )

    def check(self, problem: problems.RedeclaredPrefix) -> Iterator[Diagnostic]:
        message = f"prefix `{problem.prefix}` is declared twice on one element"
        yield self.diagnostic(problem.span, message, labels={problem.first: "first declared here"})
