"""Portions of the work by new processes of this machine; what a process that dies was linting is tried again alone."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from itertools import chain
from typing import TYPE_CHECKING

from sdfcheck.lint.portions import (
    Done,
    Lost,
    Portion,
    checked,
    lint_portion,
    outcomes,
    rules_for,
    settled,
    single_files,
    submit,
)
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Notify, Options, Progress, joined

if TYPE_CHECKING:
    from concurrent.futures import Executor

COPIES = sys.platform == "linux"
"""Whether a worker is a copy of this process; on macOS the system's own libraries do not allow that."""


def run_of(results: Sequence[Sequence[Done]], options: Options, notify: Notify | None) -> Run:
    """One run of the results of all portions."""
    done = list(chain.from_iterable(results))
    for notice in (notice for each in done for notice in each.notices):
        if notify is not None:
            notify(notice)
    parts = [each.part for each in done]
    parts[0] = parts[0]._replace(rules=rules_for((path for part in parts for path in part.files), options))
    return joined(parts)


def by_processes(
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

    # An interrupt ends it in silence; the process that was started speaks.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    parent = parent_process()
    assert parent

    def end_with_parent() -> None:
        wait([parent.sentinel])
        os._exit(1)

    Thread(target=end_with_parent, daemon=True).start()
