"""The files to convert, and where each result goes."""

from __future__ import annotations

import os
from collections.abc import Collection, Sequence
from pathlib import Path

from sdfcheck.cli.convert.options import Request
from sdfcheck.cli.parts.output import refuse_to_write
from sdfcheck.cli.parts.terminal import read_stdin
from sdfcheck.files.discover import discover
from sdfcheck.files.regular import identity
from sdfcheck.source.record import NamedTuple
from sdfcheck.source.relative import relative_path
from sdfcheck.source.wrong_usage import WrongUsage

_STDIN = Path("-")


class Source(NamedTuple):
    """Something to convert; ``data`` is what stdin has given. ``named``: a person wrote its path."""

    path: Path
    named: bool = True
    data: bytes | None = None


def sources(request: Request) -> list[Source]:
    """The files that are named, those in the folders that are named, and stdin for ``-``.

    Raises: WrongUsage: no file is found.
    """
    paths = request.paths
    if not paths:
        raise WrongUsage("no file is named")
    if request.stdin_filename is not None and _STDIN not in paths:
        raise WrongUsage("--stdin-filename needs - among the inputs")
    folders = [path for path in paths if path.is_dir()]
    configuration = request.around.configuration
    found = discover(folders, exclude=lambda path: configuration.settings_for(path).excludes(path))
    if folders and not found.files and len(folders) == len(paths):
        raise WrongUsage(f"no SDFormat, URDF or xacro file in {folders[0]}")
    wanted = []
    for path in paths:
        if path == _STDIN:
            name = request.stdin_filename or Path("<stdin>")
            wanted.append(Source(name, data=read_stdin()))
        elif path not in folders:
            wanted.append(Source(path))
    inside = (Source(each.path, named=False) for each in found.files if each.path.name != "model.config")
    return [*wanted, *inside]


def targets(request: Request, files: Sequence[Source], suffix: str) -> list[Path | None]:
    """Where each result goes; None is stdout.

    Results of the same name go to folders as those of their sources, unless --flat forbids it.

    Raises:
        WrongUsage: the options contradict each other, or two results would go to one place.
    """
    folder = _folder(request)
    if folder is None:
        if len(files) > 1:
            raise WrongUsage("several inputs need --output-dir")
        return [request.output_file]
    paths = [file.path if file.data is None else Path(_stem(file.path.name).strip("<>")) for file in files]
    names = [Path(f"{_stem(path.name)}{suffix}") for path in paths]
    if len(set(names)) < len(names):
        if request.flat:
            raise WrongUsage(_clash(paths, names, folder))
        names = _mirrored(paths, names)
    if len(set(names)) < len(names):
        taken = {name for name in names if names.count(name) > 1}
        names = [
            name.with_name(f"{path.name}{suffix}") if name in taken else name
            for path, name in zip(paths, names, strict=True)
        ]
        if len(set(names)) < len(names):
            raise WrongUsage(_clash(paths, names, folder))
    return [folder / name for name in names]


def _folder(request: Request) -> Path | None:
    """The folder for the results, each under a name of its own; None where one place is named, or none."""
    if request.output_file is not None and request.output_dir is not None:
        raise WrongUsage("--output-file and --output-dir exclude each other")
    if request.copy_meshes and request.output_file is None and request.output_dir is None:
        raise WrongUsage("--copy-meshes needs a place: -o FILE or --output-dir FOLDER")
    folder = request.output_dir
    if request.output_file is not None and request.output_file.is_dir():
        folder = request.output_file
    if request.flat and folder is None:
        raise WrongUsage("--flat goes with --output-dir")
    return folder


def _stem(name: str) -> str:
    name = name.removesuffix(".xacro")
    return name.rpartition(".")[0] or name


def _mirrored(paths: Sequence[Path], names: Sequence[Path]) -> list[Path]:
    """The names below folders that are those of the paths, as seen from the folder that holds all of them."""
    folders = [os.path.abspath(path.parent) for path in paths]
    try:
        top = os.path.commonpath(folders)
    except ValueError:  # several drives
        return list(names)
    return [Path(relative_path(folder, top), name) for folder, name in zip(folders, names, strict=True)]


def _clash(paths: Sequence[Path], names: Sequence[Path], folder: Path) -> str:
    first: dict[Path, Path] = {}
    for path, name in zip(paths, names, strict=True):
        if name in first:
            return f"{first[name]} and {path} would both go to {folder / name}"
        first[name] = path
    raise AssertionError("two of the names are equal")


def refuse_to_overwrite(
    files: Collection[Path], targets: Sequence[Path | None], others: Sequence[Path | None], *, stays: bool
) -> None:
    """Keep reports off inputs and results, and results off inputs unless the one file's format ``stays`` the same.

    Raises:
        WrongUsage: one would be written over another, or where nothing is written.
    """
    inputs = {identity(file) for file in files}
    replaced = [each for each in targets if stays and each is not None and identity(each) in inputs - {None}]
    if replaced and len(files) > 1:
        raise WrongUsage(f"{replaced[0]} is an input; name it with -o to replace it")
    refuse_to_write([each for each in (*targets, *others) if each not in replaced], files)
