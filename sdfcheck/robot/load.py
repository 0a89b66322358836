"""Loading of a robot description for programs."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

from sdfcheck.files.library import Library, SearchPaths
from sdfcheck.files.regular import read_named
from sdfcheck.robot.includes.included import TooManyModels, refuse_too_many
from sdfcheck.robot.root import Root, root_of
from sdfcheck.source.document import read
from sdfcheck.source.errors import WrongUsage
from sdfcheck.source.sniff import HEAD, Kind, sniff


class Unreadable(ValueError):
    """The file holds no robot description that can be read; the message says why, and where."""


def load(
    path: str | os.PathLike[str],
    *,
    arguments: Mapping[str, str] | None = None,
    model_paths: Sequence[Path] = (),
    package_paths: Sequence[Path] = (),
    packages: Mapping[str, Path] = MappingProxyType({}),
    tables: Sequence[Path] = (),
) -> Root:
    """Read an SDFormat, URDF or xacro file.

    ``arguments`` are given to xacro. Included models are looked for below ``model_paths`` and in
    the folders of the environment variables that Gazebo uses, packages below ``package_paths`` and by
    their names in ``packages``.
    ``tables`` are those of vendors' own elements (``mujoco.vendor.txt``), as packs of rules bring
    them. Other problems of the file are reported by :func:`sdfcheck.lint`: everything that can be
    understood is there.

    Raises:
        OSError: the file cannot be read.
        Unreadable: it holds no robot description, cannot be expanded, or brings too many models.
        WrongUsage: a table cannot be read.
    """
    place = Path(path)
    by_name = tuple((name, Path(folder)) for name, folder in packages.items())
    search = SearchPaths(tuple(model_paths), tuple(package_paths), by_name, tables=_checked(tables))
    return _root(read_named(place), place, arguments, search)


def parse(
    text: str | bytes,
    path: str | os.PathLike[str] = "<text>",
    *,
    arguments: Mapping[str, str] | None = None,
    tables: Sequence[Path] = (),
) -> Root:
    """Read a text like the content of a file; relative names in it are resolved from the folder of ``path``.

    ``tables`` are as for :func:`load`. Raises Unreadable; WrongUsage: a table cannot be read.
    """
    data = text if isinstance(text, bytes) else text.encode("utf-8", "surrogatepass")
    return _root(data, Path(path), arguments, SearchPaths(tables=_checked(tables)))


def opened(what: str | bytes | os.PathLike[str], tables: Sequence[Path] = ()) -> Root:
    """A description by its path or its text; raises as :func:`load`."""
    text = as_text(what)
    return load(what, tables=tables) if text is None else parse(text, tables=tables)  # type: ignore[arg-type]


def _checked(tables: Sequence[Path]) -> tuple[Path, ...]:
    if tables:
        from sdfcheck.formats.vendor.definitions import BadTable
        from sdfcheck.formats.vendor.table import check_tables

        try:
            check_tables(tables)
        except BadTable as error:
            raise WrongUsage(str(error)) from None
    return tuple(tables)


def as_text(what: object) -> bytes | None:
    """The bytes of a text: what is bytes, or a str that begins with ``<``; None for anything else."""
    if isinstance(what, str) and what.lstrip("\ufeff \t\r\n").startswith("<"):
        return what.encode("utf-8", "surrogatepass")
    return what if isinstance(what, bytes) else None


def _root(data: bytes, path: Path, arguments: Mapping[str, str] | None, search: SearchPaths) -> Root:
    # Only the parser knows what broken XML was meant to be, and only the first bytes show whether
    # it is xacro or SRDF, whose root has the name of URDF's.
    kind = sniff(data[:HEAD], path)
    document = read(data, path, kind if kind in {Kind.XACRO, Kind.SRDF} else None)
    if document.kind is Kind.XACRO:
        from sdfcheck.xacro.expansion import Surroundings, expand

        surroundings = Surroundings(dict(search.packages), search.packages_in)
        expansion = expand(document, arguments or {}, surroundings)
        if expansion.document is None:
            obstacle = expansion.obstacle(document.path)
            raise Unreadable(f"{obstacle}, so xacro does not expand the file; sdfcheck.lint says more")
        document = expansion.document
    if document.root is None or document.kind not in {Kind.SDF, Kind.URDF}:
        raise Unreadable(f"{document.path}: looks like {document.kind.description}, no robot description")
    document.library = Library(search)
    try:
        refuse_too_many(document)
    except TooManyModels as error:
        raise Unreadable(str(error)) from None
    return root_of(document)
