"""Files and folders that a URI can lead to."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from sdfcheck.files.library import library_of
from sdfcheck.lsp.completion.item import Item, Sort
from sdfcheck.source.document import Document

_MOST = 500
_MESHES = (".dae", ".stl", ".obj", ".gltf", ".glb", ".ply")
_IMAGES = (".png", ".jpg", ".jpeg", ".tga", ".dds", ".tif")
_ENDINGS = {
    "mesh": _MESHES,
    "heightmap": (".png", ".tif", ".tiff", ".jpg"),
    "texture": _IMAGES,
    "albedo_map": _IMAGES,
    "normal_map": _IMAGES,
    "xacro:include": (".xacro", ".urdf", ".xml"),
    "include": (".sdf", ".world", ".urdf"),
}
_CLIMB = 6


def path_items(document: Document, typed: str, tag: str, around: tuple[str, ...]) -> Iterator[Item]:
    """The continuations of a URI that has been typed up to its last slash; each item is the whole URI."""
    holder = tag if tag in _ENDINGS else (around[-2] if len(around) > 1 else "")
    head, slash, _ = typed.rpartition("/")
    if "://" not in typed:
        for scheme in ("model://", "package://", "file://"):
            if tag != "xacro:include":
                yield Item(scheme, Sort.WORD, scheme, rank=6)
    if typed.startswith("$(find ") and ")" not in typed:
        yield from (
            Item(f"$(find {name})", Sort.FOLDER, f"$(find {name})/", rank=2) for name in _packages(document)
        )
        return
    if head.endswith(":/") or head in {"model:", "package:"}:
        names = _packages(document) if head.startswith("package") else _models(document)
        scheme = head.partition(":")[0]
        yield from (Item(f"{scheme}://{name}", Sort.FOLDER, f"{scheme}://{name}", rank=2) for name in names)
        return
    folder = _folder(document, head + slash)
    if folder is not None:
        yield from _listed(folder, head + slash, _ENDINGS.get(holder, ()))


def _listed(folder: Path, head: str, endings: tuple[str, ...]) -> Iterator[Item]:
    try:
        entries = sorted(os.scandir(folder), key=lambda entry: entry.name)
    except OSError:
        return
    for entry in entries[:_MOST]:
        if entry.name.startswith("."):
            continue
        if entry.is_dir():
            yield Item(f"{head}{entry.name}/", Sort.FOLDER, f"{head}{entry.name}/", rank=4)
        elif not endings or entry.name.lower().endswith(endings):
            yield Item(f"{head}{entry.name}", Sort.FILE, f"{head}{entry.name}", rank=3)


def _folder(document: Document, head: str) -> Path | None:
    """The folder that the beginning of a URI means."""
    beside = Path(os.path.abspath(document.path)).parent
    scheme, sign, rest = head.partition("://")
    if head.startswith("$(find "):
        name, _, inside = head[len("$(find ") :].partition(")")
        found = _package(document, name.strip())
        return None if found is None else found / inside.strip("/")
    if not sign:
        return beside / head
    if scheme == "file":
        return Path("/" + rest.lstrip("/"))
    name, _, inside = rest.partition("/")
    if scheme == "package":
        found = _package(document, name)
        return None if found is None else found / inside
    if scheme == "model":
        return next(
            (place / name / inside for place in _model_folders(document) if os.path.isdir(place / name)), None
        )
    return None


def _package(document: Document, name: str) -> Path | None:
    library = library_of(document)
    return None if library is None else library.packages(document.path).find(name)


def _packages(document: Document) -> list[str]:
    library = library_of(document)
    return [] if library is None else library.packages(document.path).names[:_MOST]


def _models(document: Document) -> list[str]:
    """The folders that hold a model."""
    found: dict[str, None] = {}
    for folder in _model_folders(document):
        try:
            names = sorted(os.listdir(folder))
        except OSError:
            continue
        found.update(
            dict.fromkeys(name for name in names[:_MOST] if os.path.isfile(folder / name / "model.config"))
        )
    return sorted(found)


def _model_folders(document: Document) -> Iterator[Path]:
    library = library_of(document)
    if library is not None:
        yield from map(Path, library.model_folders)
    folder = Path(os.path.abspath(document.path)).parent
    for above in (folder, *folder.parents)[:_CLIMB]:
        yield above
        yield above / "models"
