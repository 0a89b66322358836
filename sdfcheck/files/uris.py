"""From a URI in a description to a file on disk.

Schemes: ``model://name/…`` (a model in one of the model folders), ``package://name/…``
(a ROS package), ``file://…``, none (relative to the referring file), and what comes
from the network, which is never fetched.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

from sdfcheck.files.library import Disk, folders_above, library_of
from sdfcheck.files.packages import TEMPLATE, is_part, package_around
from sdfcheck.files.regular import MEGABYTE, is_below, names_in
from sdfcheck.source.document import Document
from sdfcheck.source.record import NamedTuple

_SCHEME = re.compile(r"([A-Za-z][A-Za-z0-9+.\-]+):/*")
_DRIVE = re.compile(r"/[A-Za-z]:(?:/|\Z)")
"""As in ``file:///C:/robots/arm.dae``: on Windows the first slash is not part of the path."""
REMOTE_SCHEMES = frozenset({"http", "https", "fuel", "ftp"})
SEARCHED_SCHEMES = frozenset({"model", "package"})
LOCAL_SCHEMES = frozenset({"file", *SEARCHED_SCHEMES})


class Location(NamedTuple):
    """Where a URI leads.

    ``path`` is the file or folder, None if nothing is there; then ``inside`` was looked
    for below ``folders``, and ``near`` is one that differs only in case. ``name`` is the
    model or package that is named, ``owner`` its folder if that was found, though not the file in it.
    """

    scheme: str
    path: Path | None
    folders: tuple[str, ...] = ()
    inside: str = ""
    near: Path | None = None
    name: str = ""
    owner: Path | None = None

    @property
    def tried(self) -> tuple[str, ...]:
        """The paths that were looked at."""
        paths = (os.path.normpath(os.path.join(folder, self.inside)) for folder in self.folders)
        return tuple(dict.fromkeys(paths))

    @property
    def first(self) -> str:
        """The first of the paths that were looked at; empty if none was."""
        return os.path.normpath(os.path.join(self.folders[0], self.inside)) if self.folders else ""

    @property
    def is_remote(self) -> bool:
        return self.scheme in REMOTE_SCHEMES

    @property
    def is_searched_for(self) -> bool:
        """Does the place depend on search paths, which another computer may have set otherwise?"""
        return self.scheme in SEARCHED_SCHEMES

    @property
    def is_local(self) -> bool:
        """Is the scheme one that leads to a file, none included?"""
        return not self.scheme or self.scheme in LOCAL_SCHEMES


def scheme_of(uri: str) -> str:
    """The scheme in lower case, empty without one; the letter of a Windows drive is not a scheme."""
    match = _SCHEME.match(uri.strip())
    return match[1].lower() if match else ""


def locate(document: Document, uri: str) -> Location:
    """Find what a URI in a document names; nothing is fetched, nothing is read.

    Each URI in the documents of a folder is looked up once.
    """
    surroundings = document.view(_surroundings)
    found = surroundings.located.get(uri)
    if found is None:
        found = surroundings.located[uri] = _locate(document, uri.strip(), surroundings)
    return found


def empty_folder(document: Document, path: str | os.PathLike[str]) -> str:
    """The folder above a path that is there, if it holds nothing, as one of a submodule that is not checked out.

    The folder of the document itself may be empty: its text may not be saved yet.
    """
    folder = document.view(_surroundings).disk.view(os.path.dirname(os.path.abspath(path)), _empty_from)
    return "" if not folder or is_below(os.path.abspath(document.path), (folder,)) else folder


def _empty_from(folder: str, _: Disk) -> str:
    """The first folder that is there from this one upwards, if it holds nothing."""
    while not os.path.isdir(folder):
        folder, below = os.path.dirname(folder), folder
        if folder == below:
            return ""
    return "" if names_in(folder) else folder


_MEDIA = ("media", "Media")
_CONFIG = "model.config"
_STEPS = frozenset({os.curdir, os.pardir})
"""A path that begins with one is relative to the file that names it, and to nothing else."""


class _Owners(NamedTuple):
    """Where the folder of a model or package was looked for, where it is, and where it is but for case."""

    tried: tuple[str, ...]
    there: tuple[str, ...]
    near: tuple[str, ...]


class _Surroundings:
    """A folder of documents: the folders above it, and what was looked up from there."""

    __slots__ = ("above", "disk", "folder", "located", "owners")

    def __init__(self, folder: str, disk: Disk) -> None:
        self.folder = folder
        """As it is known."""
        self.above = folders_above(folder)
        self.disk = disk
        self.located: dict[str, Location] = {}
        self.owners: dict[tuple[str, str], _Owners] = {}


def _surroundings(document: Document) -> _Surroundings:
    library = library_of(document)
    disk = document.view(_own_disk) if library is None else library.disk
    folder = os.path.dirname(document.path) or os.curdir
    return disk.view(folder, _Surroundings)


def _own_disk(document: Document) -> Disk:
    return Disk()


def _locate(document: Document, text: str, around: _Surroundings) -> Location:
    match = _SCHEME.match(text)
    scheme = match[1].lower() if match else ""
    if scheme and scheme not in LOCAL_SCHEMES:
        return Location(scheme, None)
    disk = around.disk
    rest = text[match.end() :] if match else text
    name, _, inside = rest.partition("/")
    if scheme in SEARCHED_SCHEMES:
        owners = _owners(document, scheme, name, around)
        found = _first(disk, scheme, owners.there or owners.near, inside)
        if found.path is None and owners.there:
            found = found._replace(path=_installed(document, owners.there[0], inside))
        if not owners.there:
            # Only the case of letters can be wrong then.
            near = found.path or found.near
            return Location(scheme, None, owners.tried, inside, near, name)
        return found._replace(name=name, owner=Path(owners.there[0]))
    path = file_path(text) if scheme else rest
    beside = os.path.join(around.folder, path)
    if os.path.isabs(path) or name in _STEPS or disk.has(beside):
        return _first(disk, scheme, (beside,))
    # Else it is looked for among the models, as Gazebo does for any scheme, and Gazebo Classic in the folders of media.
    tried = _owners(document, "model", name, around).tried
    models = (os.path.join(model, inside) if inside else model for model in tried)
    media = (os.path.join(above, media, "models", path) for above in around.above for media in _MEDIA)
    exported = _exported(document, path) if name in _MEDIA else ()
    return _first(disk, scheme, (beside, *models, *media, *exported))


def _owners(document: Document, scheme: str, name: str, around: _Surroundings) -> _Owners:
    """The folders of a model or package."""
    if (scheme, name) not in around.owners:
        candidates = (_models if scheme == "model" else _packages)(document, name, around)
        tried = tuple(dict.fromkeys(map(os.path.normpath, candidates)))
        there = tuple(path for path in tried if os.path.isdir(path))
        if scheme == "model" and not any(around.disk.has(os.path.join(path, _CONFIG)) for path in there):
            of_project = _models_of_project(document, name, around)
            tried, there = tried + of_project, of_project + there
        alike = () if there else (around.disk.ignoring_case(path) for path in tried)
        near = tuple(path for path in alike if path and os.path.isdir(path))
        around.owners[scheme, name] = _Owners(tried, there, near)
    return around.owners[scheme, name]


def file_path(uri: str) -> str:
    """The path after ``file://``, as libsdformat and Gazebo cut it; a host is taken for a folder."""
    rest = uri.strip()[len("file:") :]
    path = rest[2:] if rest[:2] == "//" else rest
    return path[1:] if os.name == "nt" and _DRIVE.match(path) else path


def _first(disk: Disk, scheme: str, folders: tuple[str, ...], inside: str = "") -> Location:
    paths = [os.path.join(folder, inside) if inside else folder for folder in folders]
    for path in paths:
        if disk.has(path):
            return Location(scheme, Path(path))
    near = next((found for path in paths if (found := disk.ignoring_case(os.path.normpath(path)))), None)
    return Location(scheme, None, folders, inside, None if near is None else Path(near))


def _models(document: Document, name: str, around: _Surroundings) -> Iterator[str]:
    if (library := library_of(document)) is not None:
        for folder in library.model_folders:
            yield os.path.join(folder, name)
    # The usual layout needs no setting: models side by side, or in a `models` folder near by.
    for above in around.above:
        yield os.path.join(above, name)
        yield os.path.join(above, "models", name)


def _models_of_project(document: Document, name: str, around: _Surroundings) -> tuple[str, ...]:
    """The folders of a model in other packages of the project: launch files point Gazebo to those.

    Or that of a package of the name, as libsdformat writes what is ``package://`` in URDF.
    """
    library = library_of(document)
    if library is None or library.search.is_alone:
        return ()
    packages = library.packages(document.path)
    package = packages.find(name, document.path)
    own = () if package is None or not around.disk.has(str(package / "package.xml")) else (str(package),)
    return (*packages.models(name, around.folder), *own)


def _exported(document: Document, path: str) -> Iterator[str]:
    """A path into folders of media in each package of the project, which packages export to Gazebo Classic."""
    library = library_of(document)
    if library is not None and not library.search.is_alone:
        packages = library.packages(document.path)
        found = (packages.find(name, document.path) for name in packages.names)
        yield from (os.path.join(package, path) for package in found if package is not None)


def _packages(document: Document, name: str, around: _Surroundings) -> Iterator[str]:
    if (library := library_of(document)) is not None:
        found = library.packages(document.path).find(name, document.path)
        if found is not None:
            yield str(found)
            yield str(found / "src" / name)  # Python installs what is beside its modules
    for above in around.above:
        beside = os.path.join(above, name)
        if os.path.basename(above) == name and not is_part(above):
            yield above
        if not is_part(beside):
            yield beside


_MOST_LIKE = 20
_BUILDS = ("CMakeLists.txt", "setup.py")


def as_built(document: Document, path: str) -> Path | None:
    """The file at a path, or the one that the build of its package installs there; None without one."""
    library = library_of(document)
    found = Path(path) if library is None else library.packages(document.path).locate(Path(path))
    return found if os.path.exists(found) else None


def substitute(document: Document, path: str) -> str | None:
    """A file of the same name, from its package on, for one in a package that is not there; empty without one.

    None where the file is there or made by a build, and where its package is not known or steps lead out of it.
    """
    library = library_of(document)
    is_plain = os.path.isabs(path) and os.pardir not in path.split("/")
    around = package_around(path) if is_plain else None
    if library is None or around is None or os.path.exists(path + TEMPLATE) or as_built(document, path):
        return None
    package, name = around[0], os.path.basename(path)
    for build in _BUILDS:
        with suppress(OSError):
            if name in library.read(Path(package, build), document, MEGABYTE).decode("utf-8", "replace"):
                return None
    found = library.packages(document.path).files(name, _MOST_LIKE)
    alike = (str(each) for each in found if each.name == name and is_below(str(each), (package,)))
    return next((Path(each).relative_to(package).as_posix() for each in alike), "")


_BUILT = r"_BINARY_DIR\}}[^\s\"'()]{{0,200}}/{}(?![\w.-])"
"""A file in the folder of the build, as CMakeLists.txt names it."""


def _installed(document: Document, package: str, inside: str) -> Path | None:
    """The file of a package that its build installs at another place, where programs look for it."""
    found = as_built(document, os.path.join(package, inside))
    return (
        found
        if found is not None and is_below(os.path.realpath(found), (os.path.realpath(package),))
        else None
    )


def is_built(document: Document, path: str) -> bool:
    """Does the build of its package make a file: does CMakeLists.txt name it in the folder of the build?"""
    library, around = library_of(document), package_around(path)
    if library is None or around is None:
        return False
    with suppress(OSError):
        text = library.read(Path(around[0], _BUILDS[0]), document, MEGABYTE).decode("utf-8", "replace")
        return re.search(_BUILT.format(re.escape(os.path.basename(path))), text) is not None
    return False
