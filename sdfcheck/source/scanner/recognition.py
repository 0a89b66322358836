"""What a document is that is none of those that are linted."""

from __future__ import annotations

from sdfcheck.source.document import Document
from sdfcheck.source.problems import UnrecognizedDocument
from sdfcheck.source.scanner.tokens import Token, TokenKind, first_line
from sdfcheck.source.sniff import HEAD, Kind, sniff, suggested_root


def unrecognized(document: Document) -> UnrecognizedDocument:
    """Say what the document looks like, at its root element or its first line."""
    text, kind = document.source.text, document.kind
    if kind in {Kind.BROKEN_XML, Kind.NOT_XML, Kind.OTHER_XML}:
        kind = sniff(text[:HEAD].encode("utf-8", "surrogatepass"), document.path)
    looks_like = kind.description if kind is not Kind.NOT_XML else "plain text"
    root = document.root
    if root is None:
        if kind in {Kind.OTHER_XML, Kind.BROKEN_XML}:
            looks_like = "XML without any element"
        place = first_line(Token(TokenKind.TEXT, 0, len(text)), text)
        return UnrecognizedDocument(document.source.span(*place), looks_like, None, None)
    if kind not in {Kind.OTHER_XML, Kind.MISSPELT_ROOT}:
        return UnrecognizedDocument(root.span, looks_like, None, None)
    return UnrecognizedDocument(root.span, looks_like, root.name, suggested_root(root.name))
