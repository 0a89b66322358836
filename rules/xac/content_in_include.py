from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class ContentInInclude(Rule):
    """`xacro:include` has child elements, which xacro ignores with a warning.

    In ROS launch files an include takes arguments as children; in xacro an included file reads the
    properties and arguments of the file that includes it.
    """

    code = "XAC014"
    name = "content-in-include"
    severity = Severity.WARNING
    remedy = """Leave the include empty, and set arguments with `xacro:arg` before it.

    The included file reads the arguments and properties of the file that includes it. Parameters for one
    use each belong in a macro that the file defines.
    """
    explains = (problems.IgnoredIncludeContent,)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:include filename="no_such_*.xacro" optional="true">'
            '<«xacro:arg» name="gazebo" value="${nowhere}"/></xacro:include>',
            file=FILE,
            says="children of `xacro:include` are ignored",
        ),
    )
    good = (
        Good(
            '<xacro:arg name="gazebo" default="true"/>'
            '<xacro:include filename="no_such_*.xacro" optional="true"></xacro:include>',
            file=FILE,
        ),
    )

    def check(self, problem: problems.IgnoredIncludeContent) -> Iterator[Diagnostic]:
        yield self.diagnostic(problem.span, f"children of `xacro:include` are ignored: `{problem.element}`")
