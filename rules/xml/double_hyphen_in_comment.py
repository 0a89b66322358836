from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Good, Rule, Severity, Span, TextEdit, make_fix, problems
from sdfcheck_rules.xml.strict import unless_xacro

XACRO = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


class DoubleHyphenInComment(Rule):
    """A comment contains `--`, which XML forbids.

    The simulators read the file anyway; every strict XML parser refuses it, and
    with it the tools that are built on one (editors, xmllint, Python's own parser).
    xacro is one of them, so in a `.xacro` file it is an error: nobody gets the robot.
    """

    code = "XML002"
    name = "double-hyphen-in-comment"
    severity = Severity.WARNING
    remedy = """Write a single hyphen, or put spaces between the hyphens.

    To switch off an element that has a comment in it, remove the inner comment, or cut the element out.
    """
    explains = (problems.CommentHyphens,)

    bad = (
        Bad(
            '<sdf version="1.12"><!-- run with «--»verbose --></sdf>',
            fixed='<sdf version="1.12"><!-- run with - -verbose --></sdf>',
        ),
        Bad(
            '<sdf version="1.12"><!-- «----» wheels ---- --></sdf>',
            fixed='<sdf version="1.12"><!-- - - - - wheels - - - - --></sdf>',
        ),
        Bad('<sdf version="1.12"><!-- a «--»-></sdf>', fixed='<sdf version="1.12"><!-- a - --></sdf>'),
        Bad('<sdf version="1.12"><!--«--»--></sdf>', fixed='<sdf version="1.12"><!--- - --></sdf>'),
        Bad(
            f'<robot name="r" {XACRO}><!-- «--» wheels --><link name="a"/></robot>',
            file="robot.urdf.xacro",
            fixed=f'<robot name="r" {XACRO}><!-- - - wheels --><link name="a"/></robot>',
        ),
    )
    good = (Good('<sdf version="1.12"><!-- a - b - c --></sdf>', why="single hyphens are fine"),)

    def check(self, problem: problems.CommentHyphens) -> Iterator[Diagnostic]:
        edits = tuple(TextEdit(run, _apart(run)) for run in problem.runs)
        fix = make_fix("put spaces between the hyphens", edits)
        own = unless_xacro(problem.span, "`--` inside a comment is not allowed in XML")
        yield self.diagnostic(problem.span, fix=fix, **own)


def _apart(run: Span) -> str:
    """The hyphens with spaces between them; after the last, too, where the end of the comment follows."""
    return " ".join(run.text) + " " * run.source.text.startswith("-->", run.end)
