"""A run in several processes, for folders with many files.

The files are dealt out in portions: this process and its workers each take the next one
when they are done with the last. Where a process can be copied, a worker has at once
whatever this one has loaded.
"""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Iterable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.discover import Found
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Linter, Notice, Notify, Options, Part, Progress, find, joined
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from multiprocessing.connection import Connection
    from multiprocessing.context import ForkContext, SpawnContext
    from multiprocessing.queues import SimpleQueue

COPIES = sys.platform == "linux"
"""Whether a worker is a copy of this process; on macOS the system's own libraries would mind."""
LEAST = 16 if COPIES else 100
"""So many files are linted while a worker gets ready; with fewer for each, one process is as fast."""
MOST = 8
"""More processes than that are of little use, so that nobody gets them unasked."""
_PORTIONS = 8
"""For each process, so that none waits long for the last."""


class Done(NamedTuple):
    """What was made of one portion, and what there is to say about it."""

    part: Part
    notices: list[Notice]


def run_in_parallel(
    paths: Sequence[Path],
    options: Options,
    jobs: int | None = None,
    *,
    progress: Progress | None = None,
    notify: Notify | None = None,
) -> Run:
    """The same as :func:`sdfcheck.lint.session.run`, by ``jobs`` processes; None: by as many as are of use."""
    found = find(paths, options)
    jobs = min(jobs or MOST, processors(), len(found.files) // LEAST)
    if jobs < 2:
        with Linter(options) as linter:
            return joined([linter.lint(found, progress=progress, notify=notify)])
    work = _Work(_portions(found, jobs * _PORTIONS), options, is_listening=notify is not None)
    done = _share(work, jobs, progress)
    in_order = [done[number] for number in sorted(done)]
    for notice in (notice for each in in_order for notice in each.notices):
        if notify is not None:
            notify(notice)
    return joined([each.part for each in in_order])


def processors() -> int:
    """How many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _portions(found: Found, number: int) -> list[Found]:
    """About so many portions of what was found; neighbours stay together, as they refer to one another."""
    size = -(-len(found.files) // number)
    portions = [Found(found.files[at : at + size]) for at in range(0, len(found.files), size)]
    portions[0] = found._replace(files=portions[0].files)
    return portions


class _Work(NamedTuple):
    """What there is to do; ``is_listening``: is somebody told of what comes up?"""

    portions: list[Found]
    options: Options
    is_listening: bool

    def do(self, numbers: Iterable[int], progress: Progress | None = None) -> dict[int, Done]:
        """Lint the portions of these numbers."""
        count = sum(len(portion.files) for portion in self.portions)
        done = {}
        with Linter(self.options) as linter:
            for number in numbers:
                before = sum(len(portion.files) for portion in self.portions[:number])
                notices: list[Notice] = []
                told = _shifted(progress, before, count) if progress else None
                notify = notices.append if self.is_listening else None
                part = linter.lint(self.portions[number], progress=told, notify=notify)
                done[number] = Done(part, notices)
        return done


def _share(work: _Work, jobs: int, progress: Progress | None) -> dict[int, Done]:
    """What came of the portions, by their numbers, done by this process and ``jobs - 1`` workers."""
    from multiprocessing import get_context

    import sdfcheck.lint.engine  # noqa: F401  (before there are copies)

    context = get_context("fork") if COPIES else get_context("spawn")
    numbers = range(len(work.portions))
    try:
        tasks: SimpleQueue[int | None] = context.SimpleQueue()
    except (ImportError, OSError):  # a system without semaphores, or that lets nobody have one
        return work.do(numbers, progress)
    for task in (*numbers, *[None] * jobs):
        tasks.put(task)
    workers: list[_Worker] = []
    try:
        with suppress(OSError):  # the system has its limits: then there are fewer
            workers.extend(_Worker(context, tasks, work) for _ in range(jobs - 1))
        done = work.do(iter(tasks.get, None), progress)
        for worker in workers:
            done.update(worker.result())
    finally:
        for worker in workers:
            worker.end()
    return done


def _shifted(progress: Progress, before: int, count: int) -> Progress:
    """The same for a portion that comes after so many files, of all that there are."""
    return lambda done, _, path: progress(before + done, count, path)


class _Worker:
    """Another process that takes its share, and the way by which its results come back."""

    def __init__(
        self,
        context: ForkContext | SpawnContext,
        tasks: SimpleQueue[int | None],
        work: _Work,
    ) -> None:
        self._results, theirs = context.Pipe(duplex=False)
        self._process = context.Process(target=_serve, args=(theirs, tasks, work))
        self._process.start()
        theirs.close()

    def result(self) -> dict[int, Done]:
        """What the worker has done; raises what it has raised."""
        try:
            told: dict[int, Done] | Exception = self._results.recv()
        except EOFError:
            self._process.join()
            cause = f"one of the processes was ended from outside (exit code {self._process.exitcode})"
            raise WrongUsage(f"{cause}; --jobs 1 needs the least memory") from None
        if isinstance(told, Exception):
            raise told
        return told

    def end(self) -> None:
        """Nobody waits for it any longer."""
        self._process.terminate()


def _serve(results: Connection, tasks: SimpleQueue[int | None], work: _Work) -> None:
    """What a worker does: it sends its share, or the exception that it met."""
    # Who interrupts the run speaks to the process that was started.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    told: dict[int, Done] | Exception
    try:
        told = work.do(iter(tasks.get, None))
    except Exception as error:
        told = error
    results.send(told)
