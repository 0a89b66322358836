"""Recognition of documents that are not of a kind that is linted."""

from __future__ import annotations

from sdfcheck.source.problems import UnrecognizedDocument
from sdfcheck.source.scanner.tokens import Token, TokenKind, first_line
from sdfcheck.source.sniff import HEAD, Kind, sniff, suggested_root
from sdfcheck.source.text import Source, Span


def unrecognized(source: Source, kind: Kind, name: str | None, place: Span | None) -> UnrecognizedDocument:
    """The kind that a text seems to be, by its root element (``name`` at ``place``) or its first line."""
    text = source.text
    if kind in {Kind.BROKEN_XML, Kind.NOT_XML, Kind.OTHER_XML}:
        kind = sniff(text[:HEAD].encode("utf-8", "surrogatepass"), source.path)
    looks_like = kind.description if kind is not Kind.NOT_XML else "plain text"
    if name is None or place is None:
        if kind in {Kind.OTHER_XML, Kind.BROKEN_XML}:
            looks_like = "XML without any element"
        source.is_foreign = kind is Kind.NOT_XML
        line = first_line(Token(TokenKind.TEXT, 0, len(text)), text)
        return UnrecognizedDocument(source.span(*line), looks_like, None, None)
    if kind not in {Kind.OTHER_XML, Kind.MISSPELT_ROOT}:
        return UnrecognizedDocument(place, looks_like, None, None)
    return UnrecognizedDocument(place, looks_like, name, suggested_root(name), _end(source, name))


def _end(source: Source, name: str) -> Span | None:
    """The name in the end tag of the root, where the text ends with that."""
    tag, end = f"</{name}>", len(source.text.rstrip())
    if not source.text.endswith(tag, 0, end):
        return None
    return source.span(end - len(tag) + 2, end - 1)
