"""When to lint: soon after a change, never twice at once, and not for what has changed again."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Awaitable, Callable

LONGEST = 0.02
"""The longest wait after a keystroke, in s; a text that is linted in no time waits for nothing."""
_QUICK = 0.04


class Schedule:
    """Calls ``work`` with a key after each change of what the key names; changes in quick succession count once."""

    def __init__(self, work: Callable[[str], Awaitable[None]], longest: float = LONGEST) -> None:
        self._work = work
        self._longest = longest
        self._took: dict[str, float] = {}
        self._timers: dict[str, asyncio.TimerHandle] = {}
        self._running: dict[str, asyncio.Task[None]] = {}
        self._again: set[str] = set()

    def note(self, key: str) -> None:
        """Something has changed."""
        if key in self._running:
            self._again.add(key)
            return
        timer = self._timers.pop(key, None)
        if timer is not None:
            timer.cancel()
        took = self._took.get(key, 0.0)
        wait = 0.0 if took < _QUICK else min(self._longest, took / 2)
        self._timers[key] = asyncio.get_running_loop().call_later(wait, self._begin, key)

    def drop(self, key: str) -> None:
        """The key is of no interest any more."""
        timer = self._timers.pop(key, None)
        if timer is not None:
            timer.cancel()
        self._again.discard(key)
        self._took.pop(key, None)

    def _begin(self, key: str) -> None:
        self._timers.pop(key, None)
        task = asyncio.ensure_future(self._run(key))
        self._running[key] = task
        task.add_done_callback(lambda _: self._ended(key))

    async def _run(self, key: str) -> None:
        started = time.monotonic()
        await self._work(key)
        self._took[key] = time.monotonic() - started

    def _ended(self, key: str) -> None:
        del self._running[key]
        if key in self._again:
            self._again.discard(key)
            self.note(key)
