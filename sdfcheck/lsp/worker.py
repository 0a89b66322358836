"""One thread that does all work on documents, one job at a time: answers first, then what can wait."""

from __future__ import annotations

import asyncio
import gc
import heapq
import threading
from collections.abc import Callable
from contextlib import suppress
from itertools import count
from typing import Any, TypeVar

T = TypeVar("T")

ANSWER, LINT, OVERVIEW, SURVEY = range(4)
"""The order of work: answers that somebody waits for, diagnostics of open files, hints beside a
text, diagnostics of files that include it.
"""

PAUSE = 5.0
"""After so many seconds without a job, garbage is collected: what is read after an edit is read by then."""
MANY = 500
"""After so many jobs without a pause as well."""

_Job = tuple[int, int, Callable[[], Any], Callable[[Any, BaseException | None], None]]
"""Urgency, number, the work, and what takes its result or its exception."""


class Worker:
    """Runs jobs for an event loop; what belongs to documents is never touched by two threads."""

    def __init__(self) -> None:
        self._jobs: list[_Job] = []
        self._number = count()
        self._news = threading.Condition()
        self._is_closed = False
        self._thread = threading.Thread(target=self._serve, name="documents", daemon=True)
        self._thread.start()

    async def run(self, work: Callable[[], T], urgency: int = ANSWER) -> T:
        """The result of a job, which waits for its turn; one that nobody waits for any more is left out."""
        loop = asyncio.get_running_loop()
        future: asyncio.Future[T] = loop.create_future()

        def settle(value: Any, error: BaseException | None) -> None:
            if future.done():
                return
            if error is None:
                future.set_result(value)
            else:
                future.set_exception(error)

        def done(value: Any, error: BaseException | None) -> None:
            with suppress(RuntimeError):  # the loop has ended meanwhile
                loop.call_soon_threadsafe(settle, value, error)

        def wanted() -> T | None:
            return None if future.cancelled() else work()

        with self._news:
            heapq.heappush(self._jobs, (urgency, next(self._number), wanted, done))
            self._news.notify()
        return await future

    def close(self) -> None:
        """End after the job that is being done."""
        with self._news:
            self._is_closed = True
            self._news.notify()

    def _serve(self) -> None:
        done_since = 0
        while True:
            with self._news:
                while not self._jobs and not self._is_closed:
                    if not self._news.wait(PAUSE if done_since else None):
                        gc.collect()
                        done_since = 0
                if self._is_closed:
                    return
                *_, work, done = heapq.heappop(self._jobs)
            try:
                value = work()
            except BaseException as error:
                done(None, error)
            else:
                done(value, None)
            del work, done
            done_since += 1
            if done_since >= MANY:
                gc.collect()
                done_since = 0
