"""``--fix``, ``--add-ignore`` and ``--diff`` of ``sdfcheck lint``."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path

from sdfcheck.cli.parts.output import deliver
from sdfcheck.cli.parts.terminal import emit, say
from sdfcheck.cli.parts.view_options import Request
from sdfcheck.files.overwrite import Refused, overwrite
from sdfcheck.files.regular import read_named
from sdfcheck.lint.diagnostic import counted
from sdfcheck.lint.fix.fixer import ROUNDS, FixedFile, MadeFix, fix_files
from sdfcheck.lint.run import Run
from sdfcheck.lint.session import Level, Notice, Notify, Options, run
from sdfcheck.lint.suppress.baseline import hold, read, render
from sdfcheck.report.paths import Paths
from sdfcheck.source.decode import decode, encoding_of
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple


class Work(NamedTuple):
    """An operation on files: its verb, and its function."""

    verb: str
    participle: str
    change: Callable[[Run, Sequence[Path], Options], Iterator[FixedFile]]


def work(request: Request) -> Work:
    """The options of the command line.

    Raises:
        WrongUsage: the reason cannot be in a comment.
    """
    if not request.add_ignore:
        return Work("fix", "fixed", partial(fix_files, unsafe=request.unsafe_fixes))
    from sdfcheck.lint.suppress.add_ignores import add_ignores

    if "--" in request.reason or request.reason.endswith("-") or not request.reason.isprintable():
        raise WrongUsage(
            "--reason cannot be in a comment: it has `--`, ends with `-` or is not a line of text"
        )
    return Work("silence", "silenced", partial(add_ignores, reason=request.reason.strip()))


class Rewriter:
    """Changes the files below ``paths`` in which a run has found something, or the text of stdin."""

    def __init__(
        self, paths: Sequence[Path], options: Options, notify: Notify, work: Work, request: Request
    ) -> None:
        self._paths = paths
        self._options = options
        self._notify = notify
        self._work = work
        self._request = request
        self._given_up: set[Path] = set()
        self._made: dict[Path, Counter[MadeFix]] = {}

    def write(self, done: Run) -> Run:
        """Write what changes, and lint again: a fix in one file may show in another.

        The text of stdin goes to stdout.
        """
        fixed, silenced = 0, done.suppressed
        for _ in range(ROUNDS):
            written = 0
            for fixed_file in self._fixed_files(done):
                if self._write(fixed_file):
                    written += fixed_file.fixed
                    self._note(fixed_file)
            if not written:
                break
            fixed += written
            done = run(self._paths, self._options, notify=self._notify)
        if self._options.stdin is not None:
            sys.stdout.buffer.write(self._options.stdin)
            sys.stdout.flush()
        if self._work.verb == "fix":
            self._say_fixes()
            if self._request.fix_only and not self._request.quiet:
                say(f"Fixed {counted(fixed, 'finding')}." if fixed else "Nothing to fix.")
            return done._replace(fixed=fixed)
        if not self._request.quiet:
            new = done.suppressed - silenced
            say(f"Silenced {counted(new, 'finding')}." if new else "Nothing to silence.")
        return done

    def show(self, done: Run) -> int:
        """Print what would change as a unified diff; the exit code says whether there is anything."""
        fixed = 0
        for fixed_file in self._fixed_files(done):
            emit(unified_diff(fixed_file))
            fixed += fixed_file.fixed
            self._note(fixed_file)
        self._say_fixes()
        if not self._request.quiet:
            whole, verb = counted(max(fixed, len(done.diagnostics)), "finding"), self._work.verb
            say(f"Would {verb} {fixed} of {whole}." if fixed else f"Nothing to {verb}.")
        return int(fixed > 0)

    def _note(self, fixed_file: FixedFile) -> None:
        self._made.setdefault(fixed_file.path, Counter()).update(fixed_file.made)

    def _say_fixes(self) -> None:
        """List the fixes by file: how often each was made, or would be, and what it does."""
        if not self._request.show_fixes:
            return
        paths = Paths()
        for path, made in sorted(self._made.items()):
            say(f"- {paths(path)}:")
            for fix, count in sorted(made.items(), key=lambda item: item[0]):
                say(f"    {count} × {fix.code} {fix.name}: {fix.title}")

    def _fixed_files(self, done: Run) -> Iterator[FixedFile]:
        left = tuple(each for each in done.diagnostics if each.span.source.path not in self._given_up)
        for fixed_file in self._work.change(done._replace(diagnostics=left), self._paths, self._options):
            if fixed_file.path in self._given_up:
                continue
            if fixed_file.refusal:
                what = "some fixes are left out" if fixed_file.fixed else f"not {self._work.participle}"
                self._give_up(fixed_file.path, Level.WARNING, f"{what}: {fixed_file.refusal}")
            if fixed_file.fixed:
                yield fixed_file

    def _write(self, fixed_file: FixedFile) -> bool:
        if self._options.stdin is not None and fixed_file.path == self._options.stdin_path:
            self._options = self._options._replace(stdin=fixed_file.after)
            return True
        try:
            if read_named(fixed_file.path) != fixed_file.before:
                self._give_up(
                    fixed_file.path, Level.FAILURE, f"not {self._work.participle}: it has changed meanwhile"
                )
                return False
            overwrite(fixed_file.path, fixed_file.after, instead=True)
        except OSError as error:
            self._give_up(
                fixed_file.path,
                Level.FAILURE,
                f"not {self._work.participle}: {error.strerror}"
                if isinstance(error, Refused)
                else f"cannot be written: {error.strerror}",
            )
            return False
        return True

    def _give_up(self, path: Path, level: Level, reason: str) -> None:
        self._given_up.add(path)
        self._notify(Notice(level, f"{path}: {reason}"))


def unified_diff(fixed_file: FixedFile) -> str:
    """The changes in a file, in the format of ``diff -u``."""
    from difflib import unified_diff as compare

    name = fixed_file.path.as_posix()
    before, after = (_lines(data, fixed_file.path) for data in (fixed_file.before, fixed_file.after))
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


# ``--baseline`` of ``sdfcheck lint``.


def write(done: Run, path: Path, *, quiet: bool) -> int:
    """Write a baseline; returns the exit code."""
    deliver(render(done, path), path)
    if not quiet:
        say(f"{path} holds {counted(len(done.diagnostics), 'finding')}.")
    return 0


def without_known(done: Run, path: Path, notify: Notify) -> Run:
    """The run without what the baseline knows."""
    held = hold(done, read(path), path)
    if held.gone:
        verb, them = ("is", "it") if held.gone == 1 else ("are", "them")
        known = counted(held.gone, "finding")
        notify(Notice(Level.NOTE, f"{known} of {path} {verb} gone; --write-baseline forgets {them}"))
    return held.run
