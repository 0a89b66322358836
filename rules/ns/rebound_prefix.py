from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems

ROBOT = (
    '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro" xmlns:p="http://example.org/p">'
    '<xacro:include filename="part.xacro"/><link name="a"><p:mark/></link></robot>'
)
PART = (
    '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" xmlns:p="http://example.org/{}">'
    '<xacro:macro name="m"><p:mark/></xacro:macro></robot>'
)


class ReboundPrefix(Rule):
    """An included xacro file binds a prefix to another name than the file that includes it.

    xacro puts the elements of both into one robot and keeps the first name, with a warning: what the included file
    writes with the prefix gets the meaning of the other file.
    """

    code = "NS015"
    name = "rebound-prefix"
    severity = Severity.WARNING
    remedy = "Bind the prefix to the same name in both files, or use another prefix in one of them."
    explains = (problems.ReboundPrefix,)

    bad = (
        Bad(
            ROBOT.replace("http://example.org/p", "«http://example.org/p»"),
            file="robot.urdf.xacro",
            files={"part.xacro": PART.format("q")},
            says="prefix `p` has another name in part.xacro, which this file includes",
        ),
    )
    good = (Good(ROBOT, file="robot.urdf.xacro", files={"part.xacro": PART.format("p")}),)

    def check(self, problem: problems.ReboundPrefix) -> Iterator[Diagnostic]:
        assert problem.other is not None
        file = problem.other.source.path.name
        message = f"prefix `{problem.name}` has another name in {file}, which this file includes"
        yield self.diagnostic(problem.span, message, labels={problem.other: "the other name"})
