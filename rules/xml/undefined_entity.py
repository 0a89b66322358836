from collections.abc import Iterator

from sdfcheck import (
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Good,
    Rule,
    Severity,
    Span,
    TextEdit,
    make_fix,
    problems,
    warns,
)
from sdfcheck_rules.xml.strict import is_xacro, unless_xacro

_NEAR = 500
"""So many characters before an `&` are searched for the start of an expression."""


class UndefinedEntity(Rule):
    """An `&` begins no reference that XML knows.

    XML defines `&amp;`, `&lt;`, `&gt;`, `&quot;`, `&apos;` and characters by number.
    libsdformat and Drake keep any other name as it is written, urdfdom 3 drops the `&`, and all of them
    take the number of a character for the character; every strict XML parser refuses the file,
    that of xacro among them: in a xacro file it is an error.
    """

    code = "XML006"
    name = "undefined-entity"
    severity = Severity.WARNING
    remedy = """Write `&amp;` for the character `&`, and any other character as itself.

    In attributes `<` is `&lt;`, and a double quote in double quotes `&quot;`. A space that does not break
    is `&#160;`.
    """
    explains = (problems.UnknownEntity,)

    bad = (
        Bad(
            '<sdf version="1.12"><model name="salt «&» pepper"><link name="l"/></model></sdf>',
            fixed='<sdf version="1.12"><model name="salt &amp; pepper"><link name="l"/></model></sdf>',
            says="a bare `&`",
        ),
        Bad(
            '<robot name="r«&nbsp;»1"><link name="l"/></robot>',
            fixed='<robot name="r&amp;nbsp;1"><link name="l"/></robot>',
            says="`&nbsp;` is not defined",
        ),
        Bad(
            '<sdf version="1.12"><model name="salt «&»& pepper"><link name="l"/></model></sdf>',
            fixed='<sdf version="1.12"><model name="salt &amp;&amp; pepper"><link name="l"/></model></sdf>',
        ),
        Bad('<robot name="r«&#7;»1"><link name="l"/></robot>', says="a character that XML does not allow"),
        Bad(
            '<robot name="r«&»1"><link name="l"/></robot>',
            file="robot.urdf.xacro",
            fixed='<robot name="r&amp;1"><link name="l"/></robot>',
            says="xacro refuses the file",
        ),
    )
    good = (
        Good('<sdf version="1.12"><model name="salt &amp; pepper"><link name="l"/></model></sdf>'),
        Good('<robot name="&#x52;2"><link name="l"/></robot>', why="a character by its number"),
        Good('<sdf version="1.12"><!-- salt & pepper --><world name="w"/></sdf>', why="a comment"),
        Good(
            '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="${1 && 2}"/></robot>',
            file="robot.urdf.xacro",
            why="expansion-error owns bad Python",
        ),
    )

    def check(self, problem: problems.UnknownEntity) -> Iterator[Diagnostic]:
        span, name = problem.span, problem.name
        if name.startswith("#"):
            message = f"`{span.text}` is a character that XML does not allow"
            reads = {**dict.fromkeys(Consumer, warns("reads the character")), Consumer.ISAAC: REFUSES}
            yield self.diagnostic(span, help="remove it", **unless_xacro(span, message, affects=reads))
            return
        text, end = span.source.text, span.start + 1
        if text[span.start - 1 : span.start] == "&":
            return  # said of the first of them
        while text.startswith("&", end):
            end += 1
        ampersands = span.source.span(span.start, end)
        if len(ampersands.text) > 1 and _is_in_expression(span):
            return
        message = (
            f"`{span.text}` is not defined in XML" if name else "a bare `&` begins nothing that XML knows"
        )
        fix = make_fix("write `&amp;`", (TextEdit(ampersands, "&amp;" * len(ampersands.text)),))
        yield self.diagnostic(span, fix=fix, **unless_xacro(span, message))


def _is_in_expression(span: Span) -> bool:
    """In one of xacro `&&` is bad Python, whatever XML makes of it."""
    before = span.source.text[max(span.start - _NEAR, 0) : span.start]
    return is_xacro(span) and before.rfind("${") > before.rfind("}")
