from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems


class DuplicateAttribute(Rule):
    """An element has the same attribute twice.

    XML forbids it, and every consumer refuses the file: which of the two values should
    count, nobody can know.
    """

    code = "XML003"
    name = "duplicate-attribute"
    severity = Severity.ERROR
    remedy = """Remove one of the two attributes.

    Keep the value that is meant; if both are, one of them has the wrong name.
    """
    explains = (problems.RepeatedAttribute,)

    bad = (
        Bad(
            '<sdf version="1.12"><model name="m"><link name="a" «name»="b"/></model></sdf>',
            says="attribute `name` is given twice",
        ),
        Bad('<robot name="r" «name»="r"><link name="l"/></robot>', says="given twice"),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:name="v"/></sdf>',
            why="a prefix makes it another attribute",
        ),
        Good('<robot name="r"><link name="l"/></robot>'),
    )

    def check(self, problem: problems.RepeatedAttribute) -> Iterator[Diagnostic]:
        message = f"attribute `{problem.span.text}` is given twice"
        yield self.diagnostic(problem.span, message, labels={problem.first: "first given here"})
