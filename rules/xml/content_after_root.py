from collections.abc import Iterator

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, problems, warns

PASSED_OVER = dict.fromkeys(Consumer, warns("passes over it"))


class ContentAfterRoot(Rule):
    """Something stands behind the root element: a second one, an end tag, or text.

    A document has one root element. The simulators read the first one and ignore a
    second, but refuse a file with text behind it; every strict XML parser refuses both.
    What stands there is not checked.
    """

    code = "XML008"
    name = "content-after-root"
    severity = Severity.ERROR
    affects = dict.fromkeys(Consumer, REFUSES)
    explains = (problems.ContentAfterRoot,)

    bad = (
        Bad(
            '<sdf version="1.12"><world name="w"/></sdf>\n<«sdf» version="1.12"><world name="v"/></sdf>',
            says="a second root element, `sdf`",
        ),
        Bad('<sdf version="1.12"><world name="w"/></sdf>\n«</sdf>»', says="`</sdf>` closes nothing"),
        Bad('<sdf version="1.12"><world name="w"/></sdf>\n«the end»\n', says="text behind the root element"),
    )
    good = (
        Good(
            '<sdf version="1.12"><world name="w"/></sdf>\n<!-- the end -->\n',
            why="comments may stand anywhere",
        ),
    )

    def check(self, problem: problems.ContentAfterRoot) -> Iterator[Diagnostic]:
        span, text = problem.span, problem.span.text
        affects = {}
        if text.startswith("</"):
            message = f"`{text}` closes nothing: the root element is closed already"
            affects = PASSED_OVER
        elif text.startswith("<?xml"):
            message = "a second document begins behind the root element"
            affects = PASSED_OVER
        elif span.start and span.source.text[span.start - 1] == "<":
            message = f"a second root element, `{text}`"
            affects = PASSED_OVER
        else:
            message = "text behind the root element"
        yield self.diagnostic(span, message, labels={problem.root: "the root element"}, affects=affects)
