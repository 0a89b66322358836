"""The robots that an SRDF file may be about: those of its name, in the project around it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

from sdfcheck.files.library import Library, library_of
from sdfcheck.files.packages import Packages
from sdfcheck.files.regular import read_regular
from sdfcheck.robot.root import root_of
from sdfcheck.robot.semantics.semantics import Semantics, names
from sdfcheck.source.document import Document, read
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.sniff import Kind
from sdfcheck.source.text import is_expression
from sdfcheck.xacro.language import matches

if TYPE_CHECKING:
    from sdfcheck.robot.graph import Model

MOST_FILES = 1000
MOST_ROBOTS = 6
"""So many files of a project are looked at, and so many robots compared."""

_ROBOT = re.compile(r"<robot\b[^>]*?\sname\s*=\s*[\"']([^\"']*)[\"']")
_DECLARED = re.compile(
    r"^ *urdf:[ \r]*\n *package: *([\w.-]+)[ \r]*\n *relative_path: *([\w./-]+)", re.IGNORECASE | re.MULTILINE
)
_GIVEN = re.compile(r"^ *xacro_args: *(.*(?:\n(?! *\w+:[^=]).*)*)", re.MULTILINE)
_ARGUMENT = re.compile(r"(\w+):=(?:\"([^\"]*)\"|'([^']*)'|([^\s\"']*))")
_NO_ARGUMENTS: Mapping[str, str] = {}
_FEWEST = 0.5
"""A robot is not the one that is meant if it has fewer of the names."""

Expand = Callable[[Document, Mapping[str, str]], "Document | None"]
"""Expands a robot with some arguments."""


def find_robots(semantics: Semantics, expand: Expand | None) -> None:
    """Find the robots that an SRDF file may be about; ``expand`` expands xacro.

    They have the name of the file and most of what it names: the robot for which MoveIt's assistant made the file, or
    else those in the package of the file, and if there is none in the project around it. Without one, the robot that
    has it all in a file of the package that is called like the SRDF file. Where the robots of its name in the package
    have nothing of what it names they are its ``strangers``; where the package has robots of other names only, one
    that has it all is its ``namesake``.
    """
    library = library_of(semantics.document)
    if library is None or not semantics.name or not semantics.named:
        return
    path = semantics.document.path
    own = Packages(_package(path))
    if any(True for _ in semantics.element.children("end_effector")):
        semantics.has_kinematics = any(
            file.name == "kinematics.yaml" for file in own.files(".yaml", MOST_FILES)
        )
    for meant in declared(path, library.packages(path)):
        head = _own_head(meant.path, semantics)
        robot = None if head is None else _robot(meant.path, head, semantics, expand, meant.arguments)
        if robot is not None and _score(semantics, robot) >= _FEWEST:
            semantics.robots = (robot,)
            return
    for packages in (own, library.packages(path)):
        scored = [(_score(semantics, robot), robot) for robot in _candidates(semantics, packages, expand)]
        best = max((score for score, _ in scored), default=0.0)
        if best >= _FEWEST:
            semantics.robots = tuple(robot for score, robot in scored if score == best)
            return
        if packages is own and scored and best == 0:
            semantics.strangers = tuple(robot for _, robot in scored)
    if not semantics.strangers:
        semantics.robots = tuple(_called_alike(semantics, own))
        semantics.namesake = _namesake(semantics, own)


def _called_alike(semantics: Semantics, packages: Packages) -> Iterator[Model]:
    """The robot of another name, in the nearest URDF file that is called like the SRDF file, if it has all names."""
    for path in _files(semantics.document, packages, (".urdf",)):
        if path.stem == semantics.document.path.stem:
            head = _head(path, semantics)
            robot = None if head is None else _robot(path, head, semantics, None)
            if robot is not None and _score(semantics, robot) == 1:
                yield robot
                return


def _namesake(semantics: Semantics, packages: Packages) -> Model | None:
    """The URDF robot of another name that has all that a file names, where no robot may have its name."""
    heads: dict[Path, _Head] = {}
    for path in _files(semantics.document, packages, (".urdf", ".xacro")):
        head = _head(path, semantics)
        if head is not None:
            heads[path] = head
            if head.name == semantics.name or is_expression(head.name) or len(heads) > MOST_ROBOTS:
                return None
    robots = [_robot(path, head, semantics, None) for path, head in heads.items() if head.kind is Kind.URDF]
    fitting = [robot for robot in robots if robot is not None and _score(semantics, robot) == 1]
    return fitting[0] if len(fitting) == 1 else None


def descriptions_of(semantics: Semantics) -> Iterator[Document]:
    """The documents of robots that an SRDF file may be about, as they are written.

    First the one for which MoveIt's assistant made the file, then those that are called like the file or have the
    name of its robot, the nearest first.
    """
    library = library_of(semantics.document)
    if library is None or not semantics.name:
        return
    path = semantics.document.path
    meant = [each.path for each in declared(path, library.packages(path))]
    stem, seen = _stem(path), set[Path]()
    for file in chain(meant, _alike_first(semantics, library)):
        head = _head(file, semantics) if file not in seen else None
        seen.add(file)
        is_alike = file in meant or _stem(file) == stem
        if head is None or not (is_alike or _may_be(head.name, semantics.name)):
            continue
        if (found := library.document(file, head.kind, semantics.document)) is not None:
            yield found


class Declared(NamedTuple):
    """The file of the robot for which MoveIt's assistant made a package, and the arguments with which it expands."""

    path: Path
    arguments: dict[str, str]


def declared(path: Path, packages: Packages) -> list[Declared]:
    """The robot that the settings of MoveIt's assistant name in the package of a file."""
    settings = _package(path) / ".setup_assistant"
    try:
        text = read_regular(settings).decode("utf-8", "replace") if settings.is_file() else ""
    except OSError:
        return []
    found = _DECLARED.search(text)
    folder = packages.find(found[1]) if found is not None else None
    if found is None or folder is None:
        return []
    given = _GIVEN.search(text)
    arguments = _ARGUMENT.findall(given[1]) if given is not None else []
    return [Declared(folder / found[2], {name: "".join(values) for name, *values in arguments})]


class Assistants:
    """The robots for which MoveIt's assistant made the packages of a project."""

    def __init__(self, packages: Packages) -> None:
        files = packages.files(".setup_assistant", MOST_FILES)
        self.declared = [each for path in files for each in declared(path, packages)]

    def arguments(self, path: Path) -> list[dict[str, str]]:
        """The arguments with which packages expand a robot, each once."""
        found = [each.arguments for each in self.declared if each.arguments and each.path == path]
        return [one for number, one in enumerate(found) if one not in found[:number]]


def _alike_first(semantics: Semantics, library: Library) -> Iterator[Path]:
    """The files that may hold robots, in the package and in the project; first those that are called alike."""
    path = semantics.document.path
    for packages in (Packages(_package(path)), library.packages(path)):
        files = _files(semantics.document, packages, (".urdf", ".xacro"))
        yield from sorted(files, key=lambda file: _stem(file) != _stem(path))


def _may_be(written: str, name: str) -> bool:
    """Is this the name of a robot, or may its expressions come to it?"""
    bounds = [0, *(place for match in matches(written) for place in match.span()), len(written)]
    first, *others = (written[start:end] for start, end in zip(bounds[::2], bounds[1::2], strict=True))
    if not others:
        return written == name
    *middle, last = others
    at = len(first) if name.startswith(first) else -1
    for piece in middle:
        found = name.find(piece, at + 1) if at >= 0 else -1
        at = found + len(piece) if found >= 0 else -1
    return any((first, *others)) and 0 <= at < len(name) - len(last) and name.endswith(last)


def _stem(path: Path) -> str:
    return path.name.partition(".")[0]


def _package(path: Path) -> Path:
    """The folder of the package that a file is in, else its own."""
    folders = path.absolute().parents
    return next((folder for folder in folders if (folder / "package.xml").is_file()), folders[0])


def _score(semantics: Semantics, robot: Model) -> float:
    """The share of the names that a robot has."""
    known = {kind: names(robot, kind) for kind in ("link", "joint")}
    asked = [part for part in semantics.named if not semantics.is_added(part)]
    return sum(part.value.text.strip() in known[part.kind] for part in asked) / max(len(asked), 1)


def _candidates(semantics: Semantics, packages: Packages, expand: Expand | None) -> Iterator[Model]:
    found = 0
    suffixes = (".urdf", ".xacro") if expand is not None else (".urdf",)
    for path in _files(semantics.document, packages, suffixes):
        if found == MOST_ROBOTS:
            return
        head = _own_head(path, semantics)
        robot = None if head is None else _robot(path, head, semantics, expand)
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


class _Head(NamedTuple):
    """The name of the robot that a file describes, the kind of the file, and its content."""

    name: str
    kind: Kind
    data: bytes


def _head(path: Path, semantics: Semantics) -> _Head | None:
    """The beginning of a file, read; None where it describes no robot or cannot be read."""
    library = library_of(semantics.document)
    try:
        data = library.read(path, semantics.document) if library is not None else b""
    except OSError:
        return None
    match = _ROBOT.search(data[:8192].decode("utf-8", "replace"))
    is_xacro = path.suffix == ".xacro" or b"<xacro:" in data
    return None if match is None else _Head(match[1], Kind.XACRO if is_xacro else Kind.URDF, data)


def _own_head(path: Path, semantics: Semantics) -> _Head | None:
    """The beginning of a file that describes a robot of the name; None: it does not."""
    head = _head(path, semantics)
    return head if head is not None and head.name == semantics.name else None


def _robot(
    path: Path,
    head: _Head,
    semantics: Semantics,
    expand: Expand | None,
    arguments: Mapping[str, str] = _NO_ARGUMENTS,
) -> Model | None:
    """The robot of a file; None where it has no links, or cannot be expanded."""
    kind = head.kind
    document: Document | None = read(head.data, path, kind)
    assert document is not None
    document.library = semantics.document.library
    if kind is Kind.XACRO:
        document = expand(document, arguments) if expand is not None else None
    if document is None or document.root is None or document.root.name != "robot":
        return None
    robot = root_of(document).scopes[0]
    return robot if robot.links else None  # type: ignore[return-value]
