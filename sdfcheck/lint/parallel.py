"""A run by several workers: the processes of this machine, or an executor that the caller brings.

Where a process can be copied, a worker has at once whatever this one has loaded. A worker
that dies takes its executor with it: the files that it may have had are then linted one by
one, each in a process that nothing else depends on, and the others as before.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.lint.portions import (
    Done,
    Lost,
    Portion,
    checked,
    lint_portion,
    outcomes,
    portions,
    rules_for,
    settled,
    single_files,
    submit,
)
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Linter, Notify, Options, Progress, find, joined
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from concurrent.futures import Executor

COPIES = sys.platform == "linux"
"""Whether a worker is a copy of this process; on macOS the system's own libraries would mind."""
LEAST = 32 if COPIES else 100
"""So many files are linted while a worker gets ready; with fewer for each, one process is as fast."""
MOST = 8
"""More processes than that are of little use, so that nobody gets them unasked."""
_PORTIONS = 8
"""For each process, so that none waits long for the last."""
_PORTIONS_OF_A_CLUSTER = 64
"""At least so many (of one file or more), as the number of workers is not known."""


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
    work = portions(found, options, jobs * _PORTIONS, is_listening=notify is not None)
    return _run_of(_by_processes(work, jobs, progress), options, notify)


def run_on(executor: Executor, paths: Sequence[Path], options: Options) -> Run:
    """The same as :func:`sdfcheck.lint.session.run`, by the workers of an executor.

    Files whose worker was lost are in ``skipped``, with the reason. The work that a
    broken executor has left is done by processes of this machine.

    Raises:
        WrongUsage: as ``run`` does; also if the executor gave no result at all.
    """
    work = portions(find(paths, options), options, _PORTIONS_OF_A_CLUSTER, is_listening=False)
    futures = submit(executor, work)
    try:
        found = outcomes(work, futures)
    finally:
        for future in futures:
            future.cancel()
    lost = [outcome for outcome in found if isinstance(outcome, Lost)]
    if len(lost) == len(found) and not lost[0].is_broken:
        raise WrongUsage(f"the executor linted nothing: {lost[0].reason}")
    left = [n for n, outcome in enumerate(found) if isinstance(outcome, Lost) and outcome.is_broken]
    again = dict(zip(left, _by_processes([work[n] for n in left], processors()), strict=True))
    return _run_of(
        [again.get(n) or [settled(work[n], outcome)] for n, outcome in enumerate(found)], options, None
    )


def processors() -> int:
    """How many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _run_of(results: Sequence[Sequence[Done]], options: Options, notify: Notify | None) -> Run:
    done = list(chain.from_iterable(results))
    for notice in (notice for each in done for notice in each.notices):
        if notify is not None:
            notify(notice)
    parts = [each.part for each in done]
    parts[0] = parts[0]._replace(rules=rules_for((path for part in parts for path in part.files), options))
    return joined(parts)


def _by_processes(
    work: Sequence[Portion], jobs: int, progress: Progress | None = None
) -> list[Sequence[Done]]:
    """The results of each portion, in order."""
    results: dict[int, Sequence[Done]] = {}
    waiting = list(range(len(work)))
    while waiting:
        found = _attempt([work[number] for number in waiting], jobs, progress)
        pairs = zip(waiting, found, strict=True)
        results |= {number: [outcome] for number, outcome in pairs if isinstance(outcome, Done)}
        lost = [number for number in waiting if number not in results]
        # Those that were being linted, and those that were on the way to a worker.
        suspects, waiting = lost[: 2 * jobs + 1], lost[2 * jobs + 1 :]
        results |= {number: _one_by_one(work[number]) for number in suspects}
    return [results[number] for number in range(len(work))]


def _attempt(work: Sequence[Portion], jobs: int, progress: Progress | None = None) -> Sequence[Done | Lost]:
    """The outcomes of portions in new processes; in this one where the system grants none."""
    import sdfcheck.lint.engine  # noqa: F401  (before there are copies)

    try:
        with _processes(jobs) as pool:
            return outcomes(work, submit(pool, work), progress)
    except (ImportError, NotImplementedError, OSError):  # no semaphores, or too many processes
        return [checked(lint_portion(portion)) for portion in work]


def _one_by_one(portion: Portion) -> list[Done]:
    """The results of a portion, each file linted in a process that may die."""
    work = waiting = single_files(portion)
    results: list[Done] = []
    while waiting:
        for single, outcome in zip(waiting, _attempt(waiting, 1), strict=True):
            results.append(settled(single, outcome))
            if isinstance(outcome, Lost):  # and with it those that were to follow in that process
                break
        waiting = work[len(results) :]
    return results


@contextmanager
def _processes(jobs: int) -> Iterator[Executor]:
    """An executor of new processes, which end with it, at once where it is left by an exception."""
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import active_children, get_context

    others = set(active_children())
    pool = ProcessPoolExecutor(jobs, get_context("fork" if COPIES else "spawn"), initializer=_begin)
    try:
        yield pool
    except BaseException:
        for process in set(active_children()) - others:
            process.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _begin() -> None:
    """Prepare a worker."""
    import signal
    from multiprocessing import parent_process
    from multiprocessing.connection import wait
    from threading import Thread

    # An interrupt ends it without a word; the process that was started speaks.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    parent = parent_process()
    assert parent

    def end_with_parent() -> None:
        wait([parent.sentinel])
        os._exit(1)

    Thread(target=end_with_parent, daemon=True).start()
