from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Origin, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class XacroIncludeCycle(Rule):
    """A xacro file includes itself, directly or by way of others.

    xacro has no guard against this and stops when its stack is full. Including one
    file several times is fine; an include inside ``xacro:if`` may end.
    """

    code = "XAC006"
    name = "xacro-include-cycle"
    severity = Severity.ERROR
    remedy = """Remove the include that leads back, or put what both files need into a third one.

    The notes show the way around. An include that is conditional by `xacro:if` may end.
    """
    explains = (problems.XacroIncludeCycle,)
    scaffold = IN_XACRO

    bad = (Bad('<xacro:include filename="«robot.sdf.xacro»"/>', file=FILE, says="includes itself"),)
    good = (
        Good(
            '<xacro:if value="false"><xacro:include filename="robot.sdf.xacro"/></xacro:if>',
            why="the condition ends it",
            file=FILE,
        ),
    )

    def check(self, problem: problems.XacroIncludeCycle) -> Iterator[Diagnostic]:
        labels = dict.fromkeys(problem.steps[1:], "which includes this")
        yield self.diagnostic(
            problem.span,
            f"including `{problem.name}` here leads back: the file includes itself",
            labels=labels,
            origins=tuple(Origin(*step) for step in problem.origins),
        )
