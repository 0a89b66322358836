from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, TextEdit, make_fix, problems, used
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class UndeclaredXacroPrefix(Rule):
    """``xacro:`` is used, and the file does not declare the prefix.

    xacro reads with a namespace-aware parser, which stops at an unbound prefix. Which
    name the prefix is bound to does not matter; the one from the ROS wiki is customary.
    An included file needs a declaration of its own.
    """

    code = "XAC002"
    name = "undeclared-xacro-prefix"
    severity = Severity.ERROR
    remedy = """Declare it on the root element: `xmlns:xacro="http://www.ros.org/wiki/xacro"`.

    Each file needs it, included ones as well.
    """
    explains = (problems.UndeclaredXacroPrefix,)

    bad = (
        Bad(
            '<sdf version="1.12"><model name="m">'
            '<«xacro»:property name="w" value="1"/><link name="l${w}"/></model></sdf>',
            fixed='<sdf version="1.12" xmlns:xacro="http://www.ros.org/wiki/xacro"><model name="m">'
            '<xacro:property name="w" value="1"/><link name="l${w}"/></model></sdf>',
            file=FILE,
        ),
    )
    good = (
        Good(IN_XACRO.replace("{}", '<xacro:property name="w" value="1"/><link name="l${w}"/>'), file=FILE),
        Good(
            '<sdf version="1.12"><model name="m"><link name="l"/></model></sdf>',
            why="nothing of xacro is used",
            file=FILE,
        ),
    )

    def check(self, problem: problems.UndeclaredXacroPrefix) -> Iterator[Diagnostic]:
        declaration = TextEdit(problem.insertion, ' xmlns:xacro="http://www.ros.org/wiki/xacro"')
        yield self.diagnostic(
            problem.span,
            f"prefix `xacro` is not declared{used(problem.count)}",
            labels={problem.insertion: "a declaration belongs here"},
            fix=make_fix("declare it on the root element", (declaration,)),
        )
