"""Which files to look at: those that were named, and those that a walk finds."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.source.record import NamedTuple
from sdfcheck.source.wrong_usage import WrongUsage

if TYPE_CHECKING:
    from sdfcheck.files.git import Listed
    from sdfcheck.files.gitignore import Ignores

SUFFIXES = (".sdf", ".urdf", ".world", ".xacro")
MODEL_CONFIG = "model.config"

# Folders that never hold the sources of a robot, besides all hidden ones.
_FOREIGN_FOLDERS = frozenset({"__pycache__", "node_modules", "site-packages"})
# Folders that build tools write, known by what the tools leave in them.
_BUILD_FOLDERS = frozenset({"build", "devel", "install", "log", "venv"})
_BUILD_MARKS = ("COLCON_IGNORE", "CATKIN_IGNORE", ".catkin", "CMakeCache.txt", "pyvenv.cfg")


class DiscoveredFile(NamedTuple):
    """A file to look at; ``named`` if a person wrote its path, else found in a walk."""

    path: Path
    named: bool


class Found(NamedTuple):
    """What the given paths lead to: sorted, each file once.

    ``skipped`` are files and folders left out, with the reason; ``empty`` are the
    given folders in which nothing was found.
    """

    files: tuple[DiscoveredFile, ...]
    skipped: tuple[tuple[Path, str], ...] = ()
    empty: tuple[Path, ...] = ()


def exclude_nothing(path: Path) -> bool:
    return False


def discover(
    paths: Sequence[Path],
    *,
    exclude: Callable[[Path], bool] = exclude_nothing,
    force_exclude: bool = False,
    respect_gitignore: bool = True,
) -> Found:
    """Find the files that ``paths`` name, and the robot descriptions below the folders among them.

    Hidden folders, ``node_modules``, ``site-packages``, ``__pycache__`` and the folders
    of build tools are not entered, nor are symbolic links to folders. A file that was
    named is found whatever ``exclude`` says, unless ``force_exclude``. A folder that
    was named is walked even where it is hidden or ignored itself.

    Raises:
        WrongUsage: a path does not exist.
    """
    found: dict[str, DiscoveredFile] = {}
    skipped: list[tuple[Path, str]] = []
    empty: list[Path] = []
    for path in paths:
        if os.path.isdir(path):
            walked = list(_walk(path, respect_gitignore, skipped))
            if not walked:
                empty.append(path)
            for file in walked:
                if exclude(file):
                    skipped.append((file, "excluded by the configuration"))
                else:
                    found.setdefault(os.path.abspath(file), DiscoveredFile(file, named=False))
        elif not os.path.exists(path):
            raise WrongUsage(f"no such file or folder: {path}")
        elif force_exclude and exclude(path):
            skipped.append((path, "excluded by the configuration"))
        else:
            key = os.path.abspath(path)
            if key not in found or not found[key].named:
                found[key] = DiscoveredFile(path, named=True)
    files = sorted(found.values(), key=lambda file: file.path.as_posix())
    return Found(tuple(files), tuple(sorted(set(skipped))), tuple(empty))


def is_robot_file(name: str) -> bool:
    """Whether a file of this name is worth a look in a walk."""
    folded = name.lower()
    return folded.endswith(SUFFIXES) or folded == MODEL_CONFIG


def _walk(top: Path, respect_gitignore: bool, skipped: list[tuple[Path, str]]) -> Iterator[Path]:
    if respect_gitignore:
        from sdfcheck.files.git import listed

        names = listed(top)
        if names is not None:
            yield from _listed_files(top, names, skipped)
            return
        from sdfcheck.files.gitignore import Ignores

        yield from _descend(top, Ignores.above(top), skipped)
    else:
        yield from _descend(top, None, skipped)


def _listed_files(top: Path, names: list[Listed], skipped: list[tuple[Path, str]]) -> Iterator[Path]:
    """The robot files among those that git lists, and those of repositories inside this one."""
    foreign: dict[str, bool] = {"": False}
    for name, is_repository in names:
        folder, _, base = name.rpartition("/")
        if not is_repository and not is_robot_file(base):
            continue
        path = top / name
        if _below_foreign(top, name if is_repository else folder, foreign):
            continue
        if is_repository:
            yield from _walk(path, True, skipped)
        elif path.is_file():
            yield path


def _below_foreign(top: Path, folder: str, known: dict[str, bool]) -> bool:
    """Whether ``folder`` (relative to ``top``) or one above it is not to be entered."""
    if folder not in known:
        parent = folder.rpartition("/")[0]
        known[folder] = _below_foreign(top, parent, known) or _is_foreign(top / folder)
    return known[folder]


def _is_foreign(folder: Path) -> bool:
    name = folder.name
    if name.startswith(".") or name in _FOREIGN_FOLDERS:
        return True
    return name in _BUILD_FOLDERS and any((folder / mark).exists() for mark in _BUILD_MARKS)


def _descend(folder: Path, ignores: Ignores | None, skipped: list[tuple[Path, str]]) -> Iterator[Path]:
    """Walk without git's help."""
    if ignores is not None:
        ignores = ignores.entering(folder)
    try:
        with os.scandir(folder) as listing:
            entries = sorted(listing, key=lambda entry: entry.name)
    except OSError as error:
        skipped.append((folder, f"cannot be read: {error.strerror}"))
        return
    for entry in entries:
        path = folder / entry.name
        is_folder = entry.is_dir(follow_symlinks=False)
        if _is_foreign(path) if is_folder else not (is_robot_file(entry.name) and entry.is_file()):
            continue
        if ignores is not None and ignores.ignore(path, folder=is_folder):
            continue
        if is_folder:
            yield from _descend(path, ignores, skipped)
        else:
            yield path
