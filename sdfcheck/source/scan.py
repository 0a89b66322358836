"""Where everything stands: one pass over the text, never failing.

lxml keeps the tree; this scan keeps the places. Both number elements in document
order, which is how they find each other. On a text that is not well formed the scan
also says why (:mod:`sdfcheck.source.problems`) and writes it anew, well formed, so
that the rest can be linted all the same.
"""

from __future__ import annotations

import re
from typing import NamedTuple

from sdfcheck.source.problems import (
    CommentHyphens,
    ContentAfterRoot,
    DocumentType,
    LateDeclaration,
    Problem,
    SyntaxDefect,
    SyntaxKind,
    TooDeep,
)
from sdfcheck.source.start_tag import START, StartTag, parse_start_tag
from sdfcheck.source.text import Source, Span
from sdfcheck.source.wellformed import LENGTH_LIMIT, Rewriter, find_illegal, find_unknown_entities

DEPTH_LIMIT = 256
"""Deeper than this libxml2 refuses to read; tinyxml2, which libsdformat uses, ends at 500."""

_END = re.compile(r"</\s*([^\s<>]*)\s*>")
_NESTING = re.compile(r"[\[\]>]|<!--.*?-->|\"[^\"]*\"|'[^']*'", re.S)
_ENTITY = re.compile(r"<!ENTITY\s+(?:%\s+)?([\w.\-:]+)")
_HYPHENS = re.compile(r"-{2,}")
_NOT_BLANK = re.compile(r"\S")


class ElementPlace(NamedTuple):
    """Offsets of an element's tags: start tag ``start:end``, end tag ``close:close_end``.

    An element without an end tag (``<a/>``, or never closed) has ``close == close_end``.
    """

    start: int
    end: int
    close: int
    close_end: int


class Scan:
    """The places of one text's elements (in document order), comments and defects."""

    __slots__ = (
        "close_ends",
        "closes",
        "comments",
        "document_type",
        "ends",
        "odd",
        "problems",
        "starts",
        "wellformed",
    )

    def __init__(self) -> None:
        self.starts: list[int] = []
        self.ends: list[int] = []
        self.closes: list[int] = []
        self.close_ends: list[int] = []
        self.comments: list[tuple[int, int]] = []
        self.document_type: Span | None = None
        self.problems: list[Problem] = []
        self.odd: dict[int, StartTag] = {}
        """Start tags that are not as XML wants them, by their place in the order."""
        self.wellformed = ""
        """The text written anew, well formed; empty unless asked for."""

    def place(self, index: int) -> ElementPlace:
        return ElementPlace(
            self.starts[index], self.ends[index], self.closes[index], self.close_ends[index]
        )


def scan(source: Source, *, rewrite: bool = False) -> Scan:
    """Scan a text; with ``rewrite`` also write it anew in well-formed XML."""
    return _Scanner(source, Rewriter() if rewrite else None).run()


class _Scanner:
    """The state of one scan: the elements that are open, and what was found so far."""

    def __init__(self, source: Source, rewriter: Rewriter | None) -> None:
        self.source = source
        self.text = source.text
        self.out = rewriter
        self.result = Scan()
        self.problems = self.result.problems
        self.open: list[tuple[int, str]] = []
        self.too_deep = 0
        self.root_done = False
        self.entities: tuple[str, ...] = ()

    def run(self) -> Scan:
        text, pos = self.text, 0
        if illegal := find_illegal(self.source):
            self.problems.append(illegal)
        while True:
            angle = text.find("<", pos)
            if angle != pos and not self.take_text(pos, len(text) if angle < 0 else angle):
                break
            if angle < 0:
                break
            pos = self.take_markup(angle)
            if pos < 0:
                break
        self.finish()
        return self.result

    # Each `take_…` looks at one piece and returns the offset behind it, or -1 to stop.

    def take_markup(self, at: int) -> int:
        follows = self.text[at + 1 : at + 2]
        if follows == "/":
            return self.take_end_tag(at)
        if follows == "!":
            return self.take_declaration(at)
        if follows == "?":
            return self.take_instruction(at)
        if follows.isalpha() or follows in {"_", ":"}:
            return self.take_start_tag(at)
        self.defect(SyntaxKind.STRAY_ANGLE, at, at + 1)
        if self.out and self.open:
            self.out.text("<")
        return at + 1

    def take_start_tag(self, at: int) -> int:
        if self.root_done:
            tag, _ = parse_start_tag(self.source, at)
            return self.after_root(tag.name_start, tag.name_end)
        if len(self.open) >= DEPTH_LIMIT:
            return self.take_too_deep(at)
        result, index = self.result, len(self.result.starts)
        match = START.match(self.text, at)
        if match and not self.out:
            end, name, empty = match.end(), match[1], bool(match[3])
        else:
            tag, problems = parse_start_tag(self.source, at)
            self.problems += problems
            if problems:
                result.odd[index] = tag
            end, name, empty = tag.end, tag.name, tag.empty
            if self.out:
                self.problems += self.out.start_tag(self.source, tag, self.entities)
        result.starts.append(at)
        result.ends.append(end)
        result.closes.append(end)
        result.close_ends.append(end)
        if not empty:
            self.open.append((index, name))
        elif not self.open:
            self.root_done = True
        return end

    def take_end_tag(self, at: int) -> int:
        match = _END.match(self.text, at)
        if match is None:
            end = self.text.find(">", at) + 1
            following = self.text.find("<", at + 1)
            if end == 0 or -1 < following < end:
                end = following if following >= 0 else len(self.text)
            self.defect(SyntaxKind.UNCLOSED_TAG, at, end, detail=self.text[at:end].strip())
            name = self.text[at + 2 : end].strip("> \t\r\n")
        else:
            name, end = match[1], match.end()
        if self.too_deep:
            self.too_deep -= 1
            return end
        return self.close(name, at, end)

    def close(self, name: str, at: int, end: int) -> int:
        if not self.open:
            if self.root_done:
                return self.after_root(at, end)
            self.defect(SyntaxKind.EXTRA_END_TAG, at, end, detail=name)
            return end
        index, opened = self.open[-1]
        if name != opened:
            names = [n for _, n in self.open]
            if name not in names:
                # A misspelt end tag closes its element; a left-over one closes nothing.
                start = self.name_span(index)
                if _alike(name, opened):
                    self.defect(SyntaxKind.MISMATCHED_END_TAG, at + 2, at + 2 + len(name), start, opened)
                else:
                    self.defect(SyntaxKind.EXTRA_END_TAG, at + 2, at + 2 + len(name), start, name)
                    return end
            else:
                here = self.source.span(at, end)
                while self.open[-1][1] != name:
                    self.leave_open(SyntaxKind.UNCLOSED_ELEMENT, at, here)
        index, _ = self.open.pop()
        self.result.closes[index], self.result.close_ends[index] = at, end
        if self.out:
            self.out.end_tag()
        self.root_done = not self.open
        return end

    def leave_open(self, kind: SyntaxKind, at: int, here: Span | None) -> None:
        """The innermost open element ends without an end tag."""
        index, name = self.open.pop()
        self.result.closes[index] = self.result.close_ends[index] = at
        span = self.name_span(index)
        self.problems.append(SyntaxDefect(span, kind, here, name))
        if self.out:
            self.out.end_tag()

    def take_declaration(self, at: int) -> int:
        text = self.text
        if text.startswith("<!--", at):
            end = text.find("-->", at + 4)
            if end < 0:
                self.defect(SyntaxKind.UNCLOSED_COMMENT, at, at + 4)
                return len(text)
            self.comment(at, end + 3)
            return end + 3
        if text.startswith("<![CDATA[", at):
            end = text.find("]]>", at)
            if end < 0:
                self.defect(SyntaxKind.UNCLOSED_SECTION, at, at + 9)
                return len(text)
            if self.out and self.open and not self.too_deep:
                self.out.text(text[at + 9 : end])
            return end + 3
        return self.take_document_type(at)

    def take_document_type(self, at: int) -> int:
        depth = 0
        for match in _NESTING.finditer(self.text, at):
            mark = match[0]
            depth += (mark == "[") - (mark == "]")
            if mark == ">" and depth <= 0:
                break
        else:
            self.defect(SyntaxKind.UNCLOSED_SECTION, at, min(at + 9, len(self.text)))
            return len(self.text)
        end = match.end()
        names = tuple(dict.fromkeys(_ENTITY.findall(self.text, at, end)))
        self.entities += names
        self.result.document_type = self.source.span(at, end)
        self.problems.append(DocumentType(self.source.span(at, min(at + 9, end)), names))
        return end

    def take_instruction(self, at: int) -> int:
        end = self.text.find("?>", at)
        if end < 0:
            self.defect(SyntaxKind.UNCLOSED_SECTION, at, at + 2)
            return len(self.text)
        end += 2
        if at > 0 and self.text.startswith("<?xml", at) and self.text[at + 5 : at + 6].isspace():
            if not self.open and not self.root_done:
                span = self.source.span(0, at)
                self.problems.append(LateDeclaration(span, self.source.span(at, end)))
            else:
                self.defect(SyntaxKind.OTHER, at, end, detail="an XML declaration in the middle of the document")
        return end

    def take_text(self, start: int, end: int) -> bool:
        """Text between markup; False stops the scan."""
        if self.too_deep:
            return True
        if self.open:
            if self.out:
                self.problems += find_unknown_entities(self.source, start, end, self.entities)
                self.out.text(self.text[start:end], keep_references=True)
                if end - start > LENGTH_LIMIT:
                    self.defect(SyntaxKind.TOO_LONG, start, start, detail=self.open[-1][1])
                section_end = self.text.find("]]>", start, end)
                if section_end >= 0:
                    self.defect(SyntaxKind.SECTION_END_IN_TEXT, section_end, section_end + 3)
            return True
        match = _NOT_BLANK.search(self.text, start, end)
        if match is None:
            return True
        stop = start + len(self.text[start:end].rstrip("\x00 \t\r\n"))
        if stop <= match.start():
            return True  # NUL padding: reported once, as an illegal character
        line_end = match.start() + len(self.text[match.start() : stop].splitlines()[0])
        if self.root_done:
            return self.after_root(match.start(), line_end) > 0
        self.defect(SyntaxKind.TEXT_OUTSIDE_ROOT, match.start(), line_end)
        return True

    def take_too_deep(self, at: int) -> int:
        tag, _ = parse_start_tag(self.source, at)
        if not any(isinstance(problem, TooDeep) for problem in self.problems):
            span = self.source.span(tag.name_start, tag.name_end)
            self.problems.append(TooDeep(span, DEPTH_LIMIT))
        self.too_deep += not tag.empty
        return tag.end

    def after_root(self, at: int, end: int) -> int:
        self.problems.append(ContentAfterRoot(self.source.span(at, end), self.name_span(0)))
        return -1

    def comment(self, at: int, end: int) -> None:
        self.result.comments.append((at, end))
        if self.out and self.open and not self.too_deep:
            self.out.comment()
        runs = tuple(
            self.source.span(m.start(), m.end()) for m in _HYPHENS.finditer(self.text, at + 4, end - 3)
        )
        if not runs and self.text[end - 4] == "-" and end - 4 >= at + 4:
            runs = (self.source.span(end - 4, end - 1),)
        if runs:
            self.problems.append(CommentHyphens(runs[0], runs))

    def finish(self) -> None:
        if self.open:
            # One mistake: where the file breaks off. The innermost element says it.
            kind = SyntaxKind.TRUNCATED if len(self.open) > 1 else SyntaxKind.UNCLOSED_ELEMENT
            size = len(self.text)
            outer = self.name_span(self.open[0][0]) if len(self.open) > 1 else None
            self.leave_open(kind, size, outer)
            for index, _ in self.open:
                self.result.closes[index] = self.result.close_ends[index] = size
                if self.out:
                    self.out.end_tag()
        if not self.result.starts and not self.problems:
            self.defect(SyntaxKind.NO_ELEMENT, 0, 0)
        if self.out:
            self.result.wellformed = self.out.result()

    def name_span(self, index: int) -> Span:
        start = self.result.starts[index] + 1
        odd = self.result.odd.get(index)
        if odd:
            return self.source.span(odd.name_start, odd.name_end)
        match = START.match(self.text, start - 1)
        return self.source.span(start, match.end(1) if match else self.result.ends[index])

    def defect(
        self, kind: SyntaxKind, start: int, end: int, other: Span | None = None, detail: str = ""
    ) -> None:
        self.problems.append(SyntaxDefect(self.source.span(start, end), kind, other, detail))


def _alike(a: str, b: str) -> bool:
    """Two names that differ by a slip of the hand: case, one letter more, less or other, two swapped."""
    a, b = a.lower(), b.lower()
    if abs(len(a) - len(b)) > 1:
        return False
    if a == b or sorted(a) == sorted(b):
        return True
    start = next((i for i, (x, y) in enumerate(zip(a, b, strict=False)) if x != y), min(len(a), len(b)))
    return len(b) > 1 and (a[start + 1 :] == b[start + 1 :] or a[start + 1 :] == b[start:] or a[start:] == b[start + 1 :])
