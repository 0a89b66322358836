from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems, replace
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class PrefixedMacroName(Rule):
    """The name of a macro begins with `xacro:`.

    The prefix belongs to the call. xacro drops it from the name, and warns.
    """

    code = "XAC016"
    name = "prefixed-macro-name"
    severity = Severity.WARNING
    remedy = """Remove the prefix from the name: `<xacro:macro name="leg" …>`, called as `<xacro:leg …/>`.
    """
    explains = (problems.PrefixedMacroName,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:macro name="«xacro:leg»" params=""><link name="a"/></xacro:macro><xacro:leg/>',
            fixed='<xacro:macro name="leg" params=""><link name="a"/></xacro:macro><xacro:leg/>',
            file=FILE,
            says="the name of macro `leg` has the prefix",
        ),
    )
    good = (Good('<xacro:macro name="leg" params=""><link name="a"/></xacro:macro><xacro:leg/>', file=FILE),)

    def check(self, problem: problems.PrefixedMacroName) -> Iterator[Diagnostic]:
        fix = replace(problem.span, problem.name, "remove the prefix")
        yield self.diagnostic(
            problem.span, f"the name of macro `{problem.name}` has the prefix `xacro:`", fix=fix
        )
