"""Broken tags, comments and sections: where they were meant to end, and what they were meant to be."""

from __future__ import annotations

import re

from sdfcheck.source.problems import Problem, SyntaxDefect, SyntaxKind
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.start_tag import NAME, AttributePlace, StartTag, is_name, repeated_attributes
from sdfcheck.source.text import Source

# Where comments and sections were meant to end, when their end is missing or misspelled.

_LINE = re.compile(r"[^\r\n]*")
_MISSPELT_COMMENT_END = re.compile(r"(?:--!>|--\s{1,80}>|(?<!-)->)")
_AT_LINE_END = re.compile(r"[ \t]*(?:[\r\n]|\Z)")
_MISSPELT_SECTION_END = re.compile(r"\]\s{0,80}\]?\s{0,80}>|\]\]")
_END_TAG = re.compile(r"<(/?)[A-Za-z_][^<>]*?(/?)>")
_SWITCHED_OFF = re.compile(r"<!--/?[A-Za-z_][\w:.\-]*(?:\s+[\w:.\-]+\s*=\s*(?:\"[^\"<]*\"|'[^'<]*'))*\s*/?>")
"""A comment that begins as a tag does: somebody has put `!--` into the tag, and not a note before it."""

_NEAR = 20_000
"""How far the end of something is looked for; farther away it would be a guess."""


class InnerComment(NamedTuple):
    """A ``<!--`` inside a comment.

    ``unclosed``: the outer comment lacks its end. Otherwise somebody has nested the two,
    and what was meant to be comment ends at ``rest_end``.
    """

    start: int
    unclosed: bool
    rest_end: int
    is_torn: bool = False
    """Elements that begin in the comment end in the rest."""


def line_end(text: str, at: int, limit: int | None = None) -> int:
    """The offset of the end of the line, at most ``limit``."""
    match = _LINE.match(text, at, len(text) if limit is None else limit)
    assert match
    return match.end()


class CommentEnd(NamedTuple):
    """Where a comment was meant to end; from ``misspelt`` on (-1: nowhere) is what was to end it."""

    end: int
    misspelt: int = -1


def comment_end(text: str, begin: int, limit: int | None = None) -> CommentEnd:
    """Where a comment without ``-->`` before ``limit`` was meant to end: at a misspelled end, or after its words."""
    limit = len(text) if limit is None else limit
    markup = text.find("<", begin, limit)
    if markup < 0:
        markup = limit
    proper = text.find("-->", begin, markup)
    if proper >= 0:
        return CommentEnd(proper + 3)
    if match := _MISSPELT_COMMENT_END.search(text, begin, markup):
        return CommentEnd(match.end(), match.start())
    following = text.find("<!--", begin, min(limit, begin + _NEAR))
    for match in _MISSPELT_COMMENT_END.finditer(text, markup, following if following >= 0 else begin + _NEAR):
        if _AT_LINE_END.match(text, match.end()):
            return CommentEnd(match.end(), match.start())
    if markup == len(text):
        return CommentEnd(markup)
    # Words up to the next markup, or markup that the comment was to hide.
    end = line_end(text, begin, limit)
    return CommentEnd(begin + len(text[begin:markup].rstrip()) if end < markup else end)


def find_inner_comment(text: str, at: int, end: int) -> InnerComment | None:
    """The comment from ``at`` to ``end`` holds another's beginning: why?

    None: no harm done, it is just there.
    """
    inner = text.find("<!--", at + 4, end - 3)
    if inner < 0:
        return None
    following = text.find("<!--", end, end + _NEAR)
    leftover = text.find("-->", end, following if following >= 0 else end + _NEAR)
    if leftover >= 0:
        return InnerComment(inner, False, leftover + 3, _balance(text, end, leftover) < 0)
    if _SWITCHED_OFF.match(text, at, inner):
        return None
    # An outer comment without end swallows what is between its words and the next comment.
    markup = text.find("<", at + 4)
    if text[at + 4 : markup].strip() and line_end(text, at, markup) < markup < inner:
        return InnerComment(inner, True, end)
    return InnerComment(inner, True, end) if _balance(text, at + 4, min(inner, at + _NEAR)) < 0 else None


def _balance(text: str, begin: int, end: int) -> int:
    """How many more elements begin than end."""
    return sum(-1 if tag[1] else not tag[2] for tag in _END_TAG.finditer(text, begin, end))


def section_end(text: str, begin: int) -> int:
    """Where a CDATA section without ``]]>`` was meant to end: at a misspelled end, or before an end tag."""
    limit = text.find("</", begin)
    if limit < 0:
        limit = len(text)
    match = _MISSPELT_SECTION_END.search(text, begin, limit)
    return match.end() if match else limit


# Start tags that are not well formed: what they were meant to be, and their faults.

_TAG_NAME = re.compile(r"\s*([^\s<>/=\"']*)")
_BLANK = re.compile(r"\s*")
_ODD_BLANK = re.compile(r"[^\S \t\r\n]")
_ATTRIBUTE_NAME = re.compile(r"[^\s<>/=\"']+")
_EQUALS = re.compile(r"\s*=\s*")
_UNQUOTED = re.compile(r"(?:[^\s<>\"'/]|/(?!>))+")
_UNOPENED = re.compile(r"([^<>\"'=]*)[\"'](?=[\s/>])")
_QUOTED = re.compile(r"([\"'])[^\"'<>\r\n]*\1(?=[\s/>])")
_CURLY = "“”„‟‘’‚‛´`"  # noqa: RUF001 - these are what is looked for
_CURLY_VALUE = re.compile(rf"[{_CURLY}]([^{_CURLY}<>\"'\r\n]*)[{_CURLY}]")
_ESCAPED_VALUE = re.compile(r"\\([\"'])([^\"'<>\r\n]*?)\\\1")
# Spaces are bounded so that a line of a million of them takes no hour.
_UNCLOSED = re.compile(r"[^<>\r\n]*?(?=[\"']?\s{0,80}/?>|[<\r\n]|\Z)")
_NEXT_ATTRIBUTE = re.compile(rf"(.*?)\s{{1,80}}{NAME}\s{{0,80}}=\s{{0,80}}")
_TAG = re.compile(r"</?[\w:.\-]+[\s/>]")
_LINE_END = re.compile(r"[\r\n]")
_END_NAME = re.compile(r"</([^\s<>]+)>")


def parse_broken_tag(source: Source, text: str, at: int) -> tuple[StartTag, list[Problem]]:
    """Read the tag whose ``<`` is at ``at``, one attribute after the other.

    ``text`` is the source's, or one in which some characters are blanked.
    """
    return _BrokenTag(source, text, at).parse()


class _BrokenTag:
    def __init__(self, source: Source, text: str, at: int) -> None:
        self.source = source
        self.text = text
        self.at = at
        match = _TAG_NAME.match(text, at + 1)
        assert match
        self.name = match[1]
        self.name_start, self.name_end = match.span(1)
        self.problems: list[Problem] = []
        self.attributes: list[AttributePlace] = []
        self.searched, self.value_end = 0, -1
        """From where the end of unclosed values was looked for, and where it is: many may share one."""
        self.confused = False
        """Where the attributes begin and end is a guess from here on, so nothing more is said of them."""

    def parse(self) -> tuple[StartTag, list[Problem]]:
        text, pos = self.text, self.name_end
        if self.name_start > self.at + 1:
            self.defect(SyntaxKind.BLANK_IN_TAG, self.at, self.name_end, self.name)
        if not is_name(self.name):
            self.defect(SyntaxKind.MALFORMED_NAME, self.name_start, self.name_end, self.name)
        while True:
            pos = self.blank(pos)
            if text.startswith("/>", pos):
                return self.finish(pos + 2, empty=True)
            if text.startswith("\\>", pos):
                self.attribute_defect(SyntaxKind.MALFORMED_ATTRIBUTE, pos, pos + 1, "\\")
                return self.finish(pos + 2, empty=True)
            mark = text[pos : pos + 1]
            if mark == ">":
                return self.finish(pos + 1, empty=False)
            if text.startswith("<!--", pos) and (end := text.find("-->", pos)) >= 0:
                self.defect(SyntaxKind.COMMENT_IN_TAG, pos, end + 3, self.name)
                pos = end + 3
            elif mark in {"", "<"}:
                return self.unclosed(pos)
            else:
                pos = self.attribute(pos)

    def finish(self, end: int, *, empty: bool) -> tuple[StartTag, list[Problem]]:
        tag = StartTag(self.name, self.name_start, self.name_end, tuple(self.attributes), end, empty)
        repeated = [] if self.confused else repeated_attributes(self.source, tag)
        return tag, self.problems + repeated

    def unclosed(self, pos: int) -> tuple[StartTag, list[Problem]]:
        """The ``>`` is missing: the tag ends with its last attribute, and what follows is text."""
        if pos == len(self.text):
            self.problems.clear()
            end = self.at + len(self.text[self.at : line_end(self.text, self.at)].rstrip())
            self.defect(SyntaxKind.TRUNCATED, self.at, end, self.name)
            return self.finish(pos, empty=False)
        start, end = self.name_start, self.name_end
        if self.attributes:
            last = self.attributes[-1]
            start, end = last.name_start, last.value_end
            end += self.text[end] in "\"'"
        if empty := self.text[end:pos].strip() == "/":
            start = self.text.index("/", end)
            end = start + 1
        elif not self.attributes:
            # <mass1</mass>: the value is stuck to the name.
            match = _END_NAME.match(self.text, pos)
            if match and self.name.startswith(match[1]):
                self.name = match[1]
                end = self.name_end = start + len(self.name)
        if not any(p.kind is SyntaxKind.UNCLOSED_VALUE for p in self.problems if isinstance(p, SyntaxDefect)):
            self.problems.clear()
            self.defect(SyntaxKind.UNCLOSED_TAG, start, end, self.name)
        self.confused = True
        return self.finish(end, empty=empty)

    def attribute(self, pos: int) -> int:
        text = self.text
        match = _ATTRIBUTE_NAME.match(text, pos)
        if match is None:
            self.attribute_defect(SyntaxKind.MALFORMED_ATTRIBUTE, pos, pos + 1, text[pos], confusing=True)
            return pos + 1
        equals = _EQUALS.match(text, match.end())
        sticks = not text[pos - 1].isspace() and bool(self.attributes)
        if equals is None and sticks:
            # A quote too many inside the value; or a comma after it.
            at, end = (pos - 1, pos) if is_name(match[0]) else match.span()
            self.attribute_defect(SyntaxKind.MALFORMED_ATTRIBUTE, at, end, text[at:end], confusing=True)
            return match.end()
        if equals is None:
            if _QUOTED.match(text, match.end()):
                self.attribute_defect(SyntaxKind.MISSING_EQUALS, pos, match.end(), match[0])
                return self.value(match, match.end())
            self.attribute_defect(SyntaxKind.VALUELESS_ATTRIBUTE, pos, match.end(), match[0], confusing=True)
            return match.end()
        if not is_name(match[0]):
            self.attribute_defect(SyntaxKind.MALFORMED_NAME, pos, match.end(), match[0])
        elif sticks:
            self.attribute_defect(SyntaxKind.MISSING_SPACE, pos, match.end(), match[0])
        self.look_for_odd_blank(match.end(), equals.end())
        return self.value(match, equals.end())

    def value(self, name: re.Match[str], pos: int) -> int:
        quote = self.text[pos : pos + 1]
        if quote not in {'"', "'"}:
            return self.unquoted(name, pos)
        end = self.text.find(quote, pos + 1)
        if end < 0:
            return self.unclosed_value(name, pos)
        follows = self.text[end + 1 : end + 2]
        angle = self.text.find("<", pos + 1, end)
        if angle < 0 and (not follows or follows in " \t\r\n/>?<"):
            self.add(name, pos + 1, end)
            return end + 1
        value = self.text[pos + 1 : end]
        if value.rstrip().endswith("=") and (follows.isalnum() or angle >= 0):
            return self.unclosed_value(name, pos)
        if angle >= 0:
            if (follows and follows not in " \t\r\n/>") or _has_swallowed_tag(value):
                return self.unclosed_value(name, pos)
            self.attribute_defect(SyntaxKind.ANGLE_IN_VALUE, angle, angle + 1, name[0])
        self.add(name, pos + 1, end)
        return end + 1

    def unclosed_value(self, name: re.Match[str], pos: int) -> int:
        """No closing quote: the value ends before the next attribute, or with the tag or the line."""
        if not self.searched <= pos + 1 <= self.value_end:
            match = _UNCLOSED.match(self.text, pos + 1)
            assert match
            self.searched, self.value_end = pos + 1, match.end()
        end = self.value_end
        following = _NEXT_ATTRIBUTE.match(self.text, pos + 1, end)
        if following and self.text[following.end() : following.end() + 1] in {'"', "'"}:
            end = following.end(1)
        self.attribute_defect(SyntaxKind.UNCLOSED_VALUE, pos, end, name[0])
        self.add(name, pos + 1, end)
        return end + (self.text[end : end + 1] in {'"', "'"})

    def unquoted(self, name: re.Match[str], pos: int) -> int:
        for pattern, group, kind in (
            (_CURLY_VALUE, 1, SyntaxKind.CURLY_QUOTES),
            (_ESCAPED_VALUE, 2, SyntaxKind.UNQUOTED_VALUE),
            (_UNOPENED, 1, SyntaxKind.UNQUOTED_VALUE),
            (_UNQUOTED, 0, SyntaxKind.UNQUOTED_VALUE),
        ):
            if match := pattern.match(self.text, pos):
                self.attribute_defect(kind, match.start(), match.end(), name[0])
                self.add(name, match.start(group), match.end(group))
                return match.end()
        self.attribute_defect(
            SyntaxKind.VALUELESS_ATTRIBUTE, name.start(), name.end(), name[0], confusing=True
        )
        return pos

    def add(self, name: re.Match[str], start: int, end: int) -> None:
        self.attributes.append(AttributePlace(name[0], name.start(), name.end(), start, end))

    def attribute_defect(
        self, kind: SyntaxKind, start: int, end: int, detail: str, *, confusing: bool = False
    ) -> None:
        if not self.confused:
            self.defect(kind, start, end, detail)
        self.confused |= confusing

    def defect(self, kind: SyntaxKind, start: int, end: int, detail: str) -> None:
        self.problems.append(SyntaxDefect(self.source.span(start, end), kind, None, detail))

    def blank(self, pos: int) -> int:
        match = _BLANK.match(self.text, pos)
        assert match
        self.look_for_odd_blank(pos, match.end())
        return match.end()

    def look_for_odd_blank(self, start: int, end: int) -> None:
        if odd := _ODD_BLANK.search(self.text, start, end):
            self.attribute_defect(SyntaxKind.ODD_BLANK, odd.start(), odd.end(), f"U+{ord(odd[0]):04X}")


def _has_swallowed_tag(value: str) -> bool:
    """Is there a tag in a value, and a line end before or after it?"""
    tags = list(_TAG.finditer(value))
    return bool(tags) and bool(
        _LINE_END.search(value, tags[0].end()) or _LINE_END.search(value, 0, tags[-1].start())
    )
