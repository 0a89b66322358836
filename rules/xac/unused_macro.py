from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class UnusedMacro(Rule):
    """A robot defines a macro and nothing calls it.

    Its content is not in the robot. Macros of libraries are for the files that include them and
    are not reported.
    """

    code = "XAC022"
    name = "unused-macro"
    severity = Severity.INFO
    remedy = """Call the macro, or remove it.

    A macro for other files belongs in a file of its own, without the `<robot>` that is built.
    """
    explains = (problems.UnusedMacro,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:macro name="«leg»" params=""><link name="a"/></xacro:macro>',
            file=FILE,
            says="macro `leg` is never called",
        ),
    )
    good = (
        Good('<xacro:macro name="leg" params=""><link name="a"/></xacro:macro><xacro:leg/>', file=FILE),
        Good(
            '<xacro:macro name="leg" params=""><link name="a"/></xacro:macro><xacro:call macro="leg"/>',
            file=FILE,
        ),
    )

    def check(self, problem: problems.UnusedMacro) -> Iterator[Diagnostic]:
        yield self.diagnostic(problem.span, f"macro `{problem.name}` is never called")
