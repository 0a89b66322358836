from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class UnusedMacroParameter(Rule):
    """A macro takes a parameter that its body does not read.

    Callers give it a value to no effect; often the body has a literal where the
    parameter was meant, or an ``insert_block`` without its prefix. A macro that is
    called in the body may read the parameter too: xacro looks names up in the caller.
    Where an element in the body has the parameter's name and a fixed text, the finding is at that text. It is for
    information where no call in the project gives the parameter, or several files define the macro, of which one is
    chosen.
    """

    code = "XAC009"
    name = "unused-macro-parameter"
    severity = Severity.WARNING
    remedy = """Use the parameter in the body, as `${name}`, or remove it from the macro and its calls.

    Look for a literal in the body that should vary. A block is inserted by
    `<xacro:insert_block name="origin"/>`.
    """
    explains = (problems.UnusedMacroParameter,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:macro name="m" params="side «mass»:=1"><link name="${side}"/></xacro:macro>',
            file=FILE,
            says="parameter `mass` of macro `m`",
        ),
        Bad(
            '<xacro:macro name="m" params="update_rate"><gazebo reference="a"><plugin name="p" filename="p.so">'
            "<updateRate>«40.0»</updateRate></plugin></gazebo></xacro:macro>",
            file=FILE,
            says="`updateRate` is always 40.0: parameter `update_rate` of macro `m` is never read",
        ),
        Bad('<xacro:macro name="m" params="«*origin»"><link name="a"/></xacro:macro>', file=FILE),
    )
    good = (
        Good(
            '<xacro:macro name="inner" params=""><link name="${side}"/></xacro:macro>'
            '<xacro:macro name="outer" params="side"><xacro:inner/></xacro:macro>',
            why="the macro that is called reads it",
            file=FILE,
        ),
        Good(
            '<xacro:macro name="m" params="*origin"><link name="a"><xacro:insert_block name="origin"/></link>'
            "</xacro:macro>",
            file=FILE,
        ),
    )

    def check(self, problem: problems.UnusedMacroParameter) -> Iterator[Diagnostic]:
        message, fixed = (
            f"parameter `{problem.name}` of macro `{problem.macro}` is never read",
            problem.literal,
        )
        if fixed is None:
            severity = Severity.INFO if problem.is_free else None
            yield self.diagnostic(problem.span, message, severity=severity, cause=problem.cause)
            return
        message = f"`{fixed.element.name}` is always {fixed.text.strip()}: {message}"
        labels = {problem.span: "the parameter"}
        yield self.diagnostic(fixed, message, labels=labels)
