from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems, replace
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class UnusualXacroNamespace(Rule):
    """The prefix `xacro` is bound to a name that is nearly the customary one.

    xacro goes by the prefix alone and takes any name; other tools may not.
    """

    code = "XAC027"
    name = "unusual-xacro-namespace"
    severity = Severity.INFO
    remedy = 'Write the customary name: `xmlns:xacro="http://www.ros.org/wiki/xacro"`.'
    explains = (problems.UnusualXacroNamespace,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<sdf version="1.12" xmlns:xacro="«http://www.ros.org/wiki/xarco»"><model name="m"><link name="base"/>'
            '<xacro:property name="w" value="1"/><link name="l${w}"/></model></sdf>',
            fixed='<sdf version="1.12" xmlns:xacro="http://www.ros.org/wiki/xacro"><model name="m"><link name="base"/>'
            '<xacro:property name="w" value="1"/><link name="l${w}"/></model></sdf>',
            file=FILE,
            scaffold="",
            says="`http://www.ros.org/wiki/xarco`; did you mean `http://www.ros.org/wiki/xacro`?",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12" xmlns:xacro="http://ros.org/wiki/xacro"><model name="m"><link name="base"/>'
            '<xacro:property name="w" value="1"/><link name="l${w}"/></model></sdf>',
            file=FILE,
            scaffold="",
        ),
    )

    def check(self, problem: problems.UnusualXacroNamespace) -> Iterator[Diagnostic]:
        assert problem.near
        message = f"prefix `xacro` is bound to `{problem.name}`"
        fix = replace(problem.span, problem.near, f"write `{problem.near}`")
        yield self.diagnostic(problem.span, message, meant=problem.near, fix=fix)
