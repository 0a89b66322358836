from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class UnusedArgument(Rule):
    """An argument is declared and nothing asks for it.

    Passing it has no effect. Reported for robots of which every included file is known.
    """

    code = "XAC021"
    name = "unused-argument"
    severity = Severity.INFO
    remedy = """Remove the argument, or read it: `$(arg speed)`.

    Launch files that give it have to change with it.
    """
    explains = (problems.UnusedArgument,)
    scaffold = IN_XACRO

    bad = (
        Bad('<xacro:arg name="«speed»" default="1"/>', file=FILE, says="argument `speed` is never asked for"),
    )
    good = (
        Good('<xacro:arg name="prefix" default="x"/><link name="$(arg prefix)a"/>', file=FILE),
        Good("""<xacro:arg name="k" default="x"/><link name="${xacro.arg('k')}"/>""", file=FILE),
    )

    def check(self, problem: problems.UnusedArgument) -> Iterator[Diagnostic]:
        yield self.diagnostic(problem.span, f"argument `{problem.name}` is never asked for")
