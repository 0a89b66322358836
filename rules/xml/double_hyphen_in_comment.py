from collections.abc import Iterator

from sdfcheck import Bad, Diagnostic, Edit, Good, Rule, Severity, make_fix, problems


class DoubleHyphenInComment(Rule):
    """A comment contains `--`, which XML forbids.

    The simulators read the file anyway; every strict XML parser refuses it, and
    with it the tools that are built on one (editors, xmllint, Python's own parser).
    """

    code = "XML002"
    name = "double-hyphen-in-comment"
    severity = Severity.WARNING
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
    )
    good = (Good('<sdf version="1.12"><!-- a - b - c --></sdf>', why="single hyphens are fine"),)

    def check(self, problem: problems.CommentHyphens) -> Iterator[Diagnostic]:
        edits = tuple(Edit(run, " ".join("-" * len(run.text))) for run in problem.runs)
        fix = make_fix("put spaces between the hyphens", edits)
        yield self.diagnostic(problem.span, "`--` inside a comment is not allowed in XML", fix=fix)
