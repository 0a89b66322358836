"""A run by several workers: the processes of this machine, or an executor that the caller brings.

Where a process can be copied, a worker has at once whatever this one has loaded. A worker
that dies takes its executor with it: the files that it may have had are then linted one by
one, each in a process that nothing else depends on, and the others as before.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.lint.session import Linter, Notify, Options, Progress, find, joined
from sdfcheck.source.errors import WrongUsage

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from sdfcheck.lint.run import Run

LEAST = 32 if sys.platform == "linux" else 100
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
    options = options.about(paths)
    found = find(paths, options)
    jobs = min(jobs or MOST, processors(), len(found.files) // LEAST)
    if jobs < 2:
        with Linter(options) as linter:
            return joined([linter.lint(found, progress=progress, notify=notify)], notify)
    # One process needs none of it.
    from sdfcheck.lint.processes import by_processes, portions, run_of

    work = portions(found, options, jobs * _PORTIONS, is_listening=notify is not None)
    return run_of(by_processes(work, jobs, progress), options, notify)


def run_on(executor: Executor, paths: Sequence[Path], options: Options) -> Run:
    """The same as :func:`sdfcheck.lint.session.run`, by the workers of an executor.

    Files whose worker was lost are in ``skipped``, with the reason. The work that a
    broken executor has left is done by processes of this machine.

    Raises:
        WrongUsage: as ``run`` does; also if the executor gave no result at all.
    """
    from sdfcheck.lint.processes import Lost, by_processes, outcomes, portions, run_of, settled, submit

    options = options.about(paths)
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
    again = dict(zip(left, by_processes([work[n] for n in left], processors()), strict=True))
    return run_of(
        [again.get(n) or [settled(work[n], outcome)] for n, outcome in enumerate(found)], options, None
    )


def processors() -> int:
    """How many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1
