"""One run: find files, settle what applies to each, lint it, silence what is to be silenced."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.discover import DiscoveredFile, Found, discover
from sdfcheck.files.library import Disk, Library
from sdfcheck.files.regular import (
    OUTSIDE,
    Identity,
    Outside,
    note_read,
    noting,
    open_named,
    open_regular,
    read_on,
)
from sdfcheck.lint.config.configuration import Configuration
from sdfcheck.lint.config.settings import Settings
from sdfcheck.lint.one_file import Caches, Selected, lint_file, lint_included
from sdfcheck.lint.rulebook.rulebook import RuleBook
from sdfcheck.lint.run import RuleFacts, Run
from sdfcheck.lint.select import ActiveRules
from sdfcheck.source.errors import REPORT_IT, WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import HEAD, Kind, Treatment, sniff, treatment

if TYPE_CHECKING:
    from sdfcheck.files.library import Projects, SearchPaths
    from sdfcheck.lint.diagnostic import Diagnostic
    from sdfcheck.lint.rulebook.pack import Fault

Progress = Callable[[int, int, Path], None]
"""Called before each file: how many are done, how many there are, and which comes now."""


class Level(Enum):
    """How much a notice matters; after a FAILURE the run is incomplete (exit code 2)."""

    NOTE = "note"
    WARNING = "warning"
    FAILURE = "error"


class Notice(NamedTuple):
    """A note on the run that is not a diagnostic of a file."""

    level: Level
    text: str


Notify = Callable[[Notice], None]


def _nobody(notice: Notice) -> None:
    """The notifier of a session without one."""


class Options(NamedTuple):
    """The settings of the caller; the configuration has the rest.

    ``kind`` is what named files are taken for, whatever they look like. ``stdin`` is a
    text to lint under the name ``stdin_path``. xacro files are expanded with ``arguments``
    (in place of those of the configuration) unless ``expand`` is False. Files below the folders
    ``named`` may refer to one another.
    """

    configuration: Configuration
    force_exclude: bool = False
    skip_unrelated: bool = False
    kind: Kind | None = None
    stdin: bytes | None = None
    stdin_path: Path = Path("<stdin>")
    expand: bool = True
    arguments: tuple[tuple[str, str], ...] = ()
    named: tuple[Path, ...] = ()
    exclude: tuple[Path, ...] = ()
    """Files and folders that are left out, also where they are named."""
    changed_since: str = ""
    """A commit of git: only files are linted that a change since then can affect."""
    is_alone: bool = False
    """Is each file judged as the whole description that a consumer gets, also where others include it?"""

    def settings_for(self, path: Path) -> Settings:
        """The settings of a file."""
        return self.configuration.settings_for(path)

    def about(self, paths: Sequence[Path]) -> Options:
        """The settings of a run on some paths: files below the folders among them may refer to one another."""
        folders = tuple(path for path in paths if os.path.isdir(path))
        return self._replace(named=folders) if folders else self


class InternalError(Exception):
    """A bug met on a file."""

    def __init__(self, path: Path, error: str) -> None:
        super().__init__(path, error)

    def __str__(self) -> str:
        return f"{self.args[0]}: {self.args[1]}"


class Part(NamedTuple):
    """The results of some of the files of a run.

    ``foreign`` holds, by real path, what was found in files that only includes lead to,
    and how much of that was silenced.
    """

    diagnostics: list[Diagnostic]
    foreign: dict[str, tuple[Sequence[Diagnostic], int]]
    files: list[Path]
    skipped: list[tuple[Path, str]]
    suppressed: int
    rules: dict[str, RuleFacts]
    read: frozenset[Identity] = frozenset()
    """All files that were read."""


def run(
    paths: Sequence[Path], options: Options, *, progress: Progress | None = None, notify: Notify | None = None
) -> Run:
    """Lint what ``paths`` lead to.

    Raises:
        WrongUsage: a path does not exist, or the configuration is faulty.
        InternalError: a bug, if nobody is notified; otherwise the other files are linted anyway.
    """
    options = options.about(paths)
    with Linter(options) as linter:
        return joined([linter.lint(find(paths, options), progress=progress, notify=notify)], notify)


class Linter:
    """Lints the files of a run, all at once or by parts; what some of them include is read once for all.

    The parts of one run may share their ``book`` and ``projects``.
    """

    __slots__ = ("_book", "_caches", "_options")

    def __init__(
        self,
        options: Options,
        book: RuleBook | None = None,
        projects: dict[SearchPaths, Projects] | None = None,
    ) -> None:
        self._options = options
        self._book = book or RuleBook()
        self._caches = Caches(
            expand=options.expand,
            arguments=options.arguments,
            named=options.named,
            is_alone=options.is_alone,
            projects=projects,
        )

    def __enter__(self) -> Linter:
        return self

    def __exit__(self, *raised: object) -> None:
        self._caches.close()

    def lint(self, found: Found, *, progress: Progress | None = None, notify: Notify | None = None) -> Part:
        """Lint files that were found, and what they include first; raises as :func:`run` does."""
        with noting() as read:
            part = self._lint(found, progress, notify)
        return part._replace(read=frozenset(read))

    def _lint(self, found: Found, progress: Progress | None, notify: Notify | None) -> Part:
        options, book = self._options, self._book
        part = Part([], {}, [], list(found.skipped), 0, {})
        suppressed = 0
        seen: ActiveRules | None = None
        for file in selected(found, options, part.skipped, notify=notify or _nobody, progress=progress):
            settings = options.settings_for(file.path)
            active = book.active(settings, file.path)
            if active is not seen:
                _report_faults(book.faults(settings), notify)
            with _surviving(file.path, part.skipped, notify):
                kept, silenced = lint_file(file, book, settings, self._caches)
                part.files.append(file.path)
                part.diagnostics.extend(kept)
                suppressed += silenced
                if active is not seen:
                    part.rules.update((facts.code, facts) for facts in active.facts)
                    seen = active
        for document in self._caches.included(part.files):
            with _surviving(document.path, part.skipped, notify):
                reported = lint_included(document, book, options.configuration)
                part.foreign[os.path.realpath(document.path)] = reported
        for path, referrer in self._caches.refused:
            (notify or _nobody)(Notice(Level.NOTE, f"{referrer}: {path} is not read: it lies {OUTSIDE}"))
        return part._replace(suppressed=suppressed)


def _report_faults(faults: Sequence[Fault], notify: Notify | None) -> None:
    """Report the rules of plugins that could not be loaded."""
    if faults and notify is None:
        raise WrongUsage("; ".join(map(str, faults)))
    for fault in faults:
        assert notify is not None
        notify(Notice(Level.FAILURE, str(fault)))


def joined(parts: Sequence[Part], notify: Notify | None = None) -> Run:
    """The run that consists of some parts, in order, with one notice of all pointers of Git LFS."""
    skipped = sorted(entry for part in parts for entry in part.skipped)
    pointers = [path for path, reason in skipped if reason == _looks_like(Kind.LFS_POINTER)]
    if pointers:
        first = f"{pointers[0]}" + (f" and {len(pointers) - 1} more" if pointers[1:] else "")
        (notify or _nobody)(Notice(Level.WARNING, f"{first}: {_POINTERS}"))
    files = [path for part in parts for path in part.files]
    may_clash = len(parts) > 1 and any(part.foreign for part in parts)
    own = set(map(Disk().real, files)) if may_clash else set()
    foreign: dict[str, tuple[Sequence[Diagnostic], int]] = {}
    for part in parts:
        foreign = {
            **{path: reported for path, reported in part.foreign.items() if path not in own},
            **foreign,
        }
    diagnostics = [diagnostic for part in parts for diagnostic in part.diagnostics]
    for part in parts:
        note_read(part.read)
    for reported, _ in foreign.values():
        diagnostics += reported
    if diagnostics:
        from sdfcheck.lint.fold import without_repeats

        diagnostics = sorted(without_repeats(diagnostics), key=lambda diagnostic: diagnostic.sort_key)
    rules = {code: facts for part in parts for code, facts in part.rules.items()}
    return Run(
        tuple(diagnostics),
        tuple(files),
        tuple(skipped),
        sum(part.suppressed for part in parts) + sum(silenced for _, silenced in foreign.values()),
        rules=tuple(rules[code] for code in sorted(rules)),
    )


@contextmanager
def _surviving(path: Path, skipped: list[tuple[Path, str]], notify: Notify | None) -> Iterator[None]:
    """A bug that occurs on a file is reported, and the file ignored; without a notifier, it is raised."""
    try:
        yield
    except WrongUsage:
        raise
    except Exception as error:
        if notify is None or os.environ.get("SDFCHECK_DEBUG"):
            raise InternalError(path, f"{type(error).__name__}: {error}") from error
        reported = " ".join(f"{type(error).__name__}: {error}".split())
        notify(Notice(Level.FAILURE, f"{path}: internal error: {reported} ({REPORT_IT})"))
        skipped.append((path, "met a bug"))


def find(paths: Sequence[Path], options: Options) -> Found:
    """The files that ``paths`` and the configuration lead to, not looked into yet."""
    configuration = options.configuration

    def exclude(path: Path) -> bool:
        return is_left_out(path) or configuration.settings_for(path).excludes(path)

    def is_left_out(path: Path) -> bool:
        whole = os.path.abspath(path)
        return any(whole == each or whole.startswith(os.path.join(each, "")) for each in left_out)

    left_out = tuple(map(os.path.abspath, options.exclude))
    here = configuration.settings_in(Path.cwd())
    found = discover(
        paths, exclude=exclude, force_exclude=options.force_exclude, respect_gitignore=here.respect_gitignore
    )
    if left_out:
        files = tuple(file for file in found.files if not is_left_out(file.path))
        found = found._replace(files=files)
    if options.changed_since:
        from sdfcheck.files.changed import only_affected

        found = found._replace(files=only_affected(found.files, paths, options.changed_since))
    if options.stdin is None:
        return found
    if options.force_exclude and exclude(options.stdin_path):
        return found._replace(skipped=(*found.skipped, (options.stdin_path, "excluded by the configuration")))
    return found._replace(files=(*found.files, DiscoveredFile(options.stdin_path, named=True)))


def selected(
    found: Found,
    options: Options,
    skipped: list[tuple[Path, str]],
    *,
    notify: Notify = _nobody,
    progress: Progress | None = None,
) -> Iterator[Selected]:
    """Read the files that are worth linting; the others go to ``skipped``, with the reason."""
    for folder in found.empty:
        text = f"no SDFormat, URDF, xacro or model.config file in {folder}"
        notify(Notice(Level.WARNING, text))
    for folder, reason in found.unreadable:
        notify(Notice(Level.FAILURE, f"{folder}: {reason}"))
        skipped.append((folder, reason))
    for number, file in enumerate(found.files):
        if progress is not None:
            progress(number, len(found.files), file.path)
        try:
            taken = _look(file, options, notify)
        except OSError as error:
            reason = f"cannot be read: {error.strerror}"
            notify(Notice(Level.FAILURE, f"{file.path}: {reason}"))
            skipped.append((file.path, reason))
            continue
        if isinstance(taken, Selected):
            yield taken
        else:
            skipped.append((file.path, _looks_like(taken)))


def _look(file: DiscoveredFile, options: Options, notify: Notify) -> Selected | Kind:
    """The file's content if it is to be linted, else only what it is."""
    if options.stdin is not None and file.path == options.stdin_path:
        return _judge(file, options.stdin, options, notify)
    limit = options.configuration.settings_for(file.path).size_limit
    with open_named(file.path, limit) if file.named else open_regular(file.path, limit) as stream:
        head = stream.read(HEAD)
        taken = _judge(file, head, options, notify)
        is_link = isinstance(taken, Selected) and os.path.islink(file.path)
        if is_link and sniff(head, file.path) not in _DESCRIPTIONS:
            _refuse_to_show(file.path, options)
        if len(head) == HEAD and isinstance(taken, Selected):
            return taken._replace(data=head + read_on(stream, file.path, limit))
        return taken


_DESCRIPTIONS = frozenset({Kind.SDF, Kind.URDF, Kind.XACRO, Kind.MODEL_CONFIG, Kind.SRDF})


def _refuse_to_show(path: Path, options: Options) -> None:
    """Make sure that a link to what is not a robot description does not lead out: findings would show the text."""
    search = options.settings_for(path).search._replace(named=options.named)
    around = Library(search).around(path)
    if not around.hold(path, os.path.realpath(path)):
        raise Outside(path, f"a link to what is not a robot description, {OUTSIDE}")


def _judge(file: DiscoveredFile, head: bytes, options: Options, notify: Notify) -> Selected | Kind:
    if options.kind is not None and file.named:
        return Selected(file.path, head, options.kind)
    kind = sniff(head, file.path)
    action = treatment(kind, file.path, named=file.named and not options.skip_unrelated)
    if action is Treatment.LINT:
        return Selected(file.path, head, kind)
    if action is not Treatment.SKIP:
        level = {Treatment.NOTICE: Level.NOTE, Treatment.WARN: Level.WARNING}.get(action, Level.FAILURE)
        if kind is not Kind.LFS_POINTER:  # one notice for all of them
            notify(Notice(level, f"{file.path}: {_looks_like(kind)}, not linted"))
    return kind


def _looks_like(kind: Kind) -> str:
    return f"looks like {kind.description}"


_POINTERS = "only pointers of Git LFS are here, not linted; fetch the files with `git lfs pull`"
