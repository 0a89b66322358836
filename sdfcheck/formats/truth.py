"""What readers of SDFormat take for true."""

from __future__ import annotations


def is_true(text: str) -> bool:
    """``true`` in any case, or ``1``, blanks aside; everything else is false or no truth value."""
    return text.strip().lower() in {"true", "1"}
