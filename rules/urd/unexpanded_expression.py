from collections.abc import Iterator

from sdfcheck import IN_URDF_LINK, Bad, Diagnostic, Good, Rule, Severity, problems, unexpanded


class UnexpandedExpression(Rule):
    """An expression of xacro is left in a plain URDF file.

    No simulator knows `${…}` and `$(…)`: they end up in names and paths as they are, a file
    of such a name is not found, and where a number is wanted the file is refused or a part of
    the link dropped.
    """

    code = "URD009"
    name = "unexpanded-expression"
    severity = Severity.ERROR
    remedy = """Expand the file with `sdfcheck expand` or xacro, or name it `.xacro` if it is the source.

    `sdfcheck expand robot.urdf.xacro -o robot.urdf` writes the plain file. A generated file with such rests
    was expanded with a macro or an argument that did not reach this place.
    """
    explains = (problems.UnexpandedExpression,)
    scaffold = IN_URDF_LINK

    bad = (
        Bad('<visual><geometry><sphere radius="«${r}»"/></geometry></visual>', says="`${r}` is not expanded"),
        Bad(
            '<visual><geometry><mesh filename="file://«$(find p)»/${m}.stl"/></geometry></visual>',
            says="`$(find p)` is not expanded, nor is 1 other expression",
        ),
        Bad(
            '<visual><geometry><sphere radius="«${r}»"/></geometry></visual></link><gazebo reference="base">'
            '<sensor name="imu" type="imu"><update_rate>${rate}</update_rate></sensor></gazebo></robot>',
            scaffold='<robot name="r"><link name="base">{}',
            says="nor is 1 other expression",
        ),
    )
    good = (
        Good("<!-- radius was ${r} -->", why="a comment"),
        Good('<visual name="$5"><geometry><sphere radius="1"/></geometry></visual>'),
    )

    def check(self, problem: problems.UnexpandedExpression) -> Iterator[Diagnostic]:
        message = f"`{problem.span.text}` is not expanded"
        others = problem.count - 1
        if others:
            message += (
                f", nor {'is 1 other expression' if others == 1 else f'are {others} other expressions'}"
            )
        repeats = [value.span for value in problem.values]
        yield self.diagnostic(problem.span, message, affects=unexpanded(problem.values), repeats=repeats)
