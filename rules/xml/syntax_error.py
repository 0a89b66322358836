from collections.abc import Iterator

from sdfcheck import (
    REFUSES,
    Bad,
    Consumer,
    Diagnostic,
    Fix,
    Good,
    Rule,
    Severity,
    Span,
    accepts,
    problems,
    refuses,
    replace,
    warns,
)
from sdfcheck_rules.xml.strict import is_xacro

Kind = problems.SyntaxKind

MESSAGES = {
    Kind.UNCLOSED_ELEMENT: "`<{name}>` is never closed",
    Kind.MISMATCHED_END_TAG: "`{text}` does not match `{name}`",
    Kind.EXTRA_END_TAG: "`</{name}>` closes nothing that is open",
    Kind.MISSING_START_TAG: "`<{name}>` is missing before `{text}`",
    Kind.MISSING_SLASH: "`{text}` opens an element where `</{name}>` is meant",
    Kind.MISSING_ANGLE: "`<` is missing before `{text}`",
    Kind.TRUNCATED: "the file ends inside `{text}`",
    Kind.UNCLOSED_TAG: "`>` is missing at the end of the tag `<{name}`",
    Kind.BLANK_IN_TAG: "a space between `<` and `{name}`",
    Kind.ODD_BLANK: "{name} in a tag looks like a space but is not one for XML",
    Kind.CROWDED_END_TAG: "an end tag holds only its name, not `{text}`",
    Kind.UNCLOSED_COMMENT: "`-->` is missing at the end of a comment",
    Kind.NESTED_COMMENT: "a comment begins inside a comment",
    Kind.MISSPELT_MARK: "`{text}` where `{name}` is meant",
    Kind.COMMENT_IN_TAG: "a comment inside the tag `<{name}`",
    Kind.UNCLOSED_SECTION: "`{text}` is not closed by `{name}`",
    Kind.UNCLOSED_VALUE: "the value of `{name}` has no closing quote",
    Kind.UNQUOTED_VALUE: "the value of `{name}` is not in quotes",
    Kind.CURLY_QUOTES: "the value of `{name}` is in typographic quotes",
    Kind.VALUELESS_ATTRIBUTE: "`{name}` has no value",
    Kind.MISSING_EQUALS: "`=` is missing between `{name}` and its value",
    Kind.MISSING_SPACE: "a space is missing before `{name}`",
    Kind.MALFORMED_ATTRIBUTE: "unexpected `{name}` in a tag",
    Kind.MALFORMED_NAME: "`{text}` is not a name for XML",
    Kind.ANGLE_IN_VALUE: "`<` in the value of `{name}`",
    Kind.STRAY_ANGLE: "`{text}` begins no tag",
    Kind.SECTION_END_IN_TEXT: "`]]>` in a text",
    Kind.ILLEGAL_CHARACTER: "a character that XML does not allow ({name})",
    Kind.MERGE_CONFLICT: "an unresolved merge conflict",
    Kind.TEXT_OUTSIDE_ROOT: "text before the root element",
    Kind.MALFORMED_INSTRUCTION: "`{text}` is not as XML wants it",
    Kind.ODD_VERSION: "`{text}` is not a version of XML",
    Kind.SECOND_DECLARATION: "an XML declaration appears only once, at the start of the file",
    Kind.NO_ELEMENT: "there is no element",
    Kind.TOO_LONG: "the text of `{name}` is longer than parsers read (10 million characters)",
    Kind.TOO_MANY: "`{name}` has more than 1000 attributes; from here on they are not looked at",
    Kind.OTHER: "{name}",
}
LABELS = {
    Kind.UNCLOSED_ELEMENT: "`</{name}>` is missing before this",
    Kind.EXTRA_END_TAG: "this is what is open here",
    Kind.MISSING_START_TAG: "closed here",
    Kind.MISSING_SLASH: "opened here",
    Kind.TRUNCATED: "opened here",
    Kind.MISSPELT_MARK: "begun here",
    Kind.UNCLOSED_COMMENT: "begun here",
    Kind.NESTED_COMMENT: "both end here",
    Kind.MERGE_CONFLICT: "up to here",
    Kind.SECOND_DECLARATION: "the first one",
}
ADVICE = {
    Kind.UNCLOSED_ELEMENT: "write `</{name}>` where the element ends",
    Kind.EXTRA_END_TAG: "remove it, or write the start tag that it belongs to",
    Kind.MISSING_START_TAG: "write `<{name}>` where the element begins, or remove its end tag",
    Kind.TRUNCATED: "complete the file: it was cut off, or its last end tags were lost",
    Kind.UNCLOSED_VALUE: "write the quote at the end of the value",
    Kind.UNCLOSED_COMMENT: "write `-->` where the comment ends",
    Kind.NESTED_COMMENT: "remove the inner comment, or end the outer one before it",
    Kind.ILLEGAL_CHARACTER: "remove the character",
    Kind.MERGE_CONFLICT: "keep one of the two sides, and remove the lines of marks",
    Kind.TEXT_OUTSIDE_ROOT: "remove the text, or make a comment of it",
    Kind.SECOND_DECLARATION: "remove it",
}
"""The help of those without a replacement where the rule's own would not fit."""
WRITTEN = {
    Kind.MISMATCHED_END_TAG: ("{name}", "write `{name}`"),
    Kind.MISSING_SLASH: ("</{name}>", "write `</{name}>`"),
    Kind.MISSING_ANGLE: ("<{text}", "insert `<`"),
    Kind.MISSPELT_MARK: ("{name}", "write `{name}`"),
    Kind.UNCLOSED_TAG: ("{text}>", "insert `>`"),
    Kind.BLANK_IN_TAG: ("<{name}", "write `<{name}`"),
    Kind.ODD_BLANK: (" ", "write an ordinary blank"),
    Kind.CURLY_QUOTES: ('"{bare}"', "use straight quotes"),
    Kind.UNQUOTED_VALUE: ('"{bare}"', "put quotes around it"),
    Kind.MISSING_EQUALS: ("{text}=", "insert `=`"),
    Kind.MISSING_SPACE: (" {text}", "insert a space"),
    Kind.ANGLE_IN_VALUE: ("&lt;", "write `&lt;`"),
    Kind.SECTION_END_IN_TEXT: ("]]&gt;", "write `]]&gt;`"),
    Kind.ODD_VERSION: ("1.0", "write `1.0`"),
}
"""The replacement of the span where that is plain, and its title."""
HARMLESS = {Kind.ANGLE_IN_VALUE, Kind.SECTION_END_IN_TEXT, Kind.ODD_VERSION}
"""Text that simulators read anyway, so that the file means the same after the fix."""


TAKEN = frozenset(
    (
        Kind.ANGLE_IN_VALUE,
        Kind.MISSING_SPACE,
        Kind.NESTED_COMMENT,
        Kind.SECTION_END_IN_TEXT,
        Kind.ILLEGAL_CHARACTER,
    )
)
READ = accepts("reads it anyway")
OF_TINYXML = refuses("refuses the file before version 4")
UNSEEN = warns("does not see the element before version 4")
"""The readings of tinyxml2, which the consumers use, of these."""


class SyntaxError(Rule):  # noqa: A001 - the name of the defect
    """The text is not well-formed XML.

    Nearly all of this makes every consumer refuse the whole file: libsdformat, Drake,
    MuJoCo and urdfdom read with tinyxml2, which stops at the first such place and often
    names another one. A `<` in a value, a `]]>` in a text, a missing space, one after a `<` and a second
    declaration are the exceptions: these consumers take them, and all strict XML parsers (Python's, ROS tools
    built on it) refuse the file. An odd number for the version of XML, or a misspelled declaration, is a warning
    for the same reason. The rest of the file is checked as far as it can be made out.
    """

    code = "XML001"
    name = "syntax-error"
    severity = Severity.ERROR
    remedy = """Complete the XML at the marked place: each `<tag>` needs its `</tag>`, each value its quotes.

    The place is where the text no longer fits; the missing part is often a few lines above it, at the tag
    that the label marks. A merge conflict is solved by keeping one of the two sides and removing the lines
    of `<<<<<<<`, `=======` and `>>>>>>>`. Editors that know XML close tags by themselves.
    """
    explains = (problems.SyntaxDefect,)

    bad = (
        Bad(
            '<sdf version="1.12">\n <world name="w">\n  <«light» name="l">\n </world>\n</sdf>',
            says="`<light>` is never closed",
        ),
        Bad(
            '<sdf version="1.12"><world name="w"><model name="m"><link name="l"><pose/>«</world>»</sdf>',
            says="`</link></model>` is missing before `</world>`",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><link name="a">\n  <collision name="c">\n      «<size>»1 1 1</size>\n'
            "    </box>\n   </geometry>\n   <laser_retro>1</laser_retro>\n  </collision>\n </link></model></sdf>",
            says="`<geometry><box>` is missing before `<size>`",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><link name="a"></«lnik»></model></sdf>',
            fixed='<sdf version="1.12"><model name="m"><link name="a"></link></model></sdf>',
            unsafe=True,
            says="`</lnik>` does not match `<link>`",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><link name="a"/>«</link>»</model></sdf>',
            says="closes nothing",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><static>true«<static>»<link name="a"/></model></sdf>',
            fixed='<sdf version="1.12"><model name="m"><static>true</static><link name="a"/></model></sdf>',
            unsafe=True,
            says="opens an element where `</static>` is meant",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><link name="a"/></model«>»',
            says="the file ends before `</sdf>`",
        ),
        Bad(
            '<sdf version="1.12"><world name="w"><light name="l" «type="point"»</light></world></sdf>',
            fixed='<sdf version="1.12"><world name="w"><light name="l" type="point"></light></world></sdf>',
            unsafe=True,
            says="`>` is missing at the end of the tag `<light`",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><link name=«"a»/></model></sdf>',
            says="`name` has no closing quote",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><link name=«a»/></model></sdf>',
            fixed='<sdf version="1.12"><model name="m"><link name="a"/></model></sdf>',
            unsafe=True,
            says="`name` is not in quotes",
        ),
        Bad(
            '<robot name="r"><link name="a"/><link name="b"/><joint name="j"«type»="fixed"><parent link="a"/>'
            '<child link="b"/></joint></robot>',
            fixed='<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="fixed"><parent link="a"/>'
            '<child link="b"/></joint></robot>',
            unsafe=True,
            says="a space is missing before `type`",
        ),
        Bad(
            '<robot name="r"><link name="a">«< /link»></robot>',
            fixed='<robot name="r"><link name="a"></link></robot>',
            unsafe=True,
            says="a space between `<` and `/link`",
        ),
        Bad(
            '<?xml version="1.0"?>\n«<?xml version="1.0"?>»\n<robot name="r"><link name="a"/></robot>',
            says="an XML declaration appears only once",
        ),
        Bad(
            '<sdf version="1.12"><model name="a«<»b"><link name="l"/></model></sdf>',
            fixed='<sdf version="1.12"><model name="a&lt;b"><link name="l"/></model></sdf>',
            says="`<` in the value of `name`",
        ),
        Bad(
            '<sdf version="1.12"><model name="m">«<!--» a link\n<link name="a"/></model></sdf>',
            says="is missing at the end of a comment",
        ),
        Bad(
            '<robot name="r">«<!-» <link name="l"/> -->\n<link name="a"/></robot>',
            fixed='<robot name="r"><!-- <link name="l"/> -->\n<link name="a"/></robot>',
            unsafe=True,
            says="`<!-` where `<!--` is meant",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><!-- a «<!--» b --> <link name="a"/> --></model></sdf>',
            says="a comment begins inside a comment",
        ),
        Bad(
            '<sdf version="1.12"><model name="m"><!-- <link name="b"> «<!--» b --></link> --><link name="a"/>'
            "</model></sdf>",
            says="a comment begins inside a comment",
        ),
        Bad('<sdf version="1.12">\n«<<<<<<<» HEAD\n=======\n>>>>>>> topic\n</sdf>', says="merge conflict"),
        Bad(
            '«<?xml verison="1.0"?>»\n<sdf version="1.12"><world name="w"/></sdf>',
            says="is not as XML wants it",
        ),
        Bad(
            '<?xml version="«0.0»"?>\n<sdf version="1.12"><world name="w"/></sdf>',
            fixed='<?xml version="1.0"?>\n<sdf version="1.12"><world name="w"/></sdf>',
            says="`0.0` is not a version of XML",
        ),
    )
    good = (
        Good(
            '<sdf version="1.12"><model name=\'the "best"\'><link name="a"/></model></sdf>',
            why="the other quotes",
        ),
        Good(
            '<sdf version="1.12"><model name="m"><link name="a>b"/></model></sdf>',
            why="`>` is free in values",
        ),
        Good('<sdf version="1.12"><!-- <model> --><world name="w"/></sdf>', why="a comment"),
    )

    def check(self, problem: problems.SyntaxDefect) -> Iterator[Diagnostic]:
        span, kind, other, name = problem.span, problem.kind, problem.other, problem.detail
        text = span.text.splitlines()[0][:60] if span.text else ""
        message = MESSAGES[kind].format(text=text, name=name)
        labels = {}
        affects = dict.fromkeys(Consumer, READ) if is_taken(problem) and not is_xacro(span) else {}
        if affects and not is_odd(problem) and kind is not Kind.SECOND_DECLARATION:
            affects[Consumer.ISAAC] = REFUSES  # its parser is a strict one
        if affects and kind is Kind.BLANK_IN_TAG:
            text_there = span.source.text
            is_empty = text_there.startswith("/", text_there.find(">", span.end) - 1)
            affects |= dict.fromkeys((Consumer.ROS, Consumer.URDFDOM), UNSEEN if is_empty else OF_TINYXML)
        if kind is Kind.TRUNCATED and other is not None:
            message = f"the file ends before `</{name}>`"
        elif kind is Kind.UNCLOSED_ELEMENT and other is not None and other.start < span.start:
            message, labels = missing_end(span, text, name), {other: "opened here"}
        elif kind is Kind.MISSING_START_TAG and not text.strip():
            message = f"`<{name}>` is missing here"
        elif kind is Kind.TEXT_OUTSIDE_ROOT and text.startswith("\ufeff"):
            message = "a second byte order mark before the root element"
        elif kind is Kind.MISMATCHED_END_TAG and other is not None:
            slash, other_slash = ("/", "") if other.start < span.start else ("", "/")
            message = f"`<{slash}{text}>` does not match `<{other_slash}{name}>`"
            labels = {other: "closed here" if other_slash else "opened here"}
        if other is not None and not labels and kind in LABELS:
            is_closed = kind is Kind.EXTRA_END_TAG and other.text == name
            labels = {other: "closed here already" if is_closed else LABELS[kind].format(name=name)}
        severity = Severity.WARNING if is_odd(problem) else None
        advice = ADVICE[kind].format(name=name) if kind in ADVICE else None
        yield self.diagnostic(
            span,
            message,
            severity=severity,
            labels=labels,
            fix=fix_for(problem),
            help=advice,
            affects=affects,
        )


def is_odd(problem: problems.SyntaxDefect) -> bool:
    """Is it only the declaration that is wrong?"""
    kind = problem.kind
    return kind is Kind.ODD_VERSION or (
        kind is Kind.MALFORMED_INSTRUCTION and problem.span.text.endswith("?>")
    )


def is_taken(problem: problems.SyntaxDefect) -> bool:
    """Does tinyxml2 read the file anyway? Of a comment in another one the rest may be left."""
    kind, span = problem.kind, problem.span
    if kind is Kind.SECOND_DECLARATION:
        return problem.other is not None and not span.source.text[problem.other.end : span.start].strip()
    if kind is Kind.BLANK_IN_TAG:
        return not span.text.startswith("</")
    if kind is Kind.MISSPELT_MARK:  # to tinyxml2 an unknown node, which ends at the first `>`
        comment = span.source.text[span.start : span.source.text.find("-->", span.end)]
        return span.text == "<!-" and "<" not in comment.partition(">")[2]
    return is_odd(problem) or (kind in TAKEN and (kind is not Kind.NESTED_COMMENT or not problem.detail))


def missing_end(span: Span, text: str, name: str) -> str:
    if not text.strip():
        return f"`</{name}>` is missing here"
    return f"`</{name}>` is missing {'before' if text.startswith('<') else 'after'} `{text}`"


def fix_for(problem: problems.SyntaxDefect) -> Fix | None:
    if problem.kind not in WRITTEN:
        return None
    text = problem.span.text
    written, title = (
        part.format(text=text, name=problem.detail, bare=bare(text)) for part in WRITTEN[problem.kind]
    )
    return replace(problem.span, written, title, unsafe=problem.kind not in HARMLESS)


def bare(text: str) -> str:
    """A value without whatever quotes it has."""
    return text.strip("\\\"'“”„‟‘’‚‛´`")  # noqa: RUF001 - these are what it is about
