from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Edit, Good, Rule, Severity, make_fix, problems


class ColonInComment(Rule):
    """A comment holds a colon with a blank behind it.

    A ROS 2 launch file that passes the description on as a parameter, and does not say
    that it is text, has it read as YAML. There such a colon begins a mapping: the launch
    fails with `mapping values are not allowed here`, and nothing points to the comment.
    The cure on the other side is `ParameterValue(…, value_type=str)`.
    """

    code = "URD015"
    name = "colon-in-comment"
    severity = Severity.INFO
    explains = (problems.ColonInComment,)
    scaffold = IN_ROBOT

    bad = (
        Bad("<!-- author«:» me -->", fixed="<!-- author - me -->", says="a colon in a comment"),
        Bad(
            "<!-- author«:» me --><!-- a:b -->\n<!-- to do:\n  a joint -->",
            fixed="<!-- author - me --><!-- a:b -->\n<!-- to do -\n  a joint -->",
            says="2 colons in comments",
        ),
    )
    good = (
        Good("<!-- see https://example.org/a:b -->", why="no blank behind"),
        Good('<link name="x"/><!-- no -->'),
    )

    def check(self, problem: problems.ColonInComment) -> Iterator[Diagnostic]:
        count = len(problem.colons)
        what = "a colon in a comment breaks" if count == 1 else f"{count} colons in comments break"
        message = f"{what} launch files that read the description as YAML"
        fix = make_fix("write a dash", tuple(Edit(colon, " -") for colon in problem.colons))
        yield self.diagnostic(problem.span, message, fix=fix)
