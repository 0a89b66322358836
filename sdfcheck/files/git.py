"""Repositories of git: the root of a project, its files, those that changed, and those that are ignored."""

from __future__ import annotations

import os
import re
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.regular import MEGABYTE, read_regular
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import relative_path

if TYPE_CHECKING:
    from pathspec import GitIgnoreSpec


# The answers of git about a folder.

_LOCAL_VARIABLES = frozenset(
    """
    GIT_ALTERNATE_OBJECT_DIRECTORIES GIT_COMMON_DIR GIT_CONFIG GIT_CONFIG_COUNT GIT_CONFIG_PARAMETERS GIT_DIR
    GIT_GRAFT_FILE GIT_IMPLICIT_WORK_TREE GIT_INDEX_FILE GIT_INTERNAL_SUPER_PREFIX GIT_NAMESPACE
    GIT_NO_REPLACE_OBJECTS GIT_OBJECT_DIRECTORY GIT_PREFIX GIT_REPLACE_REF_BASE GIT_SHALLOW_FILE GIT_WORK_TREE
    """.split()
)
"""Set while git runs a hook; they would point at that repository, whichever folder is asked about."""
_UNREAD = re.compile(rb"^warning: could not open directory '([^\n]*)': ([^\n]*)$", re.MULTILINE)

TIMEOUT = 5.0
"""So many seconds git may take: what it reads may be a pipe into which nobody writes."""


def work_tree(folder: Path) -> Path | None:
    """The root of the repository that holds ``folder``; recognized by its ``.git``, without running git."""
    absolute = Path(os.path.abspath(folder))
    return next((place for place in (absolute, *absolute.parents) if os.path.exists(place / ".git")), None)


class Listed(NamedTuple):
    """One name that git lists: a file, or a repository inside the repository."""

    name: str
    is_repository: bool


class Listing(NamedTuple):
    """The files that git lists, sorted, and the folders that it could not read → reasons; all relative."""

    names: tuple[Listed, ...]
    unread: tuple[tuple[str, str], ...] = ()


def listed(folder: Path) -> Listing | None:
    """Tracked and untracked files below ``folder`` that are not ignored, relative to it.

    None if git has no answer: it is missing, this is not a repository, or the folder is itself ignored.
    """
    root = work_tree(folder)
    if root is None or _has_odd_ignores(folder, root):
        return None
    done = _git(folder, "ls-files", "-z", "--stage", "--cached", "--others", "--exclude-standard")
    if done is None:
        return None
    names = {_parse(os.fsdecode(line)) for line in done.output.split(b"\0") if line}
    if any(listed.name in {"", os.curdir} for listed in names):
        return None  # a submodule that is not checked out: git speaks of the folder itself, as what is around sees it
    if not names and _git(folder, "check-ignore", "--quiet", ".") is not None:
        return None
    unread = [
        (relative_path(root / os.fsdecode(name), folder), os.fsdecode(why))
        for name, why in _UNREAD.findall(done.complaints)
    ]
    return Listing(tuple(sorted(names)), tuple(unread))


def changed_since(root: Path, reference: str) -> tuple[Path, ...]:
    """The files of a repository that differ from what its branch left of ``reference``.

    Those that are not committed, not tracked or deleted since are among them. No program that a repository
    names runs: neither filters nor other comparisons.

    Raises:
        WrongUsage: the reference names no commit, or git has no answer.
    """
    commit = _git(root, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{reference}^{{commit}}")
    if commit is None:
        text = f"--changed-since: `{reference}` names no commit in {root}; a shallow clone may lack it"
        raise WrongUsage(f"{text} (`git fetch --unshallow`)")
    start = os.fsdecode(commit.output.strip())
    left_at = _git(root, "merge-base", start, "HEAD")
    if left_at is not None:
        start = os.fsdecode(left_at.output.strip())
    found: list[Path] = []
    filters = _without_filters(root)
    for question in (
        ("diff-index", "--cached", "--name-only", "--no-renames", "-z", start, "--"),
        ("diff-files", "--name-only", "-z"),
        ("ls-files", "--others", "--exclude-standard", "-z"),
    ):
        done = _git(root, *filters, *question)
        if done is None:
            raise WrongUsage(f"--changed-since: git has no answer about {root}")
        found += [root / os.fsdecode(name) for name in done.output.split(b"\0") if name]
    return tuple(dict.fromkeys(found))


def _without_filters(root: Path) -> list[str]:
    """Options by which git runs no filter: it would for files that are as old as its index."""
    done = _git(root, "config", "-z", "--name-only", "--get-regexp", r"^filter\..*\.(clean|process)$")
    keys = [os.fsdecode(key) for key in done.output.split(b"\0") if key] if done is not None else []
    filters = dict.fromkeys(key.rpartition(".")[0] for key in keys)
    settings = [f"{each}.{key}" for each in filters for key in ("clean=", "process=", "required=false")]
    return [word for setting in settings for word in ("-c", setting)]


def _has_odd_ignores(folder: Path, root: Path) -> bool:
    """Whether a ``.gitignore`` from ``folder`` up to ``root`` is a pipe or the like: git would wait."""
    absolute = Path(os.path.abspath(folder))
    above = [place for place in (absolute, *absolute.parents) if place == root or root in place.parents]
    files = [*(place / ".gitignore" for place in above), root / ".git" / "info" / "exclude"]
    return any(os.path.exists(file) and not os.path.isfile(file) for file in files)


def _parse(line: str) -> Listed:
    """Tracked names are after their mode, hash and stage; untracked ones have nothing before them."""
    entry, tab, name = line.partition("\t")
    if tab and entry.count(" ") == 2 and len(entry) > 45:
        return Listed(name.rstrip("/"), entry.startswith("160000 "))
    return Listed(line.rstrip("/"), line.endswith("/"))


class _Done(NamedTuple):
    output: bytes
    complaints: bytes


def _git(folder: Path, *arguments: str) -> _Done | None:
    """The output of a git command; None if it fails."""
    import subprocess

    environment = {name: value for name, value in os.environ.items() if name not in _LOCAL_VARIABLES}
    environment["LC_ALL"] = "C"
    try:
        done = subprocess.run(
            # A repository may name a program here, which would run.
            ["git", "-c", "core.fsmonitor=false", *arguments],
            cwd=folder,
            env=environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            check=True,
            timeout=TIMEOUT,
        )
    except (OSError, subprocess.SubprocessError):
        return None
    return _Done(done.stdout, done.stderr)


# ``.gitignore`` files, for where git is not there to ask.

SIZE_LIMIT = MEGABYTE
"""Larger files of patterns are not read."""


class Ignores:
    """The ``.gitignore`` files that apply in a folder, outermost first."""

    __slots__ = ("_layers",)

    def __init__(self, layers: tuple[tuple[str, GitIgnoreSpec], ...] = ()) -> None:
        self._layers = layers

    @classmethod
    def above(cls, folder: Path) -> Ignores:
        """Those between the root of the repository and ``folder``, unless they ignore ``folder`` itself."""
        root = work_tree(folder)
        absolute = Path(os.path.abspath(folder))
        ignores = cls()
        if root is None:
            return ignores
        ignores = ignores._reading(root, ".git/info/exclude")
        inside = [place for place in reversed([absolute, *absolute.parents]) if root in place.parents]
        for place in inside:
            ignores = ignores.entering(place.parent)
            if ignores.ignore(place, folder=True):
                return cls()
        return ignores

    def entering(self, folder: Path) -> Ignores:
        """With the ``.gitignore`` of ``folder`` added, if it has one."""
        return self._reading(folder, ".gitignore")

    def ignore(self, path: Path, *, folder: bool) -> bool:
        """Whether ``path`` is ignored; the innermost file with an opinion decides."""
        absolute = os.path.abspath(path)
        for top, spec in reversed(self._layers):
            relative = relative_path(absolute, top).replace(os.sep, "/")
            verdict = spec.check_file(relative + "/" if folder else relative).include
            if verdict is not None:
                return verdict
        return False

    def _reading(self, folder: Path, name: str) -> Ignores:
        try:
            lines = read_regular(folder / name, SIZE_LIMIT).decode("utf-8", "replace").splitlines()
        except OSError:
            return self
        return Ignores((*self._layers, (os.path.abspath(folder), _compile(lines))))


def is_ignored(path: str | os.PathLike[str]) -> bool:
    """Does a repository leave out a file, which need not be there, as what a build makes or a download brings?"""
    ignores = ignores_in(os.path.dirname(os.path.abspath(path)))
    return ignores is None or ignores.ignore(Path(path), folder=False)


def ignores_in(folder: str, _: object = None) -> Ignores | None:
    """The patterns for the files in a folder, which may not be there; None where it is ignored itself."""
    absolute = Path(os.path.abspath(folder))
    root = work_tree(absolute)
    if root is None:
        return Ignores()
    ignores = Ignores()._reading(root, ".git/info/exclude").entering(root)
    for place in reversed([each for each in (absolute, *absolute.parents) if root in each.parents]):
        if ignores.ignore(place, folder=True):
            return None
        ignores = ignores.entering(place)
    return ignores


def _compile(lines: list[str]) -> GitIgnoreSpec:
    """The patterns; like git, ignore lines that are not patterns."""
    from pathspec import GitIgnoreSpec

    try:
        return GitIgnoreSpec.from_lines(lines)
    except ValueError:
        return GitIgnoreSpec.from_lines([line for line in lines if _is_pattern(line)])


def _is_pattern(line: str) -> bool:
    from pathspec import GitIgnoreSpec

    try:
        GitIgnoreSpec.from_lines([line])
    except ValueError:
        return False
    return True
