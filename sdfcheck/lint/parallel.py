"""A run in several processes, for folders with many files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Notice, Notify, Options, Part, Progress, find, joined, lint_part, run
from sdfcheck.source.discover import Found

LEAST = 100
"""So many files are linted while a process starts; with fewer for each, one process is as fast."""
_ROUNDS = 4
"""Parts for each process, so that none waits long for the last."""


def run_in_parallel(
    paths: Sequence[Path], options: Options, jobs: int, *, progress: Progress | None, notify: Notify
) -> Run:
    """The same as :func:`sdfcheck.lint.session.run`, by at most ``jobs`` processes and one for each CPU."""
    found = find(paths, options)
    count = len(found.files)
    jobs = min(jobs, os.cpu_count() or 1, count // LEAST)
    if jobs < 2:
        return run(paths, options, progress=progress, notify=notify)
    from concurrent.futures import ProcessPoolExecutor
    from multiprocessing import get_context

    size = -(-count // (jobs * _ROUNDS))
    # Neighbours stay together: they refer to one another.
    parts = [Found(found.files[at : at + size]) for at in range(0, count, size)]
    parts[0] = parts[0]._replace(skipped=found.skipped, barren=found.barren)
    results = []
    with ProcessPoolExecutor(jobs, mp_context=get_context("spawn")) as pool:
        for part, notices in pool.map(_lint, parts, [options] * len(parts)):
            results.append(part)
            for notice in notices:
                notify(notice)
            if progress is not None and part.files:
                progress(sum(len(each.files) for each in results), count, part.files[-1])
    return joined(results)


def _lint(found: Found, options: Options) -> tuple[Part, list[Notice]]:
    """What one process does with a part of the files."""
    notices: list[Notice] = []
    return lint_part(found, options, notify=notices.append), notices
