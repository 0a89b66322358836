"""Text for the XML formats."""

from __future__ import annotations

import re

_ILLEGAL = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_ESCAPES = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})


def attributes(**values: object) -> str:
    """Attributes with a space before each."""
    return "".join(f' {name}="{escaped(str(value))}"' for name, value in values.items())


def escaped(text: str) -> str:
    """Safe between tags and quotes; what XML 1.0 cannot hold becomes a replacement character."""
    legal = _ILLEGAL.sub("\ufffd", text).translate(_ESCAPES)
    if legal.isprintable():
        return legal
    return "".join(c if c.isprintable() else f"&#{ord(c)};" for c in legal)
