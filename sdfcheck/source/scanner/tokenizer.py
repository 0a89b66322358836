"""A text cut into tags, texts, comments and the rest, whatever it looks like.

Every piece gets a guess of what it was meant to be; where it is not well formed, there is a problem as
well. How tags belong together is not asked here.
"""

from __future__ import annotations

import re

from sdfcheck.source.problems import DocumentType, Problem, SyntaxDefect, SyntaxKind
from sdfcheck.source.scanner.broken_tag import (
    comment_end,
    find_inner_comment,
    line_end,
    parse_broken_tag,
    section_end,
)
from sdfcheck.source.scanner.start_tag import ATTRIBUTES, BLANK, NAME, START, has_names, is_name
from sdfcheck.source.scanner.tokens import DEFECT_LIMIT, Token, TokenKind, Tokens, hyphens
from sdfcheck.source.text import Source

# XML declarations and other instructions: whether they are well formed.


_INSTRUCTION = re.compile(
    rf"<\?xml{BLANK}+version{BLANK}*={BLANK}*([\"'])1\.[0-9]+\1"
    rf"(?:{BLANK}+encoding{BLANK}*={BLANK}*([\"'])[A-Za-z][\w.\-]*\2)?(?:{BLANK}+standalone{BLANK}*={BLANK}*([\"'])(?:yes|no)\3)?{BLANK}*\?>"
    rf"|<\?(?![xX][mM][lL])({NAME})(?:{BLANK}[\s\S]*)?\?>|<\?(xml-{NAME})(?:{BLANK}[\s\S]*)?\?>"
)
_VERSION = re.compile(rf"<\?xml{BLANK}+version{BLANK}*={BLANK}*([\"'])(\w[\w.\-]*)\1")


def instruction_fault(text: str, start: int, end: int) -> tuple[SyntaxKind, int, int] | None:
    """The fault of an instruction and its place; None if it is sound."""
    match = _INSTRUCTION.fullmatch(text, start, end)
    if match and is_name(match[4] or match[5] or "xml"):
        return None
    version = _VERSION.match(text, start, end)
    if version and _INSTRUCTION.fullmatch(f'<?xml version="1.0"{text[version.end() : end]}'):
        return SyntaxKind.ODD_VERSION, version.start(2), version.end(2)
    return SyntaxKind.MALFORMED_INSTRUCTION, start, end


_SOUND_TAG = re.compile(rf"{START.pattern}|</({NAME}){BLANK}*>")
_ODD_END = re.compile(r"</?[ \t]*/?[ \t]*([^\s<>/]*)([^<>]*?)(/?>|(?=<)|\Z)")
_BLANK_START = re.compile(rf"<\s{{1,80}}{NAME}{ATTRIBUTES}\s*/?>")
_BLANK_END = re.compile(rf"<[ \t]+/[ \t]*{NAME}\s*>")
_ODD_START = re.compile(r"<[^\s<>!?/=\"'][^<>]*>")
_DECLARATION = re.compile(r"<![^<>\r\n]*>?")
_BARE_INSTRUCTION = re.compile(r"<xml\s[^<>]*\?>")
_MISSPELT_OPENING = re.compile(r"<!?\[?CDATA\[|<!\[[A-Z]{3,6}\[|<!\[CDATA|<!-|<--", re.IGNORECASE)
_NESTING = re.compile(r"[\[\]>]|<!--.*?(?:-->|\Z)|\"[^\"]*\"|'[^']*'", re.DOTALL)
_ENTITY = re.compile(r"<!ENTITY\s+(?:%\s+)?([\w.\-:]+)")
_CUTS = frozenset(
    (
        SyntaxKind.TRUNCATED,
        SyntaxKind.UNCLOSED_COMMENT,
        SyntaxKind.UNCLOSED_SECTION,
        SyntaxKind.MISSPELT_MARK,
        SyntaxKind.OTHER,
    )
)
_SWALLOWED_MARKUP = re.compile(r">\s{0,80}<")
_ANGLES = re.compile(r"<+")


def tokenize(source: Source, text: str) -> Tokens:
    """Cut up ``text``: the source's, or one in which some characters are blanked."""
    return _Tokenizer(source, text).run()


class _Tokenizer:
    def __init__(self, source: Source, text: str) -> None:
        self.source = source
        self.text = text
        self.pieces: list[Token] = []
        self.problems: list[Problem] = []
        self.doubtful: list[tuple[int, int]] = []
        self.entities: list[str] = []
        self.odd_ends: list[int] = []
        self.odd_names: set[str] = set()
        """The names of the broken start tags: a malformed one is not reported again at its end tag."""
        self.has_document_type = False
        self.defects = 0
        self.known: dict[str, tuple[int, int]] = {}
        """Mark → from where it was looked for, and where it is (-1: nowhere): many pieces may wait for one end."""
        self.swallowed = (0, -1, -1)  # the same for markup in an instruction, and where that ends

    def run(self) -> Tokens:
        text, pos, size = self.text, 0, len(self.text)
        is_ascii, add = text.isascii(), self.pieces.append
        while pos < size:
            angle = text.find("<", pos)
            if angle < 0:
                angle = size
            if text[pos:angle].strip(" \t\r\n"):
                add(Token(TokenKind.TEXT, pos, angle))
            if angle == size:
                break
            match = _SOUND_TAG.match(text, angle)
            if match is None or not (is_ascii or match[4] or has_names(match)):
                pos = self.take(angle, is_foreign=match is not None)
                continue
            pos = match.end()
            if match[4]:
                add(Token(TokenKind.END, angle, pos, match[4]))
            else:
                add(Token(TokenKind.EMPTY if match[3] else TokenKind.START, angle, pos, match[1]))
        if self.defects > DEFECT_LIMIT:
            self.doubtful.append((0, size))
        entities, odd_ends = tuple(self.entities), frozenset(self.odd_ends)
        return Tokens(self.pieces, self.problems, self.doubtful, entities, odd_ends, self.is_cut())

    def is_cut(self) -> bool:
        """Does the text end inside a tag, a comment, a section, and has that been said?"""
        last = self.problems[-1] if self.problems else None
        if not isinstance(last, SyntaxDefect) or not self.pieces:
            return False
        piece = self.pieces[-1]
        return last.kind in _CUTS and last.span.start == piece.start and piece.end == len(self.text)

    # Each `take…` looks at one piece and returns the offset after it.

    def take(self, at: int, *, is_foreign: bool) -> int:
        """A piece that is not a well-formed tag; ``is_foreign``: only its names are unknown."""
        text = self.text
        follows = text[at + 1 : at + 2]
        if follows == "/" or _BLANK_END.match(text, at):
            return self.take_end_tag(at)
        if follows == "!":
            return self.take_declaration(at)
        if follows == "?":
            return self.take_instruction(at)
        if match := _MISSPELT_OPENING.match(text, at):
            return self.take_misspelt(at, match.end())
        is_name = follows.isalpha() or follows in {"_", ":"}
        if is_name or is_foreign or _ODD_START.match(text, at) or _BLANK_START.match(text, at):
            return self.take_broken_tag(at)
        return self.take_angles(at)

    def take_broken_tag(self, at: int) -> int:
        if match := _BARE_INSTRUCTION.match(self.text, at):
            self.defect(SyntaxKind.MALFORMED_INSTRUCTION, at, match.end())
            self.pieces.append(Token(TokenKind.DECLARATION, at, match.end()))
            return match.end()
        tag, problems = parse_broken_tag(self.source, self.text, at)
        for problem in problems:
            self.note(problem)
        self.doubtful.append((at, tag.end))
        self.odd_names.add(tag.name)
        self.pieces.append(
            Token(TokenKind.EMPTY if tag.empty else TokenKind.START, at, tag.end, tag.name, tag)
        )
        return tag.end

    def take_misspelt(self, at: int, begin: int) -> int:
        """``<!- … ->``, ``<-- … -->``, ``<[CDATA[ … ]]>``: comments and sections."""
        is_section = self.text[begin - 1] != "-"
        self.defect(SyntaxKind.MISSPELT_MARK, at, begin, "<![CDATA[" if is_section else "<!--")
        end = self.find("]]>", at) + 3 if is_section else comment_end(self.text, begin).end
        if end == 2:
            end = section_end(self.text, begin)
        self.doubtful.append((at, end))
        self.pieces.append(Token(TokenKind.SECTION if is_section else TokenKind.OTHER, at, end))
        return end

    def take_angles(self, at: int) -> int:
        """A ``<`` that begins nothing, or several: text. The last one may begin a tag yet."""
        match = _ANGLES.match(self.text, at)
        assert match
        end = match.end() if match.end() == at + 1 else match.end() - 1
        kind = SyntaxKind.TRUNCATED if end == len(self.text) else SyntaxKind.STRAY_ANGLE
        self.defect(kind, at, end)
        if self.defects <= DEFECT_LIMIT:
            following = self.text.find("<", match.end())
            end_of_doubt = following if following >= 0 else len(self.text)
            self.doubtful.append((self.text.rfind(">", 0, at) + 1, end_of_doubt))
        self.pieces.append(Token(TokenKind.TEXT, at, end))
        return end

    def take_end_tag(self, at: int) -> int:
        odd = _ODD_END.match(self.text, at)
        assert odd
        end, name_end = odd.end(), odd.end(1)
        if not odd[3]:
            end = name_end
            cut = odd.end() == len(self.text)
            self.defect(SyntaxKind.TRUNCATED if cut else SyntaxKind.UNCLOSED_TAG, at, name_end, f"/{odd[1]}")
            end = odd.end() if cut else name_end
        elif odd[2].strip() or odd[3] == "/>":
            start = odd.start(2) + len(odd[2]) - len(odd[2].lstrip())
            self.defect(SyntaxKind.CROWDED_END_TAG, start, end - 1, odd[1])
        elif odd[1] and odd.start(1) > at + 2:
            self.defect(SyntaxKind.BLANK_IN_TAG, at, name_end, f"/{odd[1]}")
        elif not odd[1]:
            self.defect(SyntaxKind.MALFORMED_NAME, at, end)
        elif odd[1] not in self.odd_names:
            self.defect(SyntaxKind.MALFORMED_NAME, odd.start(1), name_end)
        self.odd_ends.append(at)
        self.pieces.append(Token(TokenKind.END, at, end, odd[1]))
        return end

    def take_declaration(self, at: int) -> int:
        text = self.text
        if text.startswith("<!--", at):
            return self.take_comment(at)
        if text.startswith("<![CDATA[", at):
            return self.take_section(at)
        if match := _MISSPELT_OPENING.match(text, at):
            return self.take_misspelt(at, match.end())
        if text[at : at + 9].upper() == "<!DOCTYPE":
            return self.take_document_type(at)
        match = _DECLARATION.match(text, at)
        assert match
        end = match.end()
        self.defect(SyntaxKind.OTHER, at, at + 2, "this is not a comment, CDATA section or document type")
        self.pieces.append(Token(TokenKind.OTHER, at, end))
        return end

    def take_section(self, at: int) -> int:
        end = self.find("]]>", at) + 3
        if end == 2:
            self.defect(SyntaxKind.UNCLOSED_SECTION, at, at + 9, "]]>")
            end = section_end(self.text, at + 9)
            self.doubtful.append((at, end))
        self.pieces.append(Token(TokenKind.SECTION, at, end))
        return end

    def take_comment(self, at: int) -> int:
        text = self.text
        end = self.find("-->", at + 4) + 3
        if end == 2:
            end = self.unclosed_comment(at, len(text))
        elif (inner := find_inner_comment(text, at, end)) is None:
            problem = hyphens(self.source, at, end)
            if problem is not None:
                self.problems.append(problem)
        elif inner.unclosed:
            end = self.unclosed_comment(at, inner.start)
        else:
            here = self.source.span(inner.start, inner.start + 4)
            close = self.source.span(end - 3, end)
            self.note(SyntaxDefect(here, SyntaxKind.NESTED_COMMENT, close, "torn" if inner.is_torn else ""))
            self.doubtful.append((at, inner.rest_end))
            if inner.is_torn:  # every consumer refuses the rest: it is read as the comment that was meant
                end = inner.rest_end
        self.pieces.append(Token(TokenKind.COMMENT, at, end))
        return end

    def unclosed_comment(self, at: int, limit: int) -> int:
        """Say so where the end is missing: at its misspelling, or after the last line of words."""
        end, misspelt = comment_end(self.text, at + 4, limit)
        here = self.source.span(at, at + 4)
        content = self.text[at:end].rstrip()
        if misspelt >= 0:
            place = self.source.span(misspelt, end)
            self.note(SyntaxDefect(place, SyntaxKind.MISSPELT_MARK, here, "-->"))
        elif "\n" in content and end < len(self.text):
            last = content[content.rindex("\n") + 1 :].strip()
            place = self.source.span(at + len(content) - len(last), at + len(content))
            self.note(SyntaxDefect(place, SyntaxKind.UNCLOSED_COMMENT, here))
        else:
            self.note(SyntaxDefect(here, SyntaxKind.UNCLOSED_COMMENT))
        self.doubtful.append((at, end))
        return end

    def take_document_type(self, at: int) -> int:
        # A second one is wrong in any case, and not worth reading to the end.
        end = self.document_type_end(at) if not self.has_document_type else self.find(">", at) + 1
        if end == 0:
            self.defect(SyntaxKind.UNCLOSED_SECTION, at, at + 9, ">")
            end = line_end(self.text, at)
        else:
            names = tuple(dict.fromkeys(_ENTITY.findall(self.text, at, end)))
            self.entities += names
            self.problems.append(DocumentType(self.source.span(at, at + 9), names))
        self.has_document_type = True
        self.pieces.append(Token(TokenKind.OTHER, at, end))
        return end

    def document_type_end(self, at: int) -> int:
        """Just after a document type, whose internal subset may hold angle brackets; 0 if it never ends."""
        depth = 0
        for match in _NESTING.finditer(self.text, at):
            mark = match[0]
            depth += (mark == "[") - (mark == "]")
            if mark == ">" and depth <= 0:
                return match.end()
        return 0

    def take_instruction(self, at: int) -> int:
        text = self.text
        end = self.find("?>", at) + 2
        if end == 1 or self.has_swallowed(at, end):
            self.defect(SyntaxKind.UNCLOSED_SECTION, at, at + 2, "?>")
            following = text.find("<", at + 1)
            end = line_end(text, at, following if following >= 0 else None)
            end = text.find(">", at, end) + 1 or end
        elif fault := instruction_fault(text, at, end):
            self.defect(*fault)
        is_declaration = text.startswith("<?xml", at) and text[at + 5 : at + 6].isspace()
        self.pieces.append(Token(TokenKind.DECLARATION if is_declaration else TokenKind.OTHER, at, end))
        return end

    def has_swallowed(self, at: int, end: int) -> bool:
        """Is there markup in an instruction? The next one is looked for once for all that lie before it."""
        if not self.swallowed[0] <= at <= self.swallowed[1]:
            match = _SWALLOWED_MARKUP.search(self.text, at)
            self.swallowed = at, match.start() if match else len(self.text), match.end() if match else -1
        return 0 <= self.swallowed[2] <= end

    def find(self, mark: str, at: int) -> int:
        """Like ``str.find``, but what was looked for from farther in front is not looked for again."""
        begin, found = self.known.get(mark, (0, -2))
        if at < begin or -1 < found < at or found < -1:
            found = self.text.find(mark, at)
            self.known[mark] = at, found
        return found

    def defect(self, kind: SyntaxKind, start: int, end: int, detail: str = "") -> None:
        end = min(end, len(self.text))
        self.note(SyntaxDefect(self.source.span(start, end), kind, None, detail))

    def note(self, problem: Problem) -> None:
        self.defects += isinstance(problem, SyntaxDefect)
        if self.defects <= DEFECT_LIMIT or not isinstance(problem, SyntaxDefect):
            self.problems.append(problem)
