from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Edit, Good, Rule, Severity, edit, problems


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
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:p="https://example.org/p"><world name="w" p:kind="2d"/></sdf>',
            why="an attribute uses it",
        ),
    )

    def check(self, problem: problems.UnusedPrefix) -> Iterator[Diagnostic]:
        fix = edit("remove the declaration", (Edit(problem.whole, ""),))
        yield self.diagnostic(problem.span, f"prefix `{problem.prefix}` is declared and not used", fix=fix)
