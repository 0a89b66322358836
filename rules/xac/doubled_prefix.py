from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems, replace
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO

MACRO = '<xacro:macro name="arm" params="prefix"><link name="{}tip"/></xacro:macro><xacro:arm prefix=""/>'


class DoubledPrefix(Rule):
    """A name has the same prefix twice.

    Without a prefix it is right, and nobody sees it. With one the name is that of nothing else.
    """

    code = "XAC030"
    name = "doubled-prefix"
    severity = Severity.WARNING
    remedy = """Write the prefix once.

    To see such mistakes, expand the file with a prefix: `sdfcheck expand FILE prefix:=left_`.
    """
    explains = (problems.DoubledPrefix,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            MACRO.replace("{}", "«${prefix}${prefix}»"),
            fixed=MACRO.replace("{}", "${prefix}"),
            unsafe=True,
            file=FILE,
            says="the name has `${prefix}` twice",
        ),
    )
    good = (
        Good(MACRO.replace("{}", "${prefix}"), file=FILE),
        Good(MACRO.replace("{}", "${prefix}to_${prefix}"), why="a name for a pair", file=FILE),
    )

    def check(self, problem: problems.DoubledPrefix) -> Iterator[Diagnostic]:
        once = f"${{{problem.name}}}"
        fix = replace(problem.span, once, f"write `{once}` once", unsafe=True)
        yield self.diagnostic(problem.span, f"the name has `{once}` twice", fix=fix)
