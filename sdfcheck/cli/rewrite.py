"""``--fix``, ``--add-ignore`` and ``--diff`` of ``sdfcheck lint``."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Protocol

from sdfcheck.cli.terminal import emit, say
from sdfcheck.files.overwrite import overwrite
from sdfcheck.lint.fix.fixer import ROUNDS, Mended, mend
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Level, Notice, Notify, Options, run
from sdfcheck.lint.wording import counted
from sdfcheck.source.decode import decode, encoding_of
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.wrong_usage import WrongUsage


class Work(NamedTuple):
    """What is done to files: the word for it, and the function that does it."""

    verb: str
    participle: str
    change: Callable[[Run, Sequence[Path], Options], Iterator[Mended]]


class Request(Protocol):
    """What the command line says about it."""

    unsafe_fixes: bool
    add_ignore: bool
    reason: str


def work(request: Request) -> Work:
    """What the command line asks for.

    Raises:
        WrongUsage: the reason cannot be in a comment.
    """
    if not request.add_ignore:
        return Work("fix", "fixed", partial(mend, unsafe=request.unsafe_fixes))
    from sdfcheck.lint.suppress.add_ignores import add_ignores

    if "--" in request.reason or request.reason.endswith("-") or not request.reason.isprintable():
        raise WrongUsage("--reason cannot be in a comment: it has `--`, ends with `-` or is no line of text")
    return Work("silence", "silenced", partial(add_ignores, reason=request.reason.strip()))


class Rewriter:
    """Changes the files below ``paths`` in which a run has found something, or the text of stdin."""

    def __init__(
        self, paths: Sequence[Path], options: Options, notify: Notify, work: Work, *, quiet: bool
    ) -> None:
        self._paths = paths
        self._options = options
        self._notify = notify
        self._work = work
        self._quiet = quiet
        self._given_up: set[Path] = set()

    def write(self, done: Run) -> Run:
        """Write what changes, and lint again: a fix in one file may show in another.

        The text of stdin goes to stdout.
        """
        fixed, silenced = 0, done.suppressed
        for _ in range(ROUNDS):
            written = sum(mended.fixed for mended in self._mended(done) if self._write(mended))
            if not written:
                break
            fixed += written
            done = run(self._paths, self._options, notify=self._notify)
        if self._options.stdin is not None:
            sys.stdout.buffer.write(self._options.stdin)
            sys.stdout.flush()
        if self._work.verb == "fix":
            return done._replace(fixed=fixed)
        if not self._quiet:
            new = done.suppressed - silenced
            say(f"Silenced {counted(new, 'finding')}." if new else "Nothing to silence.")
        return done

    def show(self, done: Run) -> int:
        """Print what would change as a unified diff; the exit code says whether there is anything."""
        fixed = 0
        for mended in self._mended(done):
            emit(unified_diff(mended))
            fixed += mended.fixed
        if not self._quiet:
            whole, verb = counted(max(fixed, len(done.diagnostics)), "finding"), self._work.verb
            say(f"Would {verb} {fixed} of {whole}." if fixed else f"Nothing to {verb}.")
        return int(fixed > 0)

    def _mended(self, done: Run) -> Iterator[Mended]:
        for mended in self._work.change(done, self._paths, self._options):
            if mended.path in self._given_up:
                continue
            if mended.refusal:
                self._give_up(mended.path, Level.WARNING, f"not {self._work.participle}: {mended.refusal}")
            elif mended.fixed:
                yield mended

    def _write(self, mended: Mended) -> bool:
        if self._options.stdin is not None and mended.path == self._options.stdin_path:
            self._options = self._options._replace(stdin=mended.after)
            return True
        try:
            if mended.path.read_bytes() != mended.before:
                self._give_up(
                    mended.path, Level.FAILURE, f"not {self._work.participle}: it has changed meanwhile"
                )
                return False
            overwrite(mended.path, mended.after)
        except OSError as error:
            self._give_up(mended.path, Level.FAILURE, f"cannot be written: {error.strerror}")
            return False
        return True

    def _give_up(self, path: Path, level: Level, reason: str) -> None:
        self._given_up.add(path)
        self._notify(Notice(level, f"{path}: {reason}"))


def unified_diff(mended: Mended) -> str:
    """What changed in a file, as ``diff -u`` says it."""
    from difflib import unified_diff as compare

    name = mended.path.as_posix()
    before, after = (_lines(data, mended.path) for data in (mended.before, mended.after))
    lines = compare(before, after, f"a/{name}", f"b/{name}")
    return "".join(
        line if line.endswith("\n") else f"{line}\n\\ No newline at end of file\n" for line in lines
    )


def _lines(data: bytes, path: Path) -> list[str]:
    """The lines with their ends; only a line feed ends one, as for ``diff``."""
    source, _ = decode(data, path)
    mark = "\ufeff" if encoding_of(data).mark else ""
    lines = (mark + source.text).split("\n")
    last = lines.pop()
    return [*(f"{line}\n" for line in lines), *([last] if last else [])]
