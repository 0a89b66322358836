"""Which files to look at: those that were named, and those that a walk finds."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.regular import oddity
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.text import pattern, relative_path

if TYPE_CHECKING:
    from sdfcheck.files.git import Ignores, Listing

SUFFIXES = (".sdf", ".srdf", ".urdf", ".urdf.xml", ".world", ".xacro")
MODEL_CONFIG = "model.config"

# Folders that never hold the sources of a robot, in addition to all hidden ones.
_FOREIGN_FOLDERS = frozenset({"__pycache__", "node_modules", "site-packages"})
# Folders that build tools write, known by what the tools leave in them.
_BUILD_FOLDERS = frozenset({"build", "devel", "install", "log", "venv"})
_BUILD_MARKS = ("COLCON_IGNORE", "CATKIN_IGNORE", ".catkin", "CMakeCache.txt", "pyvenv.cfg")
_REFUSED = pattern(
    r"(?:^|/)tests?(?:_?data)?/(?:[^/]*/)*(?:[^/]*[_.-])?"
    r"(?:bad|broken|corrupt|errors?|failing|faulty|illegal|incorrect|invalid|malformed|wrong)"
    r"(?:[_.-][^/]*)?(?:/|$)"
)
"""Files of tests that are to be refused."""
FAULTY = "a test of faulty files, by its name"


class DiscoveredFile(NamedTuple):
    """A file to look at; ``named`` if a person wrote its path, else found in a walk."""

    path: Path
    named: bool


class Found(NamedTuple):
    """The files that the given paths lead to: sorted, each once.

    ``skipped`` are files and folders left out, with the reason; ``empty`` are the
    given folders in which nothing was found, ``unreadable`` folders that could not be
    looked into, with the reason.
    """

    files: tuple[DiscoveredFile, ...]
    skipped: tuple[tuple[Path, str], ...] = ()
    empty: tuple[Path, ...] = ()
    unreadable: tuple[tuple[Path, str], ...] = ()


def exclude_nothing(path: Path) -> bool:
    return False


def _absent(path: Path) -> WrongUsage:
    """The error for a path that leads to nothing."""
    name, sign, value = str(path).partition("=")
    hint = f"; an argument of xacro is written `{name}:={value}`" if sign and name.isidentifier() else ""
    return WrongUsage(f"no such file or folder: {path}{hint}")


def discover(
    paths: Sequence[Path],
    *,
    exclude: Callable[[Path], bool] = exclude_nothing,
    force_exclude: bool = False,
    respect_gitignore: bool = True,
) -> Found:
    """Find the files that ``paths`` name, and the robot descriptions below the folders among them.

    Hidden folders, ``node_modules``, ``site-packages``, ``__pycache__`` and the folders of build tools are not
    entered, nor are symbolic links to folders. A file that was named is found whatever ``exclude`` says, unless
    ``force_exclude``. A folder that was named is walked even where it is hidden or ignored itself.

    Raises:
        WrongUsage: a path does not exist.
    """
    found: dict[str, DiscoveredFile] = {}
    left = _Left([], [], tuple(path for path in paths if os.path.isdir(path)))
    empty: list[Path] = []
    for path in paths:
        if os.path.isdir(path):
            walked = list(_walk(path, respect_gitignore, left))
            if not walked:
                empty.append(path)
            for file in walked:
                reason = "excluded by the configuration" if exclude(file) else _said_by_name(file, path)
                if reason:
                    left.skipped.append((file, reason))
                else:
                    found.setdefault(os.path.abspath(file), DiscoveredFile(file, named=False))
        elif not os.path.exists(path):
            raise _absent(path)
        elif force_exclude and exclude(path):
            left.skipped.append((path, "excluded by the configuration"))
        else:
            key = os.path.abspath(path)
            if key not in found or not found[key].named:
                found[key] = DiscoveredFile(path, named=True)
    files = sorted(found.values(), key=lambda file: file.path.as_posix())
    return Found(tuple(files), _once(left.skipped), tuple(empty), _once(left.unreadable))


def _said_by_name(file: Path, top: Path) -> str:
    """Why a file that was found in a folder is left out, by its path; empty if it is not."""
    is_refused = _REFUSED.search(relative_path(file, top).replace(os.sep, "/"))
    return FAULTY if is_refused else ""


def _once(entries: list[tuple[Path, str]]) -> tuple[tuple[Path, str], ...]:
    return tuple(sorted(set(entries)))


class _Left(NamedTuple):
    """The files that a walk leaves out, with the reasons."""

    skipped: list[tuple[Path, str]]
    unreadable: list[tuple[Path, str]]
    named: tuple[Path, ...]

    def is_fit(self, path: Path) -> bool:
        """Whether a robot file that was found can be read; if not, it is noted."""
        odd = oddity(path) or ("a link that leads out of the project" if self._leads_out(path) else "")
        if odd:
            self.skipped.append((path, odd))
        return not odd

    def _leads_out(self, path: Path) -> bool:
        if not os.path.islink(path):
            return False
        from sdfcheck.files.library import Library, SearchPaths

        around = Library(SearchPaths(named=self.named)).around(path)
        return not around.hold(path, os.path.realpath(path))

    def not_read(self, folder: Path, why: str) -> None:
        self.unreadable.append((folder, f"cannot be read: {why}"))


def is_robot_file(name: str) -> bool:
    """Whether a file of this name is worth a look in a walk."""
    folded = name.lower()
    return folded.endswith(SUFFIXES) or folded == MODEL_CONFIG


def _walk(top: Path, respect_gitignore: bool, left: _Left) -> Iterator[Path]:
    if respect_gitignore:
        from sdfcheck.files.git import listed

        listing = listed(top)
        if listing is not None:
            yield from _listed_files(top, listing, left)
            return
        from sdfcheck.files.git import Ignores

        yield from _descend(top, Ignores.above(top), left)
    else:
        yield from _descend(top, None, left)


def _listed_files(top: Path, listing: Listing, left: _Left) -> Iterator[Path]:
    """The robot files among those that git lists, and those of repositories inside this one."""
    foreign: dict[str, bool] = {"": False}
    for name, why in listing.unread:
        if not _below_foreign(top, name, foreign):
            left.not_read(top / name, why)
    for name, is_repository in listing.names:
        folder, _, base = name.rpartition("/")
        if not is_repository and not is_robot_file(base):
            continue
        path = top / name
        if _below_foreign(top, name if is_repository else folder, foreign):
            continue
        if is_repository:
            # A submodule may not be checked out, and its folder removed.
            if os.path.isdir(path) and not path.is_symlink():
                yield from _walk(path, True, left)
        # Git lists what was deleted, and what lies in folders that nobody may enter.
        elif os.path.lexists(path) and not os.path.isdir(path) and left.is_fit(path):
            yield path


def _below_foreign(top: Path, folder: str, known: dict[str, bool]) -> bool:
    """Whether ``folder`` (relative to ``top``) or one above it is not to be entered."""
    missing = []
    at = folder
    while at not in known:
        missing.append(at)
        at = at.rpartition("/")[0]
    for at in reversed(missing):
        known[at] = known[at.rpartition("/")[0]] or _is_foreign(top / at)
    return known[folder]


def _is_foreign(folder: Path) -> bool:
    name = folder.name
    if name.startswith(".") or name in _FOREIGN_FOLDERS:
        return True
    return name in _BUILD_FOLDERS and any(os.path.exists(folder / mark) for mark in _BUILD_MARKS)


def _descend(top: Path, ignores: Ignores | None, left: _Left) -> Iterator[Path]:
    """Walk without git's help; without recursion, as folders may be deep."""
    waiting = [(top, ignores)]
    while waiting:
        folder, ignores = waiting.pop()
        if ignores is not None:
            ignores = ignores.entering(folder)
        try:
            with os.scandir(folder) as listing:
                entries = sorted(listing, key=lambda entry: entry.name)
        except OSError as error:
            left.not_read(folder, error.strerror or str(error))
            continue
        for entry in entries:
            path = folder / entry.name
            is_folder = entry.is_dir(follow_symlinks=False)
            if _is_foreign(path) if is_folder else not is_robot_file(entry.name):
                continue
            if ignores is not None and ignores.ignore(path, folder=is_folder):
                continue
            if is_folder:
                waiting.append((path, ignores))
            elif not os.path.isdir(path) and left.is_fit(path):
                yield path
