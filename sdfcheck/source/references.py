"""Characters that XML writes as references, such as ``&amp;``."""

from __future__ import annotations

from collections.abc import Mapping

IN_QUOTES = {'"': "&quot;", "'": "&apos;"}
"""The characters that a value in quotes of either kind cannot hold."""
IN_ATTRIBUTE = {'"': "&quot;", "\n": "&#10;", "\t": "&#9;", "\r": "&#13;"}
"""The characters that an attribute in double quotes cannot hold, or that would be read as a space."""


def escape(text: str, others: Mapping[str, str] | None = None) -> str:
    """A text as XML writes it; ``others``: further characters, with what is written for them."""
    text = text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")
    for character, reference in (others or {}).items():
        text = text.replace(character, reference)
    return text


def unescape(text: str) -> str:
    """The text before :func:`escape`."""
    for character, reference in IN_QUOTES.items():
        text = text.replace(reference, character)
    return text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")
