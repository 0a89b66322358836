"""Names as XML 1.0 defines them, to the letter."""

from __future__ import annotations

import re
from functools import cache

_PLAIN = re.compile(r"[A-Za-z_:][A-Za-z0-9_:.\-]*")
_INITIAL = (
    r":A-Z_a-z\xc0-\xd6\xd8-\xf6\xf8-\u02ff\u0370-\u037d\u037f-\u1fff\u200c\u200d\u2070-\u218f"
    r"\u2c00-\u2fef\u3001-\ud7ff\uf900-\ufdcf\ufdf0-\ufffd\U00010000-\U000effff"
)
_FURTHER = rf"{_INITIAL}\-.0-9\xb7\u0300-\u036f\u203f\u2040"


def is_name(text: str) -> bool:
    """Is this a name for XML?"""
    return (_PLAIN if text.isascii() else _any_letters()).fullmatch(text) is not None


def made_name(text: str) -> str:
    """The nearest thing that is a name."""
    made = text if is_name(text) else re.sub(rf"[^{_FURTHER}]", "_", text)
    return made if is_name(made) else f"_{made}"


@cache
def _any_letters() -> re.Pattern[str]:
    """Compiled when needed: it takes 10 ms."""
    return re.compile(rf"[{_INITIAL}][{_FURTHER}]*")
