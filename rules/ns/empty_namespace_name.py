from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns


class EmptyNamespaceName(Rule):
    """A prefix is declared with an empty name.

    "Namespaces in XML 1.0" forbids it for a prefix. libsdformat does not look at the
    name; namespace-aware XML parsers refuse the file.
    """

    code = "NS012"
    name = "empty-namespace-name"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: warns("older versions refuse the file")}
    explains = (problems.EmptyNamespaceName,)

    bad = (
        Bad(
            '<sdf version="1.12" «xmlns:p»=""><world name="w" p:kind="2d"/></sdf>',
            says="prefix `p` is declared with an empty name",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="p"><world name="w" p:kind="2d"/></sdf>',
            why="any text is a name, though a URI is customary",
        ),
    )

    def check(self, problem: problems.EmptyNamespaceName) -> Iterator[Diagnostic]:
        message = f"prefix `{problem.prefix}` is declared with an empty name"
        advice = "customary is a URI that you control"
        yield self.diagnostic(problem.span, message, help=advice)
