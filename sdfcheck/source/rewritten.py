"""How the tree of a text that was rewritten as well-formed XML differs from its text."""

from __future__ import annotations

COLON = "\ua4fd"
"""Takes the place of the colon in names of a rewritten text, from which namespace processing is kept out.

It is a Lisu letter (tone mya jeu) that looks like a colon and that XML allows in names. A hyphen
follows it, or a dot where the text has the letter itself.
"""

ATTRIBUTE_LIMIT = 1000
"""The most attributes of an element that are read: listing them costs the square of their number."""


def written_name(tag: str, prefix: str | None) -> str:
    """A name as the file has it, ``prefix:local``, from lxml's ``{uri}local``."""
    if tag[:1] == "{":
        local = tag[tag.index("}") + 1 :]
        return f"{prefix}:{local}" if prefix else local
    return tag.replace(f"{COLON}-", ":").replace(f"{COLON}.", COLON) if COLON in tag else tag


def rewritten_name(name: str) -> str:
    """A name of the file as a rewritten text has it."""
    return name.replace(COLON, f"{COLON}.").replace(":", f"{COLON}-")
