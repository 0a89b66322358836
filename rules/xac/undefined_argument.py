from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems, replace
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO
from sdfcheck_rules.xac.unreached import unless_reached


class UndefinedArgument(Rule):
    """`$(arg …)` names an argument that no `xacro:arg` declares; a similar name is declared.

    xacro stops there unless the caller gives one of that name.
    """

    code = "XAC013"
    name = "undefined-argument"
    severity = Severity.ERROR
    remedy = 'Declare it with `<xacro:arg name="…" default="…"/>`, or write the name that is declared.'
    explains = (problems.UndefinedArgument,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:arg name="prefix" default="x"/><link name="$(arg «prefx»)a"/>',
            fixed='<xacro:arg name="prefix" default="x"/><link name="$(arg prefix)a"/>',
            unsafe=True,
            file=FILE,
            says="argument `prefx` is not declared; did you mean `prefix`?",
        ),
    )
    good = (Good('<xacro:arg name="prefix" default="x"/><link name="$(arg prefix)a"/>', file=FILE),)

    def check(self, problem: problems.UndefinedArgument) -> Iterator[Diagnostic]:
        near = problem.near
        message = f"argument `{problem.name}` is not declared"
        fix = replace(problem.span, near, f"rename it to `{near}`", unsafe=True)
        own = unless_reached(is_dormant=problem.is_dormant)
        yield self.diagnostic(problem.span, message, meant=near, fix=fix, **own)
