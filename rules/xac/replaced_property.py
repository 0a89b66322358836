from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO

INCLUDES = '<xacro:include filename="small.xacro"/><xacro:include filename={}/>'
ARM = (
    '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:property name="{1}reach" value="{2}"/>'
    '<xacro:macro name="{0}" params="p"><link name="${{p}}${{{1}reach}}"/></xacro:macro></robot>'
)
SMALL, LARGE = ARM.format("small", "", "0.1"), ARM.format("large", "", "0.2")


class ReplacedProperty(Rule):
    """Two included files give one property different values, and the macros of the first one get that of the second.

    A macro reads its properties when it is called. Without a word the robot of the first file is built with the
    numbers of the other, such as two arms of one maker in one cell.
    """

    code = "XAC031"
    name = "replaced-property"
    severity = Severity.WARNING
    remedy = """Give the property of each file a name of its own, such as `ur5_reach`.

    Where the files cannot be changed, call the macros of the first one before the second one is included, or include
    them with a namespace: `ns="small"`.
    """
    explains = (problems.ReplacedProperty,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            INCLUDES.format('"«large.xacro»"') + '<xacro:small p="a"/><xacro:large p="b"/>',
            file=FILE,
            files={"small.xacro": SMALL, "large.xacro": LARGE},
            says="`reach` of this file replaces that of an earlier one, which macro `small` was to read",
        ),
    )
    good = (
        Good(
            INCLUDES.format('"large.xacro"') + '<xacro:small p="a"/><xacro:large p="b"/>',
            file=FILE,
            files={"small.xacro": SMALL, "large.xacro": ARM.format("large", "large_", "0.2")},
        ),
        Good(
            '<xacro:include filename="small.xacro"/><xacro:small p="a"/><xacro:include filename="large.xacro"/>'
            '<xacro:large p="b"/>',
            file=FILE,
            files={"small.xacro": SMALL, "large.xacro": LARGE},
            why="it is called in between",
        ),
    )

    def check(self, problem: problems.ReplacedProperty) -> Iterator[Diagnostic]:
        labels = {problem.other: "its own value"} if problem.other else None
        message = f"`{problem.name}` of this file replaces that of an earlier one"
        message += f", which macro `{problem.near}` was to read"
        yield self.diagnostic(problem.span, message, labels=labels)
