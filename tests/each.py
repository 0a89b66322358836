"""One test of many things: what is wrong with each of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TypeVar

T = TypeVar("T")


def each(things: Iterable[T], check: Callable[[T], None], name: Callable[[T], str] = str) -> None:
    """Check all of them; a failure names those that are not as they should be, and says why."""
    found = [f"{name(thing)}: {wrong}" for thing in things if (wrong := _complaint(thing, check)) is not None]
    assert not found, "\n".join(found)


def _complaint(thing: T, check: Callable[[T], None]) -> str | None:
    try:
        check(thing)
    except AssertionError as error:
        return str(error)
    return None
