from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, refuses


class DelimiterInExtension(Rule):
    """A name inside `gazebo` contains `::`.

    When libsdformat has converted the robot it checks all names for `::`, those of a
    plugin's own elements included, and refuses the whole robot for one. Only the name of
    a plugin itself, mostly a C++ class, may hold it.
    """

    code = "URD017"
    name = "delimiter-in-extension"
    severity = Severity.WARNING
    affects = {Consumer.GAZEBO: refuses("refuses the robot")}
    explains = (problems.DelimiterInExtension,)
    scaffold = IN_ROBOT

    bad = (
        Bad(
            '<gazebo><plugin name="p" filename="p"><joint name="«r::j»"/></plugin></gazebo>',
            says="`r::j` contains `::`, for which libsdformat refuses the robot",
        ),
    )
    good = (
        Good('<gazebo><plugin name="gz::sim::systems::Imu" filename="p"/></gazebo>', why="a plugin's class"),
        Good(
            '<gazebo><plugin name="p" filename="p"><joint>r::j</joint></plugin></gazebo>', why="text is free"
        ),
    )

    def check(self, problem: problems.DelimiterInExtension) -> Iterator[Diagnostic]:
        value = problem.value
        message = f"the name `{value.text}` contains `::`, for which libsdformat refuses the robot"
        yield self.diagnostic(value, message)
