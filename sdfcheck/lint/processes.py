"""Lints in several processes: the files are dealt out in portions, and the findings come back in order."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import lru_cache
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.discover import DiscoveredFile, Found
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Level, Linter, Notice, Notify, Options, Part, Progress, joined
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from concurrent.futures import Executor, Future

    from sdfcheck.files.library import Projects, SearchPaths
    from sdfcheck.lint.run import RuleFacts


# A run divided among the workers of an executor: the portions, and their results.
#
# Any :class:`concurrent.futures.Executor` will do: threads, processes, a cluster. A portion of
# the files and its result can be pickled; a portion is linted from scratch, so that the result
# depends neither on the worker nor on the order.

DIED = "the process that linted it died, perhaps for lack of memory"
LARGEST = 50
"""So many files at most form a portion; its setup is paid once."""


class Portion(NamedTuple):
    """Some of the files of a run, of which each has its ``key``; relative paths start from ``folder``."""

    found: Found
    options: Options
    folder: Path
    key: bytes
    is_listening: bool

    @property
    def files(self) -> tuple[DiscoveredFile, ...]:
        return self.found.files


class Done(NamedTuple):
    """The result of one portion, and the notices that came up."""

    part: Part
    notices: list[Notice]


class Lost(NamedTuple):
    """A portion without a result, and why; ``is_broken``: the executor takes no more work."""

    reason: str
    is_broken: bool


def portions(found: Found, options: Options, number: int, *, is_listening: bool) -> list[Portion]:
    """About so many portions of the files; neighbors stay together, as they refer to one another."""
    size = max(1, min(LARGEST, -(-len(found.files) // max(1, number))))
    folder, key = Path.cwd(), os.urandom(8)
    parts = [Found(found.files[at : at + size]) for at in range(0, len(found.files), size)] or [Found(())]
    parts[0] = found._replace(files=parts[0].files)
    return [Portion(part, options, folder, key, is_listening) for part in parts]


def single_files(portion: Portion) -> list[Portion]:
    """A portion for each file."""
    number = len(portion.files)
    return portions(portion.found, portion.options, number, is_listening=portion.is_listening)


def lint_portion(portion: Portion) -> Done | Exception:
    """Lint the files of a portion, in whatever process or thread; exceptions are results like others."""
    notices: list[Notice] = []
    try:
        _check_folder(portion)
        book = _book(portion.key)
        with Linter(portion.options, book, _projects(portion.key)) as linter:
            part = linter.lint(portion.found, notify=notices.append if portion.is_listening else None)
    except Exception as error:
        return error
    # The facts of the rules are larger than what is found in most files.
    return Done(part._replace(rules={}), notices)


@lru_cache(maxsize=4)
def _book(key: bytes) -> RuleBook:
    """The rule book of a run, which its portions share."""
    return RuleBook()


@lru_cache(maxsize=1)
def _projects(key: bytes) -> dict[SearchPaths, Projects]:
    """The projects that the portions of a run are in, by search paths: their folders are listed once."""
    return {}


def rules_for(files: Iterable[Path], options: Options) -> dict[str, RuleFacts]:
    """The facts of the rules that run on some of the files, by code."""
    book = RuleBook()
    chosen = {id(active): active for active in (book.active(options.settings_for(f), f) for f in files)}
    return {facts.code: facts for active in chosen.values() for facts in active.facts}


def _check_folder(portion: Portion) -> None:
    here = Path.cwd()
    if here == portion.folder:
        return
    for file in portion.files:
        if not file.path.is_absolute():
            raise WrongUsage(
                f"{file.path} is relative to {portion.folder}, and a worker runs in {here}; give absolute paths"
            )


def submit(executor: Executor, work: Sequence[Portion]) -> list[Future[Done | Exception]]:
    """Give portions to an executor, all of them or as many as it takes before it breaks."""
    from concurrent.futures import BrokenExecutor

    futures: list[Future[Done | Exception]] = []
    with suppress(BrokenExecutor):
        futures.extend(executor.submit(lint_portion, portion) for portion in work)
    return futures


def outcomes(
    work: Sequence[Portion], futures: Sequence[Future[Done | Exception]], progress: Progress | None = None
) -> list[Done | Lost]:
    """The outcome of each portion, in order; raises the first exception that linting one met."""
    found: list[Done | Lost] = []
    count, before = sum(len(portion.files) for portion in work), 0
    for portion, future in zip(work, futures, strict=False):
        if progress is not None and portion.files:
            progress(before, count, portion.files[0].path)
        found.append(_outcome(future))
        before += len(portion.files)
    return found + [Lost("", is_broken=True)] * (len(work) - len(found))


def _outcome(future: Future[Done | Exception]) -> Done | Lost:
    from concurrent.futures import BrokenExecutor

    try:
        result = future.result()
    except Exception as error:  # whatever the executor raises for a worker that it has lost
        return Lost(_described(error), isinstance(error, BrokenExecutor))
    return checked(result)


def checked(result: Done | Exception) -> Done:
    """The result of :func:`lint_portion`; raises the exception that it may be."""
    if isinstance(result, Exception):
        raise result
    return result


def _described(error: BaseException) -> str:
    return " ".join(f"{type(error).__name__}: {error}".split())


def settled(portion: Portion, outcome: Done | Lost) -> Done:
    """The outcome of a portion; where it was lost, its files are reported as not linted."""
    if isinstance(outcome, Done):
        return outcome
    reason = DIED if outcome.is_broken else outcome.reason
    skipped = [*portion.found.skipped, *((file.path, reason) for file in portion.files)]
    notices = [Notice(Level.FAILURE, f"{file.path}: not linted: {reason}") for file in portion.files]
    return Done(Part([], {}, [], skipped, 0, {}), notices)


# Portions of the work by new processes of this machine; what a process that dies was linting is tried again
# alone.

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
    return joined(parts, notify)


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
