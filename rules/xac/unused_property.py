from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class UnusedProperty(Rule):
    """A property is defined and no expression reads it.

    Reported for properties inside of macros, and for those of a robot when everything
    that it includes is known; the properties of a macro library are there for others.
    """

    code = "XAC005"
    name = "unused-property"
    severity = Severity.INFO
    remedy = """Remove the property, or use it where its number is written out.

    Look for a literal of the same value in the file: that is mostly where it was meant.
    """
    explains = (problems.UnusedProperty,)
    scaffold = IN_XACRO

    bad = (
        Bad('<xacro:property name="«height»" value="1"/>', file=FILE, says="`height`"),
        Bad(
            '<xacro:macro name="m" params=""><xacro:property name="«w»" value="1"/></xacro:macro>', file=FILE
        ),
    )
    good = (
        Good('<xacro:property name="pi" value="3"/>', why="redefined-symbol reports it", file=FILE),
        Good('<xacro:property name="height" value="1"/><link name="l${height}"/>', file=FILE),
        Good(
            '<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'
            '<xacro:property name="height" value="1"/></robot>',
            why="a library: who includes it may read it",
            file=FILE,
            scaffold="{}",
        ),
    )

    def check(self, problem: problems.UnusedProperty) -> Iterator[Diagnostic]:
        yield self.diagnostic(problem.span, f"property `{problem.name}` is never read")
