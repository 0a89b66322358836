from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems, replace
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO

HAND = '<xacro:arg name="side" default=""/><xacro:macro name="hand" params="side"><link name="{}tcp"/></xacro:macro>'


class ArgumentForParameter(Rule):
    """A macro reads an argument of the file where it has a parameter of the same name.

    `$(arg side)` is the argument that the whole file was given, whatever the call of the macro says; its parameter is
    `${side}`. Two calls then define the same names, or the parameter has no effect. Where all calls give the parameter
    this very argument, both are the same; that is reported only if the macro reads the parameter in another place.
    """

    code = "XAC028"
    name = "argument-for-parameter"
    severity = Severity.WARNING
    remedy = """Read the parameter: `${side}`.

    `$(arg side)` is right outside of the macro, in its call: `<xacro:leg side="$(arg side)"/>`.
    """
    explains = (problems.ArgumentForParameter,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            HAND.replace("{}", "«$(arg side)»") + '<xacro:hand side="left_"/>',
            fixed=HAND.replace("{}", "${side}") + '<xacro:hand side="left_"/>',
            unsafe=True,
            file=FILE,
            says="`$(arg side)` is the argument of the file, not the parameter `side` of the macro",
        ),
        Bad(
            HAND.replace("{}tcp", '${side}palm"/><link name="«$(arg side)»tcp')
            + '<xacro:hand side="$(arg side)"/>',
            fixed=HAND.replace("{}tcp", '${side}palm"/><link name="${side}tcp')
            + '<xacro:hand side="$(arg side)"/>',
            unsafe=True,
            file=FILE,
        ),
    )
    good = (
        Good(HAND.replace("{}", "${side}") + '<xacro:hand side="left_"/>', file=FILE),
        Good(
            '<xacro:arg name="kind" default="a"/><xacro:macro name="hand" params="side:=x">'
            '<link name="${side}$(arg kind)"/></xacro:macro><xacro:hand/>',
            why="no parameter has the name",
            file=FILE,
        ),
        Good(
            HAND.replace("{}", "$(arg side)") + '<xacro:hand side="$(arg side)"/>',
            why="the call gives that argument",
            file=FILE,
        ),
    )

    def check(self, problem: problems.ArgumentForParameter) -> Iterator[Diagnostic]:
        name = problem.name
        message = f"`$(arg {name})` is the argument of the file, not the parameter `{name}` of the macro"
        labels = {problem.other: "the parameter"} if problem.other else None
        fix = replace(problem.span, f"${{{name}}}", f"write `${{{name}}}`", unsafe=True)
        yield self.diagnostic(problem.span, message, labels=labels, fix=fix)
