"""Making a text smaller while a command still fails on it in the same way."""

from __future__ import annotations

from collections.abc import Callable, Iterator

ATTEMPTS = 600


def minimize(data: bytes, fails: Callable[[bytes], bool], attempts: int = ATTEMPTS) -> bytes:
    """A part of ``data`` that fails as well: ever smaller pieces are left out, lines first."""
    left = attempts
    size = max(1, len(data) // 2)
    while size and left > 0:
        shorter = None
        for candidate in _without(data, size):
            left -= 1
            if fails(candidate):
                shorter = candidate
                break
            if left <= 0:
                break
        if shorter is None:
            size //= 2
        else:
            data = shorter
            size = min(size, max(1, len(data) // 2))
    return data


def _without(data: bytes, size: int) -> Iterator[bytes]:
    for start in range(0, len(data), size):
        yield data[:start] + data[start + size :]
