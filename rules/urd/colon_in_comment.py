import re
from collections.abc import Iterator

from sdfcheck import IN_ROBOT, Bad, Diagnostic, Edit, Good, Root, Rule, Severity, Span, make_fix

QUICK = re.compile(r"<!--(?:(?!-->)[^:])*(?::|\Z)")
DIRECTIVE = re.compile(r"<!--\s*sdfcheck\Z")
SPACE = re.compile(r"\s+")
COLON = re.compile(r":(?=\s)")


class ColonInComment(Rule):
    """A comment holds a colon with a space after it.

    A ROS 2 launch file that passes the description on as a parameter, and does not say
    that it is text, has it read as YAML. There such a colon begins a mapping: the launch
    fails with `mapping values are not allowed here`, and nothing points to the comment.
    The fix on the other side is `ParameterValue(…, value_type=str)`.
    """

    code = "URD015"
    name = "colon-in-comment"
    severity = Severity.INFO
    looks_at = (Root,)
    scaffold = IN_ROBOT

    bad = (
        Bad("<!-- author«:» me -->", fixed="<!-- author - me -->", says="a colon in a comment"),
        Bad("<!-- note«:» -->", fixed="<!-- note - -->"),
        Bad(
            "<!-- author«:» me --><!-- a:b -->\n<!-- to do:\n  a joint -->",
            fixed="<!-- author - me --><!-- a:b -->\n<!-- to do -\n  a joint -->",
            says="2 colons in comments",
        ),
        Bad(
            "<!-- sdfcheck«:» ignore-file[zero-axis] agreed -->",
            fixed="<!-- sdfcheck:ignore-file[zero-axis] agreed -->",
        ),
    )
    good = (
        Good("<!-- see https://example.org/a:b -->", why="no space after"),
        Good('<link name="x"/><!-- no -->'),
    )

    @staticmethod
    def applies(root: Root) -> bool:
        return root.is_urdf and QUICK.search(root.document.source.text) is not None and bool(colons(root))

    def check(self, root: Root) -> Iterator[Diagnostic]:
        found = colons(root)
        what = "a colon in a comment breaks" if len(found) == 1 else f"{len(found)} colons in comments break"
        message = f"{what} launch files that read the description as YAML"
        edits = tuple(_edit(colon) for colon in found)
        title = "write a dash" if any(edit.text for edit in edits) else "leave out the space"
        fix = make_fix(title, edits)
        yield self.diagnostic(found[0], message, fix=fix)


def _edit(colon: Span) -> Edit:
    """The directive of a suppression stays one without the space; prose gets a dash."""
    source = colon.source
    if DIRECTIVE.search(source.text, 0, colon.start):
        end = SPACE.match(source.text, colon.end)
        return Edit(source.span(colon.end, end.end() if end else colon.end), "")
    return Edit(colon, " -")


def colons(root: Root) -> list[Span]:
    """All of them: a fix of one has to be a fix of all."""
    source = root.document.source
    return [
        source.span(*match.span())
        for start, end in root.document.scan.comments
        for match in COLON.finditer(source.text, start + 4, end - 3)
    ]
