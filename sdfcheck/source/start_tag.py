"""Start tags and their attributes, also those that are not as XML wants them."""

from __future__ import annotations

import re
from typing import NamedTuple

from sdfcheck.source.problems import Problem, RepeatedAttribute, SyntaxDefect, SyntaxKind
from sdfcheck.source.text import Source

_NAME = r"(?:[^\W\d]|:)[\w.\-:]*"
START = re.compile(rf"""<({_NAME})((?:\s+{_NAME}\s*=\s*(?:"[^"<]*"|'[^'<]*'))*)\s*(/?)>""")
"""A start tag as XML wants it: name, attributes, slash."""

_ATTRIBUTE = re.compile(rf"""\s+({_NAME})\s*=\s*(?:"([^"<]*)"|'([^'<]*)')""")
_TAG_NAME = re.compile(r"<([^\s<>/=\"']*)")
_BLANK = re.compile(r"\s*")
_ATTRIBUTE_NAME = re.compile(r"[^\s<>/=\"']+")
_WELL_NAMED = re.compile(_NAME)
_EQUALS = re.compile(r"\s*=\s*")
_UNQUOTED = re.compile(r"[^\s<>\"'/]+|/(?!>)")


class AttributePlace(NamedTuple):
    """Offsets of an attribute's name and of its value (inside the quotes)."""

    name: str
    name_start: int
    name_end: int
    value_start: int
    value_end: int


class StartTag(NamedTuple):
    """A start tag, parsed: ``end`` is behind its ``>``."""

    name: str
    name_start: int
    name_end: int
    attributes: tuple[AttributePlace, ...]
    end: int
    empty: bool


def parse_start_tag(source: Source, at: int) -> tuple[StartTag, list[Problem]]:
    """Parse the start tag whose ``<`` is at ``at``; always returns one, and what is wrong with it."""
    match = START.match(source.text, at)
    if match is None:
        return _Tolerant(source, at).parse()
    attributes = []
    for found in _ATTRIBUTE.finditer(source.text, match.end(1), match.end(2)):
        group = 2 if found[2] is not None else 3
        attributes.append(
            AttributePlace(found[1], found.start(1), found.end(1), found.start(group), found.end(group))
        )
    tag = StartTag(match[1], match.start(1), match.end(1), tuple(attributes), match.end(), bool(match[3]))
    return tag, _repeated(source, tag)


def _repeated(source: Source, tag: StartTag) -> list[Problem]:
    """Attributes given twice; doubled prefix declarations belong to the namespace analysis."""
    if len(tag.attributes) < 2:
        return []
    first: dict[str, AttributePlace] = {}
    problems: list[Problem] = []
    for attribute in tag.attributes:
        earlier = first.setdefault(attribute.name, attribute)
        if earlier is not attribute and not attribute.name.startswith("xmlns"):
            problems.append(
                RepeatedAttribute(
                    source.span(attribute.name_start, attribute.name_end),
                    source.span(earlier.name_start, earlier.name_end),
                )
            )
    return problems


class _Tolerant:
    """Reads a start tag that is not well formed, one attribute after the other."""

    def __init__(self, source: Source, at: int) -> None:
        self.source = source
        self.text = source.text
        self.at = at
        self.problems: list[Problem] = []
        self.attributes: list[AttributePlace] = []

    def parse(self) -> tuple[StartTag, list[Problem]]:
        text = self.text
        match = _TAG_NAME.match(text, self.at)
        assert match
        name, pos = match[1], match.end()
        if not _WELL_NAMED.fullmatch(name):
            self.defect(SyntaxKind.OTHER, match.start(1), pos, f"`{name}` is not a name that XML allows")
        empty = False
        while True:
            pos = _blank(text, pos)
            if text.startswith("/>", pos):
                empty, pos = True, pos + 2
                break
            mark = text[pos : pos + 1]
            if mark == ">":
                pos += 1
                break
            if mark in {"", "<"}:
                self.defect(SyntaxKind.UNCLOSED_TAG, self.at, match.end(), f"<{name}")
                break
            pos = self.attribute(pos)
        tag = StartTag(name, match.start(1), match.end(), tuple(self.attributes), pos, empty)
        return tag, self.problems + _repeated(self.source, tag)

    def attribute(self, pos: int) -> int:
        text = self.text
        match = _ATTRIBUTE_NAME.match(text, pos)
        if match is None:
            self.defect(SyntaxKind.MALFORMED_ATTRIBUTE, pos, pos + 1, text[pos])
            return pos + 1
        equals = _EQUALS.match(text, match.end())
        if equals is None:
            self.defect(SyntaxKind.VALUELESS_ATTRIBUTE, pos, match.end(), match[0])
            self.add(match, match.end(), match.end())
            return match.end()
        if not _WELL_NAMED.fullmatch(match[0]):
            self.defect(SyntaxKind.OTHER, pos, match.end(), f"`{match[0]}` is not a name that XML allows")
        elif self.attributes and not text[pos - 1].isspace():
            self.defect(SyntaxKind.OTHER, pos, match.end(), f"a space is missing before `{match[0]}`")
        return self.value(match, equals.end())

    def value(self, name: re.Match[str], pos: int) -> int:
        quote = self.text[pos : pos + 1]
        if quote not in {'"', "'"} or not quote:
            match = _UNQUOTED.match(self.text, pos)
            if match is None:
                self.defect(SyntaxKind.VALUELESS_ATTRIBUTE, name.start(), name.end(), name[0])
                self.add(name, pos, pos)
                return pos
            self.defect(SyntaxKind.UNQUOTED_VALUE, match.start(), match.end(), name[0])
            self.add(name, match.start(), match.end())
            return match.end()
        end = self.text.find(quote, pos + 1)
        angle = self.text.find("<", pos + 1, end if end >= 0 else len(self.text))
        if end < 0 or (angle >= 0 and _swallows_tags(self.text[angle:end])):
            return self.unclosed(name, pos)
        if angle >= 0:
            self.defect(SyntaxKind.ANGLE_IN_VALUE, angle, angle + 1, name[0])
        self.add(name, pos + 1, end)
        return end + 1

    def unclosed(self, name: re.Match[str], pos: int) -> int:
        """The closing quote is missing: the value ends with the tag, or with the line."""
        match = re.compile(r"[^<>\r\n]*?(?=\s*/?>|[<\r\n]|$)").match(self.text, pos + 1)
        end = match.end() if match else pos + 1
        self.defect(SyntaxKind.UNCLOSED_VALUE, pos, end, name[0])
        self.add(name, pos + 1, end)
        return end

    def add(self, name: re.Match[str], start: int, end: int) -> None:
        self.attributes.append(AttributePlace(name[0], name.start(), name.end(), start, end))

    def defect(self, kind: SyntaxKind, start: int, end: int, detail: str) -> None:
        self.problems.append(SyntaxDefect(self.source.span(start, end), kind, None, detail))


def _swallows_tags(value: str) -> bool:
    """A value that runs over a line end and into tags lacks its closing quote."""
    return ("\n" in value or "\r" in value) or bool(re.search(r"</?[\w:.\-]+[\s/>]", value))


def _blank(text: str, pos: int) -> int:
    match = _BLANK.match(text, pos)
    return match.end() if match else pos
