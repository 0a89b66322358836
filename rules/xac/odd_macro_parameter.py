from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, accepts, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO

MESSAGES = {
    "comma": "parameters are separated by spaces, not by commas: `{},`",
    "doubled": "parameter `{}` is listed twice",
    "blank": "a space between `:=` and the default of `{}`",
    "no name": "`{}` is not a name, and no call can give it",
    "no default": "`{}:=` has no default of its own, and takes the next parameter for it",
    "no colon": "write `:=` before the default of `{}`, not `=`",
}


class OddMacroParameter(Rule):
    """The parameters of a macro are not written as xacro takes them apart.

    Spaces separate them, `name:=default` gives one a default. A comma becomes a part of the name, or
    of the default; of a doubled parameter only one can ever be given: calls fail. A blank after `:=` and a
    `=` alone are taken, and hard to read.
    """

    code = "XAC024"
    name = "odd-macro-parameter"
    severity = Severity.ERROR
    remedy = """Separate parameters by spaces, write each once, and give defaults as `name:=default`.

    `params="prefix side:=left *origin"` has one that is needed, one with a default, and a block. A default
    with spaces is in quotes: `name:='a b'`.
    """
    explains = (problems.OddParameter,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:macro name="m" params="«side,» size"><link name="${side}${size}"/></xacro:macro>'
            '<xacro:m side="l" size="1"/>',
            file=FILE,
            says="parameters are separated by spaces, not by commas: `side,`",
        ),
        Bad(
            '<xacro:macro name="m" params="side «side»"><link name="${side}"/></xacro:macro><xacro:m side="l"/>',
            file=FILE,
            says="parameter `side` is listed twice",
        ),
        Bad(
            '<xacro:macro name="m" params="«side»:= l"><link name="${side}"/></xacro:macro><xacro:m/>',
            file=FILE,
            says="a space between `:=` and the default of `side`",
        ),
        Bad(
            '<xacro:macro name="m" params="«side»=l"><link name="${side}"/></xacro:macro><xacro:m/>',
            file=FILE,
            says="write `:=` before the default of `side`",
        ),
        Bad(
            '<xacro:macro name="m" params="side:=l «:=1»"><link name="${side}"/></xacro:macro><xacro:m/>',
            file=FILE,
            says="`:=1` is not a name, and no call can give it",
        ),
        Bad(
            '<xacro:macro name="m" params="«side»:= size:=1"><link name="${side}"/></xacro:macro><xacro:m/>',
            file=FILE,
            says="`side:=` has no default of its own, and takes the next parameter for it",
        ),
    )
    good = (
        Good(
            '<xacro:macro name="m" params="side:=l *origin"><link name="${side}"><xacro:insert_block name="origin"/>'
            "</link></xacro:macro><xacro:m><pose/></xacro:m>",
            file=FILE,
        ),
    )

    def check(self, problem: problems.OddParameter) -> Iterator[Diagnostic]:
        message = MESSAGES[problem.flaw.value].replace("{}", problem.name)
        labels = {problem.other: "first listed here"} if problem.other else None
        if problem.is_fatal:
            yield self.diagnostic(problem.span, message, labels=labels)
        else:
            taken = dict.fromkeys(Consumer, accepts("gets what was meant"))
            yield self.diagnostic(problem.span, message, severity=Severity.INFO, affects=taken)
