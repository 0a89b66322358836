from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class OverwrittenParameter(Rule):
    """A property in a macro replaces the parameter of the same name.

    The value that a call gives has no effect: nothing reads it before the property replaces it.
    """

    code = "XAC020"
    name = "overwritten-parameter"
    severity = Severity.WARNING
    remedy = """Rename the property, or remove the parameter.

    A default is written in the parameters instead: `params="side:=left"`.
    """
    explains = (problems.OverwrittenParameter,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:macro name="m" params="side"><xacro:property name="«side»" value="q"/><link name="${side}"/>'
            '</xacro:macro><xacro:m side="l"/>',
            file=FILE,
            says="property `side` replaces the parameter of that name before anything reads it",
        ),
    )
    good = (
        Good(
            '<xacro:macro name="m" params="side:=^"><xacro:property name="other" value="${side}"/>'
            '<link name="${other}"/></xacro:macro><xacro:property name="side" value="q"/><xacro:m/>',
            file=FILE,
        ),
    )

    def check(self, problem: problems.OverwrittenParameter) -> Iterator[Diagnostic]:
        labels = {problem.other: "the parameter"} if problem.other else None
        message = f"property `{problem.name}` replaces the parameter of that name before anything reads it"
        yield self.diagnostic(problem.span, message, labels=labels)
