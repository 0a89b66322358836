from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Origin, Rule, Severity, named, problems, write_instead
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO
from sdfcheck_rules.xac.unreached import unless_reached

_MACRO = '<xacro:macro name="leg" params="side length:=1 *origin"><link name="${side}${length}">'
_MACRO += '<xacro:insert_block name="origin"/></link></xacro:macro>'


class WrongMacroArguments(Rule):
    """A macro is called without a parameter that it needs, or with one that it does not take.

    xacro stops at either. Parameters with a default may be left out; those with a star
    take the child elements of the call, one each, in their order.
    """

    code = "XAC008"
    name = "wrong-macro-arguments"
    severity = Severity.ERROR
    remedy = """Call the macro with exactly its parameters.

    Those with `:=` in the definition have a default and can be left out. A parameter `*origin` takes a
    child element, `<origin …/>`, in the call, several of them in their order.
    """
    explains = (problems.WrongMacroArguments,)
    scaffold = IN_XACRO.replace("{}", _MACRO + "{}")

    bad = (
        Bad("<«xacro:leg»><visual/></xacro:leg>", file=FILE, says="without `side`"),
        Bad(
            '<xacro:leg side="l" «lenght»="2"><visual/></xacro:leg>',
            fixed='<xacro:leg side="l" length="2"><visual/></xacro:leg>',
            unsafe=True,
            file=FILE,
            says="takes no parameter `lenght`; did you mean `length`?",
        ),
        Bad('<«xacro:leg» side="l"/>', file=FILE, says="needs an element for `*origin`"),
        Bad(
            '<xacro:leg side="l"><visual/><«collision»/></xacro:leg>',
            file=FILE,
            says="takes no element <collision>",
        ),
    )
    good = (
        Good('<xacro:leg side="l"><visual/></xacro:leg>', why="length has a default", file=FILE),
        Good('<xacro:leg side="l" length="2"><visual/></xacro:leg>', file=FILE),
    )

    def check(self, problem: problems.WrongMacroArguments) -> Iterator[Diagnostic]:
        names, fix = named(problem.names), None
        kind, macro = problem.kind.value, f"macro `{problem.macro}`"
        if kind == "missing":
            message = f"{macro} is called without {names}"
        elif kind == "unknown":
            guess = f"; did you mean `{problem.near}`?" if problem.near else ""
            message = f"{macro} takes no parameter {names}{guess}"
            fix = write_instead(problem.near, problem.span)
        elif kind == "missing block":
            message = f"{macro} needs an element for {names or 'each of its blocks'}"
        else:
            message = f"{macro} takes no element {' '.join(f'<{name}>' for name in problem.names)} here"
        takes = ", ".join(problem.parameters)
        advice = f"it takes {takes}" if takes else "it takes no parameters"
        yield self.diagnostic(
            problem.span,
            message,
            fix=fix,
            labels={problem.definition: "defined here"} if problem.definition else None,
            origins=tuple(Origin(*step) for step in problem.origins),
            **unless_reached(is_dormant=problem.is_dormant, help=advice),
        )
