"""How the rules of this family speak of ratios."""

from __future__ import annotations

_FAR = 1e6


def times(ratio: float) -> str:
    """``300 times`` or ``1/300 of``: one digit and zeros, as far as people read them."""
    if ratio > _FAR:
        return "more than a million times"
    if ratio < 1 / _FAR:
        return "less than a millionth of"
    if ratio > 1:
        return f"{_rounded(ratio)} times"
    return f"1/{_rounded(1 / ratio)} of"


def _rounded(ratio: float) -> str:
    return f"{float(f'{ratio:.1g}'):.0f}"
