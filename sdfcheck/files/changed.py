"""The files that a change can affect: those that changed, and those that name one of them, directly or not."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterable, Iterator, Sequence
from pathlib import Path

from sdfcheck.files.discover import MODEL_CONFIG, SUFFIXES, DiscoveredFile
from sdfcheck.files.git import changed_since, listed, work_tree
from sdfcheck.files.packages import YAML
from sdfcheck.files.regular import MEGABYTE, read_regular
from sdfcheck.source.errors import WrongUsage

_NAMING = (*SUFFIXES, ".config", ".gazebo", ".inc", ".trans", ".xml", *YAML)
"""The files that may name others."""
_OF_A_FOLDER = frozenset({"model.sdf", MODEL_CONFIG})
"""Files that others name by the folder that they are in."""
_LARGEST = 16 * MEGABYTE
"""Larger files are not searched for names."""
_WORD = re.compile(r"[\w.-]+")
_END = re.compile(r"[})*]([\w-]*\.\w+)(?![\w.-])")
_FOR_ALL_BELOW = frozenset(
    {"sdfcheck.toml", ".sdfcheck.toml", "package.xml", "manifest.xml", "CMakeLists.txt"}
)
"""Files on which everything below their folder depends."""
_LAUNCH = re.compile(r"(launch\.py|/launch/[^/]+\.py|\.launch(\.xml)?)$", re.IGNORECASE)
"""Files that may give arguments to every robot of a repository."""
_TIED = re.compile(r"(?:gz|ign)_type_name|base_(?:link_)?frame")
"""Words of YAML that may be about every robot: topics of bridges, and frames of bases."""


def only_affected(
    files: Sequence[DiscoveredFile], paths: Iterable[Path], reference: str
) -> tuple[DiscoveredFile, ...]:
    """Those of ``files`` that a change since ``reference`` can affect; ``paths`` are what a person has named.

    A file is affected if it changed, if an affected file's name is in its text, or if settings or the package
    around it changed. That a text contains the name is enough, so that rather too many files are taken.

    Raises:
        WrongUsage: a path is in no git repository, ``reference`` names no commit there, or git has no answer.
    """
    roots = {_root(path, reference) for path in paths}
    affected: set[str] = set()
    for root in sorted(roots):
        affected |= _affected(root, reference)
    above = {folder for folder in affected if folder.endswith(os.sep)}
    return tuple(file for file in files if _is_in(os.path.abspath(file.path), affected, above))


def _root(path: Path, reference: str) -> Path:
    root = work_tree(path if os.path.isdir(path) else path.parent)
    if root is None:
        raise WrongUsage(f"--changed-since {reference}: {path} is in no git repository")
    return root


def _is_in(path: str, affected: Collection[str], folders: Iterable[str]) -> bool:
    return path in affected or any(path.startswith(folder) for folder in folders)


def _affected(root: Path, reference: str) -> set[str]:
    """Absolute paths of the files, and of folders (with a separator at the end), that are affected."""
    affected: set[str] = set()
    waiting = list(map(str, changed_since(root, reference)))
    around = {folder for path in waiting for folder in _read_beside(path, root)}
    named_by = _NamedBy(root, waiting) if waiting else None
    while waiting and named_by is not None:
        path = waiting.pop()
        if path not in affected:
            affected.add(path)
            waiting += (each for name in _names(path) for each in named_by.files(name))
    return affected | {_folder(path) for path in affected if os.path.isdir(path)} | _below(affected) | around


def _below(affected: Iterable[str]) -> set[str]:
    """The folders whose settings or package changed."""
    return {_folder(os.path.dirname(path)) for path in affected if os.path.basename(path) in _FOR_ALL_BELOW}


def _read_beside(path: str, root: Path) -> Iterator[str]:
    """The folder in which descriptions may be read with a file that no description names."""
    if _LAUNCH.search(path):
        yield _folder(str(root))
    elif path.endswith(YAML):  # SRDF is read with files of these beside it
        yield _folder(str(root) if _TIED.search(_text(path)) else os.path.dirname(path))


def _text(path: str) -> str:
    """A file's text, empty if it cannot be read."""
    try:
        return read_regular(Path(path), _LARGEST).decode("utf-8", "replace")
    except OSError:
        return ""


def _folder(path: str) -> str:
    return os.path.join(path, "")


def _names(path: str) -> Iterator[str]:
    """The names by which other texts may name a file."""
    folder, name = os.path.split(path)
    if name.lower() in _OF_A_FOLDER:
        yield os.path.basename(folder)
    yield name


class _NamedBy:
    """Which files of a repository name others: by the last word of their names, or by an end after an expression."""

    def __init__(self, root: Path, changed: Iterable[str]) -> None:
        self._words: dict[str, list[str]] = {}
        self._ends: dict[str, list[str]] = {}
        """The rest of a name that begins with an expression or a star: ``${side}_arm.xacro``."""
        listing = listed(root)
        names = [each.name for each in listing.names] if listing is not None else []
        known = {_key(part) for name in names for part in name.split("/")[-2:]}
        known.update(_key(name) for path in changed for name in _names(path))  # also of deleted files
        for name in names:
            if name.lower().endswith(_NAMING):
                self._add(root / name, known)

    def files(self, name: str) -> Iterator[str]:
        """The files that name one of this name. Each is given once for each way in which it does."""
        yield from self._words.pop(_key(name), ())
        for end in [end for end in self._ends if name.endswith(end)]:
            yield from self._ends.pop(end)

    def _add(self, path: Path, known: set[str]) -> None:
        text = _text(str(path))
        for word in known & {word.strip(".-") for word in _WORD.findall(text)}:
            self._words.setdefault(word, []).append(str(path))
        for end in set(_END.findall(text)):
            self._ends.setdefault(end, []).append(str(path))


def _key(name: str) -> str:
    """The last word of a name, by which a text is searched for it."""
    words = _WORD.findall(name)
    return str(words[-1]).strip(".-") if words else name
