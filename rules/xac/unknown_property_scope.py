from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class UnknownPropertyScope(Rule):
    """The scope of a property is neither `global` nor `parent`.

    xacro takes any other word for the scope that the property is in, so that it is gone at the end of
    the macro.
    """

    code = "XAC023"
    name = "unknown-property-scope"
    severity = Severity.WARNING
    remedy = """Write `scope="parent"` or `scope="global"`, or leave `scope` out.

    `parent` is the macro or file that called, `global` everything.
    """
    explains = (problems.UnknownPropertyScope,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:macro name="m" params=""><xacro:property name="k" value="1" scope="«golbal»"/>'
            '<link name="l${k}"/></xacro:macro><xacro:m/>',
            fixed='<xacro:macro name="m" params=""><xacro:property name="k" value="1" scope="global"/>'
            '<link name="l${k}"/></xacro:macro><xacro:m/>',
            unsafe=True,
            file=FILE,
            says="unknown scope `golbal`; did you mean `global`?",
        ),
    )
    good = (
        Good(
            '<xacro:macro name="m" params=""><xacro:property name="k" value="1" scope="global"/></xacro:macro>'
            '<xacro:m/><link name="l${k}"/>',
            file=FILE,
        ),
    )

    def check(self, problem: problems.UnknownPropertyScope) -> Iterator[Diagnostic]:
        near = problem.near
        rest = "" if near else "; it is `global` or `parent`"
        yield self.diagnostic(problem.span, f"unknown scope `{problem.name}`{rest}", meant=near)
