"""The scan of any text: one pass, never failing; a faulty text is written anew for a parser."""

from __future__ import annotations

import re
import sys
from bisect import bisect_left

from sdfcheck.source.decode import ATTRIBUTE_LIMIT, LENGTH_LIMIT
from sdfcheck.source.problems import Problem, SyntaxDefect, SyntaxKind, UnknownEntity
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.scanner.pairing import pair
from sdfcheck.source.scanner.scan import MARKUP, Scan
from sdfcheck.source.scanner.start_tag import (
    BLANK,
    NAME,
    START,
    StartTag,
    is_name,
    made_name,
    repeated_attributes,
    tag_of,
)
from sdfcheck.source.scanner.tokenizer import tokenize
from sdfcheck.source.scanner.tokens import Act, Step, Token, TokenKind, Tokens
from sdfcheck.source.text import Source, Span

# A text without what no markup can be made of; all else stays in its place.


_ILLEGAL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]+")
_CONFLICT_MARKER = re.compile(r"^(?:<{7}|\|{7}|={7}|>{7})(?: [^\r\n]*)?(?=[\r\n]|\Z)", re.MULTILINE)
_NO_LINE_END = re.compile(r"[^\r\n]")


class Prepared(NamedTuple):
    """``text`` is as long as the source's, with spaces for what was taken out."""

    text: str
    problems: list[Problem]
    doubtful: list[tuple[int, int]]


def prepare(source: Source) -> Prepared:
    """Blank the characters that XML does not know, and the other side of merge conflicts."""
    text = source.text
    problems: list[Problem] = []
    doubtful: list[tuple[int, int]] = []
    if illegal := _ILLEGAL.search(text):
        problems.append(_illegal(source, illegal))
        text = _ILLEGAL.sub(lambda match: " " * len(match[0]), text)
    if "<<<<<<<" in text:
        pieces, copied = [], 0
        for start, other, last, end in _conflicts(text):
            marker = source.span(start, start + 7)
            problems.append(SyntaxDefect(marker, SyntaxKind.MERGE_CONFLICT, source.span(last, last + 7)))
            doubtful.append((start, end))
            line_end = text.index("\n", start) if "\n" in text[start:other] else start + 7
            for blank, blank_end in ((start, line_end), (other, end)):
                pieces += [text[copied:blank], _NO_LINE_END.sub(" ", text[blank:blank_end])]
                copied = blank_end
        text = "".join((*pieces, text[copied:]))
    return Prepared(text, problems, doubtful)


def _conflicts(text: str) -> list[tuple[int, int, int, int]]:
    """Of each merge conflict: its start, that of the other side, and those of its last marker."""
    found = []
    start = other = -1
    for match in _CONFLICT_MARKER.finditer(text):
        mark = match[0][0]
        if mark == "<":
            start, other = match.start(), -1
        elif start >= 0 and other < 0 and mark in "|=":
            other = match.start()
        elif start >= 0 and other >= 0 and mark == ">":
            found.append((start, other, *match.span()))
            start = other = -1
    return found


def _illegal(source: Source, match: re.Match[str]) -> SyntaxDefect:
    count = sum(len(run) for run in _ILLEGAL.findall(source.text))
    detail = f"U+{ord(match[0][0]):04X}" + (f", {count} in all" if count > 1 else "")
    return SyntaxDefect(source.span(*match.span()), SyntaxKind.ILLEGAL_CHARACTER, None, detail)


# Writing a faulty text anew so that an XML parser accepts it.
#
# Well-formed text is copied. Start tags keep their number and order, which is all that the
# mapping between tree and text needs.


REFERENCE_LIMIT = 100_000
"""So many undefined references of one file are listed; more than that are no description, and would fill the memory."""

_AMPERSAND = re.compile(r"&(?:([\w.\-:]+);|(#[0-9]{1,8}|#x[0-9a-fA-F]{1,7});)?")
_OPENING = re.compile(r"\A<!?\[?[A-Za-z]+\[?")
_CUT_REFERENCE = re.compile(r"&#?[\w.\-:]*\Z")
_PREDEFINED = frozenset({"amp", "lt", "gt", "quot", "apos"})
_INSTRUCTION = re.compile(rf"<\?(?!xml)({NAME})(?:{BLANK}|\?>)", re.IGNORECASE)


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
        else:
            match = _INSTRUCTION.match(text) if len(text) <= LENGTH_LIMIT and text.endswith("?>") else None
            if match is None or not is_name(match[1]):
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


# The scan of any text: one pass, never failing.
#
# It also says why a text is not well formed (:mod:`sdfcheck.source.problems`) and rewrites
# it in well-formed XML, so that the rest can be linted. Three steps: cut the text up, join
# the tags, write.


def scan(source: Source) -> Scan:
    """The places and defects of a text, and the text rewritten."""
    prepared = prepare(source)
    return assemble(source, prepared, tokenize(source, prepared.text), prepared.text)[0]


def assemble(source: Source, prepared: Prepared, tokens: Tokens, copied: str) -> tuple[Scan, int]:
    """The scan that the pieces of a text make, and where it ends; ``copied`` is the text that is written anew."""
    result = Scan()
    pairs = pair(source, prepared.text, tokens)
    writer = Writer(source, copied, result, tokens.entities)
    writer.write(pairs.steps)
    read = (problem for problem in (*prepared.problems, *tokens.problems) if problem.span.start < pairs.end)
    found = [*read, *pairs.problems, *result.problems]
    result.problems = sorted(found, key=lambda problem: (problem.span.start, problem.span.end))
    result.doubtful = [*prepared.doubtful, *tokens.doubtful, *pairs.doubtful]
    pieces = (token for token in tokens.pieces if token.kind is TokenKind.COMMENT)
    result.comments = [(token.start, token.end) for token in pieces if token.start < pairs.end]
    return result, pairs.end


# The scan of a long text that is broken in one place.
#
# Text that is well formed far before and after the place is found by one search and hidden from the
# tolerant steps. A strict parser has the last word: where it does not read the result, or where something
# is wrong elsewhere, the whole text is scanned.


WINDOW = 16_384
"""So many characters before and after the place are never hidden."""
_WORTHWHILE = 256
"""Shorter text is not hidden."""


class _Stretch(NamedTuple):
    """Whole elements, one after the other: where they are in the text, and among the places of a scan."""

    start: int
    end: int
    places: Scan


def local_scan(source: Source, fault: int) -> Scan | None:
    """The scan of a text in which a strict parser found a fault; None where the whole text has to be looked at.

    The caller has to make sure that a strict parser reads ``wellformed``, and finds as many elements as the scan.
    """
    text, prepared = source.text, prepare(source)
    first, last = fault - WINDOW, fault + WINDOW
    if prepared.problems or "<!DOCTYPE" in text:
        return None
    hidden = [*_before(text, first), *_after(text, last)]
    if not hidden:
        return None
    masked = _masked(text, hidden)
    tokens = tokenize(source, masked)
    starts = {stretch.start for stretch in hidden}
    pieces = [token for token in tokens.pieces if token.start not in starts]
    if len(pieces) != len(tokens.pieces) - len(hidden):
        return None
    tokens = tokens._replace(pieces=pieces)
    found, end = assemble(source, prepared._replace(text=masked), tokens, text)
    is_near = all(first <= place <= last for problem in found.problems for place in _places(problem))
    if end < len(text) or not found.problems or not is_near:
        return None
    return _completed(found, hidden)


def _before(text: str, end: int) -> list[_Stretch]:
    """The whole elements before an offset."""
    places, lone_starts, lone_ends, sound_end = _read(text, 0, end)
    tags = [(places.starts[index], places.ends[index]) for index in lone_starts]
    return [] if lone_ends else _between(tags, places, tags[0][0] if tags else 0, sound_end)


def _after(text: str, start: int) -> list[_Stretch]:
    """The whole elements after an offset, from the first tag on a line of its own."""
    begin = text.find("\n", start)
    begin = text.find("<", begin) if begin >= 0 else -1
    if begin < 0:
        return []
    places, lone_starts, lone_ends, _ = _read(text, begin, len(text))
    return [] if lone_starts or not lone_ends else _between(lone_ends, places, begin, lone_ends[-1][0])


def _read(text: str, start: int, end: int) -> tuple[Scan, list[int], list[tuple[int, int]], int]:
    """The places of elements, which start and end tags have no other half, and where the last markup ends."""
    places = Scan()
    starts, ends, closes, close_ends = places.starts, places.ends, places.closes, places.close_ends
    unclosed: list[int] = []
    lone_ends: list[tuple[int, int]] = []
    after = start
    for match in MARKUP.finditer(text, start, max(end, start)):
        at, after = match.span()
        kind = match.lastindex
        if kind == 1:
            if unclosed:
                index = unclosed.pop()
                closes[index], close_ends[index] = at, after
            else:
                lone_ends.append((at, after))
        elif text[at + 1] not in "!?":
            if kind is None:
                unclosed.append(len(starts))
            starts.append(at)
            ends.append(after)
            closes.append(after)
            close_ends.append(after)
        elif text.startswith("<!--", at):
            places.comments.append((at, after))
    return places, unclosed, lone_ends, after


def _between(tags: list[tuple[int, int]], places: Scan, start: int, end: int) -> list[_Stretch]:
    """The text between unpaired tags, where it is long."""
    found = []
    for at, after in (*tags, (end, end)):
        if at - start > _WORTHWHILE:
            found.append(_Stretch(start, at, places))
        start = after
    return found


def _masked(text: str, hidden: list[_Stretch]) -> str:
    """The text with instructions of the same length in place of what is hidden."""
    pieces: list[str] = []
    copied = 0
    for start, end, _ in hidden:
        pieces += (text[copied:start], "<?hidden", " " * (end - start - 10), "?>")
        copied = end
    return "".join((*pieces, text[copied:]))


def _places(problem: Problem) -> list[int]:
    """Where the places of a problem begin."""
    values = (getattr(problem, field) for field in problem._fields)
    return [value.start for value in values if isinstance(value, Span)]


def _completed(found: Scan, hidden: list[_Stretch]) -> Scan:
    """A scan with the places of what was hidden."""
    result = Scan()
    result.problems, result.doubtful, result.wellformed = found.problems, found.doubtful, found.wellformed
    result.comments = found.comments
    taken = 0
    for start, end, places in (*hidden, _Stretch(sys.maxsize, 0, Scan())):
        until = bisect_left(found.starts, start)
        shift = len(result.starts) - taken
        result.odd |= {index + shift: tag for index, tag in found.odd.items() if taken <= index < until}
        first, last = bisect_left(places.starts, start), bisect_left(places.starts, end)
        for name in ("starts", "ends", "closes", "close_ends"):
            getattr(result, name).extend(getattr(found, name)[taken:until])
            getattr(result, name).extend(getattr(places, name)[first:last])
        result.comments += [comment for comment in places.comments if start <= comment[0] < end]
        taken = until
    result.comments = sorted(result.comments)
    return result
