"""Edits of a file's text, made in its bytes."""

from __future__ import annotations

from collections.abc import Iterable

from sdfcheck.source.decode import encoding_of

Replacement = tuple[int, int, str]
"""Where a range of characters starts and ends, and what comes in its place."""


class Unwritable(Exception):
    """A text cannot be written in the encoding of its file; the message says why."""


def splice(data: bytes, edits: Iterable[Replacement]) -> bytes:
    """Replace ranges of the text that ``data`` holds, in order and apart; all other bytes stay.

    The offsets are those of :func:`sdfcheck.source.decode.decode`.

    Raises:
        Unwritable: a new text has characters that the encoding lacks, or the bytes are not of
            the encoding.
    """
    mark, codec, *_ = encoding_of(data)
    body = data[len(mark) :]
    # Stray bytes in UTF-8 take one character each, as they do in decoding.
    errors = "surrogateescape" if codec == "utf-8" else "strict"
    try:
        text = body.decode(codec, errors)
        if text.encode(codec, errors) != body:
            raise Unwritable(f"its bytes are not the only way to write it in {codec}")
    except UnicodeError:
        raise Unwritable(f"its bytes are not {codec} throughout") from None
    try:
        return mark + replaced(text, edits).encode(codec, errors)
    except UnicodeEncodeError as error:
        raise Unwritable(f"{codec} has no character for {error.object[error.start]!r}") from None


def replaced(text: str, edits: Iterable[Replacement]) -> str:
    """A text after edits, which are in order and apart."""
    pieces, at = [], 0
    for start, end, replacement in edits:
        pieces += [text[at:start], replacement]
        at = end
    return "".join([*pieces, text[at:]])
