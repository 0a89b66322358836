from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Edit, Good, Rule, Severity, make_fix, named, problems


class UnusedPrefix(Rule):
    """A prefix is declared and not used.

    It does no harm, but says that the file holds something that it does not.
    """

    code = "NS007"
    name = "unused-prefix"
    severity = Severity.INFO
    explains = (problems.UnusedPrefix,)

    bad = (
        Bad(
            '<sdf version="1.12" «xmlns:p»="https://example.org/p"><world name="w"/></sdf>',
            fixed='<sdf version="1.12"><world name="w"/></sdf>',
            says="prefix `p` is declared and not used",
        ),
        Bad(
            '<robot name="r" «xmlns:xacro»="http://www.ros.org/wiki/xacro"><link name="l"/></robot>',
            fixed='<robot name="r"><link name="l"/></robot>',
        ),
        Bad(
            '<robot name="r" «xmlns:controller»="https://example.org/c" xmlns:sensor="https://example.org/s"'
            ' xmlns:interface="https://example.org/i"><link name="l"/></robot>',
            fixed='<robot name="r"><link name="l"/></robot>',
            says="prefixes `controller`, `sensor` and `interface` are declared and not used",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:kind="2d"/></sdf>',
            why="an attribute uses it",
        ),
    )

    def check(self, problem: problems.UnusedPrefix) -> Iterator[Diagnostic]:
        removed = tuple(Edit(whole, "") for whole in problem.wholes)
        if len(removed) == 1:
            what, cure = f"prefix {named(problem.prefixes, most=5)} is", "remove the declaration"
        else:
            what, cure = f"prefixes {named(problem.prefixes, most=5)} are", "remove the declarations"
        yield self.diagnostic(problem.span, f"{what} declared and not used", fix=make_fix(cure, removed))
