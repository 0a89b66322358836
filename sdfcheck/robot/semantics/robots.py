"""The robots that an SRDF file may be about: those of its name, in the project around it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.library import library_of
from sdfcheck.files.packages import Packages
from sdfcheck.robot.root import root_of
from sdfcheck.robot.semantics.semantics import Semantics, names
from sdfcheck.source.document import Document, read
from sdfcheck.source.sniff import Kind

if TYPE_CHECKING:
    from sdfcheck.robot.model import Model

MOST_FILES = 1000
MOST_ROBOTS = 6
"""So many files of a project are looked at, and so many robots compared."""

_ROBOT = re.compile(r"<robot\b[^>]*?\sname\s*=\s*[\"']([^\"']*)[\"']")
_FEWEST = 0.5
"""A robot is not the one that is meant if it has fewer of the names."""

Expand = Callable[[Document], "Document | None"]


def robots_of(semantics: Semantics, expand: Expand | None) -> tuple[Model, ...]:
    """The robots with the name of an SRDF file that have most of what it names; ``expand`` expands xacro.

    They are looked for in the package of the file, and if there is none in the project around it.
    """
    library = library_of(semantics.document)
    if library is None or not semantics.name or not semantics.named:
        return ()
    path = semantics.document.path
    for packages in (Packages(_package(path)), library.packages(path)):
        scored = [(_score(semantics, robot), robot) for robot in _candidates(semantics, packages, expand)]
        best = max((score for score, _ in scored), default=0.0)
        if best >= _FEWEST:
            return tuple(robot for score, robot in scored if score == best)
    return ()


def descriptions_of(semantics: Semantics) -> Iterator[Document]:
    """The documents of robots with the name of an SRDF file, as they are written, the nearest first."""
    library = library_of(semantics.document)
    if library is None or not semantics.name:
        return
    path = semantics.document.path
    seen: set[str] = set()
    for packages in (Packages(_package(path)), library.packages(path)):
        for file in _files(semantics.document, packages, (".urdf", ".xacro")):
            kind = _kind(file, _data(file, semantics), semantics) if str(file) not in seen else None
            seen.add(str(file))
            if kind is not None and (found := library.document(file, kind, semantics.document)) is not None:
                yield found


def _package(path: Path) -> Path:
    """The folder of the package that a file is in, else its own."""
    folders = path.absolute().parents
    return next((folder for folder in folders if (folder / "package.xml").is_file()), folders[0])


def _score(semantics: Semantics, robot: Model) -> float:
    """The share of the names that a robot has."""
    known = {kind: names(robot, kind) for kind in ("link", "joint")}
    right = sum(part.value.text.strip() in known[part.kind] for part in semantics.named)
    return right / len(semantics.named)


def _candidates(semantics: Semantics, packages: Packages, expand: Expand | None) -> Iterator[Model]:
    found = 0
    suffixes = (".urdf", ".xacro") if expand is not None else (".urdf",)
    for path in _files(semantics.document, packages, suffixes):
        if found == MOST_ROBOTS:
            return
        robot = _robot(path, semantics, expand)
        if robot is not None:
            found += 1
            yield robot


def _files(document: Document, packages: Packages, suffixes: tuple[str, ...]) -> list[Path]:
    """The files that may hold robots, the nearest first."""
    found = [path for suffix in suffixes for path in packages.files(suffix, MOST_FILES)]
    own = document.path.absolute().parts

    def distance(path: Path) -> tuple[int, str]:
        parts = path.absolute().parts
        same = next(
            (n for n, pair in enumerate(zip(own, parts, strict=False)) if pair[0] != pair[1]), len(own)
        )
        return len(own) + len(parts) - 2 * same, path.as_posix()

    return sorted((path for path in found if ".srdf" not in path.name), key=distance)


def _data(path: Path, semantics: Semantics) -> bytes:
    """The content of a file; nothing where it cannot be read."""
    library = library_of(semantics.document)
    try:
        return library.read(path, semantics.document) if library is not None else b""
    except OSError:
        return b""


def _kind(path: Path, data: bytes, semantics: Semantics) -> Kind | None:
    """Which kind of file describes a robot of the name; None: it does not."""
    match = _ROBOT.search(data[:8192].decode("utf-8", "replace"))
    if match is None or match[1] != semantics.name:
        return None
    return Kind.XACRO if path.suffix == ".xacro" or b"<xacro:" in data else Kind.URDF


def _robot(path: Path, semantics: Semantics, expand: Expand | None) -> Model | None:
    """The robot of a file, if it has the name."""
    data = _data(path, semantics)
    kind = _kind(path, data, semantics)
    if kind is None:
        return None
    document: Document | None = read(data, path, kind)
    assert document is not None
    document.library = semantics.document.library
    if kind is Kind.XACRO:
        document = expand(document) if expand is not None else None
    if document is None or document.root is None or document.root.name != "robot":
        return None
    robot = root_of(document).scopes[0]
    return robot if robot.links else None  # type: ignore[return-value]
