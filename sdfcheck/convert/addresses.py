"""The addresses of the files that a result names, in the style that is asked for; and copies of those files beside it.

Texts and places are worked out first; only then is anything copied.
"""

from __future__ import annotations

import json
import os
import re
from collections.abc import Iterator
from enum import Enum
from pathlib import Path

from sdfcheck.convert.result import Conversion, relative_edits, spelled
from sdfcheck.files.discover import MODEL_CONFIG
from sdfcheck.files.library import library_of
from sdfcheck.files.overwrite import overwrite, why_not
from sdfcheck.files.packages import package_around
from sdfcheck.files.regular import MEGABYTE, identity, read_regular
from sdfcheck.files.uris import locate
from sdfcheck.robot.root import root_of
from sdfcheck.source.document import Document
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.splice import Replacement, replaced
from sdfcheck.source.text import IN_QUOTES, escape, relative_path

_MODEL = "model://"

_LARGEST_SCENE = 16 * MEGABYTE
"""Of larger glTF files it is not known what they name."""
_NAMED_IN = {
    ".obj": re.compile(rb"^[ \t]*mtllib[ \t]([^\r\n]+)", re.MULTILINE),
    ".mtl": re.compile(rb"^[ \t]*(?:map_\w+|bump|disp|decal|norm|refl)[ \t]([^\r\n]+)", re.MULTILINE),
    ".dae": re.compile(rb"<(?:init_from|ref)>([^<>]*)</"),
}
"""How files of a format name others beside them. No pattern looks at a character twice."""


class UriStyle(Enum):
    """How the addresses of meshes, textures and other files are written."""

    KEEP = "keep"
    PACKAGE = "package"
    MODEL = "model"
    FILE = "file"
    RELATIVE = "relative"


class Addressed(NamedTuple):
    """The text with its addresses; ``copies`` are files and where they go; ``left`` are addresses that stay as
    they are, as nothing is found there, or nothing of the style leads there."""

    text: str
    copies: tuple[tuple[Path, Path], ...]
    left: tuple[str, ...]


def addressed(done: Conversion, source: Path, folder: Path, style: UriStyle, *, copies: bool) -> Addressed:
    """The text of a result that goes to ``folder``, and with ``copies`` the files that it names beside it.

    Relative addresses are those seen from the folder ``source``; where no style is written, such as those of
    included files, they are written as seen from ``folder``.
    """
    found = {uri: path for uri in _uris(done) if (path := _found(done, uri)) is not None}
    places = _Copies(done.document, folder, set(found.values())) if copies else None
    written: dict[str, str] = {}
    for uri, path in found.items():
        at = path if places is None else places.of(path)
        if text := _written(at, folder, style, is_copied=copies):
            written[uri] = text
    styled, left = _edits(done, written)
    plain = {edit[0]: edit for edit in relative_edits(done, source, folder)}
    edits = sorted((plain | {edit[0]: edit for edit in styled}).values())
    return Addressed(replaced(done.text, edits), () if places is None else places.all(), left)


def copy(done: Conversion, copies: tuple[tuple[Path, Path], ...]) -> int:
    """Copy files of a result; how many were written, as those that are there already stay.

    Raises:
        WrongUsage: one cannot be read or written, or another file is there.
    """
    count = 0
    for source, target in copies:
        try:
            data = _read(done.document, source)
        except OSError as error:
            raise WrongUsage(f"{source} cannot be read: {error.strerror or error}") from None
        try:
            if os.path.exists(target):
                if identity(source) != identity(target) and read_regular(target) != data:
                    raise WrongUsage(f"{target} is there already, and is not {source}")
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            overwrite(target, data)
        except OSError as error:
            raise WrongUsage(why_not(target, error)) from None
        count += 1
    return count


def config_of(name: str, file: str, version: str) -> str:
    """The ``model.config`` of a model, by which Gazebo finds its file."""
    return (
        '<?xml version="1.0"?>\n<model>\n'
        f"  <name>{escape(name)}</name>\n  <version>1.0</version>\n"
        f'  <sdf version="{escape(version, IN_QUOTES)}">{escape(file)}</sdf>\n</model>\n'
    )


def _read(document: Document, path: Path) -> bytes:
    """The bytes of a file that a result leads to; OSError if it cannot or must not be read."""
    library = library_of(document)
    return b"" if library is None else library.read(path, document)


def _uris(done: Conversion) -> Iterator[str]:
    return (resource.uri for resource in root_of(done.document).resources)


def _edits(done: Conversion, written: dict[str, str]) -> tuple[set[Replacement], tuple[str, ...]]:
    """The edits that write addresses, and the addresses that stay."""
    edits: set[Replacement] = set()
    left: dict[str, None] = {}
    for resource in root_of(done.document).resources:
        uri = resource.uri
        if uri in written and (edit := spelled(resource.uri_value, written[uri])) is not None:
            edits.add(edit)
        else:
            left[uri] = None
    return edits, tuple(left)


def _found(done: Conversion, uri: str) -> Path | None:
    """The file that an address of a result leads to; a package may be written as a model."""
    path = locate(done.document, uri).path
    if path is None and uri.startswith(_MODEL):
        path = locate(done.document, f"package://{uri.removeprefix(_MODEL)}").path
    return (
        path if path is not None and os.path.isfile(path) and library_of(done.document) is not None else None
    )


def _written(at: Path, folder: Path, style: UriStyle, *, is_copied: bool) -> str:
    """The address of a file in a style; empty where the style has none."""
    if style is UriStyle.FILE:
        # No consumer of descriptions decodes `%20`: the path is written as it is.
        path = at.absolute().as_posix()
        return f"file://{path}" if path.startswith("/") else f"file:///{path}"
    if style is UriStyle.RELATIVE or style is UriStyle.KEEP:
        return Path(relative_path(at, folder)).as_posix()
    if style is UriStyle.MODEL and (model := _model_around(at, folder if is_copied else None)) is not None:
        return f"{_MODEL}{model.name}/{Path(relative_path(at, model)).as_posix()}"
    package = package_around(at)
    if package is None:
        return ""
    inside = Path(relative_path(at, package[0])).as_posix()
    return f"{style.value}://{package[1]}/{inside}"


def _model_around(at: Path, folder: Path | None) -> Path | None:
    """The folder of the model that a file is in; ``folder`` is one that will be."""
    around = at.absolute().parents
    future = None if folder is None else folder.absolute()
    return next((each for each in around if each == future or os.path.isfile(each / MODEL_CONFIG)), None)


class _Copies:
    """Where files go that are copied below a folder: as they are in their package or model."""

    def __init__(self, document: Document, folder: Path, files: set[Path]) -> None:
        self._folder = folder
        self._document = document
        self._owners = {file: _owner(file) for file in files}
        owners = sorted(set(self._owners.values()))
        names = [owner.name for owner in owners]
        self._names = {
            owner: owner.name if names.count(owner.name) == 1 else f"{owner.name}_{number}"
            for number, owner in enumerate(owners, 1)
        }

    def of(self, file: Path) -> Path:
        """Where a file goes; one of several owners goes below the name of its own."""
        owner = self._owners[file]
        below = self._folder if len(self._names) == 1 else self._folder / self._names[owner]
        return below / relative_path(file, owner)

    def all(self) -> tuple[tuple[Path, Path], ...]:
        """The files and those that they name, as long as these stay below the folder."""
        found: dict[Path, Path] = {}
        waiting = [(file, self.of(file)) for file in sorted(self._owners)]
        top = os.path.join(os.path.abspath(self._folder), "")
        while waiting:
            file, target = waiting.pop(0)
            if file in found or not os.path.abspath(target).startswith(top):
                continue
            found[file] = target
            waiting += [
                (file.parent / name, target.parent / name)
                for name in _names_in(self._document, file)
                if os.path.isfile(file.parent / name)
            ]
        return tuple(found.items())


def _owner(file: Path) -> Path:
    """The folder of the package or model that a file is in, else its own."""
    package, model = package_around(file), _model_around(file, None)
    folders = [Path(package[0])] if package is not None else []
    folders += [model] if model is not None else []
    return max(folders, key=lambda folder: len(folder.parts), default=file.absolute().parent)


def _names_in(document: Document, file: Path) -> Iterator[str]:
    """The relative paths of materials, textures and buffers that a mesh names; none of what cannot be read."""
    suffix = file.suffix.lower()
    if suffix not in _NAMED_IN and suffix != ".gltf":
        return
    try:
        data = _read(document, file)
        named = _in_scene(data) if suffix == ".gltf" else map(os.fsdecode, _NAMED_IN[suffix].findall(data))
    except OSError:
        return  # the copy of the file will report it
    for text in named:
        name = text.strip().replace("\\", "/")
        if suffix == ".mtl" and name.startswith("-"):  # options come first
            name = name.split()[-1]
        if "." in name and ":" not in name and "\0" not in name and not os.path.isabs(name):
            yield name


def _in_scene(data: bytes) -> list[str]:
    """The addresses of buffers and images in glTF."""
    try:
        scene = json.loads(data) if len(data) <= _LARGEST_SCENE else {}
        return [str(each.get("uri", "")) for key in ("buffers", "images") for each in scene.get(key, ())]
    except (ValueError, AttributeError, TypeError, RecursionError):
        return []  # it is not glTF
