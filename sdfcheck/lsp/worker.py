"""One thread that does all work on documents: when to lint, and which job comes first."""

from __future__ import annotations

import asyncio
import ctypes
import gc
import heapq
import threading
import time
from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from itertools import count
from typing import Any, TypeVar

# When to lint: soon after a change, never twice at once, and not for what has changed again.

LONGEST = 0.02
"""The longest wait after a keystroke, in s, for the questions that come with it."""
_QUICK = 0.01
"""s: a text that is looked at in less waits for nothing."""


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
        took = self._took.get(key, _QUICK)
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


T = TypeVar("T")

ANSWER, OUTLINE, LINT, OVERVIEW, SURVEY = range(5)
"""The order of work: answers that somebody waits for, outlines, diagnostics of open files, hints beside a
text, diagnostics of files that include it.
"""

PAUSE = 5.0
"""After so many seconds without a job, memory is given back: what is read after an edit is read by then."""
MANY = 500
"""After so many jobs without a pause as well."""

_Job = tuple[int, int, Callable[[], Any], Callable[[Any, BaseException | None], None]]
"""Urgency, number, the work, and what takes its result or its exception."""


_ARENAS = -8
"""The setting of glibc that says how many heaps there are."""


def keep_memory_small() -> None:
    """Have one heap for all threads, whose free memory each can use; to be called before there are threads."""
    _ask_glibc("mallopt", _ARENAS, 1)


def _give_back() -> None:
    """Collect garbage, and give free memory back to the system."""
    gc.collect()
    _ask_glibc("malloc_trim", 0)


def _ask_glibc(function: str, *values: int) -> None:
    """Call a function of the system's library, if it has that."""
    with suppress(AttributeError, OSError, TypeError):
        getattr(ctypes.CDLL(None), function)(*values)


class Worker:
    """Runs jobs for an event loop; what belongs to documents is never touched by two threads.

    A job gives way to answers between its portions, and while it waits; two lints are never under way.
    """

    def __init__(self) -> None:
        self._jobs: list[_Job] = []
        self._urgency = ANSWER
        """Of the job under way."""
        self._beside = ThreadPoolExecutor(1, "beside")
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

    def give_way(self) -> None:
        """Do what somebody waits for more than for the job under way, which calls this between its portions."""
        while True:
            with self._news:
                if not self.is_waited_for:
                    return
                job = heapq.heappop(self._jobs)
            self._do(job)

    def aside(self, call: Callable[[], T], pause: Callable[[], None]) -> T:
        """The result of what has nothing to do with documents; meanwhile the job under way pauses."""
        future = self._beside.submit(call)
        future.add_done_callback(self._wake)
        while not (future.done() or self._is_closed):
            pause()
            with self._news:
                self._news.wait_for(lambda: future.done() or self._is_closed or self.is_waited_for)
        return future.result()

    def _wake(self, _: object) -> None:
        with self._news:
            self._news.notify_all()

    @property
    def is_waited_for(self) -> bool:
        """Is there something more urgent than the job under way, and no lint?"""
        jobs = self._jobs
        return bool(jobs) and jobs[0][0] < min(self._urgency, LINT) and not self._is_closed

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
                        _give_back()
                        done_since = 0
                if self._is_closed:
                    return
                job = heapq.heappop(self._jobs)
            self._do(job)
            del job
            done_since += 1
            if done_since >= MANY:
                _give_back()
                done_since = 0

    def _do(self, job: _Job) -> None:
        outer, (self._urgency, _, work, done) = self._urgency, job
        try:
            value = work()
        except BaseException as error:
            done(None, error)
        else:
            done(value, None)
        self._urgency = outer
