from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO

JOINT = '<joint name="j" type="fixed"><parent link="base"/><child link="b"/></joint>'
IN_ROBOT = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>{}</robot>'


class RedefinedMacro(Rule):
    """Two macros of one file have the same name.

    xacro takes the one that was defined last, in silence: calls before and after the second
    definition give different elements.
    """

    code = "XAC018"
    name = "redefined-macro"
    severity = Severity.WARNING
    remedy = """Rename one of the macros, or remove the one that is not meant.

    Two variants of one part are mostly one macro with a parameter and an `xacro:if`.
    """
    explains = (problems.RedefinedMacro,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:macro name="m" params=""><link name="a"/></xacro:macro>'
            '<xacro:macro name="«m»" params=""><link name="b"/></xacro:macro><xacro:m/>' + JOINT,
            file=FILE,
            says="macro `m` is defined twice",
            scaffold=IN_ROBOT,
        ),
    )
    good = (
        Good(
            '<xacro:if value="1"><xacro:macro name="m" params=""><link name="b"/></xacro:macro></xacro:if>'
            '<xacro:unless value="1"><xacro:macro name="m" params=""><link name="b"/></xacro:macro></xacro:unless>'
            "<xacro:m/>" + JOINT,
            why="one of two",
            file=FILE,
            scaffold=IN_ROBOT,
        ),
    )

    def check(self, problem: problems.RedefinedMacro) -> Iterator[Diagnostic]:
        labels = {problem.other: "first defined here"} if problem.other else None
        yield self.diagnostic(
            problem.span, f"macro `{problem.name}` is defined twice; the last one counts", labels=labels
        )
