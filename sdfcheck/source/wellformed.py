"""Writing a faulty text anew so that an XML parser accepts it.

Start tags keep their number and order, which is all that the mapping between tree
and text needs. Namespace processing is kept out: colons in names are replaced by
:data:`sdfcheck.source.element.COLON`, and declarations are left
to the textual namespace analysis.
"""

from __future__ import annotations

import re

from sdfcheck.source.element import COLON
from sdfcheck.source.problems import Problem, SyntaxDefect, SyntaxKind, UnknownEntity
from sdfcheck.source.start_tag import StartTag
from sdfcheck.source.text import Source

LENGTH_LIMIT = 10_000_000
"""libxml2's bound on one text or attribute value."""

_ILLEGAL = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff\ud800-\udfff]+")
_AMPERSAND = re.compile(r"&(?:([\w.\-:]+);|(#[0-9]+|#x[0-9a-fA-F]+);)?")
_PREDEFINED = frozenset({"amp", "lt", "gt", "quot", "apos"})
_NOT_NAME = re.compile(r"[^\w.\-]")


def find_illegal(source: Source) -> Problem | None:
    """The first run of characters that XML does not allow at all (NUL and its like)."""
    match = _ILLEGAL.search(source.text)
    if match is None:
        return None
    count = sum(len(run) for run in _ILLEGAL.findall(source.text))
    return SyntaxDefect(
        source.span(match.start(), match.end()),
        SyntaxKind.ILLEGAL_CHARACTER,
        None,
        f"U+{ord(match[0][0]):04X}" + (f", {count} in all" if count > 1 else ""),
    )


def find_unknown_entities(source: Source, start: int, end: int, declared: tuple[str, ...]) -> list[Problem]:
    """Bare ampersands and references that XML does not define, in one stretch of text.

    Names that the document type declares are not listed: simulators do not read them
    either, but that is said of the document type.
    """
    if source.text.find("&", start, end) < 0:
        return []
    problems: list[Problem] = []
    for match in _AMPERSAND.finditer(source.text, start, end):
        if not _is_defined(match) and match[1] not in declared:
            problems.append(UnknownEntity(source.span(match.start(), match.end()), match[1] or match[2] or ""))
    return problems


def _is_defined(match: re.Match[str]) -> bool:
    if match[1]:
        return match[1] in _PREDEFINED
    if not match[2]:
        return False
    digits = match[2]
    code = int(digits[2:], 16) if digits[1] == "x" else int(digits[1:])
    return code in {9, 10, 13} or (
        0x20 <= code <= 0x10FFFF and not 0xD800 <= code <= 0xDFFF and code not in {0xFFFE, 0xFFFF}
    )


def _escape(text: str, *, keep_references: bool) -> str:
    if keep_references and "&" in text:
        text = _AMPERSAND.sub(lambda m: m[0] if _is_defined(m) else "&amp;" + m[0][1:], text)
    elif "&" in text:
        text = text.replace("&", "&amp;")
    text = text.replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")
    return _ILLEGAL.sub(" ", text)[:LENGTH_LIMIT]


class Rewriter:
    """Collects the well-formed text, piece by piece."""

    def __init__(self) -> None:
        self._pieces: list[str] = []
        self._open: list[str] = []

    def start_tag(self, source: Source, tag: StartTag, entities: tuple[str, ...]) -> list[Problem]:
        """Write a start tag; returns what is wrong inside its attribute values."""
        problems: list[Problem] = []
        name = _safe_name(tag.name)
        pieces = [f"<{name}"]
        seen = set()
        for attribute in tag.attributes:
            start, end = attribute.value_start, attribute.value_end
            problems += find_unknown_entities(source, start, end, entities)
            if end - start > LENGTH_LIMIT:
                span = source.span(attribute.name_start, attribute.name_end)
                problems.append(SyntaxDefect(span, SyntaxKind.TOO_LONG, None, attribute.name))
                end = start
            if attribute.name in seen or attribute.name.partition(":")[0] == "xmlns":
                continue
            seen.add(attribute.name)
            value = _escape(source.text[start:end], keep_references=True)
            pieces.append(f' {_safe_name(attribute.name)}="{value}"')
        pieces.append("/>" if tag.empty else ">")
        self._pieces += pieces
        if not tag.empty:
            self._open.append(name)
        return problems

    def end_tag(self) -> None:
        self._pieces.append(f"</{self._open.pop()}>")

    def text(self, text: str, *, keep_references: bool = False) -> None:
        self._pieces.append(_escape(text, keep_references=keep_references))

    def comment(self) -> None:
        """An empty one: it only has to part the text as the real one does."""
        self._pieces.append("<!---->")

    def result(self) -> str:
        return "".join(self._pieces)


def _safe_name(name: str) -> str:
    name = _NOT_NAME.sub("_", name.replace(":", COLON))
    return name if name[:1].isalpha() or name[:1] in {"_", COLON} else f"_{name}"
