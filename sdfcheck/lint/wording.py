"""Words for several things at once."""

from __future__ import annotations

from collections.abc import Iterable


def listed(words: Iterable[str], joiner: str = "and", *, most: int = 0) -> str:
    """``a, b and c``; of more than ``most`` words so many, and how many are left: ``a, b and 3 more``."""
    shown = list(words)
    if 0 < most < len(shown):
        left = len(shown) - most
        return f"{', '.join(shown[:most])} and {left} more"
    return f" {joiner} ".join(filter(None, (", ".join(shown[:-1]), *shown[-1:])))


def named(words: Iterable[str], joiner: str = "and", *, most: int = 0) -> str:
    """Names in a list: ```a`, `b` and `c```."""
    return listed((f"`{word}`" for word in words), joiner, most=most)


def used(count: int) -> str:
    """`` (used 3 times)``; nothing for once."""
    return f" (used {count} times)" if count > 1 else ""


def counted(number: int, noun: str) -> str:
    """``1 file``, ``2 files``."""
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"
