from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO

ARGUMENT = '<xacro:arg name="sim" default="true"/>'


class NeverEqualText(Rule):
    """An argument is compared with a text that differs from its default in capitals only.

    Arguments are texts, and texts are compared letter by letter: `'true' == 'True'` is false. Write
    `${xacro.arg('sim') == 'true'}`, or `value="$(arg sim)"` alone.
    """

    code = "XAC025"
    name = "never-equal-text"
    severity = Severity.WARNING
    explains = (problems.NeverEqualText,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            ARGUMENT + """<xacro:if value="${«'$(arg sim)' == 'True'»}"><link name="a"/></xacro:if>""",
            file=FILE,
            says="`true` is not `True`",
        ),
    )
    good = (
        Good(
            ARGUMENT + """<xacro:if value="${'$(arg sim)' == 'true'}"><link name="a"/></xacro:if>""",
            file=FILE,
        ),
    )

    def check(self, problem: problems.NeverEqualText) -> Iterator[Diagnostic]:
        labels = {problem.other: "its default"} if problem.other else None
        message = f"`{problem.near}` is not `{problem.name}`: texts are compared letter by letter"
        yield self.diagnostic(problem.span, message, labels=labels)
