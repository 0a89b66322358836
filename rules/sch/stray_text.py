from collections.abc import Iterator

from sdfcheck import IN_LINK, IN_MODEL, Bad, Diagnostic, Good, Rule, Severity, problems

LONGEST = 30
"""Characters of the text that are quoted."""


class StrayText(Rule):
    """There is text in an element that holds only elements.

    No consumer looks at it. It is the rest of an edit, a tag whose `<` was lost, or a
    value that belongs one level deeper.
    """

    code = "SCH010"
    name = "stray-text"
    severity = Severity.WARNING
    remedy = """Remove the text, or put it into the element that it belongs to.

    A number in `inertial` is mostly a mass that lost its tags. Notes belong in comments: `<!-- … -->`.
    """
    explains = (problems.StrayText,)
    scaffold = IN_MODEL

    bad = (
        Bad('«/>»\n<link name="l"/>', says="text `/>` in model `m` is not read"),
        Bad("<inertial>«1.5»</inertial>", scaffold=IN_LINK),
        Bad("<inertial><mass>1</mass>«left over»\n from an edit</inertial>", scaffold=IN_LINK),
    )
    good = (
        Good('<plugin name="p" filename="p">text</plugin>', why="the content of a plugin is the plugin's"),
        Good('<p:note xmlns:p="https://example.org/p">text</p:note>', why="so is that of a custom element"),
        Good("<!-- text -->"),
    )

    def check(self, problem: problems.StrayText) -> Iterator[Diagnostic]:
        text = problem.text
        shown = text if len(text) <= LONGEST else f"{text[:LONGEST]}…"
        yield self.diagnostic(problem.span, f"text `{shown}` in {problem.element.title} is not read")
