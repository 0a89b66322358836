from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, problems
from sdfcheck_rules.xac.scaffold import FILE, IN_XACRO


class UnusedMacro(Rule):
    """A robot defines a macro and nothing calls it.

    Its content is not in the robot. Macros of libraries are for the files that include them and
    are not reported. Where a launch file expands a file of macros alone, or one that only includes such files, and
    nothing includes it, the robot is empty, and robot_state_publisher ends with `No link elements found in urdf file`:
    that is a warning.
    """

    code = "XAC022"
    name = "unused-macro"
    severity = Severity.INFO
    remedy = """Call the macro, or remove it.

    A macro for other files belongs in a file of its own, without the `<robot>` that is built.
    """
    explains = (problems.UnusedMacro, problems.EmptyRobot)
    scaffold = IN_XACRO

    bad = (
        Bad(
            '<xacro:macro name="«leg»" params=""><link name="a"/></xacro:macro>',
            file=FILE,
            says="macro `leg` is never called",
        ),
        Bad(
            '<xacro:macro name="«leg»" params=""><link name="a"/></xacro:macro>',
            scaffold='<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>',
            file="robot.urdf.xacro",
            files={"robot.launch": '<launch><param name="d" command="xacro robot.urdf.xacro"/></launch>'},
            says="macro `leg` is never called, and nothing else is in the robot that a launch file expands",
        ),
        Bad(
            '<xacro:include filename="leg.xacro"/>',
            scaffold='<robot name="«r»" xmlns:xacro="http://www.ros.org/wiki/xacro">{}</robot>',
            file="robot.urdf.xacro",
            files={
                "leg.xacro": '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="leg" params="">'
                '<link name="a"/></xacro:macro></robot>',
                "robot.launch": '<launch><param name="d" command="xacro robot.urdf.xacro"/></launch>',
            },
            says="macro `leg` is never called, and nothing else is in the robot that a launch file expands",
        ),
    )
    good = (
        Good('<xacro:macro name="leg" params=""><link name="a"/></xacro:macro><xacro:leg/>', file=FILE),
        Good(
            '<xacro:macro name="leg" params=""><link name="a"/></xacro:macro><xacro:call macro="leg"/>',
            file=FILE,
        ),
    )

    def check(self, problem: problems.UnusedMacro | problems.EmptyRobot) -> Iterator[Diagnostic]:
        message = f"macro `{problem.name}` is never called"
        if isinstance(problem, problems.UnusedMacro):
            yield self.diagnostic(problem.span, message)
            return
        message += ", and nothing else is in the robot that a launch file expands"
        yield self.diagnostic(problem.span, message, severity=Severity.WARNING)
