"""Writing a faulty text anew so that an XML parser accepts it.

Well-formed text is copied. Start tags keep their number and order, which is all that the
mapping between tree and text needs.
"""

from __future__ import annotations

import re

from sdfcheck.source.limits import ATTRIBUTE_LIMIT, LENGTH_LIMIT
from sdfcheck.source.problems import SyntaxDefect, SyntaxKind, UnknownEntity
from sdfcheck.source.scanner.scan import Scan
from sdfcheck.source.scanner.start_tag import BLANK, NAME, START, StartTag, repeated_attributes, tag_of
from sdfcheck.source.scanner.steps import Act, Step
from sdfcheck.source.scanner.tokens import Token, TokenKind
from sdfcheck.source.scanner.xml_names import made_name
from sdfcheck.source.text import Source

REFERENCE_LIMIT = 1_000
"""How many undefined references of one file are worth a list."""

_AMPERSAND = re.compile(r"&(?:([\w.\-:]+);|(#[0-9]{1,8}|#x[0-9a-fA-F]{1,7});)?")
_OPENING = re.compile(r"\A<!?\[?[A-Za-z]+\[?")
_CUT_REFERENCE = re.compile(r"&#?[\w.\-:]*\Z")
_PREDEFINED = frozenset({"amp", "lt", "gt", "quot", "apos"})
_INSTRUCTION = re.compile(rf"<\?(?!xml){NAME}(?:{BLANK}|\?>)", re.IGNORECASE)


class Writer:
    """Writes the text into a scan, and the places of its elements."""

    def __init__(self, source: Source, text: str, scan: Scan, entities: tuple[str, ...]) -> None:
        self.source = source
        self.text = text
        self.scan = scan
        self.problems = scan.problems
        self.entities = entities
        self.budget = REFERENCE_LIMIT
        self.pieces: list[str] = []
        self.copied = 0
        self.open: list[tuple[int, str]] = []

    def write(self, steps: list[Step]) -> None:
        if not steps:
            return
        self.copied = next((step.token.start for step in steps if step.act is Act.OPEN), 0)
        for act, token, _, name in steps:
            if act is Act.OPEN:
                self.start_tag(token, name)
            elif act is Act.CLOSE:
                self.end_tag(token)
            elif act is Act.DROP:
                self.replace(token, "")
            elif token.kind is TokenKind.TEXT:
                self.content(token)
            else:
                self.aside(token)
        self.scan.wellformed = "".join(self.pieces)

    def replace(self, token: Token, written: str) -> None:
        self.pieces += (self.text[self.copied : token.start], written)
        self.copied = token.end

    def start_tag(self, token: Token, name: str) -> None:
        scan, index = self.scan, len(self.scan.starts)
        scan.starts.append(token.start)
        for ends in (scan.ends, scan.closes, scan.close_ends):
            ends.append(token.end)
        tag = token.tag
        whole = self.text[token.start : token.end]
        if tag is not None or whole != self.source.text[token.start : token.end]:
            tag = tag or self.parse(token)
            scan.odd[index] = tag
        elif "&" in whole or whole.count("=") > 1 or len(whole) > LENGTH_LIMIT:
            tag = self.parse(token)
            self.problems += repeated_attributes(self.source, tag)
        is_sound = tag is None or (not self.value_problems(tag) and "&" not in whole)
        written = made_name(name)
        if index in scan.odd or not is_sound or name != token.name:
            self.replace(token, self.rewritten(tag or self.parse(token), written))
        if token.kind is TokenKind.START:
            self.open.append((index, written))
        else:
            self.flush(token.end)

    def parse(self, token: Token) -> StartTag:
        match = START.match(self.text, token.start)
        assert match
        return tag_of(match)

    def value_problems(self, tag: StartTag) -> bool:
        """Note what is wrong in the values; is there anything, or an attribute given twice?"""
        before = len(self.problems)
        if len(tag.attributes) > ATTRIBUTE_LIMIT:
            first = tag.attributes[ATTRIBUTE_LIMIT]
            span = self.source.span(first.name_start, first.name_end)
            self.problems.append(SyntaxDefect(span, SyntaxKind.TOO_MANY, None, tag.name))
        for attribute in tag.attributes:
            start, end = attribute.value_start, attribute.value_end
            self.references(start, end)
            if end - start > LENGTH_LIMIT:
                span = self.source.span(attribute.name_start, attribute.name_end)
                self.problems.append(SyntaxDefect(span, SyntaxKind.TOO_LONG, None, attribute.name))
        names = {attribute.name for attribute in tag.attributes}
        return len(self.problems) > before or len(names) < len(tag.attributes)

    def rewritten(self, tag: StartTag, name: str) -> str:
        pieces = [f"<{name}"]
        seen = set()
        for attribute in tag.attributes[:ATTRIBUTE_LIMIT]:
            start, end = attribute.value_start, attribute.value_end
            if end - start > LENGTH_LIMIT:
                end = start
            safe = made_name(attribute.name)
            if safe in seen:
                continue
            seen.add(safe)
            pieces.append(f' {safe}="{_escape(self.text[start:end])}"')
        pieces.append("/>" if tag.empty else ">")
        return "".join(pieces)

    def end_tag(self, token: Token) -> None:
        index, name = self.open.pop()
        self.scan.closes[index], self.scan.close_ends[index] = token.start, token.end
        if self.text[token.start : token.end] != f"</{name}>":
            self.replace(token, f"</{name}>")
        self.flush(token.end)

    def flush(self, end: int) -> None:
        """Copy what is left once the root is closed."""
        if not self.open:
            self.pieces.append(self.text[self.copied : end])
            self.copied = end

    def content(self, token: Token) -> None:
        start, end = token.start, token.end
        text = self.text[start:end]
        before = len(self.problems)
        self.references(start, end)
        if len(text) > LENGTH_LIMIT:
            span = self.source.span(start, start)
            self.problems.append(SyntaxDefect(span, SyntaxKind.TOO_LONG, None, self.open[-1][1]))
        section_end = text.find("]]>")
        if section_end >= 0:
            span = self.source.span(start + section_end, start + section_end + 3)
            self.problems.append(SyntaxDefect(span, SyntaxKind.SECTION_END_IN_TEXT))
        if len(self.problems) > before or "<" in text or "&" in text:
            self.replace(token, _escape(text[:LENGTH_LIMIT]))

    def aside(self, token: Token) -> None:
        """Comments, CDATA sections and instructions: they separate the text as the real ones do."""
        text = self.text[token.start : token.end]
        if token.kind is TokenKind.COMMENT:
            if len(text) < 7 or "--" in text[4:-3] or text.endswith("--->") or not text.endswith("-->"):
                self.replace(token, "<!---->")
        elif token.kind is TokenKind.SECTION:
            if len(text) > LENGTH_LIMIT or not (text.startswith("<![CDATA[") and text.endswith("]]>")):
                content = _OPENING.sub("", text[:LENGTH_LIMIT]).removesuffix("]]>")
                self.replace(token, _escape(content.replace("&", "&amp;")))
        elif len(text) > LENGTH_LIMIT or not (_INSTRUCTION.match(text) and text.endswith("?>")):
            self.replace(token, "")

    def references(self, start: int, end: int) -> None:
        """Note bare ampersands and references that XML does not define.

        Names that the document type declares are not among them: simulators do not read
        them either, but that is said of the document type.
        """
        if self.text.find("&", start, end) < 0:
            return
        for match in _AMPERSAND.finditer(self.text, start, end):
            if _is_defined(match) or match[1] in self.entities:
                continue
            # At the end of the text it is cut, and that is said already.
            if self.budget > 0 and not _CUT_REFERENCE.match(self.text, match.start()):
                self.budget -= 1
                span = self.source.span(match.start(), match.end())
                self.problems.append(UnknownEntity(span, match[1] or match[2] or ""))


def _is_defined(match: re.Match[str]) -> bool:
    if match[1]:
        return match[1] in _PREDEFINED
    if not match[2]:
        return False
    digits = match[2]
    code = int(f"0{digits[1:]}", 0) if digits[1] == "x" else int(digits[1:])
    return code in {9, 10, 13} or (
        0x20 <= code <= 0x10FFFF and not 0xD800 <= code <= 0xDFFF and code not in {0xFFFE, 0xFFFF}
    )


def _escape(text: str) -> str:
    if "&" in text:
        text = _AMPERSAND.sub(lambda m: m[0] if _is_defined(m) else "&amp;" + m[0][1:], text)
    return text.replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")
