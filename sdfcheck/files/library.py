"""The files of one run: where others are looked for, and each of them read once."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, TypeVar, cast

from sdfcheck.files.regular import (
    MEGABYTE,
    SIZE_LIMIT,
    Outside,
    is_below,
    names_in,
    open_regular,
    read_named,
    read_on,
    read_regular,
)
from sdfcheck.source.record import NamedTuple

if TYPE_CHECKING:
    from sdfcheck.files.packages import Packages
    from sdfcheck.source.document import Document
    from sdfcheck.source.sniff import Kind


# Answers of the file system, remembered.

T = TypeVar("T")
_NO_NAMES = frozenset({"", os.curdir, os.pardir})


class Disk:
    """Answers about paths; those that were given stay as they are for a run."""

    __slots__ = ("_existing", "_listings", "_real", "_views")

    def __init__(self) -> None:
        self._existing: dict[str, bool] = {}
        self._listings: dict[str, Mapping[str, str]] = {}
        self._real: dict[str, str] = {}
        self._views: dict[tuple[object, str], object] = {}

    def view(self, folder: str, compute: Callable[[str, Disk], T]) -> T:
        """The result of ``compute`` for a folder, as its path is written; computed once."""
        key = (compute, folder)
        if key not in self._views:
            self._views[key] = compute(folder, self)
        return cast("T", self._views[key])

    def has(self, path: str) -> bool:
        """Is there a file or folder?"""
        found = self._existing.get(path)
        if found is None:
            found = self._existing[path] = os.path.exists(path)
        return found

    def real(self, path: str | os.PathLike[str]) -> str:
        """The absolute path without symbolic links; folders on the way are followed once."""
        folder, name = os.path.split(path)
        if name in _NO_NAMES:
            return os.path.realpath(path)
        found = os.path.join(self._folder(folder), name)
        return os.path.realpath(found) if os.path.islink(found) else found

    def _folder(self, folder: str) -> str:
        below: list[tuple[str, str]] = []
        while (found := self._real.get(folder)) is None:
            above, name = os.path.split(folder)
            if name in _NO_NAMES:
                found = self._real[folder] = os.path.realpath(folder)
            else:
                below.append((folder, name))
                folder = above
        for folder, name in reversed(below):
            plain = os.path.join(found, name)
            plain = folder if plain == folder else plain  # one text serves as both
            found = self._real[folder] = os.path.realpath(plain) if os.path.islink(plain) else plain
        return found

    def ignoring_case(self, path: str) -> str | None:
        """A path that exists and differs from this one only in the case of letters."""
        missing: list[str] = []
        at = path
        while not self.has(at):
            above, name = os.path.split(at)
            if not name:
                return None
            missing.append(name)
            at = above or os.curdir
        for name in reversed(missing):
            same = self._listing(at).get(name.lower())
            if same is None:
                return None
            at = os.path.join(at, same)
        return os.path.normpath(at) if self.has(at) else None

    def _listing(self, folder: str) -> Mapping[str, str]:
        """The entries of a folder: names in lower case → names; empty if it is not a folder."""
        listed = self._listings.get(folder)
        if listed is None:
            listed = self._listings[folder] = {name.lower(): name for name in reversed(names_in(folder))}
        return listed


# Measurements, kept from run to run.

_EDITION = 5
"""To be counted up whenever something is measured in another way."""
_LARGEST_SHELF = 16 * MEGABYTE
_MOST_KEPT, _MOST_SHELVES = 256 * MEGABYTE, 4096
"""So much is kept, in so many files; then the oldest ones give way."""


class Shelves:
    """Rows of JSON about files: those about the files of one folder, of one kind, are in one file of the cache.

    A row begins with a stamp, which tells whether it still holds.
    """

    __slots__ = ("_fresh", "_places", "_rows")

    def __init__(self) -> None:
        self._places: dict[tuple[str, str], str | None] = {}
        self._rows: dict[str, dict[str, list[Any]]] = {}
        self._fresh: dict[str, tuple[int, dict[str, list[Any]]]] = {}

    def find(self, folder: str, name: str, kind: str, stamp: str) -> list[Any] | None:
        """The row about a file; None where it is not known, or the file has changed."""
        place = self._place(folder, kind)
        row = self._rows[place].get(name) if place is not None else None
        return row[1:] if isinstance(row, list) and row[:1] == [stamp] else None

    def keep(self, folder: str, name: str, kind: str, row: Sequence[object], most: int) -> None:
        """Keep a row from the next :meth:`save` on, with ``most`` others that are not older."""
        place = self._place(folder, kind)
        if place is not None:
            self._rows[place][name] = list(row)
            self._fresh.setdefault(place, (most, {}))[1][name] = list(row)

    def save(self) -> None:
        """Write what is new; where that cannot be, the next run measures again."""
        if not self._fresh:
            return
        import json

        from sdfcheck.files.overwrite import overwrite

        for place, (most, fresh) in self._fresh.items():
            rows = list({**_kept(place), **fresh}.items())[-most:]
            with suppress(OSError):
                os.makedirs(os.path.dirname(place), exist_ok=True)
                text = json.dumps({"edition": _EDITION, "rows": dict(rows)})
                overwrite(Path(place), text.encode("utf-8", "surrogateescape"), instead=True, lasting=False)
        with suppress(OSError):
            _make_room(os.path.dirname(next(iter(self._fresh))))
        self._fresh.clear()

    def _place(self, folder: str, kind: str) -> str | None:
        """The file of a shelf, which is read when it is asked for first; None where nothing is kept."""
        if (folder, kind) not in self._places:
            cache = cache_folder()
            place = (
                str(cache / f"{digest_of(os.path.realpath(folder))}{kind}.json")
                if cache is not None
                else None
            )
            if place is not None:
                self._rows[place] = _kept(place)
            self._places[folder, kind] = place
        return self._places[folder, kind]


def digest_of(text: str) -> str:
    """A short name for a text, which no other one has."""
    from hashlib import blake2b

    return blake2b(text.encode("utf-8", "surrogateescape"), digest_size=10).hexdigest()


def _kept(place: str) -> dict[str, list[Any]]:
    import json

    try:
        shelf = json.loads(read_regular(Path(place), _LARGEST_SHELF))
        rows = shelf["rows"] if shelf["edition"] == _EDITION else {}
        return rows if isinstance(rows, dict) else {}
    except (OSError, ValueError, TypeError, LookupError, RecursionError):
        return {}


def _make_room(cache: str) -> None:
    """Remove the oldest files of the cache while there is too much of it."""
    with os.scandir(cache) as entries:
        found = [(each.stat(), each.path) for each in entries if each.name.endswith(".json")]
    size, count = sum(status.st_size for status, _ in found), len(found)
    for status, path in sorted(found, key=lambda each: each[0].st_mtime_ns):
        if size <= _MOST_KEPT and count <= _MOST_SHELVES:
            return
        os.unlink(path)
        size, count = size - status.st_size, count - 1


def cache_folder() -> Path | None:
    """The folder of kept measurements: that of ``SDFCHECK_CACHE_DIR``, or the user's; None for none."""
    given = os.environ.get("SDFCHECK_CACHE_DIR")
    if given is not None:
        return Path(given, "meshes") if os.path.isabs(given) else None
    if os.name == "nt":
        folder = os.environ.get("LOCALAPPDATA", "")
    else:
        folder = os.environ.get("XDG_CACHE_HOME", "") or os.path.expanduser("~/.cache")
    return Path(folder, "sdfcheck", "meshes") if os.path.isabs(folder) else None


MODEL_PATH_VARIABLES = (
    "GZ_SIM_RESOURCE_PATH",
    "SDF_PATH",
    "IGN_GAZEBO_RESOURCE_PATH",
    "GAZEBO_MODEL_PATH",
    "GAZEBO_RESOURCE_PATH",
)
"""Environment variables in which Gazebo's generations and libsdformat look for models."""


class SearchPaths(NamedTuple):
    """Where names are looked for: folders of models, folders of packages, packages by name.

    ``named`` are the folders whose files a person asked about, ``tables`` those of vendors' own
    elements that are known in addition to the built-in ones. A file ``is_alone`` where no other one of
    its project is to speak for it.
    """

    models: tuple[Path, ...] = ()
    packages_in: tuple[Path, ...] = ()
    packages: tuple[tuple[str, Path], ...] = ()
    named: tuple[Path, ...] = ()
    tables: tuple[Path, ...] = ()
    is_alone: bool = False

    @property
    def model_folders(self) -> Iterator[Path]:
        """The configured folders, then those of the environment."""
        yield from self.models
        yield from _model_folders_of_environment()


def _model_folders_of_environment() -> Iterator[Path]:
    for variable in MODEL_PATH_VARIABLES:
        for part in os.environ.get(variable, "").split(os.pathsep):
            if part:
                yield Path(part)


_CLIMB = 6
"""How many folders above the referring file may hold the model or package that it names."""
_MARKS = ("package.xml", "model.config")
"""Files that make a folder a package or a model."""


def folders_above(given: str) -> list[str]:
    """A folder and those above it, up to where everybody's files begin."""
    folder = Path(os.path.abspath(given))  # resolve() would follow links
    home = Path(os.path.expanduser("~"))
    shared = {home, *home.parents, Path(folder.anchor)} - {folder}
    return [str(above) for above in (folder, *folder.parents)[:_CLIMB] if above not in shared]


class Surroundings(NamedTuple):
    """The places whose files the documents of one folder may bring in.

    ``roots`` are, without links, the project, what a person named, and the folders of packages and
    models; ``installed`` those of the environment, which build tools fill with links; ``above`` the folders
    beside which other packages may be.
    """

    roots: tuple[str, ...]
    installed: tuple[str, ...]
    above: tuple[str, ...]

    def hold(self, path: Path, real: str) -> bool:
        """Whether a file lies there; ``real`` is its path without symbolic links."""
        plain = os.path.abspath(path)
        return (
            is_below(real, self.roots)
            or is_below(plain, self.installed)
            or any(is_below(real, (owner,)) for owner in self._owners(plain))
        )

    def _owners(self, plain: str) -> Iterator[str]:
        """The packages and models beside the project that a path may lead into."""
        for above in self.above:
            for folder in (above, os.path.join(above, "models")):
                # A folder in the project may be a link out of it.
                if is_below(plain, (folder,)) and not is_below(os.path.realpath(folder), self.roots):
                    name = plain[len(os.path.join(folder, "")) :].partition(os.sep)[0]
                    owner = os.path.join(folder, name)
                    if name and any(os.path.isfile(os.path.join(owner, mark)) for mark in _MARKS):
                        yield os.path.realpath(owner)


def library_of(document: Document) -> Library | None:
    """The library that a document looks others up in; None: nothing is looked up."""
    library = document.library
    return library if isinstance(library, Library) else None


class Projects:
    """Projects on disk, and what was made of their files: nothing in it depends on a document."""

    __slots__ = ("packages", "roots", "views")

    def __init__(self) -> None:
        self.roots: dict[Path, Path] = {}
        """Folder → the one of its project."""
        self.packages: dict[Path, Packages] = {}
        self.views: dict[tuple[object, ...], object] = {}

    def forget(self) -> None:
        """Look for files in the folders again; what packages there are is remembered."""
        self.views.clear()
        for packages in self.packages.values():
            packages.forget()


class Library:
    """Reads the files that documents refer to, each once, and remembers them for the run.

    Files of more than ``limit`` bytes are not read. Libraries of the same search paths may share their ``projects``.
    """

    __slots__ = (
        "_current",
        "_documents",
        "_hashes",
        "_limit",
        "_projects",
        "_surroundings",
        "_unseen",
        "disk",
        "model_folders",
        "refused",
        "search",
        "shelves",
    )

    def __init__(
        self, search: SearchPaths | None = None, limit: int = SIZE_LIMIT, projects: Projects | None = None
    ) -> None:
        self.search = search or SearchPaths()
        self.disk = Disk()
        self.shelves = Shelves()
        self._limit = limit
        self.model_folders = tuple(dict.fromkeys(self.search.model_folders))
        self._current: Document | None = None
        self._documents: dict[str, Document | None] = {}
        self._hashes: dict[str, int] = {}
        self._unseen: list[Document] = []
        self._projects = projects or Projects()
        self._surroundings: dict[Path, Surroundings] = {}
        self.refused: dict[Path, Path] = {}
        """Files that lie outside of what may be read → a document that refers to them."""

    def document(self, path: Path, kind: Kind | None = None, of: Document | None = None) -> Document | None:
        """The document of a file that a person named, or that another document refers to; None if it cannot be read."""
        key = self.disk.real(path)
        if key not in self._documents:
            try:
                document = self._read(path, key, kind, of)
            except Outside:
                return None  # for this document; another one may bring it in
            self._documents[key] = document
            if document is not None:
                self._unseen.append(document)
        return self._documents[key]

    def known(self, data: bytes, path: Path) -> Document | None:
        """The document of a file that was read before and held these bytes; it has this path now."""
        if not self._documents:
            return None
        key = self.disk.real(path)
        document = self._documents.get(key)
        if document is None or self._hashes[key] != hash(data):
            return None
        document.source.path = path
        return document

    def turn_to(self, document: Document) -> None:
        """Look at a document that is not kept; release the one before, unless another was reached through it."""
        if self._current is not None and not self._current.is_referred_to:
            self._current.release()
        self._current = document

    def unseen(self) -> Iterator[Document]:
        """The documents that were read and not handed out here before; looking at them may bring in more."""
        while self._unseen:
            yield self._unseen.pop(0)

    def read(self, path: Path, of: Document, limit: int = SIZE_LIMIT) -> bytes:
        """The content of a file that a document refers to, of at most ``limit`` bytes; raises as :meth:`open`."""
        with self.open(path, of, limit) as stream:
            return read_on(stream, path, min(limit, self._limit))

    def open(self, path: Path, of: Document, limit: int = SIZE_LIMIT) -> BinaryIO:
        """Open a file that a document refers to; raises OSError, as :func:`open_regular`."""
        try:
            return open_regular(path, min(limit, self._limit), self.around(of.path))
        except Outside:
            self.refused.setdefault(path, of.path)
            raise

    def around(self, path: Path) -> Surroundings:
        """The places whose files a document at a path may bring in."""
        found = self._surroundings.get(path.parent)
        if found is None:
            packages = self.packages(path)
            folders = (*packages.own, *self.model_folders, *self.search.named)
            found = self._surroundings[path.parent] = Surroundings(
                tuple(dict.fromkeys(os.path.realpath(folder) for folder in folders)),
                tuple(map(os.path.abspath, (*packages.sourced, *_model_folders_of_environment()))),
                tuple(folders_above(str(path.parent))),
            )
        return found

    def packages(self, path: Path) -> Packages:
        """The packages around a file."""
        from sdfcheck.files.packages import Packages, is_shared, project_root

        known = self._projects
        root = known.roots.get(path.parent)
        if root is None:
            root = known.roots[path.parent] = project_root(path)
        if root not in known.packages:
            named, is_flat = dict(self.search.packages), is_shared(root)
            known.packages[root] = Packages(root, named, self.search.packages_in, is_flat=is_flat)
        return known.packages[root]

    @property
    def open_texts(self) -> tuple[str, ...]:
        """The texts for xacro that somebody edits, in place of files."""
        return ()

    def of_project(self, path: Path, view: Callable[[Packages], T]) -> T:
        """A view of the packages around a file, made once for all files among them."""
        return self.view(self.packages(path), view)

    def view(self, packages: Packages, view: Callable[[Packages], T]) -> T:
        """A view of packages, made once for their folder."""
        key = (view, packages.root, packages.is_flat)
        views = self._projects.views
        if key not in views:
            views[key] = view(packages)
        return cast("T", views[key])

    def forget(self) -> None:
        """Read files anew when they are asked for next; what packages there are is remembered."""
        self.disk = Disk()
        self._documents.clear()
        self._hashes.clear()
        self._unseen.clear()
        self._projects.forget()
        self._surroundings.clear()

    def documents(self) -> tuple[Document, ...]:
        """The documents that were read."""
        return tuple(document for document in self._documents.values() if document is not None)

    def holds(self, path: Path) -> bool:
        """Did something refer to a file?"""
        return self.disk.real(path) in self._documents

    def given(self, data: bytes, path: Path, kind: Kind | None = None) -> Document:
        """The document of a file that a person named, whose content has been read: a pipe gives it once."""
        key = self.disk.real(path)
        document = self._documents[key] = self._made(data, path, key, kind)
        self._unseen.append(document)
        return document

    def _read(self, path: Path, key: str, kind: Kind | None, of: Document | None) -> Document | None:
        try:
            data = read_named(path, self._limit) if of is None else self.read(path, of)
        except Outside:
            raise
        except OSError:
            return None
        return self._made(data, path, key, kind)

    def _made(self, data: bytes, path: Path, key: str, kind: Kind | None) -> Document:
        from sdfcheck.source.document import read

        plain = os.path.normpath(path)
        document = read(data, Path(plain) if self.disk.real(plain) == key else path, kind)
        self._hashes[key] = hash(data)
        document.library = self
        return document
