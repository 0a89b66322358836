from collections.abc import Iterator
from xml.parsers.expat import ExpatError, ParserCreate

from sdfcheck import REFUSES, Bad, Consumer, Diagnostic, Good, Rule, Severity, Span, ignores, problems

PARTS = {"model", "world"}
"""Without `<sdf>` around them they are reported by missing-root."""
IGNORED = {**dict.fromkeys(Consumer, ignores("it")), Consumer.ISAAC: REFUSES}
OF_URDFDOM = {
    **dict.fromkeys((Consumer.ROS, Consumer.URDFDOM), ignores("it")),
    **dict.fromkeys((Consumer.ISAAC, Consumer.PINOCCHIO, Consumer.PYBULLET), REFUSES),
}


class ContentAfterRoot(Rule):
    """Something is after the root element: a second one, an end tag, or text.

    A document has one root element. The simulators read the first one and ignore a second, but refuse a
    declaration after it, and a file that ends with text, both of which urdfdom ignores; every strict XML parser
    refuses all of this. Content after the root is not checked.
    """

    code = "XML008"
    name = "content-after-root"
    severity = Severity.ERROR
    remedy = """Remove what is after the root element, or move it into the root.

    A second robot or world belongs in a file of its own. An end tag too many mostly means that a start tag
    is missing further up.
    """
    explains = (problems.ContentAfterRoot,)

    bad = (
        Bad(
            '<sdf version="1.12"><world name="w"/></sdf>\n<«sdf» version="1.12"><world name="v"/></sdf>',
            says="a second root element, `sdf`",
        ),
        Bad('<sdf version="1.12"><world name="w"/></sdf>\n«</sdf>»', says="`</sdf>` closes nothing"),
        Bad('<sdf version="1.12"><world name="w"/></sdf>\n«the end»\n', says="text after the root element"),
        Bad(
            '<robot name="r"><link name="l"/></robot>\n«<?xml version="1.0"?>»\n<robot name="s"/>',
            says="a second document begins after the root element",
        ),
        Bad(
            '<robot name="r"><link name="l"/></robot>\n<«robot» name="s"><link name="l"/></robot>',
            says="a second root element, `robot`",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12"><world name="w"/></sdf>\n<!-- the end -->\n', why="comments may be anywhere"
        ),
        Good('<robot name="r"><link name="l"/></robot>\n<!-- the end -->\n'),
        Good('<world name="w"/>\n</sdf>\n', why="the start tag is missing: missing-root owns this one"),
    )

    def check(self, problem: problems.ContentAfterRoot) -> Iterator[Diagnostic]:
        span, text = problem.span, problem.span.text
        if text.startswith("</sdf") and problem.root.text in PARTS:
            return  # its start tag is missing, as missing-root says
        affects = {}
        if text.startswith("</"):
            message = f"`{text}` closes nothing: the root element is closed already"
            affects = IGNORED
        elif text.startswith("<?xml"):
            message = "a second document begins after the root element"
            affects = OF_URDFDOM
        elif span.start and span.source.text[span.start - 1] == "<":
            message = f"a second root element, `{text}`"
            affects = IGNORED
        else:
            message = "text after the root element"
            affects = IGNORED if has_markup_behind(span) else OF_URDFDOM
        yield self.diagnostic(span, message, labels={problem.root: "the root element"}, affects=affects)


def has_markup_behind(text: Span) -> bool:
    """Do well-formed elements or comments follow a text, so that the file does not end with it?"""
    _, sign, rest = text.source.text[text.start :].partition("<")
    try:
        ParserCreate().Parse(f"<_>{sign}{rest}</_>".encode(), True)
    except (ExpatError, ValueError):
        return False
    return rest.rstrip().endswith(">")
