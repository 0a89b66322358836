from collections.abc import Iterator

from sdfcheck import Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, replace, warns
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO
from sdfcheck_rules.xac.unreached import unless_reached

_IGNORED = dict.fromkeys(Consumer, warns("gets a robot description made without it"))


class WrongXacroAttribute(Rule):
    """An element of xacro's own lacks an attribute that it needs, or has one that it does not take.

    xacro stops at a missing one. It ignores an unknown one with a warning, and so this is a
    warning, too, unless the one that was meant is needed: a property without its value
    takes its content instead.
    """

    code = "XAC011"
    name = "wrong-xacro-attribute"
    severity = Severity.ERROR
    remedy = """Write the attribute that xacro asks for, or remove the one that it does not know.

    `xacro:property` takes `name`, `value`, `default`, `scope` and `remove`; `xacro:if` and `xacro:unless`
    `value`; `xacro:include` `filename`, `ns` and `optional`; `xacro:arg` `name` and `default`;
    `xacro:macro` `name` and `params`. Notes belong in comments.
    """
    explains = (problems.WrongXacroAttribute,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:property name="w" «vaule»="1"/><link name="a${w}"/>',
            fixed='<xacro:property name="w" value="1"/><link name="a${w}"/>',
            unsafe=True,
            file=FILE,
            says="`xacro:property` takes no `vaule`; did you mean `value`?",
        ),
        Bad('<«xacro:if»><link name="a"/></xacro:if>', file=FILE, says="`xacro:if` has no `value`"),
        Bad(
            '<xacro:property name="w" value="1" «comment»="m"/><link name="a${w}"/>',
            file=FILE,
            says="`xacro:property` takes no `comment`",
        ),
        Bad('<«xacro:arg» name="a"/>', file=FILE, says="`xacro:arg` has no `default`"),
    )
    good = (
        Good('<xacro:property name="w" value="1" scope="global"/><link name="a${w}"/>', file=FILE),
        Good('<xacro:macro name="m"><link name="a"/></xacro:macro><xacro:m/>', file=FILE),
    )

    def check(self, problem: problems.WrongXacroAttribute) -> Iterator[Diagnostic]:
        element, name, near = problem.element, problem.attribute, problem.near
        if problem.is_missing:
            own = unless_reached(is_dormant=problem.is_dormant)
            yield self.diagnostic(problem.span, f"`{element}` has no `{name}`", **own)
            return
        fix = replace(problem.span, near, f"rename it to `{near}`", unsafe=True) if near else None
        message = f"`{element}` takes no `{name}`"
        if problem.is_fatal:
            yield self.diagnostic(problem.span, message, meant=near, fix=fix)
            return
        yield self.diagnostic(
            problem.span,
            message,
            meant=near,
            fix=fix,
            severity=Severity.WARNING,
            affects=_IGNORED,
        )
