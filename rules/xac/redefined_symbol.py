from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class RedefinedSymbol(Rule):
    """A property or parameter has the name of something that expressions know.

    From there on `pi`, `e` or `len` mean the new value, also in the files that are included. xacro
    warns: "redefining global symbol". Where the value is the same that is for information.
    """

    code = "XAC015"
    name = "redefined-symbol"
    severity = Severity.WARNING
    remedy = """Choose another name for the property.

    `pi`, `e`, `radians`, `sin`, `len` and the like are what expressions know. A property `pi` with the
    value of π can simply be removed.
    """
    explains = (problems.RedefinedSymbol,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:property name="«pi»" value="3.14"/><link name="l${pi}"/>',
            file=FILE,
            says="`pi` is known to expressions",
        ),
        Bad(
            '<xacro:property name="«pi»" value="3.1415926535897931"/><link name="l${pi}"/>',
            file=FILE,
            says="expressions know `pi` without this property",
        ),
        Bad(
            '<xacro:macro name="m" params="«len»"><link name="${len}"/></xacro:macro><xacro:m len="a"/>',
            file=FILE,
        ),
    )
    good = (
        Good('<xacro:property name="pi_half" value="${pi / 2}"/><link name="l${pi_half}"/>', file=FILE),
        Good(
            '<xacro:property name="message" value="a"/><link name="${message}"/>',
            why="known as xacro.message only",
            file=FILE,
        ),
    )

    def check(self, problem: problems.RedefinedSymbol) -> Iterator[Diagnostic]:
        if problem.near is not None:
            message = f"expressions know `{problem.name}` without this property"
            yield self.diagnostic(problem.span, message, severity=Severity.INFO, help="remove it")
            return
        message = f"`{problem.name}` is known to expressions, and means something else from here on"
        yield self.diagnostic(problem.span, message)
